# SPDX-License-Identifier: MIT
"""--weights: the normals that are made, against weighted sums of facet normals in double precision."""
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
            for more in ([], ["--crease", "180"]):
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
        pictures.append(host.render_bytes("roof.obj", "--weights", weights))
        host.equal(f"drawn by {weights}", pictures[-1], host.render_bytes("given.obj"))
        host.equal(f"info by {weights}", host.info("roof.obj", "--weights", weights)["vertices"], "6")
    host.equal("the three pictures differ", len(set(pictures)), 3)
    host.equal("by area without the option", host.render_bytes("roof.obj"), pictures[WEIGHTS.index("area")])


def test_weights_are_in_the_head(host):
    host.write("roof.obj", object_text(*ROOF))
    for weights in WEIGHTS:
        host.check(f"head by {weights}", f"glint convert roof.obj --weights {weights}\n" in convert(host, "roof.obj", "--weights", weights))
