# SPDX-License-Identifier: MIT
"""The map of a picture: how far each pixel is from double precision."""
import os

from harness import MODELS
import png

UNJUDGED = (70, 70, 70)
TORUS = ["torus:48x24", "--format", "rgb565"]


def draw(host, *words):
    """Runs a command that must go well. @return what it printed, as a dictionary"""
    run = host.run(*words, "-o", "out.png")
    if run.returncode != 0 or run.stderr:
        raise AssertionError(f"{words}: {run.returncode} {run.stderr}")
    return dict(line.split(" ", 1) for line in run.stdout.splitlines())


def test_the_picture_stays(host):
    before = host.render_bytes(*TORUS)
    draw(host, "render", *TORUS, "--heat", "heat.png")
    host.equal("a map leaves the picture alone", host.read("out.png"), before)


def test_heat(host):
    # what 1 bit is off by is known from 8 of them to within 1/510; up to half a step the map goes from black to 70 of blue
    said = draw(host, "render", "torus:48x24", "--format", "mono", "--heat", "heat.png")
    mono, heat = png.decode(host.read("out.png")).rows, png.decode(host.read("heat.png")).rows
    fine = host.render("torus:48x24", "--format", "grey8").rows
    wanted = [[abs(a[0] - b[0]) / 255 for a, b in zip(r, s)] for r, s in zip(fine, mono)]
    off = max(abs(p[2] / 140 - w) for r, s in zip(heat, wanted) for p, w in zip(r, s) if p != UNJUDGED)
    host.check("--heat: 1 bit beside 8", off < 0.012, str(off))
    worst = max(max(row) for row in wanted)
    host.check("--heat: the worst", abs(float(said["steps_worst"]) - worst) < 0.01, f"{said} {worst}")
    x, y = map(int, said["steps_worst_at"].split(","))
    host.check("--heat: and where", abs(wanted[y][x] - worst) < 0.01, f"{wanted[y][x]} {worst}")
    left_out = sum(p == UNJUDGED for row in heat for p in row)
    host.check("--heat: nearly all are judged", left_out < 20 and said["pixels_judged"] == str(320 * 240 - left_out), f"{said} {left_out}")
    for words in (["render", *TORUS], ["render", *TORUS, "--dither"], ["render", *TORUS, "--gamma", "2.2"], ["scene", "teapot"],
                  ["render", *TORUS, "--shading", "vertex"],
                  ["render", *TORUS, "--eye", "1,1.5,3.2", "--orthographic", "3", "--viewer", "local"],
                  ["render", os.path.join(MODELS, "teapot.obj"), "--orthographic", "4", "--light", "point:1,2,2", "--format", "rgb565"]):
        said = draw(host, *words, "--heat", "heat.png")
        # as README.md says
        host.check(f"--heat: {words}: at most 1 pixel in 10,000 is off by a step", 10000 * int(said["pixels_over_one_step"]) <= int(said["pixels_judged"]), f"{said}")
    # light per vertex is far from light per fragment: against the latter the map shows it
    coarse = [int(draw(host, "render", "torus:12x6", "--light", "point:0,1,1", "--viewer", "local", "--shading", name, "--heat", "heat.png")["pixels_over_one_step"])
              for name in ("vertex", "fragment")]
    host.equal("--heat: each is held against its own shading", coarse, [0, 0])


def test_refused(host):
    host.refuses("a map that cannot be written", ["render", "torus:8x6", "--heat", "none/heat.png", "-o", "out.png"],
                 r"glint: none/heat\.png cannot be written: .*")
    host.refuses("maps of animations", ["scene", "teapot", "--animate", "2", "--heat", "heat.png", "-o", "out.png"],
                 r"glint: scene: --heat, --preview and --compare take one frame: not with --animate")
