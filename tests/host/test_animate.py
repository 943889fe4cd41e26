# SPDX-License-Identifier: MIT
"""--animate: a model's turn."""
import os

import png
from test_render import near
from test_scene import decode_movie

SMALL = ["--size", "64x48"]
# Nothing of it is symmetric, and its box stands about the origin.
WEDGE = "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -.5\nv -1 -1 1\nv 1 .5 .2\nf 1 2 4\nf 1 3 2\nf 1 4 3\nf 2 3 5\nf 3 4 5\nf 4 2 5\n"
VIEW = [*SMALL, "--eye", "0,0,6", "--light", "dir:1,1,2"]


def take_away(host, *names):
    data = [host.read(name) for name in names]
    for name in names:
        os.remove(host.path(name))
    return data


def test_turn(host):
    """A full circle, in equal steps, counter-clockwise from above; each frame as --rotate-y draws it."""
    host.write("wedge.obj", WEDGE)
    run = host.run("render", "wedge.obj", *VIEW, "--animate", "8", "-o", "turn.png")
    host.equal("a turn", (run.returncode, run.stdout, run.stderr), (0, "", ""))
    movie, delays = decode_movie(host, *take_away(host, "turn.png"), "a turn")
    host.equal("it takes 4 s", {n / d * 8 for n, d in delays}, {4.0})
    for i, frame in enumerate(movie):
        still = host.render("wedge.obj", *VIEW, "--rotate-y", str(45 * i)).rows
        off = sum(not near(p, q) for r, s in zip(frame, still) for p, q in zip(r, s))
        host.check(f"frame {i} is the model turned", off <= 3, f"{off} pixels differ")  # edges: the pose is rounded once more
    host.equal("frame 0 is the model as it stands", movie[0], host.render("wedge.obj", *VIEW).rows)
    host.equal("no two are the same", len({str(frame) for frame in movie}), 8)
    run = host.run("render", "wedge.obj", *VIEW, "--rotate-x", "90", "--up", "0,0,1", "--eye", "0,-6,1", "--animate", "4", "-o", "turn.png")
    frames = decode_movie(host, *take_away(host, "turn.png"), "about z")[0]
    turned = [host.render("wedge.obj", *VIEW, "--rotate-x", "90", "--up", "0,0,1", "--eye", "0,-6,1", "--rotate-z", str(90 * i)).rows
              for i in range(4)]
    host.check("about --up", all(sum(not near(p, q) for r, s in zip(a, b) for p, q in zip(r, s)) <= 3 for a, b in zip(frames, turned)))


def test_place_of_a_turn(host):
    """A model turns on the spot, wherever that is, and stays in the picture all the way."""
    far = "".join(f"v {7 + float(x)} {y} {float(z) - 9}\n" for x, y, z in (line.split()[1:] for line in WEDGE.splitlines() if line[0] == "v"))
    host.write("wedge.obj", WEDGE)
    host.write("far.obj", far + "".join(line + "\n" for line in WEDGE.splitlines() if line[0] == "f"))
    for options in ([], ["--up", "1,1,0"], ["--fov", "100", "--size", "48x64"], ["--animate", "5"]):
        arguments = [*SMALL, "--background", "0,0,1", "--animate", "12", *options]
        host.run("render", "far.obj", *arguments, "-o", "turn.png")
        movie, _ = decode_movie(host, *take_away(host, "turn.png"), "on the spot")
        host.run("render", "wedge.obj", *arguments, "-o", "turn.png")
        own, _ = decode_movie(host, *take_away(host, "turn.png"), "at the origin")
        host.check(f"{options}: on the spot", all(sum(not near(p, q, 2) for r, s in zip(a, b) for p, q in zip(r, s)) <= 6 for a, b in zip(movie, own)))
        boxes = [png.Picture(len(rows[0]), len(rows), 3, rows).box((0, 0, 255)) for rows in movie]
        width, height = len(movie[0][0]), len(movie[0])
        edges = [min(b[0] for b in boxes), min(b[1] for b in boxes), width - 1 - max(b[2] for b in boxes), height - 1 - max(b[3] for b in boxes)]
        host.check(f"{options}: in the picture", 1 <= min(edges) <= 6, str(edges))


def test_refused(host):
    draw = ["render", "torus:3x3", "--animate"]
    for value in ("0", "1001", "-1", "x", ""):
        host.refuses(f"--animate '{value}'", [*draw, value, "-o", "out.png"], rf"glint: --animate {value}: takes a number of frames, from 1 to 1000")
    host.refuses("--animate and --stats", [*draw, "2", "--stats", "-o", "out.png"], r"glint: render: --stats and --animate exclude each other")
    host.refuses("--animate alone", [*draw, "2"], r"glint: render: the file to write is missing: -o FILE")


def test_the_model_is_kept(host):
    host.write("m.obj", WEDGE)
    host.refuses("the animation is the model", ["render", "m.obj", "--animate", "3", "-o", "m.obj"], r"m\.obj:0: cannot be written: it is the model")
    host.equal("it stays", host.read("m.obj"), WEDGE.encode())
