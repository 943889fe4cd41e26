# SPDX-License-Identifier: MIT
"""Where a model is put, and how large: --up-axis, --centre, --scale, --rotate-x, -y, -z, and what is done unasked."""
import os
import re

import png
from harness import MODELS, torus_text
from test_convert import mesh

# Seven points of a lopsided solid, and triangles of which none hides behind a symmetry.
POINTS = [(-.7, -.5, -.4), (.8, -.5, -.3), (.1, .9, .2), (.3, -.4, .9), (-.2, .3, -.8)]
FACES = "s 1\nf 1 5 2\nf 2 5 3\nf 3 5 1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


def text(change=lambda p: p):
    return "".join("v " + " ".join(f"{c:.17g}" for c in change(p)) + "\n" for p in POINTS) + FACES


def differ(a, b):
    """Largest difference of a level between two pictures."""
    return max(abs(x - y) for p, q in zip(a.rows, b.rows) for s, t in zip(p, q) for x, y in zip(s, t))


def noted(host, name, *options, pattern):
    """The picture of a model that is scaled to fit, which is said in one line."""
    run = host.run("render", name, *options, "-o", "placed.png")
    host.check(f"{name} {' '.join(options)} is said to be scaled", run.returncode == 0 and
               re.fullmatch(re.escape(name) + pattern, run.stderr) is not None, f"{run.returncode} {run.stderr!r}")
    image = png.decode(host.read("placed.png"))
    os.remove(host.path("placed.png"))
    return image


NOTE = r":\d: note: coordinates reach \S+, sides \S+: drawn at {} of its size, \S+ at the origin\n"


def test_any_size_and_place(host):
    host.write("one.obj", text())
    for options in ([], ["--size", "100x200", "--fov", "20"], ["--rotate-x", "30", "--rotate-z", "110"]):
        plain = host.render("one.obj", *options)
        for name, factor, offset, drawn in [("tiny", 1e-6, 0, "1e+06"), ("huge", 1e7, 0, "1e-07"), ("smaller", 1e-12, 0, "1e+12"),
                                            ("larger", 1e20, 0, "1e-20"), ("far", 1, 1e7, "1"), ("far and huge", 1e7, 3e9, "1e-07"),
                                            ("far and tiny", 1e-3, 50, "1000")]:
            host.write("other.obj", text(lambda p, f=factor, o=offset: (p[0] * f + o, p[1] * f - o, p[2] * f + 2 * o)))
            image = noted(host, "other.obj", *options, pattern=NOTE.format(re.escape(drawn)))
            host.check(f"{name} is drawn as what is of size 1 {options}", differ(image, plain) <= 1, str(differ(image, plain)))
        host.write("other.obj", text(lambda p: (p[0] + 2000, p[1], p[2] - 20000)))
        host.check(f"far, but within Q16.16 {options}", differ(host.render("other.obj", *options), plain) <= 1)
    host.write("huge.obj", text(lambda p: tuple(1e7 * c for c in p)))
    run = host.run("info", "huge.obj")
    host.check("info says so too", re.fullmatch("huge.obj" + NOTE.format("1e-07"), run.stderr) is not None, run.stderr)
    host.check("info keeps the file's units", "\nlowest -7e+06 -5e+06 -8e+06\nhighest 8e+06 9e+06 9e+06\n" in run.stdout, run.stdout)
    host.write("large.obj", text(lambda p: tuple(30000 * c for c in p)))
    noted(host, "large.obj", pattern=NOTE.format("0.0001"))
    host.equal("with --eye nothing that fits is scaled", host.run("render", "large.obj", "--eye", "0,0,30000", "-o",
                                                                 "placed.png").stderr, "")
    os.remove(host.path("placed.png"))
    noted(host, "huge.obj", "--eye", "0,0,5", pattern=NOTE.format("1e-07"))


def test_convert_says_what_to_do(host):
    host.write("huge.obj", text(lambda p: tuple(1e7 * c for c in p)))
    host.refuses("convert a huge model", ["convert", "huge.obj", "-o", "out.h"],
                 r"huge\.obj:3: coordinates reach 9e\+06, beyond the 32766 that fit Q16\.16: give --scale fit, or 0\.0036 at most")
    for options in (["--scale", "fit"], ["--scale", "0.0036"]):
        run = host.run("convert", "huge.obj", *options, "-o", "out.h")
        host.equal(f"{options} does it", (run.returncode, run.stderr), (0, ""))
    run = host.run("convert", "huge.obj", "--scale", "fit", "-o", "huge.h")
    header = host.read("huge.h").decode()
    os.remove(host.path("huge.h"))
    host.check("--scale fit is in the head", "\n *     glint convert huge.obj --scale fit\n" in header)
    worst = max(abs(a - b) for p, q in zip(sorted(mesh(header, "huge")[0]), sorted(POINTS)) for a, b in zip(p, q))
    host.check("--scale fit is a power of ten", worst < 1e-4, str(worst))
    host.write("tiny.obj", text(lambda p: tuple(1e-7 * c for c in p)))
    run = host.run("convert", "tiny.obj", "-o", "out.h")
    host.check("a mesh too small for its steps", run.returncode == 0 and re.fullmatch(
        r"tiny\.obj:0: warning: positions move by up to \S+, of sides of 1\.7e-07: give --scale fit\n", run.stderr) is not None,
        run.stderr)
    host.equal("--scale fit for it", host.run("convert", "tiny.obj", "--scale", "fit", "-o", "out.h").stderr, "")
    host.write("far.obj", text(lambda p: (p[0] + 1e6, p[1], p[2])))
    host.equal("--centre for what is far", host.run("convert", "far.obj", "--centre", "-o", "out.h").stderr, "")


def points(host, *options):
    run = host.run("convert", "one.obj", "--no-clusters", *options, "-o", "one.h")
    host.equal(f"convert {' '.join(options)}", (run.returncode, run.stderr), (0, ""))
    header = host.read("one.h").decode()
    os.remove(host.path("one.h"))
    return mesh(header, "one")[0]


def test_options(host):
    host.write("one.obj", text())
    half = .5 ** .5
    for options, change in [
            (["--up-axis", "z"], lambda x, y, z: (x, z, -y)), (["--up-axis", "y"], lambda x, y, z: (x, y, z)),
            (["--centre"], lambda x, y, z: (x - .05, y - .2, z - .05)), (["--scale", "2,3,4"], lambda x, y, z: (2 * x, 3 * y, 4 * z)),
            (["--rotate-x", "90"], lambda x, y, z: (x, -z, y)), (["--rotate-y", "90"], lambda x, y, z: (z, y, -x)),
            (["--rotate-z", "45"], lambda x, y, z: (half * (x - y), half * (x + y), z)),
            (["--rotate-z", "90", "--rotate-y", "90", "--rotate-x", "90"], lambda x, y, z: (z, y, -x)),
            (["--rotate-x", "90", "--scale", "1,2,3", "--up-axis", "z", "--centre"],
             lambda x, y, z: (x - .05, 3 * (y - .2), 2 * (z - .05)))]:
        got = points(host, *options)
        worst = max(abs(a - b) for p, q in zip(got, POINTS) for a, b in zip(p, change(*q)))
        host.check(f"{' '.join(options)} puts points", len(got) == 5 and worst < 2e-4, f"{worst} {got}")
        # Normals are made before the model is scaled: only those by area are then what they would be afterwards.
        view = ["--eye", "1,2,6", "--size", "160x120", "--weights", "area"]
        host.write("moved.obj", text(lambda p, c=change: c(*p)))
        pictures = host.render("one.obj", *view, *options), host.render("moved.obj", *view)
        # Corners that differ by a step move edges by a pixel here and there.
        count = sum(max(abs(x - y) for x, y in zip(s, t)) > 1 for p, q in zip(*(i.rows for i in pictures)) for s, t in zip(p, q))
        host.check(f"{' '.join(options)} in render", count <= 8, str(count))


def test_scale_is_the_same_of_all_commands(host):
    """A factor comes before quantising: a model that only fits when scaled is drawn, and without a note."""
    host.write("one.obj", text())
    host.write("large.obj", text(lambda p: tuple(1e5 * c for c in p)))
    view = ["--eye", "1,2,6", "--size", "160x120"]
    host.check("--scale of render", differ(host.render("large.obj", *view, "--scale", "1e-5"), host.render("one.obj", *view)) <= 1)
    host.equal("--scale of info", host.info("large.obj", "--scale", "1e-5")["lowest"], "-0.7 -0.5 -0.8")
    host.refuses("an axis that is none", ["info", "one.obj", "--up-axis", "x"], r"glint: --up-axis x: takes y or z")
    host.refuses("a word for a factor", ["info", "one.obj", "--scale", "fits"], r"glint: --scale fits: takes fit, .*")


def test_what_no_microcontroller_holds(host):
    host.write("big.obj", torus_text(512, 256))
    line = (r"big\.obj:0: warning: {} vertices and 262144 triangles take \S+ MB of flash, more than microcontrollers have: take "
            r"fewer triangles \(--simplify N\), or a part of the model\n")
    for arguments in (["info", "big.obj"], ["convert", "big.obj", "-o", "big.h"]):
        run = host.run(*arguments)
        host.check(f"{arguments[0]} of what is too large", run.returncode == 0 and
                   re.fullmatch(line.format(r"\d+"), run.stderr) is not None, run.stderr)
    os.remove(host.path("big.h"))
    host.equal("not of a model that fits", host.run("info", os.path.join(MODELS, "spot.obj")).stderr, "")
