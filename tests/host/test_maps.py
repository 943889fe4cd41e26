# SPDX-License-Identifier: MIT
"""Maps of a picture: how each pixel was lit, and how far it is from double precision."""
import os

from harness import MODELS
import picture

FAST, EVEN, SINGLE, CORNERS, FACET = "8d939c", "4b4f57", "e0402a", "f2b134", "a86bd6"
UNJUDGED = (70, 70, 70)
TORUS = ["torus:48x24", "--format", "rgb565"]


def colours_of(rows):
    return {"%02x%02x%02x" % pixel for row in rows for pixel in row}


def draw(host, *words):
    """Runs a command that must go well. @return what it printed, as a dictionary"""
    run = host.run(*words, "-o", "out.png")
    if run.returncode != 0 or run.stderr:
        raise AssertionError(f"{words}: {run.returncode} {run.stderr}")
    return dict(line.split(" ", 1) for line in run.stdout.splitlines())


def test_lit_map(host):
    for shading, way, others in [("flat", FACET, set()), ("vertex", CORNERS, set()), ("fragment", FAST, {EVEN, SINGLE})]:
        said = draw(host, "render", *TORUS, "--shading", shading, "--lit-map", "lit.png")
        lit, drawn = picture.decode(host.read("lit.png")).rows, picture.decode(host.read("out.png")).rows
        found = colours_of(lit) - {"000000"}
        host.check(f"--lit-map: {shading}", {way} <= found <= {way} | others, str(found))
        host.check(f"--lit-map: {shading}: where the torus is",
                   all((a == (0, 0, 0)) == (b == (0, 0, 0)) for r, s in zip(lit, drawn) for a, b in zip(r, s)))
        flat = ["%02x%02x%02x" % pixel for row in lit for pixel in row]
        host.equal(f"--lit-map: {shading}: the pixels are counted", {name: int(text.split()[0]) for name, text in said.items()},
                   {"lit_" + colour: flat.count(colour) for colour in set(flat)})
    draw(host, "scene", "phong-lighting", "--lit-map", "lit.png")
    found = colours_of(picture.decode(host.read("lit.png")).rows)
    host.check("--lit-map: a scene at nodes", {"c3e88d", "bcd9f7", SINGLE} <= found, str(found))
    before = host.render_bytes(*TORUS)
    draw(host, "render", *TORUS, "--lit-map", "lit.png", "--heat", "heat.png")
    host.equal("maps leave the picture alone", host.read("out.png"), before)


def test_heat(host):
    # what 1 bit is off by is known from 8 of them to within 1/510; up to half a step the map goes from black to 70 of blue
    said = draw(host, "render", "torus:48x24", "--format", "mono", "--heat", "heat.png")
    mono, heat = picture.decode(host.read("out.png")).rows, picture.decode(host.read("heat.png")).rows
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
        host.equal(f"--heat: {words}: no pixel is off by a step", said["pixels_over_one_step"], "0")
    # an error budget of steps shows
    coarse = ["render", "torus:12x6", "--viewer", "local", "--budget"]
    over = [int(draw(host, *coarse, budget, "--heat", "heat.png")["pixels_over_one_step"]) for budget in ("0", "8")]
    host.check("--heat: a budget shows", over[0] == 0 and over[1] > 1000, str(over))


def test_refused(host):
    host.refuses("a map that cannot be written", ["render", "torus:8x6", "--heat", "none/heat.png", "-o", "out.png"],
                 r"glint: none/heat\.png cannot be written: .*")
    host.refuses("maps of animations", ["scene", "teapot", "--animate", "2", "--lit-map", "lit.png", "-o", "out.png"],
                 r"glint: scene: --lit-map, --heat, --preview and --compare take one frame: not with --animate")
