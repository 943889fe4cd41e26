# SPDX-License-Identifier: MIT
"""--labels: what is drawn over a picture and what is left alone, label.c by itself and `scene --labels`."""
import ctypes
import os
import re
import subprocess

import png
from harness import ROOT
from test_scene import SMALL, decode_movie, draw, scenes

SCENES = os.path.join(ROOT, "examples", "scenes")
BLACK, WHITE, GUARD = 0, 255, 64


class Pixels(ctypes.Structure):  # label_picture
    _fields_ = [("pixels", ctypes.c_void_p), ("width", ctypes.c_uint32), ("height", ctypes.c_uint32),
                ("channels", ctypes.c_uint32)]


class Label(ctypes.Structure):  # example_label
    _fields_ = [("text", ctypes.c_char_p)] + [(name, ctypes.c_uint16) for name in ("x", "y", "to_x", "to_y")]


def library(host):
    """label.c as a shared library."""
    if not os.path.exists(host.path("label.so")):
        subprocess.run(["cc", "-std=c99", "-shared", "-fPIC", "-I", os.path.join(ROOT, "src"), "-I",
                        os.path.join(ROOT, "examples"), os.path.join(ROOT, "port", "host", "label.c"), "-o",
                        host.path("label.so")], check=True)
    return ctypes.CDLL(host.path("label.so"))


def label_rows(host, rows, labels, composed=None):
    """Rows of tuples with labels (text, x, y, to_x, to_y) drawn over them; fails when bytes beside them change."""
    width, height, channels = len(rows[0]), len(rows), len(rows[0][0])
    data = bytes(level for row in rows for pixel in row for level in pixel)
    guard = bytes([GUARD] * 4096)
    memory = ctypes.create_string_buffer(guard + data + guard, len(data) + 2 * len(guard))
    drawn = Pixels(ctypes.addressof(memory) + len(guard), width, height, channels)
    listed = (Label * max(1, len(labels)))(*[Label(text.encode("latin-1"), *places) for text, *places in labels])
    library(host).label_draw(ctypes.byref(drawn), listed if labels else None, len(labels), *(composed or (width, height)))
    if memory.raw[:len(guard)] != guard or memory.raw[-len(guard):] != guard:
        raise AssertionError(f"{labels} on {width}x{height}: written outside the picture")
    data = memory.raw[len(guard):-len(guard)]
    at = range(0, len(data), channels)
    pixels = [tuple(data[i:i + channels]) for i in at]
    return [pixels[y * width:(y + 1) * width] for y in range(height)]


def noise(width, height, channels=3):
    """Levels that are all over the place, and neither black nor white."""
    return [[tuple(1 + (x * 37 + y * 101 + c * 59 + x * y) % 254 for c in range(channels)) for x in range(width)]
            for y in range(height)]


def changes(before, after):
    """{(x, y): level} of what differs; None as the level of what is neither black nor white."""
    return {(x, y): q[0] if set(q) in ({BLACK}, {WHITE}) else None for y, (a, b) in enumerate(zip(before, after))
            for x, (p, q) in enumerate(zip(a, b)) if p != q}


def plate(text, x, y, width, height):
    """The pixels of a text's plate: 5x8 a character, one pixel between and around them; inside the picture."""
    lines = text.split("\n")
    wide, high = 6 * max(len(line) for line in lines) + 1, 9 * len(lines) + 1
    left, top = max(0, min(x - wide // 2, width - wide)), max(0, min(y - high // 2, height - high))
    return {(i, j) for i in range(left, min(left + wide, width)) for j in range(top, min(top + high, height))}


def corner(pixels):
    return min(x for x, _ in pixels), min(y for _, y in pixels)


def ink(host, text):
    """The white pixels of a text, from the corner of its plate."""
    size = (6 * len(text) + 9, 9 * text.count("\n") + 20)
    plain = noise(*size)
    drawn = changes(plain, label_rows(host, plain, [(text, size[0] // 2, size[1] // 2, 0, 0)]))
    left, top = corner(drawn)
    return {(x - left, y - top) for (x, y), level in drawn.items() if level == WHITE}


def test_plates(host):
    for text, x, y, width, height in (
            ("Phong", 50, 30, 100, 60), ("per vertex\nBlinn-Phong", 60, 40, 120, 80), ("x", 10, 10, 20, 20),
            ("at the left", 3, 30, 100, 60), ("at the right", 97, 30, 100, 60), ("above", 50, 0, 100, 60),
            ("below\nit", 50, 59, 100, 60), ("outside", 500, 700, 100, 60), ("wider than all", 20, 20, 40, 40),
            ("high\nhigh\nhigh", 20, 8, 40, 16), ("a", 0, 0, 1, 1), ("", 10, 10, 20, 20), ("\n\n", 20, 20, 40, 40)):
        for channels in (1, 3):
            plain = noise(width, height, channels)
            drawn = changes(plain, label_rows(host, plain, [(text, x, y, 0, 0)]))
            title = f"plate of {text!r} at {x},{y} of {width}x{height}, {channels} channels"
            host.equal(f"{title}: what changes", set(drawn), plate(text, x, y, width, height))
            host.check(f"{title}: black and white", set(drawn.values()) <= {BLACK, WHITE}, str(set(drawn.values())))
            left, top = corner(drawn)
            white = {(i - left, j - top) for (i, j), level in drawn.items() if level == WHITE}
            host.equal(f"{title}: text", white, {(i, j) for i, j in ink(host, text) if (i + left, j + top) in drawn})
    plain = noise(64, 48)
    host.equal("no labels, no change", label_rows(host, plain, []), plain)


def test_font(host):
    glyphs = {code: ink(host, chr(code)) for code in range(1, 256) if code != 10}
    printable = range(33, 127)
    host.check("glyphs are 5x8 with a margin of one", all(1 <= x <= 5 and 1 <= y <= 8 for g in glyphs.values() for x, y in g))
    host.equal("a space is empty", glyphs[32], set())
    host.equal("printable characters differ", len({frozenset(glyphs[code]) for code in printable}), len(printable))
    host.check("capitals and digits are 7 high", all(
        {min(y for _, y in glyphs[ord(c)]), max(y for _, y in glyphs[ord(c)])} == {1, 7} for c in "ABCXYZ0123456789"))
    box = {(x, y) for x in range(1, 6) for y in range(1, 8) if x in (1, 5) or y in (1, 7)}
    host.check("the others are boxes", all(g == box for code, g in glyphs.items() if not 32 <= code <= 126))
    host.equal("characters stand side by side", ink(host, "Ag"), glyphs[65] | {(x + 6, y) for x, y in glyphs[103]})
    host.equal("lines are in the middle", ink(host, "A\nagb"),
               {(x + 6, y) for x, y in glyphs[65]} | {(x, y + 9) for x, y in ink(host, "agb")})


def distance(point, start, end):
    """From a point to the segment between two."""
    (px, py), (ax, ay), (bx, by) = point, start, end
    squared = (bx - ax) ** 2 + (by - ay) ** 2
    part = max(0.0, min(1.0, ((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / squared)) if squared else 0.0
    return ((px - ax - part * (bx - ax)) ** 2 + (py - ay - part * (by - ay)) ** 2) ** 0.5


def around(point, radius):
    return {(point[0] + i, point[1] + j) for i in range(-radius, radius + 1) for j in range(-radius, radius + 1)}


def test_leaders(host):
    width, height = 120, 90
    for to_x, to_y in ((10, 10), (110, 12), (12, 80), (100, 88), (60, 2), (60, 89), (0, 45), (119, 45), (61, 46), (0, 1),
                       (150, 60)):
        plain = noise(width, height)
        drawn = changes(plain, label_rows(host, plain, [("mid", 60, 45, to_x, to_y)]))
        inside = plate("mid", 60, 45, width, height)
        white = {p for p, level in drawn.items() if level == WHITE} - inside
        title = f"line to {to_x},{to_y}"
        seen = {(x, y) for x in range(width) for y in range(height)} - inside
        host.check(f"{title}: black and white", set(drawn.values()) <= {BLACK, WHITE})
        host.check(f"{title}: the plate is as without", all(drawn[p] == level for p, level in changes(
            plain, label_rows(host, plain, [("mid", 60, 45, 0, 0)])).items()))
        dot, edge = around((to_x, to_y), 1), around((to_x, to_y), 2)
        host.check(f"{title}: a pixel wide", all(distance(p, (60, 45), (to_x, to_y)) <= 0.51 for p in white - dot))
        host.check(f"{title}: without a gap", all(any((x, y) in white for y in range(height)) for x in range(
            min(60, to_x), min(max(60, to_x), width - 1) + 1) if all((x, y) in seen for y in range(height))))
        host.check(f"{title}: ends in a dot", dot & seen <= white)
        edges = set().union(edge, *(around(p, 1) for p in white))
        host.check(f"{title}: has an edge", edges & seen <= set(drawn))
        host.check(f"{title}: changes nothing else", all(p in inside or p in edge or distance(
            p, (60, 45), (to_x, to_y)) <= 2.2 for p in drawn))
    both = [("one", 20, 45, 110, 45), ("two", 80, 45, 0, 0)]
    for labels in (both, both[::-1]):
        drawn = changes(plain, label_rows(host, plain, labels))
        alone = changes(plain, label_rows(host, plain, [both[1]]))
        host.check("a line goes below every plate", all(drawn[p] == level for p, level in alone.items()))
        host.check("and on behind it", drawn.get((105, 45)) == WHITE)


def test_sizes(host):
    """Composed for 100x50: the text keeps its size; places go with the height, about the middle across."""
    for (width, height), (x, y), (to_x, to_y) in (((200, 100), (61, 41), (150, 30)), ((100, 50), (30, 20), (75, 15)),
                                                  ((300, 100), (111, 41), (200, 30)), ((60, 50), (10, 20), (55, 15))):
        plain = noise(width, height)
        drawn = changes(plain, label_rows(host, plain, [("Text", 30, 20, 75, 15)], (100, 50)))
        near = [(x + i, y + j) for i in (0, -1) for j in (0, -1)]
        host.check(f"{width}x{height}: the plate", any(plate("Text", *p, width, height) <= set(drawn) for p in near))
        dots = [p for p in drawn if all(drawn.get(q) == WHITE for q in around(p, 1))]
        host.check(f"{width}x{height}: the dot", any(max(abs(p[0] - to_x), abs(p[1] - to_y)) <= 1 for p in dots), str(dots))


def source_of(scene):
    """The text of the file that has a scene."""
    for name in os.listdir(SCENES):
        if name.endswith(".c"):
            with open(os.path.join(SCENES, name), encoding="utf-8") as file:
                text = file.read()
            if f'.name = "{scene}"' in text:
                return text
    raise AssertionError(f"no source of {scene}")


def shader_labels():
    """{shape: [label]} of the scene `shaders`, from its source."""
    found = re.findall(r'\{"([^"]+)", (\d+), (\d+), (\d+), (\d+)\}', source_of("shaders"))
    labels = [(text.replace("\\n", "\n"), *map(int, numbers)) for text, *numbers in found]
    return {shape: labels[:4] + labels[4 + 2 * i:6 + 2 * i] for i, shape in enumerate(("torus", "cylinder", "sphere"))}


def test_shaders(host):
    for shape, labels in shader_labels().items():
        for exponent in (50, 100):
            name = f"shaders:{shape}-{exponent}"
            plain = png.decode(draw(host, name)).rows
            drawn = png.decode(draw(host, name, "--labels")).rows
            host.equal(f"{name} has labels", drawn, label_rows(host, plain, labels))
            host.check(f"{name} has them with --labels only", WHITE in changes(plain, drawn).values())
        counts = []
        for mesh in re.findall(rf'"meshes/({shape}\w+\.h)"', source_of("shaders")):
            with open(os.path.join(ROOT, "examples", "meshes", mesh), encoding="utf-8") as header:
                counts.append(int(re.search(r" (\d+) triangles,", header.read()).group(1)))
        host.equal(f"{shape}: the triangles that its labels tell", [text for text, *_ in labels[4:]],
                   [f"{count} triangles each" for count in sorted(counts)])
        inside = [plate(text, x, y, 320, 180) for text, x, y, *_ in labels]
        host.check(f"{shape}: no label hides another", sum(map(len, inside)) == len(set().union(*inside)))


def test_formats(host):
    labels = shader_labels()["torus"]
    for options in ([["--format", f] for f in ("rgb565", "rgb565_be", "rgb444", "rgb888", "grey8", "grey4", "mono")] +
                    [["--dither", "--format", "mono"], ["--gamma", "2.2"], ["--tile", "8x8"], ["--size", "640x360"],
                     ["--size", "500x180"], ["--size", "100x180"], SMALL, ["--size", "1x1"]]):
        plain = png.decode(draw(host, "shaders", *options)).rows
        host.equal(f"labels with {' '.join(options)}", png.decode(draw(host, "shaders", *options, "--labels")).rows,
                   label_rows(host, plain, labels, (320, 180)))


def test_scenes(host):
    """Whatever a scene's labels are: they change nothing but pixels to black and white, and every frame has them."""
    size = ["--size", "200x150"]
    for name, (_, _, frames, variants) in scenes(host).items():
        has_labels = "example_label" in source_of(name)
        for variant in variants:
            plain, drawn = (draw(host, f"{name}:{variant}", *size, *labels) for labels in ([], ["--labels"]))
            levels = changes(png.decode(plain).rows, png.decode(drawn).rows).values()
            host.check(f"{name}:{variant} --labels: black and white", set(levels) <= {BLACK, WHITE})
            if not has_labels:
                host.equal(f"{name}:{variant} has no labels", drawn, plain)
        movie, _ = decode_movie(host, draw(host, name, *size, "--labels", "--animate", "3"), f"{name} with labels")
        host.check(f"{name}: every frame has labels", movie == [png.decode(draw(
            host, name, *size, "--labels", "--frame", str(i * frames // 3))).rows for i in range(3)])
