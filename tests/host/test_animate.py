# SPDX-License-Identifier: MIT
"""--animate: a model's turn, and frames as files of their own, by names with a number."""
import os

import png
from harness import Preloaded
from test_output import REFUSING
from test_render import near
from test_scene import decode_movie

SMALL = ["--size", "64x48"]
# Nothing of it is symmetric, and its box stands about the origin.
WEDGE = "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -.5\nv -1 -1 1\nv 1 .5 .2\nf 1 2 4\nf 1 3 2\nf 1 4 3\nf 2 3 5\nf 3 4 5\nf 4 2 5\n"
VIEW = [*SMALL, "--eye", "0,0,6", "--light", "dir:1,1,2"]


def run_for_files(host, *arguments, env=None):
    """Runs the program. @return what came of it, and the files that are new"""
    before = host.files()
    run = host.run(*arguments, env=env)
    return run, sorted(set(host.files()) - set(before))


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
    for name in ("far.obj", "wedge.obj"):
        os.remove(host.path(name))


def test_files(host):
    """The frames of the animation, in files by their numbers, and nothing else."""
    for command in (["render", "torus:8x6", *SMALL], ["scene", "teapot", *SMALL, "--labels"], ["render", "torus:8x6", "--format", "grey4", *SMALL]):
        host.run(*command, "--animate", "11", "-o", "all.png")
        movie, _ = decode_movie(host, *take_away(host, "all.png"), "one file")
        run, files = run_for_files(host, *command, "--animate", "11", "-o", "frame%02d.png")
        names = [f"frame{i:02}.png" for i in range(11)]
        host.equal(f"{command[:2]}: their names", (run.returncode, run.stdout, run.stderr, files), (0, "", "", names))
        host.equal(f"{command[:2]}: their pictures", [png.decode(data).rows for data in take_away(host, *names)], movie)


def test_names(host):
    draw = ["render", "torus:3x3", "--size", "8x8", "--animate"]
    for name, count, wanted in (("%d-", 2, ["0-", "1-"]), ("a%d.png", 11, [f"a{i}.png" for i in range(11)]), ("%01d-%%", 1, ["0-%"]),
                                ("%%%03d%%d.png", 2, ["%000%d.png", "%001%d.png"]), ("x%09dy", 1, ["x000000000y"]),
                                ("%%%%", 2, ["%%"]), ("100%%.png", 3, ["100%.png"])):
        run, files = run_for_files(host, *draw, str(count), "-o", name)
        host.equal(f"-o {name}", (run.returncode, run.stderr, files), (0, "", sorted(wanted)))
        take_away(host, *files)
    _, files = run_for_files(host, "render", "torus:3x3", "-o", "%d-%s-%%.png")
    host.equal("a still's name is as it is", files, ["%d-%s-%%.png"])
    take_away(host, *files)
    for name in ("%", "a%", "%s.png", "%n", "%d%d", "%d-%03d", "%3d", "%00d", "%010d", "%0d", "%+d", "% d", "%-3d", "%03i", "%03u", "%x", "%ld",
                 "%1$d", "%*d", "%.3d", "%0", "%03", "%%%", "%%%s", "%d%", "%D"):
        for command in ("render", "scene"):
            model = "teapot" if command == "scene" else "torus:3x3"
            host.refuses(f"{command} -o {name}", [command, model, "--animate", "2", "-o", name],
                         rf"glint: {command}: -o with --animate takes one %d, or one %03d for 3 digits \(1 to 9\), and %% for a percent")


def test_what_goes_wrong(host):
    """What was written whole stays, and is counted; nothing else is there."""
    draw = ["render", "torus:3x3", "--size", "8x8", "--animate", "5", "-o"]
    os.mkdir(host.path("f3.png"))
    run, files = run_for_files(host, *draw, "f%d.png")
    host.equal("the fourth cannot be written", (run.returncode, run.stdout, run.stderr),
               (2, "", "f3.png:0: cannot be written: Is a directory; 3 of 5 frames were written\n"))
    host.equal("the others are there", files, ["f0.png", "f1.png", "f2.png"])
    os.rmdir(host.path("f3.png"))
    for data in take_away(host, "f0.png", "f1.png", "f2.png"):
        png.decode(data)
    host.refuses("none can be written", [*draw, "no/f%d.png"],
                 r"no/f0\.png:0: cannot be written: No such file or directory; 0 of 5 frames were written")
    with Preloaded(host, REFUSING) as library:
        run, files = run_for_files(host, *draw, "f%d.png", env={"LD_PRELOAD": library, "FULL_AFTER": "2"})
        host.equal("a disk that fills up", (run.returncode, run.stderr, files),
                   (2, "f2.png:0: cannot be written: No space left on device; 2 of 5 frames were written\n", ["f0.png", "f1.png"]))
    for data in take_away(host, "f0.png", "f1.png"):
        png.decode(data)
    host.refuses("no room in the arena", ["render", "torus:48x24", "--arena", "900", "--animate", "3", "-o", "f%d.png"],
                 r"glint: --arena 900: .*; 0 of 3 frames were written")


def test_refused(host):
    draw = ["render", "torus:3x3", "--animate"]
    for value in ("0", "1001", "-1", "x", ""):
        host.refuses(f"--animate '{value}'", [*draw, value, "-o", "out.png"], rf"glint: --animate {value}: takes a number of frames, from 1 to 1000")
    for options in (["--preview", "40"], ["--compare", "other.png"]):
        host.refuses(f"--animate and {options[0]}", [*draw, "2", *options, "-o", "out.png"],
                     r"glint: render: --preview and --compare take one frame: not with --animate")
    host.refuses("--animate and --preview alone", [*draw, "2", "--preview", "9"], r"glint: render: .* take one frame: not with --animate")
    host.refuses("--animate and --stats", [*draw, "2", "--stats", "-o", "out.png"], r"glint: render: --stats and --animate exclude each other")
    host.refuses("--animate alone", [*draw, "2"], r"glint: render: the file to write is missing: -o FILE")


def test_the_model_is_no_frame(host):
    for name in ("m2.obj", "m1.obj"):
        host.write(name, WEDGE)
    os.rename(host.path("m1.obj"), host.path("m%.obj"))
    host.refuses("the third frame is the model", ["render", "m2.obj", "--animate", "3", "-o", "m%d.obj"], r"m2\.obj:0: cannot be written: it is the model")
    host.refuses("the animation is the model", ["render", "m%.obj", "--animate", "3", "-o", "m%%.obj"], r"m%\.obj:0: cannot be written: it is the model")
    host.equal("it stays", host.read("m2.obj"), WEDGE.encode())
    host.equal("one of fewer", host.run("render", "m2.obj", *SMALL, "--animate", "2", "-o", "m%d.obj").returncode, 0)
    take_away(host, "m%.obj", "m0.obj", "m1.obj", "m2.obj")
