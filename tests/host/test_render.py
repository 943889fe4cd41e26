# SPDX-License-Identifier: MIT
"""Options of `render`: what each does to the picture."""
import os
import re

from harness import MODELS, ROOT, SQUARE, SQUARE_VIEW
import png

BLACK = (0, 0, 0)
TORUS = ["torus:24x12", "--eye", "1,1.5,3.2"]

# No light but the ambient: a flat colour.
DARK = ["--light", "dir:0,0,1:0,0,0"]


def near(pixel, wanted, steps=1):
    return all(abs(a - b) <= steps for a, b in zip(pixel, wanted))


def test_defaults(host):
    plain = host.render_bytes("torus:24x12")
    image = png.decode(plain)
    host.equal("default size and format", (image.width, image.height, image.channels), (320, 240, 3))
    host.equal("default background", image.at(0, 0), BLACK)
    spelled = host.render_bytes("torus:24x12", "--size", "320x240", "--format", "rgb888", "--up", "0,1,0", "--fov", "45",
                                "--near", "0.1", "--rotate-y", "0", "--rotate-x", "0", "--rotate-z", "0", "--up-axis", "y", "--scale", "1,1,1", "--ambient", ".1,.1,.1",
                                "--diffuse", ".6,.6,.6", "--specular", ".4,.4,.4", "--shininess", "32", "--viewer",
                                "infinite", "--background", "0,0,0")
    host.equal("defaults spelled out", spelled, plain)
    eye = host.render_bytes("torus:24x12", "--eye", "0,0,4")
    host.equal("--at is the origin", host.render_bytes("torus:24x12", "--eye", "0,0,4", "--at", "0,0,0"), eye)


def test_every_option_changes_the_picture(host):
    plain = host.render_bytes(*TORUS)
    for option, value in [("--size", "64x48"), ("--format", "rgb565"), ("--format", "grey8"), ("--format", "grey4"),
                          ("--format", "rgb444"), ("--format", "mono"),
                          ("--eye", "1,1.5,3.3"), ("--at", "0.1,0,0"), ("--up", "0.3,1,0"), ("--fov", "46"),
                          ("--near", "3"), ("--orthographic", "3"), ("--rotate-y", "30"), ("--rotate-x", "30"), ("--rotate-z", "30"), ("--up-axis", "z"),
                          ("--scale", "1,0.9,1"), ("--light", "dir:1,0,0"),
                          ("--ambient", ".2"), ("--diffuse", ".5,.6,.6"), ("--specular", ".3"), ("--shininess", "8.5"),
                          ("--viewer", "local"), ("--background", "0,0,.1"), ("--crease", "10")]:
        host.check(f"{option} {value}", host.render_bytes(*TORUS, option, value) != plain)
        host.equal(f"{option}={value}", host.render_bytes(*TORUS, f"{option}={value}"),
                   host.render_bytes(*TORUS, option, value))


def test_sizes(host):
    for size in [(1, 1), (1, 240), (33, 7), (1024, 1), (1024, 1024)]:
        image = host.render(*TORUS, "--size", "%dx%d" % size)
        host.equal(f"--size {size}", (image.width, image.height), size)


def test_formats(host):
    reference = host.render(*TORUS, "--diffuse", ".7,.5,.3", "--size", "160x120")
    options = [*TORUS, "--diffuse", ".7,.5,.3", "--size", "160x120", "--format"]
    five = {(v * 255 + 15) // 31 for v in range(32)}
    six = {(v * 255 + 31) // 63 for v in range(64)}
    image = host.render(*options, "rgb565")
    host.check("rgb565 levels", image.channels == 3 and image.levels(0) <= five and image.levels(1) <= six and
               image.levels(2) <= five)
    # A level that was rounded to nearest lies within half a step of the finer one, and its own rounding.
    worst = [max(abs(a[c] - b[c]) for p, q in zip(image.rows, reference.rows) for a, b in zip(p, q)) for c in range(3)]
    host.check("rgb565 is the same picture", worst[0] <= 6 and worst[1] <= 4 and worst[2] <= 6, str(worst))
    host.equal("rgb565_be is rgb565", host.render_bytes(*options, "rgb565_be"), host.render_bytes(*options, "rgb565"))
    grey = host.render(*options, "grey8")
    wrong = max(abs(g[0] - (0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]))
                for p, q in zip(grey.rows, reference.rows) for g, c in zip(p, q))
    host.check("grey8 is the luma", grey.channels == 1 and wrong <= 1.6, str(wrong))
    four = host.render(*options, "grey4")
    wrong = max(abs(a[0] - b[0]) for p, q in zip(four.rows, grey.rows) for a, b in zip(p, q))
    host.check("grey4 levels", four.channels == 1 and four.levels() <= {v * 17 for v in range(16)} and
               len(four.levels()) > 8)
    host.check("grey4 is the same picture", wrong <= 9, str(wrong))
    image = host.render(*options, "rgb444")
    worst = max(abs(a[c] - b[c]) for p, q in zip(image.rows, reference.rows) for a, b in zip(p, q) for c in range(3))
    host.check("rgb444 is the same picture", image.channels == 3 and worst <= 9, str(worst))
    host.check("rgb444 levels", all(image.levels(c) <= {v * 17 for v in range(16)} for c in range(3)) and
               len(image.levels(0)) > 8)
    wrong = [g[0] for p, q in zip(host.render(*options, "mono").rows, grey.rows) for m, g in zip(p, q)
             if m[0] != 255 * (g[0] > 127)]
    host.check("mono is the same picture", all(127 <= g <= 128 for g in wrong), str(wrong))


def test_levels_expand_exactly(host):
    """A background of every level shows it: v of n to round(v 255 / (n - 1))."""
    host.write("square.obj", SQUARE)
    away = ["square.obj", "--eye", "0,0,-3", "--size", "8x8"]
    for bits, name in [(5, "rgb565"), (6, "rgb565"), (4, "grey4"), (4, "rgb444"), (1, "mono"), (8, "rgb888"), (8, "grey8")]:
        top = (1 << bits) - 1
        for v in range(0, top + 1, 1 if bits < 8 else 15):
            image = host.render(*away, "--format", name, "--background", f"{v / top:.9f}")
            got = image.at(4, 4)[1 if bits == 6 else 0]
            if got != (v * 255 + top // 2) // top:
                host.equal(f"{name} level {v} of {bits} bits", got, (v * 255 + top // 2) // top)
        host.check(f"{name} levels of {bits} bits", True)


def test_tiles_and_arenas(host):
    plain = host.render_bytes(*TORUS, "--viewer", "local")
    for width in (8, 16, 32, 64):
        for height in (8, 16, 32, 64):
            host.equal(f"--tile {width}x{height}",
                       host.render_bytes(*TORUS, "--viewer", "local", "--tile", f"{width}x{height}"), plain)
    run = host.run("render", *TORUS, "--arena", "1", "-o", "out.png")
    told = re.fullmatch(r"glint: --arena 1: this scene takes (\d+) bytes, or (\d+) to be drawn in one pass\n", run.stderr)
    host.check("an arena too small tells what is needed", told is not None, run.stderr)
    smallest, best = int(told.group(1)), int(told.group(2))
    host.refuses("an arena one byte short", ["render", *TORUS, "--arena", str(smallest - 1), "-o", "out.png"],
                 r"glint: --arena \d+: this scene takes \d+ bytes, or \d+ to be drawn in one pass")
    for arena in (smallest, (smallest + best) // 2, best, best * 2):
        host.equal(f"--arena {arena}", host.render_bytes(*TORUS, "--viewer", "local", "--arena", str(arena)), plain)


def stats(host, *arguments):
    run = host.run("render", *arguments, "--stats", "-o", "out.png")
    return {name: int(value) if value.isdigit() else value for name, value in (line.split(" ", 1) for line in run.stdout.splitlines())}


STATS = ["panel", "passes", "tiles", "vertices", "triangles", "facing_away", "outside", "clipped", "hidden", "references",
         "arena_used", "bytes_sent"]


def test_stats(host):
    values = stats(host, *TORUS)
    host.equal("--stats names", list(values), STATS)
    host.check("--stats references", values["references"] >= values["triangles"] - values["facing_away"] - values["outside"] > 100)
    host.equal("--stats passes", values["passes"], 1)
    host.equal("--stats triangles", values["triangles"], 576)
    host.equal("--stats bytes of rgb888", stats(host, *TORUS, "--format", "rgb888")["bytes_sent"], 320 * 240 * 3)
    host.equal("--stats bytes of grey4", stats(host, *TORUS, "--format", "grey4", "--size", "33x8")["bytes_sent"], 17 * 8)
    # A user would plan for another panel than `info` and `convert` speak of, or for an arena that is too small.
    host.equal("--stats without --format is of RGB565", values, stats(host, *TORUS, "--format", "rgb565"))
    told = re.search(r"^320x240 +rgb565 +(\d+) +(\d+) +(\d+)$", host.run("info", TORUS[0]).stdout, re.M)
    host.equal("--stats panel", values["panel"], "320x240 rgb565")
    host.check("--stats and info: the same arena", int(told[2]) <= values["arena_used"] <= int(told[3]), told[0])
    host.check("--stats clipped", stats(host, *TORUS, "--near", "3.5")["clipped"] > 0)


def test_camera(host):
    host.write("square.obj", SQUARE)
    flat = ["square.obj", *DARK, "--ambient", "1"]
    image = host.render(*flat, *SQUARE_VIEW)
    host.equal("--fov is vertical", image.box(BLACK), (30, 30, 59, 59))
    image = host.render(*flat, *SQUARE_VIEW, "--size", "180x90")
    host.equal("--size keeps pixels square", image.box(BLACK), (75, 30, 104, 59))
    image = host.render(*flat, *SQUARE_VIEW, "--at", "0,0,1", "--eye", "1,1,3")
    host.check("--at aims", image.box(BLACK)[0] < 45 and image.box(BLACK) != (30, 30, 59, 59))
    image = host.render(*flat, *SQUARE_VIEW, "--eye", "1,1,3", "--at", "1,1,0")
    host.equal("x runs right, y up", image.box(BLACK), (15, 45, 44, 74))
    image = host.render(*flat, *SQUARE_VIEW, "--eye", "1,1,3", "--at", "1,1,0", "--up", "1,0,0")
    host.equal("--up rolls", image.box(BLACK), (45, 45, 74, 74))
    host.equal("--near hides", host.render(*flat, *SQUARE_VIEW, "--near", "3.01").box(BLACK), None)
    host.equal("--near shows", host.render(*flat, *SQUARE_VIEW, "--near", "2.99").box(BLACK), (30, 30, 59, 59))


def test_orthographic(host):
    host.write("square.obj", SQUARE)
    flat = ["square.obj", *DARK, "--ambient", "1", "--size", "90x90"]
    for eye in ("0,0,3", "0,0,30"):
        image = host.render(*flat, "--eye", eye, "--orthographic", "6")
        host.equal(f"a picture 6 units high, from {eye}", image.box(BLACK), (30, 30, 59, 59))
    image = host.render(*flat, "--eye", "0,0,3", "--orthographic", "6", "--size", "180x90", "--fov", "20")
    host.equal("whatever the width and --fov", image.box(BLACK), (75, 30, 104, 59))
    image = host.render(*flat, "--eye", "0,3,3", "--orthographic", "6")  # turned by 45 degrees: 2 units high become 2^.5
    host.equal("slanted", image.box(BLACK), (30, 34, 59, 55))
    host.equal("what is behind the near plane", host.render(*flat, "--eye", "0,0,3", "--orthographic", "6", "--near", "3.01").box(BLACK), None)
    host.equal("framed, seen by 30 degrees from the right", host.render(*flat, "--orthographic", "6").box(BLACK)[::2], (32, 57))


def test_sides(host):
    host.write("square.obj", SQUARE)
    flat = [*SQUARE_VIEW, *DARK, "--ambient", "1"]
    host.equal("back faces are culled", host.render("square.obj", *flat, "--rotate-y", "180").box(BLACK), None)
    host.equal("--double-sided", host.render("square.obj", *flat, "--rotate-y", "180", "--double-sided").box(BLACK),
               (30, 30, 59, 59))


def test_light(host):
    host.write("square.obj", SQUARE)
    view = ["square.obj", *SQUARE_VIEW]
    ahead = ["--light", "dir:0,0,2"]

    def centre(*options):
        return host.render(*view, *options).at(45, 45)

    lit = centre("--light", "dir:0,0,1:1,.5,.25", "--ambient", "0", "--diffuse", ".4", "--specular", ".4")
    host.check("--light colours both", near(lit, (204, 102, 51)), str(lit))
    lit = centre("--light", "dir:1,0,1", "--ambient", "0", "--diffuse", "1", "--specular", "0")
    host.check("--light slants", near(lit, (180,) * 3), str(lit))
    lit = centre(*ahead, *ahead, "--ambient", ".1", "--diffuse", ".2", "--specular", "0")
    host.check("--light adds up", near(lit, (127,) * 3), str(lit))
    host.equal("sums are clamped", centre(*ahead, "--diffuse", "2"), (255, 255, 255))
    host.check("--light from behind", near(centre("--light", "dir:0,0,-1"), (25,) * 3))
    host.check("eight lights", near(centre(*DARK * 8, "--ambient", ".2"), (51,) * 3))


def test_viewer(host):
    host.write("square.obj", SQUARE)
    shiny = ["square.obj", *SQUARE_VIEW, "--light", "dir:0,0,1", "--ambient", "0", "--diffuse", "0", "--specular", "1"]
    infinite, local = host.render(*shiny), host.render(*shiny, "--viewer", "local")
    host.equal("--viewer infinite is even", {p for row in infinite.rows[31:59] for p in row[31:59]}, {(255, 255, 255)})
    host.check("--viewer local fades outwards", local.at(45, 45)[0] > 250 > 200 > local.at(31, 31)[0],
               f"{local.at(45, 45)} {local.at(31, 31)}")


def test_default_light(host):
    image = host.render("sphere:32x16", "--specular", "0")
    host.check("upper left is lit, and the other side a little", image.at(130, 90)[0] > image.at(190, 150)[0] + 40 > 100)
    turned = host.render("sphere:32x16", "--specular", "0", "--eye", "-3,0,0")
    host.check("the lights follow the camera", turned.at(130, 90)[0] > turned.at(190, 150)[0] + 40 > 100)


def test_framing(host):
    models = [os.path.join(MODELS, name + ".obj") for name in ("featuretype", "spot", "spot-control", "teapot")]
    for model in models + ["torus:24x12", "sphere:32x16"]:
        for width, height, more in [(320, 240, []), (100, 200, ["--fov", "100"]), (200, 50, ["--rotate-y", "70"]),
                                    (120, 120, ["--up", "0,0,1", "--scale", "1,3,1"])]:
            image = host.render(model, "--size", f"{width}x{height}", "--background", "0,0,1", *more)
            left, top, right, bottom = image.box((0, 0, 255))
            filled = max((right - left + 1) / width, (bottom - top + 1) / height)
            host.check(f"{os.path.basename(model)} framed at {width}x{height}",
                       left > 0 and top > 0 and right < width - 1 and bottom < height - 1 and filled > 0.85,
                       f"{left} {top} {right} {bottom}")
    host.write("tiny.obj", "v 0 0 0\nv .2 0 0\nv 0 .2 0\nf 1 2 3\n")
    host.check("a tiny model is framed", host.render("tiny.obj").box(BLACK) is not None)
    near_at = host.render("sphere:32x16", "--at", "1,0,0", "--background", "0,0,1").box((0, 0, 255))
    host.check("--at without --eye frames round it", near_at[0] < 100 and near_at[2] < 170, str(near_at))


def test_demo(host):
    run = host.run("demo", "--models", MODELS, "-o", "sheet.png")
    host.equal("demo names its file last", (run.returncode, run.stdout.splitlines()[-1:]), (0, ["sheet.png"]))
    image = png.decode(host.read("sheet.png"))
    os.remove(host.path("sheet.png"))
    host.equal("demo size", (image.width, image.height), (960, 480))
    of_panel = [{(2 * level * 255 + most) // (2 * most) for level in range(most + 1)} for most in (31, 63, 31)]
    host.check("demo shows a panel's levels", all(level in levels for row in image.rows for pixel in row for level, levels in zip(pixel, of_panel)))
    for x, y in [(0, 0), (320, 0), (640, 0), (0, 240), (320, 240), (640, 240)]:
        cell = [row[x:x + 320] for row in image.rows[y:y + 240]]
        colours = {pixel for row in cell for pixel in row}
        edge = {*cell[0], *cell[-1], *(row[0] for row in cell), *(row[-1] for row in cell)}
        host.check(f"demo cell at {x},{y}", len(colours) > 100, f"{len(colours)} colours")
        host.check(f"the subject at {x},{y} is not cut off", len(edge) <= 8, f"{len(edge)} colours of dithered background")
    host.refuses("demo without models", ["demo", "--models", "none", "-o", "sheet.png"], r"none/teapot\.obj:0: .+")


def test_help_and_version(host):
    with open(os.path.join(ROOT, "src", "glint.h"), encoding="utf-8") as file:
        parts = re.findall(r"#define GLINT_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", file.read())
    host.equal("--version", host.run("--version").stdout, f"glint {'.'.join(parts)}\n")
    text = host.run("help").stdout
    host.equal("help is --help, and -h", [host.run(option).stdout for option in ("--help", "-h")], [text, text])
    host.equal("of a command too", host.run("info", "-h").stdout, host.run("info", "--help").stdout)
    for option in ("size format eye at up fov near rotate-x rotate-y rotate-z up-axis centre scale light ambient diffuse specular shininess viewer opacity blend fog fog-type samples "
                   "background tile arena stats crease double-sided name licence models model shading combine ungated "
                   "dither gamma weights smooth flat repair list frame animate camera-lights labels").split():
        host.check(f"help names --{option}", f"--{option} " in text)
    for command in ("render", "info", "convert", "scene", "demo"):
        run = host.run(command, "--help")
        host.check(f"{command} --help", run.returncode == 0 and run.stdout.startswith(f"\nglint {command} "))


def test_more_vertices_than_a_part_of_a_mesh_has(host):
    """Nearly as many vertices as triangles, and more than fit a part: no more are put into it than it has room for."""
    side = 300
    rows = "".join(f"v {x} {y} {(x * y) % 7}\n" for y in range(side) for x in range(side))
    faces = "".join(f"f {y * side + x + 1} {y * side + x + 2} {(y + 1) * side + x + 1}\n"
                    for y in range(side - 1) for x in range(side - 1))
    host.write("sparse.obj", rows + faces)
    view = ["--size", "320x240", "--format", "rgb565"]
    whole = host.render_bytes("sparse.obj", *view, "--arena", "1000000")
    for arena in ("2000000", "9000000"):
        host.equal(f"in {arena} bytes", host.render_bytes("sparse.obj", *view, "--arena", arena), whole)


def test_first_picture_of_a_box(host):
    """Three sides of three tones, none of them black: a first picture shows a solid, not a silhouette."""
    image = host.render("box", "--size", "160x120", "--model", "lambert")
    tones = {}
    for row in image.rows:
        for pixel in row:
            tones[pixel] = tones.get(pixel, 0) + 1
    sides = sorted(pixel[0] for pixel, count in tones.items() if count > 400 and pixel != (0, 0, 0))
    host.check("three tones", len(sides) == 3 and sides[0] >= 40 and all(b - a >= 30 for a, b in zip(sides, sides[1:])), str(sides))
    top, front, right = (next(image.at(x, y)[0] for x, y in places if image.at(x, y)[0] in sides)
                         for places in (((80, 10),), ((60, 60),), ((125, 60),)))
    host.equal("top, front and right get darker", (top, front, right), tuple(reversed(sides)))


def test_nothing_to_see_is_said(host):
    """A black picture says why, in place of leaving it to be guessed."""
    host.write("square.obj", SQUARE)
    for name, options, pattern in [
            ("behind the camera", ["--eye", "0,0,5", "--at", "0,0,9"], r"shows nothing of the model: the camera sees no object.*"),
            ("from its back", ["--eye", "0,0,-5"], r"shows nothing of the model: all triangles face away.*"),
            ("from its back, on grey", ["--eye", "0,0,-5", "--background", ".5"], r"shows nothing of the model: all triangles face away.*"),
            ("black", ["--ambient", "0", "--diffuse", "0", "--specular", "0"], r"is black: all materials are black"),
            ("dark", ["--light", "dir:0,0,-1", "--ambient", "0", "--eye", "0,0,5"], r"is black: no light reaches what shows.*")]:
        run = host.run("render", "square.obj", *options, "-o", "out.png")
        host.check(f"a square, {name}", run.returncode == 0 and re.fullmatch(
            r"square\.obj:0: warning: the picture " + pattern + r"\n", run.stderr) is not None, run.stderr)
    host.render_bytes("square.obj", "--eye", "0,0,0.2", "--light", "dir:0,0,1:0,0,0", "--ambient", "1")  # one colour, and all there is
