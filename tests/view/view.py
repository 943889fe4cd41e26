#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The window on a screen in memory, with real keys and a real mouse: view.py GLINT_VIEW GLINT. What it shows is held
against what `glint render` and `glint scene` draw, and its text is read off the pixels. Closes with `N passed, N failed`."""
import math
import os
import re
import subprocess
import sys

import drop
from screen import ROOT, Screen, Window, png, until

sys.path.insert(0, os.path.join(ROOT, "tests", "host"))
from harness import Host  # noqa: E402

MARK = b"\xff\xc8\x3c"  # of the grid and of the slider
TORUS, BALL = "torus:48x24", "sphere:48x32"
LEVELS = ["--format", "rgb565"]


class Test(Host):
    """Checks, and the programs."""

    def __init__(self, view, program):
        super().__init__(program)
        self.view, self.screen = os.path.abspath(view), Screen()

    def open(self, *arguments, size=(320, 240)):
        return Window(self.screen, self.view, *arguments, size=size)

    def drawn(self, command, *arguments):
        """What the command line draws: rows of (red, green, blue)."""
        run = self.run(command, *arguments, "-o", "out.png")
        if run.returncode != 0:
            raise AssertionError(run.stderr)
        return [[pixel * (3 // len(pixel)) for pixel in row] for row in png.decode(self.read("out.png")).rows]

    def shows(self, name, window, wanted):
        """The window comes to show these rows."""
        self.check(name, until(lambda: window.picture().rows == wanted), difference(window.picture().rows, wanted))

    def says(self, name, window, pattern):
        """A line of the text beside the picture comes to match. @return its groups"""
        found = until(lambda: next((match for match in map(re.compile(pattern).fullmatch, window.side()) if match), None))
        self.check(name, found, f"{pattern!r} is not among {window.side()}")
        return found.groups() if found else None


def difference(rows, wanted):
    if len(rows) != len(wanted) or len(rows[0]) != len(wanted[0]):
        return f"{len(rows[0])}x{len(rows)} pixels, not {len(wanted[0])}x{len(wanted)}"
    return f"{sum(a != b for r, w in zip(rows, wanted) for a, b in zip(r, w))} pixels differ"


def share_apart(rows, wanted, levels):
    """Share of pixels in which a channel differs by more than so many levels."""
    apart = sum(max(abs(a - b) for a, b in zip(p, q)) > levels for r, w in zip(rows, wanted) for p, q in zip(r, w))
    return apart / (len(rows) * len(rows[0]))


def middle_of_light(rows):
    """Where the highlight is: the middle of the brightest pixels."""
    most = max(pixel[1] for row in rows for pixel in row)
    at = [(x, y) for y, row in enumerate(rows) for x, pixel in enumerate(row) if pixel[1] >= most - 8]
    return sum(x for x, _ in at) / len(at), sum(y for _, y in at) / len(at)


def is_grey(rows):
    return all(max(pixel) - min(pixel) <= 8 for row in rows for pixel in row)


# ---- Keys whose picture the command line draws as well: (key, options), one after the other

KEYS = [
    ("1", ["--shading", "flat"]), ("2", ["--shading", "vertex"]), ("3", ["--shading", "fragment"]),
    ("m", ["--model", "lambert"]), ("m", ["--model", "phong"]), ("m", ["--model", "blinn-phong"]),
    ("v", ["--viewer", "local"]), ("v", ["--viewer", "infinite"]),
    ("u", ["--shininess", str(32 * 2 ** 0.5)]), ("o", ["--shininess", "32"]), ("o", ["--shininess", str(32 * 2 ** -0.5)]),
    ("shift+u", ["--shininess", str(32 * 2 ** -0.375)]), ("shift+o", ["--shininess", str(32 * 2 ** -0.5)]), ("u", []),
    ("g", ["--diffuse", "0.12", "--ambient", "0.02"]), ("g", []),
    ("h", ["--diffuse", "0"]), ("h", ["--specular", "0"]), ("h", []),
    ("shift+h", ["--specular", "0"]), ("shift+h", []), ("h", ["--diffuse", "0"]), ("shift+h", []),
    ("p", ["--opacity", ".75"]), ("p", ["--opacity", ".5"]), ("shift+p", ["--opacity", ".5", "--blend", "add"]),
    ("shift+p", ["--opacity", ".5", "--blend", "dithered"]), ("p", ["--opacity", ".25", "--blend", "dithered"]), ("p", []),
    ("w", ["--samples", "2x2"]), ("w", []),
    ("d", ["--dither"]), ("d", []),
    ("f", ["--format", "rgb444"]), ("f", ["--format", "grey4"]), ("f", ["--format", "mono"]), ("d", ["--format", "mono", "--dither"]),
    ("d", ["--format", "mono"]), ("f", ["--format", "rgb888"]), ("f", ["--format", "grey8"]), ("f", []),
    ("shift+f", ["--format", "grey8"]), ("f", []),
]


def test_keys(test):
    window = test.open()
    test.shows("as it starts", window, test.drawn("render", TORUS, *LEVELS))
    for key, options in KEYS:
        window.keys(key)
        test.shows(f"{key}: {options}", window, test.drawn("render", TORUS, *LEVELS, *options))
    scale = window.scale()
    rows = window.blocks()
    test.check("a pixel is a square of one colour", scale == 3 and all(
        rows[y][3 * x:3 * x + 3] == rows[y // scale * scale][3 * (x // scale * scale):3 * (x // scale * scale) + 3]
        for y in range(0, 720, 7) for x in range(960)))
    window.keys("m", "v", "g", "h", "t", "1", "Home")
    test.shows("Home", window, test.drawn("render", TORUS, *LEVELS))
    window.keys("Escape")
    test.equal("Escape", window.program.wait(30), 0)
    window.close()


def test_panels(test):
    window = test.open(TORUS, "--format", "grey4")
    for size in [(240, 240), (240, 135), (160, 128), (128, 128), (128, 64), (96, 64), (320, 240)]:
        window.keys("s")
        window.size = size
        test.shows(f"S: {size}", window, test.drawn("render", TORUS, "--format", "grey4", "--size", "%dx%d" % size))
    window.keys("shift+s")
    window.size = (96, 64)
    test.shows("Shift S", window, test.drawn("render", TORUS, "--format", "grey4", "--size", "96x64"))
    test.screen.xdotool("windowsize", "--sync", window.id, 372 + 16 + 2 * 96, 700)
    window.measure()
    test.equal("a smaller window", window.scale(), 2)
    test.shows("a smaller window", window, test.drawn("render", TORUS, "--format", "grey4", "--size", "96x64"))
    window.close()


def test_fog(test):
    """Of the background's colour, it begins in front of a model, here a black one, and ends behind it."""
    black = [TORUS, "--model", "unlit", "--diffuse", "0", "--rotate-x", "-70", "--background", "1"]
    window = test.open(*black)
    for kind in ("linear", "squared"):
        before = window.picture().rows
        window.keys("e")
        test.says("E", window, f"fog {kind}")
        until(lambda rows=before: window.picture().rows != rows)
        levels = {pixel[1] for row in window.picture().rows for pixel in row} - {255}
        test.check(f"{kind} fog", len(levels) > 12 and min(levels) < 120 < max(levels), str(sorted(levels)))
    window.keys("e")
    test.shows("E again", window, test.drawn("render", *black, *LEVELS))
    window.close()


# ---- Light

def test_light(test):
    window = test.open(BALL, "--diffuse", "0.3")
    start = test.drawn("render", BALL, *LEVELS, "--diffuse", "0.3")
    test.shows("a ball", window, start)
    x, y = middle_of_light(start)
    moves = [("l", 1, 0), ("j", -1, 0), ("i", 0, -1), ("k", 0, 1)]
    for key, across, down in moves:
        for fine in ("", "shift+"):
            before = window.picture().rows
            window.keys(fine + key, fine + key, fine + key)
            until(lambda: window.picture().rows != before)
            until(lambda: settled(window))
            there = middle_of_light(window.picture().rows)
            along = across * (there[0] - x) + down * (there[1] - y)
            aside = abs(down * (there[0] - x)) + abs(across * (there[1] - y))
            least, most = (0.4, 4) if fine else (4, 25)
            test.check(f"{fine}{key}: the light moves {across},{down}", least < along < most and aside < along, f"{there} after {x, y}")
            x, y = there
    window.close()


def settled(window):
    """Whether the picture stays what it is for as long as it takes to grab it twice."""
    first = window.picture().rows
    return window.picture().rows == first and window.picture().rows == first


def test_lights(test):
    one = ["--light", "dir:-0.5,0.7,0.7"]
    window = test.open(TORUS, *one)
    start = test.drawn("render", TORUS, *LEVELS, *one)
    test.says("one light", window, "light 1 of 1: directional")
    window.keys("n")
    test.says("N", window, "light 2 of 2: directional")
    test.check("N: the second is coloured", until(lambda: not is_grey(window.picture().rows)))
    window.keys("c")
    test.says("C", window, "light 1 of 2: directional")
    seen = []
    for kind in ["point", "spot", "directional"]:
        window.keys("x")
        test.says(f"X: {kind}", window, f"light 1 of 2: {kind}")
        seen.append(window.picture().rows)
    far = [share_apart(a, b, 16) for a, b in zip(seen, seen[1:])]
    test.check("X: each kind is lit in another way", min(far) > 0.02, str(far))
    window.keys("shift+n")
    test.says("Shift N", window, "light 1 of 1: directional")
    test.check("Shift N: as before", share_apart(window.picture().rows, start, 10) == 0)
    window.keys("shift+n")
    test.says("no light", window, "no light")
    test.check("no light: ambient alone", {p for row in window.picture().rows for p in row} == {(0, 0, 0), (25, 24, 25)},
               str({p for row in window.picture().rows for p in row}))
    window.close()


def test_drawn_light(test):
    window = test.open(TORUS, "--light", "dir:1,0,0")
    test.shows("a torus", window, test.drawn("render", TORUS, *LEVELS, "--light", "dir:1,0,0"))
    start = window.picture().box((0, 0, 0))
    window.keys("y")
    test.check("Y: a ball to the right", until(lambda: window.picture().box((0, 0, 0))[2] > start[2]) and
               window.picture().box((0, 0, 0))[0] == start[0], f"{start} {window.picture().box((0, 0, 0))}")
    box = window.picture().box((0, 0, 0))
    column = [row[box[2] - 4] for row in window.picture().rows]
    test.equal("Y: it is white", max(column), (255, 255, 255))
    window.keys("y")
    test.shows("Y: and away", window, test.drawn("render", TORUS, *LEVELS, "--light", "dir:1,0,0"))
    window.close()


def test_turning_light(test):
    window = test.open(BALL)
    start = test.drawn("render", BALL, *LEVELS)
    test.shows("a ball", window, start)
    window.keys("b")
    test.check("B: it turns", until(lambda: share_apart(window.picture().rows, start, 60) > 0.2))
    window.keys("b")
    test.check("B: it stands", until(lambda: settled(window)))
    window.close()


# ---- Objects

def test_objects(test):
    window = test.open(TORUS)
    start = test.drawn("render", TORUS, *LEVELS)
    test.shows("a torus", window, start)
    left, top, right, bottom = window.picture().box((0, 0, 0))
    window.keys("t")

    def is_half_as_high():
        box = window.picture().box((0, 0, 0))
        return box and abs(box[2] - box[0] - (right - left)) <= 8 and 0.4 < (box[3] - box[1]) / (bottom - top) < 0.65

    test.check("T: half as high, as wide", until(is_half_as_high), f"{(left, top, right, bottom)} {window.picture().box((0, 0, 0))}")
    window.keys("t")
    test.shows("T: and back", window, start)
    window.keys("space")
    test.check("Space: coloured", until(lambda: not is_grey(window.picture().rows)))

    def is_by_normals():
        """What faces to the right is red, what faces to the left is not."""
        outer = [pixel for pixel in window.picture().rows[120] if pixel != (0, 0, 0)]
        return len(outer) > 4 and outer[-4][0] > outer[-4][1] and outer[-4][0] > outer[3][0] * 1.2

    test.check("Space: by normals", until(is_by_normals))
    window.keys("space")
    test.shows("Space: and plain", window, start)
    window.close()


def test_orbit(test):
    view = ["--at", "0,0,0", "--light", "dir:0.4,0.7,0.6", "--up", "0,1,0"]
    model = os.path.join(ROOT, "examples", "models", "teapot.obj")
    window = test.open(model, "--centre", "--eye", "0,0,3", *view)

    def drawn(eye):
        return test.drawn("render", model, "--centre", "--eye", ",".join("%.5f" % c for c in eye), *view, *LEVELS)

    def near(name, eye):
        wanted = drawn(eye)
        test.check(name, until(lambda: share_apart(window.picture().rows, wanted, 16) < 0.01),
                   str(share_apart(window.picture().rows, wanted, 16)))

    test.shows("before", window, drawn((0, 0, 3)))
    window.drag((300, 300), 80, 0)
    angle = math.radians(-40)
    near("drag across", (3 * math.sin(angle), 0, 3 * math.cos(angle)))
    window.drag((300, 300), -80, 60)
    angle = math.radians(30)
    near("drag back and down", (0, 3 * math.sin(angle), 3 * math.cos(angle)))
    window.drag((300, 300), 0, 400)
    angle = math.radians(89)
    near("drag: not over the top", (0, 3 * math.sin(angle), 3 * math.cos(angle)))
    window.drag((300, 300), 0, -178)
    near("drag: and back from there", (0, 0, 3))
    window.wheel(3)
    near("wheel", (0, 0, 3 * 0.9 ** 3))
    window.wheel(-4)
    near("wheel back", (0, 0, 3 / 0.9))
    window.close()


def test_turn(test):
    view = ["--at", "0,0,0", "--light", "dir:0.4,0.7,0.6", "--eye", "0,0,3", "--centre", *LEVELS]
    model = os.path.join(ROOT, "examples", "models", "teapot.obj")
    window = test.open(model, *view)
    test.shows("before", window, test.drawn("render", model, *view))

    def near(name, *options):
        wanted = test.drawn("render", model, *view, *options)
        test.check(name, until(lambda: share_apart(window.picture().rows, wanted, 16) < 0.01),
                   str(share_apart(window.picture().rows, wanted, 16)))

    window.drag((300, 300), 0, 60, button=3)
    near("right-drag down: the teapot turns below its light", "--rotate-x", "30")
    window.drag((300, 300), 80, 0, button=3)
    near("right-drag across", "--rotate-x", "30", "--rotate-y", "40")
    window.keys("Home")
    test.shows("Home", window, test.drawn("render", model, *view))
    window.close()


# ---- Scenes

def test_phong_lighting(test):
    """Each key does to the plain scene what its variants have: terms, and dark and coloured cylinders."""
    window = test.open("phong-lighting:plain")

    def shows(name, variant):
        test.shows(f"{name}: {variant}", window, test.drawn("scene", "phong-lighting:" + variant, *LEVELS))

    def cylinder(rows):
        return [[pixel for pixel, p, q in zip(*row) if p != q] for row in zip(rows, *cylinders)]

    cylinders = [test.drawn("scene", "phong-lighting:" + variant, *LEVELS) for variant in ("plain", "vertex-colours")]
    dark = cylinder(test.drawn("scene", "phong-lighting:dark", *LEVELS))
    shows("as it starts", "plain")
    window.keys("g")  # the ground of `dark` has a brighter highlight than that of `plain`
    test.check("g: the cylinder is dark", until(lambda: cylinder(window.picture().rows) == dark))
    for keys, variant in [(["shift+h"], "dark-diffuse-only"), (["shift+h", "g", "h"], "specular-only"),
                          (["h"], "diffuse-only"), (["h", "space"], "vertex-colours"), (["space"], "plain")]:
        window.keys(*keys)
        shows(" ".join(keys), variant)
    window.drag((300, 300), 60, 40, button=3)
    plain = test.drawn("scene", "phong-lighting:plain", *LEVELS)
    test.check("right-drag: the cylinder turns", until(lambda: share_apart(window.picture().rows, plain, 8) > 0.02))
    edges = [[row[:60] + row[-60:] for row in rows] for rows in (window.picture().rows, plain)]
    test.check("right-drag: the ground stays", edges[0] == edges[1], difference(*edges))
    window.close()


def test_scenes(test):
    window = test.open("teapot", size=(320, 160))
    test.shows("a scene", window, test.drawn("scene", "teapot", *LEVELS))
    window.keys("Right", "Right", "Right", "Left")
    test.shows("Left and Right", window, test.drawn("scene", "teapot", "--frame", "2", *LEVELS))
    test.says("the frame", window, "frame 2 of 36")
    window.keys("r")
    test.says("R: it runs", window, r"frame (1\d|2\d|3\d) of 36")
    window.keys("r")
    test.check("R: it stops", until(lambda: settled(window)))
    window.keys("Next")
    test.says("PgDn", window, "teapot:(?!fragment)[a-z-]+")
    name = window.side()[0]
    test.shows("PgDn: " + name, window, test.drawn("scene", name, *LEVELS))
    window.keys("Prior", "Prior")
    window.size = (320, 240)
    test.says("PgUp", window, "halloween:[a-z-]+")
    name = window.side()[0]
    test.shows("PgUp: " + name, window, test.drawn("scene", name, *LEVELS))
    window.close()


def test_dropped(test):
    window = test.open(TORUS)
    model = os.path.join(ROOT, "examples", "models", "spot.obj")
    drop.drop_file(test.screen.display, int(window.id), model)
    test.shows("a dropped file", window, test.drawn("render", model, *LEVELS))
    test.says("its name", window, "spot.obj")
    with open(os.path.join(window.folder.name, "bad.obj"), "w") as file:
        file.write("v 0 0 0\nf 1 2 3\n")
    drop.drop_file(test.screen.display, int(window.id), os.path.join(window.folder.name, "bad.obj"))
    bottom = window.height - 2 * 9 - 8
    test.check("a bad one is told of", until(lambda: any("bad.obj:2: position index 2 is out of range" in line for line in
                                                         window.read(8, bottom, window.width - 380, bottom + 16))))
    test.shows("and the one before stays", window, test.drawn("render", model, *LEVELS))
    window.close()


# ---- Grid

def grid_lines(window):
    """Columns and rows of the canvas in which the grid lies."""
    canvas, left, edge = window.canvas(), window.MARGIN, 10
    columns = [x - left for x in range(left, left + 960) if canvas[left + edge][3 * x:3 * x + 3] == MARK]
    rows = [y - left for y in range(left, left + 720) if canvas[y][3 * (left + edge):][:3] == MARK]
    return columns, rows


def test_grid(test):
    window = test.open(TORUS)
    window.keys("z")
    for tile in [32, 64, 8, 16]:
        wanted = [3 * x for x in range(tile, 320, tile)], [3 * y for y in range(tile, 240, tile)]
        test.check(f"Z: tiles of {tile}", until(lambda wanted=wanted: grid_lines(window) == wanted), str(grid_lines(window)))
        test.says("their size", window, f"tiles of {tile}x{tile}")
        window.keys("q")
    window.keys("z")
    test.shows("Z: and without", window, test.drawn("render", TORUS, *LEVELS))
    window.close()


# ---- Arena, bus

def slider_mark(window):
    """Columns of the slider's mark, in pixels of its width; None where it is not."""
    canvas, left = window.canvas(), window.width - window.SIDE + window.MARGIN
    for y, row in enumerate(canvas):
        columns = [x for x in range(left - 4, window.width) if row[3 * x:3 * x + 3] == MARK]
        if len(columns) == 7 and columns[-1] - columns[0] == 6 and canvas[y + 7][3 * left:3 * left + 3] != canvas[0][:3]:
            return (columns[0] - left + 3) / (window.SIDE - 2 * window.MARGIN - 1), left, y + 7
    return None


def test_arena(test):
    window = test.open(TORUS)
    start = test.drawn("render", TORUS, *LEVELS)
    test.shows("a torus", window, start)
    test.says("one pass", window, "1 pass, 80 tiles")
    most = int(test.says("its arena", window, r"arena (\d+) bytes")[0])
    least = int(test.says("and its ends", window, r"(\d+) \.\. %d" % most)[0])
    for key, share in [("a", 0.9), ("a", 0.8), ("shift+a", 0.9)]:
        window.keys(key)
        test.check(f"{key}: the slider", until(lambda share=share: abs(slider_mark(window)[0] - share) < 0.005), str(slider_mark(window)))
    at, left, y = slider_mark(window)
    window.drag((left + 20, y), -60, 0)
    test.check("the slider, dragged to its end", until(lambda: slider_mark(window)[0] == 0))
    test.says("the least arena", window, f"arena {least} bytes")
    passes = test.says("takes passes", window, r"(\d+) passes, 80 tiles")
    stats = dict(line.split(" ", 1) for line in test.run("render", TORUS, *LEVELS, "--arena", str(least), "--stats", "-o", "out.png").stdout.splitlines())
    test.equal("as many as on the command line", passes[0], stats["passes"])
    test.shows("and the same pixels", window, start)
    window.close()


def test_bus(test):
    window = test.open(TORUS)
    for key, bus in [("minus", 32), ("equal", 40), ("equal", 50)]:
        window.keys(key)
        test.says(f"{key}: the bus", window, rf"SPI {bus} MHz: send {320 * 240 * 16 / bus / 1000:.1f} ms")
    for key in ["minus"] * 6:
        window.keys(key)
    test.says("slow bus", window, "SPI 10 MHz: send 122.9 ms")
    window.close()


# ---- Files and help

def test_help(test):
    window = test.open(TORUS)
    window.keys("F1")
    found = until(lambda: [line for line in window.read(16, 16, 650, 690) if line.startswith("drag, wheel")])
    test.check("F1", found and "orbit, zoom" in found[0], str(found))
    window.keys("F1")
    test.shows("F1: and away", window, test.drawn("render", TORUS, *LEVELS))
    window.close()
    run = subprocess.run([test.view, "--help"], capture_output=True, text=True, check=False)
    test.check("--help lists the keys and the options", run.returncode == 0 and "I J K L" in run.stdout and "--viewer" in run.stdout)


def files(window, ending):
    return sorted(name for name in os.listdir(window.folder.name) if name.endswith(ending))


def test_screenshot(test):
    window = test.open(TORUS)
    start = test.drawn("render", TORUS, *LEVELS)
    window.keys("F2")
    test.check("F2", until(lambda: files(window, ".png") == ["torus_48x24-1.png"]), str(os.listdir(window.folder.name)))
    with open(os.path.join(window.folder.name, "torus_48x24-1.png"), "rb") as file:
        test.equal("F2: the picture", png.decode(file.read()).rows, start)
    window.keys("1", "F2")
    test.check("F2: another", until(lambda: files(window, ".png") == ["torus_48x24-1.png", "torus_48x24-2.png"]))
    with open(os.path.join(window.folder.name, "torus_48x24-2.png"), "rb") as file:
        test.equal("F2: the other picture", png.decode(file.read()).rows, window.picture().rows)
    window.close()


def test_bad_starts(test):
    run = subprocess.run([test.view, "none.obj"], env=test.screen.environment, capture_output=True, text=True, check=False)
    test.check("no such model", run.returncode == 2 and re.fullmatch(r"none\.obj:0: cannot be opened: .*\n", run.stderr), run.stderr)
    run = subprocess.run([test.view, "--nonsense"], env=test.screen.environment, capture_output=True, text=True, check=False)
    test.check("no such option", run.returncode == 2 and run.stderr.startswith("glint: unknown option --nonsense"), run.stderr)
    run = subprocess.run([test.view], env={**test.screen.environment, "DISPLAY": ":9999"}, capture_output=True, text=True, check=False)
    test.check("no screen", run.returncode == 2 and run.stderr.startswith("glint-view: no screen"), run.stderr)
    unseen = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
    run = subprocess.run([test.view], env=unseen, capture_output=True, text=True, check=False, timeout=60)
    test.check("no display: it does not run where nobody sees it", run.returncode == 2 and
               "glint-view: no screen: there is no display\n" in run.stderr, run.stderr)


def test_small_screen(test):
    screen = Screen(1280, 720)
    try:
        window = Window(screen, test.view, TORUS)
        test.check("the window fits a screen of 1280x720 with its title bar", window.width <= 1280 and window.height <= 680,
                   f"{window.width}x{window.height}")
        test.equal("and magnifies", window.scale(), 2)
        window.keys("F1")
        test.check("and the help fits the window", until(lambda: any(line.startswith("F2") for line in window.read(16, 16, 650, window.height))))
        window.close()
    finally:
        screen.close()


def main():
    test = Test(sys.argv[1], sys.argv[2])
    only = sys.argv[3:]
    for name in [name for name in globals() if name.startswith("test_") and (not only or name in only)]:
        test.test(name, globals()[name])
    test.screen.close()
    print(f"{test.passed} passed, {test.failed} failed")
    return 1 if test.failed or not test.passed else 0


if __name__ == "__main__":
    sys.exit(main())
