# SPDX-License-Identifier: MIT
"""Positions made one, and meshes of fewer triangles: --weld and --simplify."""
import math
import os
import re
import subprocess

from harness import Host, torus_text
from test_convert import array, convert, mesh
from test_shapes import cross, minus


def off_torus(point):
    """Distance of a point from the torus of torus_text, and the normal there."""
    x, y, z = point
    around = math.hypot(x, y)
    ring = ((around - 1) * x / around, (around - 1) * y / around, z)
    length = math.hypot(*ring)
    return abs(length - .4), [v / length for v in ring]


def first_uses(triangles):
    """The vertices in the order in which triangles come to them."""
    return list(dict.fromkeys(i for t in triangles for i in t))


def test_simplified_torus(host):
    host.write("torus.obj", torus_text(64, 32))
    errors = []
    for most in (4095, 1000, 300):
        text = convert(host, "torus.obj", "--simplify", str(most), "--no-clusters")
        positions, normals, triangles, _, _ = mesh(text, "torus")
        info = host.info("torus.obj", "--simplify", str(most))
        host.check(f"{most} at most", most * .9 <= len(triangles) <= most, str(len(triangles)))
        host.equal(f"{most}: still closed", (info["boundary_edges"], info["inconsistent_edges"], info["inward_parts"]), ("0", "0", "0"))
        host.equal(f"{most}: counts", (info["triangles_read"], info["triangles"]), ("4096", str(len(triangles))))
        host.equal(f"{most}: vertices in the order of triangles", first_uses(triangles), list(range(len(positions))))
        far = max(off_torus(p)[0] for p in positions)
        host.check(f"{most}: vertices stay on it", far < 1e-4, str(far))
        turned = max(abs(a - b) for p, n in zip(positions, normals) for a, b in zip(off_torus(p)[1], n))
        host.check(f"{most}: normals are the surface's", turned < .01, str(turned))
        errors.append(float(info["geometric_error"]))
        host.check(f"{most}: the head says so", " --simplify %d --no-clusters\n" % most in text and
                   f"\n * Simplified from 4096 triangles: geometric error {info['geometric_error']}, in units of the source.\n" in text)
        middles = [[sum(positions[i][a] for i in t) / 3 for a in range(3)] for t in triangles]
        worst = max(off_torus(p)[0] for p in middles)
        if most < 4000:  # before, what is measured is how coarse the model was
            host.check(f"{most}: the error is what middles are off by", worst / 3 < errors[-1] < 3 * worst, f"{worst} {errors}")
    host.check("fewer triangles, more error", errors == sorted(errors), str(errors))
    host.check("the same bytes", convert(host, "torus.obj", "--simplify", "300", "--no-clusters") == text)


def test_units_of_the_error(host):
    for name, factor in (("mm", 1000), ("far", 1)):
        host.write(name + ".obj", re.sub(r"^v (\S+) (\S+) (\S+)$", lambda m, f=factor, n=name: "v " + " ".join(
            repr(f * float(v) + (5000 if n == "far" else 0)) for v in m.groups()), torus_text(32, 16), flags=re.MULTILINE))
    host.write("torus.obj", torus_text(32, 16))
    options = ["--simplify", "200"]
    plain = float(host.info("torus.obj", *options)["geometric_error"])
    for name, options, wanted in [("mm.obj", [], 1000 * plain), ("torus.obj", ["--scale", "50"], plain), ("far.obj", [], plain)]:
        got = float(host.info(name, "--simplify", "200", *options)["geometric_error"])
        host.check(f"{name} {options}: in the file's units", abs(got / wanted - 1) < .01, f"{got} {wanted}")


def cube_text(count, colours=False):
    """A cube of side 2, faces cut into count x count squares; the face at x = 1 is of another material; or two colours."""
    lines, faces = ["mtllib cube.mtl"], []
    for axis in range(3):
        for side in (-1, 1):
            faces.append("usemtl one" if (axis, side) == (0, 1) else "usemtl rest")
            base = sum(line.startswith("v") for line in lines) + 1
            for i in range(count + 1):
                for j in range(count + 1):
                    point = [0.0] * 3
                    point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, side * (2 * i / count - 1), 2 * j / count - 1
                    lines.append("v %r %r %r" % tuple(point) + (f" {i % 2} 0 1" if colours else ""))
            faces += ["f %d %d %d %d" % tuple(base + k for k in (a, a + count + 1, a + count + 2, a + 1))
                      for a in (i * (count + 1) + j for i in range(count) for j in range(count))]
    return "\n".join(lines + faces) + "\n"


def test_edges_and_materials(host):
    host.write("cube.mtl", "newmtl one\nKd 1 0 0\nnewmtl rest\nKd 0 1 0\n")
    host.write("cube.obj", cube_text(8))
    info = host.info("cube.obj", "--weld", "0", "--crease", "30")
    host.equal("the cube", (info["triangles"], info["boundary_edges"], info["inward_parts"], info["positions_welded"]),
               ("768", "0", "0", str(6 * 81 - 386)))
    text = convert(host, "cube.obj", "--crease", "30", "--simplify", "12", "--no-clusters", "--name", "t")
    info = host.info("cube.obj", "--crease", "30", "--simplify", "12")
    host.equal("a cube of 12 triangles", (info["triangles"], info["boundary_edges"], info["geometric_error"], info["pieces"]),
               ("12", "0", "0", "2"))
    extent = [int(v) / 65536 for v in re.search(r"\{(.*)\}, /\* extent", text).group(1).split(",")]
    for name, count in (("one", 2), ("rest", 10)):
        steps, _ = array(text, "t_positions_" + name)
        normals, _ = array(text, "t_normals_" + name)
        triangles, _ = array(text, "t_triangles_" + name)
        points = [[round(e * s / 32768, 3) for e, s in zip(extent, step)] for step in steps]
        host.equal(f"{name}: triangles", len(triangles), count)
        host.check(f"{name}: corners", all(abs(c) == 1 for p in points for c in p) and
                   all((min(points[i][0] for i in t) == 1) == (name == "one") for t in triangles), str(points))
        host.check(f"{name}: edges are sharp", all(sorted(map(abs, n)) == [0, 0, 32767] for n in normals) and
                   all(points[i][a] * normals[i][a] == 32767 for i in range(len(points)) for a in range(3) if normals[i][a]), str(normals))
    host.write("stripes.obj", cube_text(4, colours=True))
    info = host.info("stripes.obj", "--simplify", "150")
    host.equal("colours stay", (info["colours"], info["triangles_read"], int(info["triangles"]) <= 150), ("given", "192", True))


def test_too_few(host):
    host.write("torus.obj", torus_text(8, 8))
    host.refuses("a torus of 1", ["convert", "torus.obj", "--simplify", "1", "-o", "out.h"],
                 r"torus\.obj:0: --simplify 1: (nothing would be left of it|it cannot be brought to fewer than \d+ triangles)")
    for value in ("0", "-1", "x", "4000001", "1.5"):
        host.refuses(f"--simplify {value}", ["info", "torus.obj", "--simplify", value],
                     rf"glint: --simplify {value}: takes triangles from 1 to 4000000")
    plain, many = (convert(host, "torus.obj", *options) for options in ([], ["--simplify", "128"]))
    host.equal("as many as there are", many[many.index("#ifndef"):], plain[plain.index("#ifndef"):])
    host.write("tops.obj", "".join(f"v {i} 0 0\nv {i + .5} 0 0\nv {i} 1 0\nv {i} 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n"
                                   for i in range(50)))
    run = host.run("info", "tops.obj", "--simplify", "3")
    host.check("many parts", run.returncode in (0, 2) and run.stderr.count("\n") <= 1 and
               (run.returncode == 2 or int(re.search(r"\ntriangles (\d+)", run.stdout).group(1)) <= 3), run.stderr)


def refuse_to_simplify(bare):
    bare.write("torus.obj", torus_text(8, 8))
    bare.refuses("it is said what is missing", ["info", "torus.obj", "--simplify", "100"],
                 r"torus\.obj:0: --simplify: install libmeshoptimizer-dev, and run make host again")
    run = bare.run("info", "torus.obj", "--simplify", "128")
    bare.equal("not where nothing is to be done", run.returncode, 0)
    libraries = subprocess.run(["ldd", bare.program], capture_output=True, text=True, check=True).stdout
    bare.check("it takes no library of others", not re.search("meshopt|assimp|stdc", libraries), libraries)


def rough_terrain(side):
    """Heights on a grid, seen from above: slopes of up to 2 in 1."""
    lines = []
    for z in range(side + 1):
        for x in range(side + 1):
            lines.append(f"v {x / 10:.1f} {.2 * math.sin(17.3 * x * x + 5.7 * z * x + 2.1 * z * z):.4f} {z / 10:.1f}")
    for z in range(side):
        for x in range(side):
            a = z * (side + 1) + x + 1
            lines.append(f"f {a} {a + side + 1} {a + 1}\nf {a + 1} {a + side + 1} {a + side + 2}")
    return "\n".join(lines) + "\n"


def test_terrain_is_not_folded(host):
    """A landscape seen from above has no holes: no triangle is turned over, or stands on edge."""
    host.write("land.obj", rough_terrain(40))
    for most in (1600, 800, 400):
        positions, _, triangles, _, _ = mesh(convert(host, "land.obj", "--simplify", str(most), "--no-clusters"), "land")
        up = [cross(minus(positions[b], positions[a]), minus(positions[c], positions[a]))[1] for a, b, c in triangles]
        host.equal(f"triangles of {most} that do not face up", sum(y <= 0 for y in up), 0)
        info = host.info("land.obj", "--simplify", str(most))
        host.equal(f"{most}: one surface still", (info["parts"], info["inconsistent_edges"], info["shared_edges"]), ("1", "0", "0"))


def test_without_meshoptimizer(host):
    bare = Host(os.path.join(os.path.dirname(host.program), "glint-without-scenes"))
    bare.test("without meshoptimizer", refuse_to_simplify)
    host.passed += bare.passed
    host.failed += bare.failed


def weld(host, text, distance):
    host.write("w.obj", text)
    info = host.info("w.obj", "--weld", distance)
    return int(info["positions"]), int(info["positions_welded"]), int(info["boundary_edges"])


def test_weld(host):
    gap = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0.001 0\nv 1 1.001 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n"
    host.equal("a gap within the distance", weld(host, gap, "0.0011"), (4, 2, 4))
    host.equal("a gap beyond it", weld(host, gap, "0.0009"), (6, 0, 6))
    host.equal("far from the origin", weld(host, re.sub(r"^v ", "v -1000", gap, flags=re.MULTILINE), "0.0011"), (4, 2, 4))
    for order in ("2 1 3", "3 2 1", "1 3 2"):
        other = re.sub(r"^v (\S+) (\S+) (\S+)$", lambda m, o=order: "v " + " ".join(m.group(int(i)) for i in o.split()), gap, flags=re.MULTILINE)
        host.equal(f"along another axis, {order}", weld(host, other.replace("0.001", "-0.0005").replace("1.001", "0.9995"), "0.0011"), (4, 2, 4))
    same = gap.replace(".001", "")
    host.equal("equal ones", weld(host, same, "0"), (4, 2, 4))
    host.equal("none is moved by 0", weld(host, gap, "0"), (6, 0, 6))
    painted = re.sub(r"^v (.*)$", lambda m: m.group(0) + (" 1 0 0" if m.group(1).startswith("0 0 0") else " 0 0 1"), same, flags=re.MULTILINE)
    host.equal("colours differ", weld(host, painted.replace("v 0 0 0 1 0 0", "v 0 0 0 0 1 0", 1), "0"), (5, 1, 4))
    host.equal("zeros of either sign", weld(host, same.replace("v 0 0 0", "v -0 -0 -0", 1), "0"), (4, 2, 4))
    chain = "v 0 0 0\nv 0.6 0 0\nv 1.2 0 0\nv 0 5 0\nv 3 5 0\nf 1 4 5\nf 2 4 5\nf 3 4 5\n"
    host.write("w.obj", chain)
    positions = mesh(convert(host, "w.obj", "--weld", "1", "--no-clusters", warning=r"w\.obj:0: warning: .* wound inconsistently .*\n"), "w")[0]
    host.equal("each joins the first that stays", sorted(round(p[0], 2) for p in positions if p[1] < 1), [0, 1.2])
    host.check("the head says so", " --weld 1 --no-clusters\n" in convert(host, "w.obj", "--weld", "1", "--no-clusters", warning=r"w\.obj:0: warning: .* wound inconsistently .*\n"))
    host.write("w.obj", gap.replace("v 0 1 0", "v 0 1 -1"))
    for distance, wanted in (("0.01", 4), ("0", 6)):
        positions = mesh(convert(host, "w.obj", "--weld", distance, "--crease", "180"), "w")[0]
        host.equal(f"normals are averaged over what is joined: {distance}", len(positions), wanted)
    for value in ("-1", "x", "nan", ""):
        host.refuses(f"--weld {value}", ["info", "w.obj", "--weld", value], rf"glint: --weld {value}: takes a distance from 0")
