# SPDX-License-Identifier: MIT
"""Clusters of converted meshes: that they hold all of the mesh, and that none is dropped that the eye sees part of."""
import collections
import os
import random
import re

from harness import MODELS, ROOT, torus_text
from test_convert import TOO_LARGE, array, convert

Cluster = collections.namedtuple("Cluster", "axis spread height triangles vertices borrowers")

# Far from a model, this many steps from its middle, is where its test is sharpest.
FAR = 1 << 24


def numbers(text):
    return [int(number) for number in re.findall(r"-?\d+", text)]


def body(text, array_name):
    return re.search(rf" {array_name}\[\d+\](?:\[3\])? = {{(.*?)\n}};", text, re.DOTALL).group(1)


def clusters_of(text, name, suffix=""):
    """A mesh's clusters, each with its own triangles, vertices and borrowers; [] where it has none."""
    if f"{name}_clusters{suffix} = " not in text:
        return []
    triangles, _ = array(text, f"{name}_triangles{suffix}")
    borrowers = body(text, f"{name}_borrowers{suffix}")
    borrowers = [] if "none" in borrowers else numbers(borrowers)
    clusters, triangle, vertex, borrower = [], 0, 0, 0
    for row in re.findall(r"\{\{.*?\}.*?\}", body(text, f"{name}_cluster_list{suffix}")):
        x, y, z, spread, height, triangle_count, vertex_count, borrower_count = numbers(row)
        clusters.append(Cluster((x, y, z), spread, height, triangles[triangle:triangle + triangle_count],
                                range(vertex, vertex + vertex_count), borrowers[borrower:borrower + borrower_count]))
        triangle, vertex, borrower = triangle + triangle_count, vertex + vertex_count, borrower + borrower_count
    positions, _ = array(text, f"{name}_positions{suffix}")
    if (triangle, vertex, borrower) != (len(triangles), len(positions), len(borrowers)):
        raise AssertionError(f"{name}: counts of clusters do not add up")
    return clusters


def check_structure(host, name, clusters):
    owners = {vertex: owner for owner, cluster in enumerate(clusters) for vertex in cluster.vertices}
    borrowers = [set() for _ in clusters]
    order = [vertex for cluster in clusters for triangle in cluster.triangles for vertex in triangle]
    for number, cluster in enumerate(clusters):
        for vertex in (vertex for triangle in cluster.triangles for vertex in triangle):
            if owners[vertex] != number:
                borrowers[owners[vertex]].add(number)
    host.equal(f"{name}: vertices in the order of their first use", list(dict.fromkeys(order)), sorted(owners))
    host.check(f"{name}: no vertex is borrowed before it is owned",
               all(owner < min(others, default=len(clusters)) for owner, others in enumerate(borrowers)))
    host.equal(f"{name}: borrowers", [cluster.borrowers for cluster in clusters], [sorted(others) for others in borrowers])
    host.check(f"{name}: sizes", all(1 <= len(cluster.triangles) <= 64 and max(map(abs, cluster.axis)) <= 127
                                     for cluster in clusters))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def difference(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def planes_of(positions, cluster):
    """(normal, height) of its triangles: a triangle faces the eye where normal . eye > height."""
    corners = [[positions[vertex] for vertex in triangle] for triangle in cluster.triangles]
    normals = [cross(difference(b, a), difference(c, a)) for a, b, c in corners]
    return [(normal, dot(normal, a)) for normal, (a, _, _) in zip(normals, corners)]


def is_dropped(cluster, eye):
    """axis . eye + spread |eye| <= 256 height, in integers of any size."""
    room = 256 * cluster.height - dot(cluster.axis, eye)
    return room >= 0 and room * room >= cluster.spread * cluster.spread * dot(eye, eye)


def eyes_at_the_limit(cluster, planes, source):
    """The farthest eyes along some lines from step 0 where the cluster is dropped, or near it."""
    eyes = []
    for normal, _ in source.sample(planes, min(4, len(planes))):
        length = max(1, max(map(abs, normal)))
        line = [(part * 1000 // length) + source.randint(-1500, 1500) for part in normal]
        reach = dot(cluster.axis, line) + cluster.spread * dot(line, line) ** 0.5
        if reach and 0 < 256 * cluster.height / reach < FAR:
            eyes.append(tuple(int(part * 256 * cluster.height / reach) for part in line))
    return eyes


def some_eyes(positions, source, count):
    """Close by, on the surface, at all distances."""
    eyes = [(0, 0, 0), *source.sample(positions, min(count, len(positions)))]
    for reach in [2 ** bits for bits in (10, 14, 15, 16, 17, 18, 20, 24, 40)]:
        eyes += [tuple(source.randint(-reach, reach) for _ in range(3)) for _ in range(count)]
    return eyes


def check_guarantee(host, name, positions, clusters, count):
    source = random.Random(name)
    eyes = some_eyes(positions, source, count)
    wrong = dropped = 0
    for cluster in clusters:
        planes = planes_of(positions, cluster)
        for eye in eyes + eyes_at_the_limit(cluster, planes, source):
            if is_dropped(cluster, eye):
                dropped += 1
                wrong += any(dot(normal, eye) > height for normal, height in planes)
    host.check(f"{name}: what is dropped faces away", wrong == 0 and dropped > 0, f"{wrong} of {dropped}")


def test_clusters_hold_the_mesh(host):
    host.write("torus.obj", torus_text(20, 10))
    host.write("painted.obj", re.sub(r"^(v \S+ \S+ \S+)(\d)$", r"\1\2 0.5 0.\2 1", torus_text(20, 10), flags=re.MULTILINE))
    for name, model, *options in [("torus", "torus:24x12"), ("sphere", "sphere:16x8"), ("painted", "painted.obj"),
                                  ("facets", "torus.obj", "--flat"),
                                  ("teapot", os.path.join(MODELS, "teapot.obj")),
                                  ("featuretype", os.path.join(MODELS, "featuretype.obj")),
                                  ("tree", os.path.join(MODELS, "tree.obj"))]:
        text = convert(host, model, "--name", "m", *options)
        plain = convert(host, model, "--name", "m", "--no-clusters", *options)
        clusters = clusters_of(text, "m")
        host.check(f"{name} has clusters", clusters and not clusters_of(plain, "m"))
        check_structure(host, name, clusters)
        host.equal(f"{name}: the same triangles", corners_of(text), corners_of(plain))
        size = 12 * len(clusters) + 2 * sum(len(cluster.borrowers) for cluster in clusters)
        host.equal(f"{name}: flash", flash(text), flash(plain) + size)


def flash(text):
    return int(re.search(r"(\d+) bytes of flash", text).group(1))


def test_what_clusters_take(host):
    """Flash of the example models, with clusters against without: what pages say of it."""
    more = []
    for model in sorted(name for name in os.listdir(MODELS) if name.endswith(".obj")):
        text = convert(host, os.path.join(MODELS, model), "--name", "m")
        if clusters_of(text, "m"):
            plain = convert(host, os.path.join(MODELS, model), "--name", "m", "--no-clusters")
            more.append(100 * (flash(text) / flash(plain) - 1))
    says = f"the example models take {min(more):.0f} to {max(more):.0f} % more flash"
    for page in (os.path.join("docs", "firmware.md"), os.path.join("docs", "design.md")):
        with open(os.path.join(ROOT, page), encoding="utf-8") as file:
            host.check(f"{page} says that {says}", says in " ".join(file.read().split()))


def corners_of(text):
    """How often each triangle is there, as its corners' positions, normals and colours."""
    vertices = list(zip(array(text, "m_positions")[0], array(text, "m_normals")[0]))
    if "m_colours[" in text:
        rows = re.findall(r"\{([^{}]*)\}", body(text, "m_colours"))
        vertices = [(*vertex, tuple(numbers(row))) for vertex, row in zip(vertices, rows)]
    return collections.Counter(tuple(vertices[i] for i in triangle) for triangle in array(text, "m_triangles")[0])


def test_clusters_of_pieces(host):
    host.write("big.obj", torus_text(320, 256))
    text = convert(host, "big.obj", warning=TOO_LARGE)
    for piece in range(2):
        clusters = clusters_of(text, "big", f"_{piece}")
        made = (f"static const glint_clusters big_clusters_{piece} = {{&glint_cull_cones, big_cluster_list_{piece}, "
                f"big_borrowers_{piece}, {len(clusters)}u}};\n")
        host.check(f"piece {piece} has clusters of its own",
                   len(clusters) > 500 and made in text and f"    &big_clusters_{piece},\n" in text)



def convert_anyhow(host, *arguments):
    """The header of a model that is perhaps not wound as it should be."""
    run = host.run("convert", *arguments, "--name", "m", "-o", "mesh.h")
    host.equal(f"convert {arguments}", run.returncode, 0)
    return host.read("mesh.h").decode()


def crumpled_torus(source):
    """Neighbours that turn by any angle, slivers, and triangles without area."""
    lines = [" ".join(["v", *(str(round(float(part) + source.uniform(-0.12, 0.12), source.choice([1, 6])))
                              for part in line.split()[1:])]) if line[0] == "v" else line
             for line in torus_text(40, 16).splitlines()]
    lines += ["v -2 -2 -2", "v 0 0 0", "v 2 2 2"] + [f"f -1 -2 -3\nf {i} -1 -2\nf -2 {i + 1} {i}" for i in range(1, 90, 9)]
    return "\n".join(lines) + "\n"


def test_nothing_seen_is_dropped(host):
    host.write("crumpled.obj", crumpled_torus(random.Random(1)))
    host.write("strip.obj", "".join(f"v {i} 0 {i * i / 40}\nv {i} 1 {i * i / 40}\n" for i in range(-40, 41)) +
               "".join(f"f {i} {i + 2} {i + 3} {i + 1}\n" for i in range(1, 160, 2)) + "f 1 3 5\nf 2 4 6\n")
    for name, model, count, *options in [
            ("torus", "torus:48x24", 12), ("small torus", "torus:10x6", 60), ("sphere", "sphere:32x16", 20),
            ("long cylinder", "cylinder-capped:40x3:1,50", 20), ("cone", "cone-capped:60x4", 20),
            ("crumpled torus", "crumpled.obj", 40),
            ("strip", "strip.obj", 40), ("teapot", os.path.join(MODELS, "teapot.obj"), 12),
            ("flat spot", os.path.join(MODELS, "spot.obj"), 6, "--scale", "1,0.1,3")]:
        text = convert_anyhow(host, model, *options)
        check_guarantee(host, name, array(text, "m_positions")[0], clusters_of(text, "m"), count)


def test_what_faces_away_is_dropped(host):
    """Seen from around, 2.5 times as far as a model reaches, of the triangles that face away."""
    for model, least in [("torus:96x48", 0.84), ("torus:48x24", 0.8), ("torus:24x12", 0.68), ("sphere:32x16", 0.84),
                         ("cylinder-capped:48x16", 0.95)]:
        text = convert(host, model, "--name", "m")
        positions, clusters = array(text, "m_positions")[0], clusters_of(text, "m")
        extent = [extent / 65536 for extent in numbers(re.search(r"\{(.*)\}, /\* extent", text).group(1))]
        source = random.Random(model)
        away = dropped = 0
        planes = [planes_of(positions, cluster) for cluster in clusters]
        for _ in range(30):
            line = [source.gauss(0, 1) for _ in range(3)]
            scale = 32768 * 2.5 * max(extent) / sum(part * part for part in line) ** 0.5
            eye = tuple(int(part * scale / along) for part, along in zip(line, extent))
            for cluster, own in zip(clusters, planes):
                facing_away = sum(dot(normal, eye) <= height for normal, height in own)
                away += facing_away
                dropped += facing_away if is_dropped(cluster, eye) else 0
        host.check(f"{model}: dropped", dropped >= least * away, f"{dropped} of {away}")


def test_meshes_without_clusters(host):
    for model, *options in [("torus:24x12", "--double-sided"), ("torus:24x12", "--no-clusters"), ("plane:1x1",),
                            ("plane:20x20",), ("box",), (os.path.join(MODELS, "glow.obj"),)]:
        text = convert(host, model, "--name", "m", *options)
        host.check(f"{model} {options} has none", "cluster_list" not in text and "borrowers" not in text and
                   text.endswith("    0, /* no clusters */\n    0, /* no layout */\n    0,\n    {0, 0},\n    {0, 0}, /* no texture */\n};\n\n#endif\n"))


def test_the_same_picture(host):
    for model in ("torus:48x24", "sphere:32x16", "cylinder-capped:24x1", os.path.join(MODELS, "spot.obj")):
        for view in ([], ["--eye", "0.7,0.9,1.1", "--fov", "100"], ["--rotate-y", "200", "--scale", "1,-1,2"]):
            plain = host.render_bytes(model, "--size", "96x64", "--no-clusters", *view)
            same = host.render_bytes(model, "--size", "96x64", *view) == plain
            host.check(f"{model} {' '.join(view)}: the picture", same)


def test_info_counts_clusters(host):
    for options in ([], ["--no-clusters"]):
        text = convert(host, "torus:24x12", "--name", "m", *options)
        lines = host.run("info", "torus:24x12", *options).stdout.split("\n\n")[0].splitlines()
        info = dict(line.split(" ", 1) for line in lines)
        host.equal(f"info {options}", (info["clusters"], info["flash_bytes"]),
                   (str(len(clusters_of(text, "m"))), str(flash(text))))
