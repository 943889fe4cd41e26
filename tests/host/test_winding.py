# SPDX-License-Identifier: MIT
"""Normals that are made, and the winding: reported and repaired."""
import os
import random

from harness import MODELS, SQUARE, torus_text
from test_convert import convert, mesh
from test_obj import CUBE_F, CUBE_V, CUBE_VIEW

FACES = CUBE_F.splitlines()


def turned(face):
    return "f " + " ".join(reversed(face.split()[1:]))


def cube(which):
    """A cube with the faces of these numbers turned round."""
    return CUBE_V + "\n".join(turned(face) if i in which else face for i, face in enumerate(FACES)) + "\n"


def moved(text, step):
    return "\n".join(f"v {float(w[1]) + step} {w[2]} {w[3]}" if (w := line.split())[0] == "v" else
                     "f " + " ".join(str(int(i) + 8) for i in w[1:]) for line in text.splitlines()) + "\n"


def winding(host, name, *options):
    info = host.info(name, *options)
    return tuple(int(info[key]) for key in ("parts", "mixed_parts", "inward_parts", "one_sided_parts", "triangles_turned"))


def test_report(host):
    for name, text, wanted in [
            ("good", cube([]), (1, 0, 0, 0, 0)), ("mixed", cube([2]), (1, 1, 0, 0, 0)),
            ("inward", cube(range(6)), (1, 0, 1, 0, 0)), ("two", cube([1]) + moved(cube(range(6)), 4), (2, 1, 1, 0, 0)),
            ("open", SQUARE, (1, 0, 0, 0, 0))]:
        host.write(name + ".obj", text)
        host.equal(f"info of {name}", winding(host, name + ".obj"), wanted)
        run = host.run("convert", name + ".obj", "-o", "x.h")
        warning = f"{name}.obj:0: warning: of {wanted[0]} connected parts {wanted[1]} are wound inconsistently and " \
                  f"{wanted[2]} inside out: see --repair\n" if wanted[1] + wanted[2] else ""
        host.equal(f"convert of {name} warns", (run.returncode, run.stderr), (0, warning))
        run = host.run("convert", name + ".obj", "--repair", "-o", "x.h")
        host.equal(f"repaired {name} needs no warning", (run.returncode, run.stderr), (0, ""))


def test_repair(host):
    host.write("good.obj", cube([]))
    wanted = host.render_bytes("good.obj", *CUBE_VIEW, "--flat")
    for faces in ([0], [1, 4], [0, 1, 2], [0, 1, 2, 3, 4], range(6)):
        host.write("bad.obj", cube(faces))
        host.equal(f"cube with {list(faces)} turned", winding(host, "bad.obj", "--repair"), (1, 0, 0, 0, 2 * len(faces)))
        host.equal("its picture", host.render_bytes("bad.obj", *CUBE_VIEW, "--flat", "--repair"), wanted)
    host.write("two.obj", cube([1]) + moved(cube(range(6)), 4))
    host.equal("parts are repaired one by one", winding(host, "two.obj", "--repair"), (2, 0, 0, 0, 14))
    host.equal("what is right stays", winding(host, "good.obj", "--repair")[4], 0)
    dice = random.Random(7)
    lines = [turned(line) if line[0] == "f" and dice.random() < 0.5 else line for line in torus_text(24, 12).splitlines()]
    host.write("shuffled.obj", "\n".join(lines))
    host.write("torus.obj", torus_text(24, 12))
    host.equal("a shuffled torus", winding(host, "shuffled.obj", "--repair")[:4], (1, 0, 0, 0))
    positions, normals, *_ = mesh(convert(host, "shuffled.obj", "--repair"), "shuffled")
    outward = all(n[2] * p[2] > -1e-3 for p, n in zip(positions, normals))
    host.check("its normals point out of the tube", outward)
    for name in ("teapot", "spot", "spot-control", "featuretype"):
        host.equal(f"{name} is right", winding(host, os.path.join(MODELS, name + ".obj"), "--repair")[1:], (0, 0, 0, 0))


def test_repair_of_open_and_one_sided_parts(host):
    quad = "v {0} 0 0\nv {1} 0 0\nv {1} 1 0\nv {0} 1 0\n"
    strip = "".join(quad.format(i, i + 1) for i in range(3)) + "f 1 2 3 4\nf 8 7 6 5\nf 9 10 11 12\n"
    host.write("strip.obj", strip)
    host.equal("a flat strip keeps what most of it has", winding(host, "strip.obj", "--repair"), (1, 0, 0, 0, 2))
    positions, normals, *_ = mesh(convert(host, "strip.obj", "--repair"), "strip")
    host.check("and its side", len(positions) == 8 and all(n[2] > 0.99 for n in normals))
    host.write("bowl.obj", cube([0, 2]).replace(turned(FACES[0]) + "\n", "").replace(FACES[3] + "\n", turned(FACES[3]) + "\n"))
    host.equal("an open box faces away from its middle", winding(host, "bowl.obj", "--repair"), (1, 0, 0, 0, 4))
    around = 8
    points = "".join(f"v {x} {y} {z}\n" for x, y, z in moebius(around))
    faces = [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(around - 1)] + [(2 * around - 2, 2 * around - 1, 0, 1)]
    host.write("moebius.obj", points + "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces))
    host.equal("a Moebius strip is one-sided", winding(host, "moebius.obj", "--repair"), (1, 1, 0, 1, 0))
    run = host.run("convert", "moebius.obj", "--repair", "-o", "x.h")
    os.remove(host.path("x.h"))
    host.equal("which is reported", (run.returncode, run.stderr), (0, "moebius.obj:0: warning: of 1 connected parts 1 are "
                                                                   "wound inconsistently and 0 inside out\n"))


def moebius(around):
    from math import cos, pi, sin  # pylint: disable=import-outside-toplevel # the only test that takes them
    for i in range(around):
        u = 2 * pi * i / around
        for side in (-0.4, 0.4):
            yield (1 + side * cos(u / 2)) * cos(u), (1 + side * cos(u / 2)) * sin(u), side * sin(u / 2)


def test_given_normals_follow_the_repair(host):
    normals = "vn 0 0 1\nvn 0 0 -1\nvn 1 0 0\nvn -1 0 0\nvn 0 1 0\nvn 0 -1 0\n"

    def text(side, which):
        faces = [face.split()[1:] for face in cube(which).splitlines() if face[0] == "f"]
        rows = ["f " + " ".join(f"{i}//{n + 1}" for i in face) for n, face in enumerate(faces)]
        return CUBE_V + (normals if side > 0 else normals.replace("-", "+").replace(" 1", " -1").replace("+", "")) + "\n".join(rows)

    host.write("good.obj", text(1, []))
    wanted = host.render_bytes("good.obj", *CUBE_VIEW)
    host.write("faces.obj", text(1, [0, 3]))
    host.equal("right normals on turned faces stay", host.render_bytes("faces.obj", *CUBE_VIEW, "--repair"), wanted)
    host.write("inward.obj", text(-1, range(6)))
    host.equal("normals that point inwards are turned too", host.render_bytes("inward.obj", *CUBE_VIEW, "--repair"), wanted)


def test_facets(host):
    host.write("cube.obj", cube([]))
    positions, normals, triangles, _, _ = mesh(convert(host, "cube.obj", "--flat"), "cube")
    host.equal("a cube's facets", (len(positions), len(triangles)), (24, 12))
    host.check("their normals", {tuple(round(v) for v in n) for n in normals} ==
               {(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)})
    host.equal("--flat overrides normals", host.info(os.path.join(MODELS, "teapot.obj"), "--flat")["normals"], "given")
    host.equal("--flat is --crease 0 on a cube", host.render_bytes("cube.obj", *CUBE_VIEW, "--flat"),
               host.render_bytes("cube.obj", *CUBE_VIEW, "--crease", "0"))
