# SPDX-License-Identifier: MIT
"""The normals that are made: which triangles share them, and weighted sums of facet normals in double precision."""
import math

from test_convert import convert, mesh
from test_shapes import cross, dot, minus

WEIGHTS = ("equal", "area", "angle")

# The corner (2, 3, 4) of a box: one triangle of the face towards +x has it, three towards +y, five towards +z.
BOX_CORNER = ([(2, 3, 4), (2, 0, 4), (2, 3, 0), (0, 3, 4), (0, 3, 0), (1, 3, 0), (0, 0, 4), (1, 0, 4), (1.5, 0, 4), (0, 1, 4)],
              [(0, 1, 2), (0, 2, 5), (0, 5, 4), (0, 4, 3), (0, 3, 9), (0, 9, 6), (0, 6, 7), (0, 7, 8), (0, 8, 1)])

# A slanted roof of triangles whose angles at its tip are acute, right and obtuse; the last has no area.
ROOF = ([(0, 0, 1), (3, 0, 0), (0.5, 1, 0.25), (-2, 2, 0), (-1, -1, -1), (0.125, -0.5, 0)],
        [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1), (0, 0, 1)])


def unit(v):
    length = math.sqrt(dot(v, v))
    return tuple(x / length for x in v)


def angle(a, b):
    return math.acos(dot(unit(a), unit(b)))


def averages(points, triangles, weights):
    """A normal for each point: the sum of the unit normals of its triangles, each times its weight."""
    sums = [(0.0, 0.0, 0.0)] * len(points)
    for corners in triangles:
        if len(set(corners)) < 3:
            continue
        for i in range(3):
            here, next_, last = (points[corners[(i + j) % 3]] for j in range(3))
            normal = cross(minus(next_, here), minus(last, here))
            weight = {"equal": 1.0, "area": math.sqrt(dot(normal, normal)) / 2,
                      "angle": angle(minus(next_, here), minus(last, here))}[weights]
            sums[corners[i]] = tuple(s + weight * n for s, n in zip(sums[corners[i]], unit(normal)))
    return [unit(s) for s in sums]


def object_text(points, triangles, normals=()):
    lines = ["v %r %r %r" % p for p in points] + ["vn %r %r %r" % n for n in normals]
    corner = "{0}//{0}" if normals else "{0}"
    return "\n".join(lines + ["f " + " ".join(corner.format(i + 1) for i in t) for t in triangles]) + "\n"


def test_weights_of_normals(host):
    for name, (points, triangles) in (("corner", BOX_CORNER), ("roof", ROOF)):
        host.write(f"{name}.obj", object_text(points, triangles))
        for weights in WEIGHTS:
            wanted = averages(points, triangles, weights)
            for more in (["--smooth"], ["--crease", "180"]):
                made, normals, *_ = mesh(convert(host, f"{name}.obj", "--weights", weights, *more), name)
                found = [normals[min(range(len(made)), key=lambda i: math.dist(made[i], p))] for p in points]
                wrong = max(abs(a - b) for got, normal in zip(found, wanted) for a, b in zip(got, normal))
                host.check(f"{name} by {weights} {' '.join(more)}", len(made) == len(points) and wrong <= 0.5001 / 32767,
                           f"{len(made)} vertices, {wrong * 32767} steps")
        tips = [averages(points, triangles, weights)[0] for weights in WEIGHTS]
        host.check(f"{name}: the three differ", all(dot(a, b) < 0.999 for a, b in zip(tips, tips[1:] + tips[:1])), str(tips))
    count = unit((1.0, 3.0, 5.0))
    host.check("equal weights count triangles", all(abs(a - b) < 1e-12 for a, b in zip(averages(*BOX_CORNER, "equal")[0], count)))


def test_weights_are_drawn(host):
    points, triangles = ROOF
    host.write("roof.obj", object_text(points, triangles))
    pictures = []
    for weights in WEIGHTS:
        host.write("given.obj", object_text(points, triangles, averages(points, triangles, weights)))
        pictures.append(host.render_bytes("roof.obj", "--smooth", "--weights", weights))
        host.equal(f"drawn by {weights}", pictures[-1], host.render_bytes("given.obj"))
        host.equal(f"info by {weights}", host.info("roof.obj", "--smooth", "--weights", weights)["vertices"], "6")
    host.equal("the three pictures differ", len(set(pictures)), 3)
    host.equal("by angle without the option", host.render_bytes("roof.obj", "--smooth"), pictures[WEIGHTS.index("angle")])


def test_weights_are_in_the_head(host):
    host.write("roof.obj", object_text(*ROOF))
    for weights in WEIGHTS:
        host.check(f"head by {weights}", f"glint convert roof.obj --weights {weights}\n" in convert(host, "roof.obj", "--weights", weights))


def normals_at(host, text, *options):
    """The set of normals of all vertices at each position of OBJ text, as steps of the header."""
    host.write("t.obj", text)
    positions, normals, *_ = mesh(convert(host, "t.obj", *options), "t")
    found = {}
    for position, normal in zip(positions, normals):
        found.setdefault(tuple(round(x, 3) for x in position), set()).add(tuple(round(32767 * x) for x in normal))
    return found


UP, LEFT = (0, 0, 32767), (-32767, 0, 0)
HINGE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -1\n"  # two triangles that meet at (0, 0, 0) and (0, 1, 0), at 90 degrees
BOTH = (round(-32767 / math.sqrt(2)), 0, round(32767 / math.sqrt(2)))


def test_smoothing_groups(host):
    """A modeller's hard and soft edges stay what they are, whatever their angle."""
    for name, before, between, wanted in [
            ("groups 1 and 2", "s 1\n", "s 2\n", {UP, LEFT}), ("off", "s off\n", "", {UP, LEFT}), ("0", "s 0\n", "", {UP, LEFT}),
            ("one group", "s 7\n", "", {BOTH}), ("one group, again", "s 7\n", "s 1\ns 7\n", {BOTH}),
            ("off behind a group", "s 1\n", "s off\n", {UP, LEFT}), ("a group behind none", "", "s 1\n", {UP, LEFT}),
            ("none", "", "", {UP, LEFT}), ("an object in between", "s 1\n", "o a\ng b\n", {BOTH})]:
        text = f"{HINGE}{before}f 1 2 3\n{between}f 1 3 4\n"
        found = normals_at(host, text)
        host.equal(f"s: {name}", (found[0, 0, 0], found[0, 1, 0]), (wanted, wanted))
        host.equal(f"s: {name}, --smooth", normals_at(host, text, "--smooth")[0, 0, 0], {BOTH})
        host.equal(f"s: {name}, --flat", normals_at(host, text, "--flat")[0, 0, 0], {UP, LEFT})
    given = HINGE + "vn 0 0 1\ns 1\nf 1//1 2//1 3//1\nf 1 3 4\n"
    host.equal("s: given normals stay", normals_at(host, given)[0, 0, 0], {UP, BOTH})


def test_sharp_edges_without_smoothing_groups(host):
    """An edge of more than 40 degrees is sharp unless something says otherwise: boxes have edges, cylinders are round."""
    for degrees, count in ((30, 1), (39.9, 1), (40.1, 2), (60, 2)):
        x, z = -math.cos(math.radians(degrees)), -math.sin(math.radians(degrees))
        found = normals_at(host, f"v 0 0 0\nv 1 0 0\nv 0 1 0\nv {x} 0 {z}\nf 1 2 3\nf 1 3 4\n")
        host.equal(f"an edge of {degrees} degrees", len(found[0, 0, 0]), count)


def test_corners_of_a_cube(host):
    """A corner's normal leans to no side because of how the quads there were cut into triangles."""
    points = "".join(f"v {x} {y} {z}\n" for z in (1, -1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
    quads = [(1, 2, 3, 4), (6, 5, 8, 7), (2, 6, 7, 3), (5, 1, 4, 8), (4, 3, 7, 8), (5, 6, 2, 1)]
    for cuts in range(0, 64, 7):
        faces = ""
        for i, quad in enumerate(quads):
            a, b, c, d = quad[cuts >> i & 1:] + quad[:cuts >> i & 1]
            faces += f"f {a} {b} {c}\nf {a} {c} {d}\n"
        found = normals_at(host, points + "s 1\n" + faces)
        wrong = [p for p in found if found[p] != {tuple(round(18918 * x) for x in p)}]
        host.equal(f"corners of a cube cut by {cuts:06b}", (len(found), wrong), (8, []))


def test_slivers_between_triangles(host):
    """Triangles without area, as of a polygon with corners in a row, neither split a smooth edge nor bend its normals."""
    bent = "v 0 0 0\nv 4 0 0\nv 4 1 -0.3\nv 0 1 -0.3\nv 4 -1 -0.3\nv 0 -1 -0.3\nv 1 0 0\nv 2 0 0\nv 3 0 0\n"
    far = "f 1 2 3\nf 1 3 4\n"
    near = "f 6 8 1\nf 6 5 8\nf 5 2 8\n"
    plain = normals_at(host, bent + "f 1 2 3 4\nf 6 5 2 1\n")
    for name, slivers in [("one", "f 1 8 2\n"), ("turned", "f 2 1 8\n"), ("a point twice", "f 1 8 8\nf 1 8 2\n"),
                          ("in a row", "f 1 7 8\nf 1 8 2\n"), ("rounded", "f 1 8 2\n")]:
        points = bent.replace("v 2 0 0", "v 2 0 1e-7") if name == "rounded" else bent
        found = normals_at(host, points + far + near + slivers)
        host.equal(f"slivers: {name}", [found[p] for p in ((0, 0, 0), (4, 0, 0))], [plain[p] for p in ((0, 0, 0), (4, 0, 0))])
        host.equal(f"slivers: {name}, on the edge", found[2, 0, 0], plain[0, 0, 0])
