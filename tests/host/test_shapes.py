# SPDX-License-Identifier: MIT
"""Shapes in place of a file: counts, sizes and normals of each."""
from math import isclose

from test_convert import convert, mesh

# Name, vertices, triangles, half sizes, boundary edges.
SHAPES = [
    ("torus:24x12", 288, 576, (1.4, 1.4, 0.4), 0), ("torus:8x4:3,1", 32, 64, (4, 4, 1), 0),
    ("sphere:32x16", 482, 960, (1, 1, 1), 0), ("sphere:8x4:2.5", 26, 48, (2.5, 2.5, 2.5), 0),
    ("cylinder:16x2", 48, 64, (1, 1, 1), 32), ("cylinder:16x2:0.5,3", 48, 64, (0.5, 0.5, 3), 32),
    ("cylinder-capped:16x2", 82, 96, (1, 1, 1), 0), ("cylinder-capped:4x1:2,1", 18, 16, (2, 2, 1), 0),
    ("cone:16x2", 48, 48, (1, 1, 1), 16), ("cone-capped:16x2:1,2", 65, 64, (1, 1, 2), 0),
    ("plane:4x3", 20, 24, (1, 1, 0), 14), ("plane:1x1:7,0.5", 4, 2, (7, 0.5, 0), 4),
    ("box", 24, 12, (1, 1, 1), 0), ("box:1,2,3", 24, 12, (1, 2, 3), 0),
]


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def test_counts_and_sizes(host):
    for name, vertices, triangles, half, boundary in SHAPES:
        info = host.info(name)
        host.equal(f"{name} counts", (info["vertices"], info["triangles"], info["triangles_dropped"]),
                   (str(vertices), str(triangles), "0"))
        host.equal(f"{name} edges", (info["boundary_edges"], info["inconsistent_edges"], info["shared_edges"]),
                   (str(boundary), "0", "0"))
        host.equal(f"{name} parts", (info["parts"], info["mixed_parts"], info["inward_parts"]), ("1", "0", "0"))
        host.equal(f"{name} keeps the generator's steps", info["largest_move"], "0")
        high = [float(v) for v in info["highest"].split()]
        host.check(f"{name} sizes", all(isclose(a, b, abs_tol=1e-4 * max(half)) for a, b in zip(high, half)), str(high))
        host.check(f"{name} is drawn", len(host.render(name, "--eye", "3,2,9", "--size", "48x36").levels()) > 1)


def test_normals(host):
    """Outward, and within what a facet can turn from the surface that it stands for."""
    for name, *_ in SHAPES:
        positions, normals, triangles, _, _ = mesh(convert(host, name, "--name", "m"), "m")
        for corners in triangles:
            a, b, c = (positions[i] for i in corners)
            facet = cross(minus(b, a), minus(c, a))
            length = dot(facet, facet) ** 0.5
            cosines = [dot(facet, normals[i]) / length for i in corners]
            if min(cosines) < 0.45 or max(cosines) < 0.65:
                host.check(f"{name} normals", False, f"triangle {corners}: {cosines}")
                break
        else:
            host.check(f"{name} normals", all(abs(dot(n, n) - 1) < 2e-4 for n in normals))


def test_options_apply(host):
    plain, scaled = host.info("box"), mesh(convert(host, "box", "--name", "m", "--scale", "2,3,4"), "m")
    host.equal("a shape can be scaled", [round(max(p[a] for p in scaled[0]), 3) for a in range(3)], [2, 3, 4])
    host.equal("a shape's normals are its own", plain["normals"], "given")
    host.check("--flat splits", int(host.info("sphere:8x4", "--flat")["vertices"]) > 4 * 26)
    host.equal("--crease joins", host.info("box", "--crease", "180")["vertices"], "24")
    host.write("box", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    host.equal("a file of a shape's name has a folder", host.info("./box")["triangles"], "1")
    host.check("a name that only begins like a shape is a file",
               "cannot be opened" in host.run("info", "toruses:8x8").stderr and "cannot be opened" in host.run("info", "torus").stderr)


def test_help(host):
    text = host.run("help").stdout
    for name in ("torus", "sphere", "cylinder", "cylinder-capped", "cone", "cone-capped", "plane"):
        host.check(f"help names {name}", f"\n  {name}:" in text)
    host.check("help names box", "\n  box[:X,Y,Z]" in text)
    for kind in ("dir:x,y,z", "point:x,y,z", "spot:x,y,z:ax,ay,az:inner,outer"):
        host.check(f"help names {kind}", f"\n    {kind}[" in text)


def test_no_shape_and_no_file(host):
    """Who guesses a shape's name is told those that there are."""
    run = host.run("render", "cube", "-o", "out.png")
    host.check("cube", run.returncode == 2 and all(f" {name}" in run.stderr for name in ("torus:NxM", "sphere:NxM", "plane:NxM", "box")) and
               run.stderr.count("\n") == 1, run.stderr)
    host.check("cube.obj is a file's name", "box" not in host.run("info", "cube.obj").stderr)
