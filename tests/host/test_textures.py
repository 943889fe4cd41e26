# SPDX-License-Identifier: MIT
"""Textures: pictures of PNG, what materials say of them, what is drawn, and what `convert` writes."""
import base64
import json
import math
import os
import random
import re
import struct
import subprocess
import zlib

import png
from harness import MODELS
from test_convert import STRICT, convert
from test_formats import gltf

# A square that fills the view, the picture's left lower corner at its own.
SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
COORDINATES = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
FACE = "f 1/1 2/2 3/3 4/4\n"
MODEL = "mtllib t.mtl\n" + SQUARE + COORDINATES + "usemtl paint\n" + FACE
PAINT = "newmtl paint\nillum 0\nKd 1 1 1\nmap_Kd picture.png\n"
VIEW = ["--eye", "0,0,3", "--orthographic", "2", "--size", "64x64"]
SIDE = 8  # texels of pictures that are looked at one by one, each 8 pixels wide
SAMPLES = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}


def filtered(kind, row, above, step):
    """A row as a filter of PNG leaves it."""
    left, corners = bytes(step) + row, bytes(step) + above
    guesses = [lambda i: 0, lambda i: left[i], lambda i: above[i], lambda i: (left[i] + above[i]) // 2,
               lambda i: png.paeth(left[i], above[i], corners[i])]
    return bytes([kind]) + bytes((value - guesses[kind](i)) & 255 for i, value in enumerate(row))


def encode(rows, depth=8, colour=2, extra=(), methods=(0, 0, 0), packer=None, parts=1):
    """A PNG file of rows of samples; its rows have all filters in turn, its data lie in several chunks."""
    width, samples = len(rows[0]) // SAMPLES[colour], SAMPLES[colour]
    raw, above = b"", bytes((width * samples * depth + 7) // 8)
    for y, row in enumerate(rows):
        bits = "".join(f"{sample:0{depth}b}" for sample in row)
        packed = int(bits.ljust(8 * len(above), "0"), 2).to_bytes(len(above), "big")
        raw += filtered(y % 5, packed, above, max(1, samples * depth // 8))
        above = packed
    packer = packer or zlib.compressobj()
    data = packer.compress(raw) + packer.flush()
    cuts = [len(data) * i // parts for i in range(parts + 1)]
    return (png.SIGNATURE + png.head(width, len(rows), depth, colour, methods) + b"".join(png.chunk(*e) for e in extra) +
            b"".join(png.chunk(b"IDAT", data[a:b]) for a, b in zip(cuts, cuts[1:])) + png.chunk(b"IEND", b""))


def picture(colour_at, width=SIDE, height=SIDE):
    return encode([[level for x in range(width) for level in colour_at(x, y)] for y in range(height)])


def letters(x, y):
    """No two texels are alike, and no turn or mirror image is."""
    return 36 * x, 36 * y, 255 if x < 2 or y < 1 else 0


def stored565(colour):
    """The levels of a colour in RGB565, rounded."""
    red, green, blue = ((level * full + 127) // 255 for level, full in zip(colour, (31, 63, 31)))
    return red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2


def write(host, data, paint=PAINT, model=MODEL):
    host.write("picture.png", data)
    host.write("t.mtl", paint)
    host.write("t.obj", model)


def texels(host, *options, model="t.obj", side=SIDE):
    """The levels of each texel of the square that is drawn."""
    image = host.render(model, *VIEW, *options)
    step = 64 // side
    return [[image.at(x * step + step // 2, y * step + step // 2) for x in range(side)] for y in range(side)]


def near(got, wanted, most=1):
    return all(abs(a - b) <= most for rows in zip(got, wanted) for pair in zip(*rows) for a, b in zip(*pair))


def shown(colour_at):
    return [[stored565(colour_at(x, y)) for x in range(SIDE)] for y in range(SIDE)]


def test_each_type_of_png(host):
    """Whoever saves a picture does not know which of the fifteen types of PNG it has."""
    numbers = random.Random(1)
    for colour, depths in ((0, (1, 2, 4, 8, 16)), (2, (8, 16)), (3, (1, 2, 4, 8)), (4, (8, 16)), (6, (8, 16))):
        for depth in depths:
            count, full = SAMPLES[colour], 2 ** depth - 1
            rows = [[numbers.randint(0, full) for _ in range(SIDE * count)] for _ in range(SIDE)]
            palette = [tuple(numbers.randint(0, 255) for _ in range(3)) for _ in range(full + 1 if depth <= 8 else 0)]
            if colour in (4, 6):  # no holes
                rows = [[full if i % count == count - 1 else sample for i, sample in enumerate(row)] for row in rows]
            extra = [(b"PLTE", b"".join(map(bytes, palette)))] if colour == 3 else []
            write(host, encode(rows, depth, colour, extra))
            wanted = [[palette[row[x]] if colour == 3 else
                       tuple(round(row[x * count + (c if count >= 3 else 0)] * 255 / full) for c in range(3))
                       for x in range(SIDE)] for row in rows]
            wanted = [[stored565(levels) for levels in row] for row in wanted]
            got = texels(host, "--texture-type", "rgb565")
            host.check(f"colour type {colour} of {depth} bits", near(got, wanted), f"{got[0]}, not {wanted[0]}")


def test_each_way_to_pack(host):
    write(host, picture(letters))
    plain = texels(host)
    host.check("the picture stands upright", near(plain, shown(letters)), str(plain[0]))
    rows = [[level for x in range(SIDE) for level in letters(x, y)] for y in range(SIDE)]
    noise = random.Random(2)
    long = [[noise.choice((0, 0, 0, 255)) for _ in range(3 * 64)] for _ in range(64)]
    for name, level, strategy in (("stored", 0, 0), ("fixed codes", 9, zlib.Z_FIXED), ("codes of its own", 9, 0),
                                  ("no matches", 9, zlib.Z_HUFFMAN_ONLY), ("runs", 9, zlib.Z_RLE)):
        def pack(data, parts):
            return encode(data, packer=zlib.compressobj(level, zlib.DEFLATED, 15, 9, strategy), parts=parts)  # pylint: disable=cell-var-from-loop
        write(host, pack(rows, 3))
        host.equal(name, texels(host), plain)
        write(host, pack(long, 2))
        got = texels(host, "--texture-type", "rgb565", side=64)
        host.check(f"{name}, longer", near(got, [[tuple(row[3 * x:3 * x + 3]) for x in range(64)] for row in long]))


STORED = encode([[9] * 3 * SIDE] * SIDE, packer=zlib.compressobj(0))
BAD = [
    ("a wrong level", lambda data: STORED[:-40] + b"\xff" + STORED[-39:], "its pixels are damaged, or cut off"),
    ("cut", lambda data: data[:len(data) // 2], "the file is cut off"),
    ("cut within the head", lambda data: data[:20], "the file is cut off"),
    ("without pixels", lambda data: data[:33] + png.chunk(b"IEND", b""), "the file is cut off"),
    ("a wrong byte", lambda data: data[:60] + bytes([data[60] ^ 16]) + data[61:], "its pixels are damaged, or cut off"),
    ("fewer rows", lambda data: data[:16] + struct.pack(">2I", SIDE, SIDE + 1) + data[24:], "its pixels are damaged, or cut off"),
    ("more rows", lambda data: data[:16] + struct.pack(">2I", SIDE, SIDE - 1) + data[24:], "its pixels are damaged, or cut off"),
    ("no depth", lambda data: data[:24] + b"\3" + data[25:], "its head is damaged"),
    ("no colour type", lambda data: data[:25] + b"\5" + data[26:], "its head is damaged"),
    ("no size", lambda data: data[:16] + bytes(4) + data[20:], "its head is damaged"),
    ("too wide", lambda data: data[:16] + struct.pack(">2I", 4097, 1) + data[24:], "it has 4097x1 pixels: at most 4096x4096 are read"),
    ("a bomb", lambda data: data[:16] + struct.pack(">2I", 2**31 - 1, 2**31 - 1) + data[24:],
     "it has 2147483647x2147483647 pixels: at most 4096x4096 are read"),
    ("interlaced", lambda data: data[:28] + b"\1" + data[29:], "it is interlaced, which is not read: save it without"),
    ("no palette", lambda data: data[:25] + b"\3" + data[26:], "it has no palette"),
    ("GIF", lambda data: b"GIF89a", "it is GIF, which is not read: save it as PNG"),
    ("text", lambda data: b"P3 1 1 255 0 0 0", "it is neither PNG nor JPEG"),
    ("empty", lambda data: b"", "it is neither PNG nor JPEG"),
]


def test_bad_pictures(host):
    """The model is drawn without the picture, and one line says why."""
    write(host, picture(letters), PAINT.replace("map_Kd picture.png\n", ""))
    bare = host.render_bytes("t.obj", *VIEW)
    for name, spoil, why in BAD:
        write(host, spoil(picture(letters)))
        run = host.run("render", "t.obj", *VIEW, "-o", "out.png")
        host.equal(f"{name} is told", (run.returncode, run.stderr),
                   (0, f"t.mtl:4: warning: the texture 'picture.png' is not drawn: {why}\n"))
        host.equal(f"{name} is drawn without", host.read("out.png"), bare)
        host.refuses(f"--texture, {name}", ["info", "t.obj", "--texture", "picture.png"],
                     rf"t\.obj:0: --texture picture\.png: {re.escape(why)}")
    for name, paint, why in [("missing", PAINT.replace("picture", "other"), "the texture 'other.png' is not drawn: cannot be read"),
                             ("outside", PAINT.replace("picture", "../other"), "the texture '../other.png' is not drawn: is not in the model's folder")]:
        write(host, picture(letters), paint)
        run = host.run("render", "t.obj", *VIEW, "-o", "out.png")
        host.equal(f"{name} is told", (run.returncode, run.stderr), (0, f"t.mtl:4: warning: {why}\n"))
        host.equal(f"{name} is drawn without", host.read("out.png"), bare)
    write(host, picture(letters), model=MODEL.replace(COORDINATES, "").replace(FACE, "f 1 2 3 4\n"))
    run = host.run("render", "t.obj", *VIEW, "-o", "out.png")
    host.equal("no coordinates", (run.returncode, run.stderr),
               (0, "t.mtl:4: warning: the texture 'picture.png' is not drawn: the triangles have no texture coordinates\n"))
    host.refuses("--texture without coordinates", ["info", "t.obj", "--texture", "picture.png"],
                 r"t\.obj:0: --texture: the model has no texture coordinates")
    write(host, picture(letters), model=MODEL.replace("usemtl", "f 1 2 3\nusemtl"))
    host.equal("--texture leaves what has no coordinates", host.info("t.obj", "--texture", "picture.png")["materials"], "1")
    host.refuses("--texture, missing", ["render", "box", "--texture", "no.png", "-o", "x.png"], r"box:0: --texture no\.png: .+")


def test_what_materials_say(host):
    write(host, picture(letters))
    plain = host.render_bytes("t.obj", *VIEW)
    moved = MODEL.replace(COORDINATES, "vt 0.25 -1.25\nvt 2.25 -1.25\nvt 2.25 1.75\nvt 0.25 1.75\n")
    write(host, picture(letters), model=moved)
    repeated = host.render_bytes("t.obj", *VIEW)
    host.check("coordinates beyond 1 repeat the picture", repeated != plain)
    for name, paint, model, wanted in [
            ("-s and -o", "map_Kd -s 2 3 1 -o 0.25 -1.25 0 picture.png", MODEL, repeated),
            ("fewer numbers", "map_Kd -s 2 -o 0.25 picture.png",
             MODEL.replace(COORDINATES, "vt 0.25 0\nvt 2.25 0\nvt 2.25 1\nvt 0.25 1\n").replace("t.mtl", "plain.mtl"), None),
            ("quotes", 'map_Kd "picture.png"', MODEL, plain), ("backslashes", "map_Kd C:\\textures\\picture.png", MODEL, plain),
            ("a folder of another machine", "map_Kd /home/me/picture.png", MODEL, plain),
            ("v counts from the end", "map_Kd picture.png", MODEL.replace(FACE, "f 1/-4 2/-3 3/-2 4/-1\n"), plain),
            ("the last of two", "map_Kd no.png\nmap_Kd picture.png", MODEL, plain)]:
        write(host, picture(letters), PAINT.replace("map_Kd picture.png", paint), model)
        host.write("plain.mtl", PAINT)
        if wanted is None:
            wanted = host.render_bytes("t.obj", *VIEW)
            write(host, picture(letters), PAINT.replace("map_Kd picture.png", paint))
        host.equal(name, host.render_bytes("t.obj", *VIEW), wanted)
    write(host, picture(letters), PAINT.replace("map_Kd ", "map_Kd -bm 0.5 -imfchan r -clamp on "))
    run = host.run("render", "t.obj", *VIEW, "-o", "out.png")
    host.equal("options that are not followed", (run.returncode, run.stderr),
               (0, "t.mtl:4: warning: '-bm' of a texture is skipped: -clamp, -s and -o are followed (and 1 more)\n"))
    for name, paint, factor in (("Kd", "Kd .5 .25 1", (.5, .25, 1)), ("Kd 0, as some exporters write it", "Kd 0 0 0", (1, 1, 1)), ("no Kd", "", (1, 1, 1))):
        write(host, picture(letters), PAINT.replace("Kd 1 1 1", paint))
        wanted = [[tuple(round(f * level) for f, level in zip(factor, colour)) for colour in row] for row in shown(letters)]
        host.check(f"{name} times the picture", near(texels(host), wanted, 2), str(texels(host)[0]))


def test_drawn_as_materials_say(host):
    """Holes show what is behind, -clamp the edge, --bilinear means, and light falls on the picture."""
    rows = [[level for x in range(SIDE) for level in (*letters(x, y), 255 * ((x + y) % 3 > 0))] for y in range(SIDE)]
    write(host, encode(rows, colour=6))
    wanted = [[colour if (x + y) % 3 else (0, 0, 0) for x, colour in enumerate(row)] for y, row in enumerate(shown(letters))]
    host.check("holes", near(texels(host), wanted, 8), str(texels(host)[0]))
    beyond = MODEL.replace(COORDINATES, "vt -0.5 -0.5\nvt 1.5 -0.5\nvt 1.5 1.5\nvt -0.5 1.5\n")
    write(host, picture(letters), PAINT.replace("map_Kd ", "map_Kd -clamp on "), beyond)
    colours = shown(letters)
    places = [min(max(2 * i - 4, 0), 7) for i in range(SIDE)]
    got = host.render("t.obj", *VIEW)  # a texel is 4 pixels wide
    edges = [[got.at(8 * x + 2, 8 * y + 2) for x in range(SIDE)] for y in range(SIDE)]
    host.check("-clamp on", near(edges, [[colours[y][x] for x in places] for y in places]), str(edges[0]))
    write(host, picture(lambda x, y: (32 * x, 32 * y, 128)))
    got = host.render("t.obj", *VIEW, "--bilinear")
    between = [[got.at(x, y) for x in (12, 28, 44)] for y in (12, 28, 44)]
    host.check("--bilinear", near(between, [[(4 * x - 16, 4 * y - 16, 128) for x in (12, 28, 44)] for y in (12, 28, 44)], 6), str(between))
    write(host, picture(letters), PAINT.replace("illum 0\nKd 1 1 1", "illum 1\nKd .5 .5 .5"))
    lit = [[tuple(round(level * .55) for level in colour) for colour in row] for row in colours]
    got = texels(host, "--light", "dir:0,0,1")
    host.check("lit", near(got, lit, 3), str(got[0]))


def arrays(text, name):
    """Width, height, key or None, and the levels of each texel of a converted texture."""
    body = re.search(rf"glint_texture {name} = \{{\n    &glint_texture_(\w+),\n    (\w+),\n    (\w+).*?,.*?\n    (\d+), /\* width \*/\n    (\d+), "
                     rf"/\* height \*/\n    (\w+),\n    (\d+), /\* key \*/\n    (?:0|&\w+),.*?\n\}};", text)
    kind, packed, palette, width, height, flags, key = body.groups()
    values = {array: [int(v) for v in re.search(rf" {array}\[\d+\] = \{{(.*?)\}};", text, re.DOTALL)[1].replace(",", " ").split()]
              for array in (packed, palette) if array != "0"}
    codes = values[packed]
    if kind == "palette16":
        codes = [code for byte in codes for code in (byte >> 4, byte & 15)][:int(width) * int(height)]
    levels = [(code,) * 3 if kind == "grey8" else (value >> 11) * 255 / 31 and ((value >> 11) << 3 | value >> 13, (value >> 5 & 63) << 2 | value >> 9 & 3,
                                                                             (value & 31) << 3 | value >> 2 & 7)
              or (0, (value >> 5 & 63) << 2 | value >> 9 & 3, (value & 31) << 3 | value >> 2 & 7)
              for code in codes for value in [values[palette][code] if palette != "0" else code]]
    holes = [flags != "0" and code == int(key) for code in codes]
    return kind, int(width), int(height), levels, holes


def mean_square(levels, wanted):
    return sum((a - b) ** 2 for one, other in zip(levels, wanted) for a, b in zip(one, other)) / 3 / len(wanted)


def converted(host, *options):
    """The header, and the line on its texture that is printed."""
    run = host.run("convert", "t.obj", "-o", "t.h", *options)
    host.equal(f"converts {' '.join(options)}", (run.returncode, run.stderr), (0, ""))
    return host.read("t.h").decode(), re.search(r"^texture (\d+)x(\d+) (\w+) (\d+) (.*)$", run.stdout, re.MULTILINE).groups(), run.stdout


def test_the_smallest_type(host):
    """Flash is what microcontrollers are short of; 35 dB are promised."""
    numbers = random.Random(3)
    many = [tuple(numbers.randint(0, 255) for _ in range(3)) for _ in range(150)]
    for name, side, colour_at, kind, size in [
            ("levels of grey", 16, lambda x, y: (16 * y + x,) * 3, "grey8", 256),
            ("four colours", 32, lambda x, y: (255 * (x > 9), 60, 200 * (y > 20)), "palette16", 512 + 32),
            ("150 colours", 64, lambda x, y: many[(x * 64 + y) % 150], "palette256", 4096 + 512),
            ("noise", 64, lambda x, y: tuple(numbers.randint(0, 255) for _ in range(3)), "rgb565", 2 * 4096),
            ("two by two", 2, lambda x, y: (255 * x, 255 * y, 0), "rgb565", 8)]:
        wanted = [colour_at(x, y) for y in range(side) for x in range(side)]
        write(host, encode([[level for colour in wanted[y * side:(y + 1) * side] for level in colour] for y in range(side)]))
        text, (width, height, told, told_size, ratio), stdout = converted(host)
        got, *sizes, levels, _ = arrays(text, "t_texture_paint")
        error = mean_square(levels, wanted)
        host.equal(f"{name}: type and bytes", (got, told, int(told_size), sizes), (kind, kind, size, [int(width), int(height)]))
        host.check(f"{name}: the error is what is told", ratio == "exact" and error == 0 or
                   error > 0 and abs(10 * math.log10(255 * 255 / error) - float(ratio)) < 0.06, f"{error} {ratio}")
        host.check(f"{name}: and no more than is promised", error <= 255 * 255 / 10 ** 3.5, str(error))
        bare = int(re.search(r"(\d+) bytes of flash", text)[1]) - size
        host.check(f"{name}: flash", f"flash_bytes {bare + size}\n" in stdout and bare == 2 * 6 + 4 * (6 + 6 + 4), f"{bare} {size}")
        for forced in ("rgb565", "grey8", "palette256", "palette16"):
            host.equal(f"{name} as {forced}", arrays(converted(host, "--texture-type", forced)[0], "t_texture_paint")[0], forced)


def test_dither(host):
    """Bands of few colours become grains: areas keep their colour."""
    wanted = [(4 * x, 4 * y, 128) for y in range(64) for x in range(64)]
    write(host, picture(lambda x, y: (4 * x, 4 * y, 128), 64, 64))

    def blocks(levels):
        return [tuple(sum(levels[(y + j) * 64 + x + i][c] for j in range(8) for i in range(8)) / 64 for c in range(3))
                for y in range(0, 64, 8) for x in range(0, 64, 8)]
    errors = [mean_square(blocks(arrays(converted(host, "--texture-type", "palette16", *options)[0], "t_texture_paint")[3]), blocks(wanted))
              for options in ([], ["--texture-dither"])]
    host.check("areas keep their colour", errors[1] < errors[0] / 2, str(errors))


def test_sizes(host):
    """Whatever size a picture has, its texture has powers of two, each texel the mean of what it covers."""
    for size, options, wanted in [((6, 3), [], (8, 4)), ((22, 23), [], (16, 32)), ((8, 8), ["--texture-size", "4"], (4, 4)),
                                  ((16, 2), ["--texture-size", "4"], (4, 1)), ((8, 8), ["--texture-size=7"], (4, 4)), ((1, 1), [], (1, 1))]:
        write(host, picture(lambda x, y: (9 * x, 9 * y, 0), *size))
        host.equal(f"{size} {options}", arrays(converted(host, *options)[0], "t_texture_paint")[1:3], wanted)
    numbers = random.Random(4)
    colours = [[tuple(numbers.randint(0, 255) for _ in range(3)) for _ in range(8)] for _ in range(8)]
    write(host, picture(lambda x, y: colours[y][x]))
    means = [stored565([round(sum(colours[2 * y + j][2 * x + i][c] for j in (0, 1) for i in (0, 1)) / 4) for c in range(3)])
             for y in range(4) for x in range(4)]
    got = arrays(converted(host, "--texture-size", "4", "--texture-type", "rgb565")[0], "t_texture_paint")[3]
    host.check("means", all(abs(a - b) <= 8 for one, other in zip(got, means) for a, b in zip(one, other)), f"{got} {means}")
    for value in ("0", "1025", "many"):
        host.refuses(f"--texture-size {value}", ["info", "t.obj", "--texture-size", value], r"glint: --texture-size .*: takes texels from 1 to 1024")


def test_levels(host):
    """Each level has means of what is below it, and holes where most of that is hole; flash says what all take."""
    numbers = random.Random(6)
    for width, height, kind, alpha in [(16, 16, "rgb565", 255), (16, 4, "palette256", 255), (2, 8, "palette16", 0), (8, 8, "grey8", 0), (1, 1, "rgb565", 255)]:
        colours = [[(8 * numbers.randint(0, 31),) * 3 + (numbers.choice((alpha, 255)),) for _ in range(width)] for _ in range(height)]
        write(host, encode([[level for colour in row for level in colour] for row in colours], colour=6))
        plain = converted(host, "--texture-type", kind)
        text, (*_, size, _), stdout = converted(host, "--texture-type", kind, "--texture-levels")
        names = ["t_texture_paint"] + [f"t_texture{i}_paint" for i in range(1, max(width, height).bit_length())]
        host.equal(f"{kind}: levels", re.findall(r"glint_texture (\w+) = ", text), names[::-1])
        host.equal(f"{kind}: each names the next, and the material the largest", re.findall(r"&(t_texture\w+),", text), names[::-1])
        host.equal(f"{kind}: the texture is the same", arrays(text, names[0]), arrays(plain[0], names[0]))
        bits = {"rgb565": 16, "palette16": 4}.get(kind, 8)
        counts = [max(1, width >> i) * max(1, height >> i) for i in range(len(names))]
        host.equal(f"{kind}: bytes", int(size) - int(plain[1][3]), sum((count * bits + 7) // 8 for count in counts[1:]))
        for i, name in enumerate(names):
            _, across, down, levels, holes = arrays(text, name)
            host.equal(f"{name}: size", (across, down), (max(1, width >> i), max(1, height >> i)))
            for at, (got, hole) in enumerate(zip(levels, holes)):
                x, y, wide, high = at % across, at // across, width // across, height // down
                below = [colours[y * high + b][x * wide + a] for a in range(wide) for b in range(high)]
                shown = [colour[0] for colour in below if colour[3]]
                if 2 * len(shown) != len(below):
                    host.equal(f"{kind} {name} {at}: hole", hole, 2 * len(shown) < len(below))
                if not hole and kind != "palette16":
                    host.check(f"{kind} {name} {at}: mean", abs(got[1] - sum(shown) / len(shown)) <= (12 if kind == "palette256" else 5), f"{got} {shown}")
    host.equal("info", host.run("info", "t.obj", "--texture-levels").returncode, 0)


def test_holes(host):
    """Texels whose alpha is below one half have the key, others never."""
    numbers = random.Random(5)
    hidden = [[(x * y + x) % 3 == 0 for x in range(SIDE)] for y in range(SIDE)]
    flat = [hole for row in hidden for hole in row]
    for name, colour_at in [("greys", lambda: (numbers.choice((0, 77, 255)),) * 3), ("colours", lambda: (255, numbers.choice((0, 3)), 255)),
                            ("many", lambda: tuple(numbers.randint(0, 255) for _ in range(3)))]:
        rows = [[level for hole in row for level in (*colour_at(), 120 if hole else 130)] for row in hidden]
        write(host, encode(rows, colour=6))
        for kind in ("rgb565", "grey8", "palette256", "palette16"):
            host.equal(f"{name} as {kind}", arrays(converted(host, "--texture-type", kind)[0], "t_texture_paint")[4], flat)
    rows = [[7 if hole else 9 for hole in row] for row in hidden]
    for name, colour, extra in [("a grey", 0, [(b"tRNS", struct.pack(">H", 7))]), ("of a palette", 3, [(b"PLTE", bytes(range(30))), (b"tRNS", bytes([255] * 7 + [0]))]),
                                ("a colour", 2, [(b"tRNS", struct.pack(">3H", 7, 7, 7))])]:
        write(host, encode([[v for v in row for _ in range(SAMPLES[colour])] for row in rows], 8, colour, extra))
        host.equal(f"transparent: {name}", arrays(converted(host)[0], "t_texture_paint")[4], flat)


def test_converted_materials(host):
    """Each picture once, under the name of the first material that has it; sources compile as strictly as others."""
    paint = "".join(f"newmtl {name}\nmap_Kd {file}\n" for name, file in
                    (("a", "picture.png"), ("b", "-clamp on picture.png"), ("c", "other.png"), ("unused", "no.png")))
    model = "mtllib t.mtl\n" + SQUARE + COORDINATES + "".join(f"o {name}{name}\nusemtl {name}\n{FACE}" for name in "abcd").replace(
        "usemtl d\nf 1/1 2/2 3/3 4/4", "usemtl b\nf 1 2 3 4")
    write(host, picture(letters), paint, model)
    host.write("other.png", picture(lambda x, y: (0, 30 * x, 30 * y)))
    for options in ([], ["--objects"], ["--texture-levels"], ["--bilinear", "--positions", "int8", "--indices", "auto"]):
        text = convert(host, "t.obj", *options)
        host.equal(f"{options}: textures", re.findall(r"glint_texture (t_texture_\w+) = ", text), ["t_texture_a", "t_texture_c"])
        host.equal(f"{options}: of materials", re.findall(r"&(t_texture_\w+),", text), ["t_texture_a", "t_texture_a", "t_texture_c"])
        host.equal(f"{options}: flags", re.findall(r"shininess \*/\n    (.*),", text)[:3],
                   [" | ".join(["GLINT_MATERIAL_BILINEAR"] * ("--bilinear" in options) if not clamps else
                               ["GLINT_MATERIAL_CLAMP"] + ["GLINT_MATERIAL_BILINEAR"] * ("--bilinear" in options)) or "0" for clamps in (0, 1, 0)])
        host.equal(f"{options}: what was read", re.findall(r"Also read: (.*),", text), ["t.mtl", "picture.png", "other.png"])
        host.equal("as a pair", host.run("convert", "t.obj", *options, "-o", "pair.c").returncode, 0)
        host.write("user.cpp", '#include "pair.h"\nconst glint_texture *used() { return &pair_texture_a; }\n')
        for compiler, *files in (("cc", "-std=c99", "pair.c"), ("clang", "-std=c99", "pair.c"), ("c++", "user.cpp")):
            run = subprocess.run([compiler, *STRICT, "-c", *files, "-o", "pair.o"], cwd=host.folder, capture_output=True, text=True, check=False)
            host.equal(f"{options}: {compiler}", run.stderr, "")
    host.check("spot's parts meet in seams", int(host.info(os.path.join(MODELS, "spot.obj"), "--texture", "picture.png")["vertices"]) >
               int(host.info(os.path.join(MODELS, "spot.obj"))["vertices"]))


def test_meshes_keep_coordinates(host):
    """Clusters, a weld, a repair and a mirror image move no texel; fewer triangles move them a little."""
    host.write("picture.png", picture(lambda x, y: (4 * x, 4 * y, 128), 64, 64))
    options = ["--texture", "picture.png", "--model", "unlit", "--size", "160x120", "--texture-type", "rgb565"]
    plain = host.render("torus:48x24", *options)
    for more in (["--no-clusters"], ["--weld", "0"], ["--repair"]):
        host.equal(" ".join(more), host.render("torus:48x24", *options, *more).rows, plain.rows)
    fewer = host.render("torus:48x24", *options, "--simplify", "600")
    apart = sum(abs(a - b) for rows in zip(plain.rows, fewer.rows) for pair in zip(*rows) for a, b in zip(*pair)) / (160 * 120 * 3)
    host.check("--simplify", apart < 3, str(apart))


def test_shapes(host):
    """A picture on each side of a box can be read; round shapes have it once around."""
    host.write("picture.png", picture(letters))
    for turn in ([], ["--rotate-y", "90"], ["--rotate-y", "180"], ["--rotate-y", "270"], ["--rotate-x", "90"], ["--rotate-x", "-90"]):
        got = texels(host, "--texture", "picture.png", "--model", "unlit", *turn, model="box")
        host.check(f"box {turn}", near(got, shown(letters)), str(got[0]))
    got = texels(host, "--texture", "picture.png", "--model", "unlit", model="plane:3x5")
    host.check("plane", near(got, shown(letters)), str(got[0]))
    host.write("sides.png", picture(lambda x, y: (0, 36 * y, 30 + 25 * x)))
    view = ["--texture", "sides.png", "--model", "unlit", "--eye", "4,0.3,0", "--up", "0,0,1", "--orthographic", "2.2", "--size", "64x64"]
    for shape in ("sphere:64x32", "cylinder:64x4", "cone:64x16"):
        image = host.render(shape, *view)  # +x is before the camera, where the picture begins, and +y to the right
        host.check(f"{shape}: from left to right, its end beside its beginning", image.at(35, 33)[2] < 64 < 190 < image.at(28, 33)[2],
                   f"{image.at(35, 33)} {image.at(28, 33)}")
        seam = [host.render(shape, *view, "--eye", "-4,0.3,0").at(x, 33)[2] for x in range(27, 38)]
        host.check(f"{shape}: its middle behind", all(90 < level < 150 for level in seam), str(seam))
        host.check(f"{shape}: from top to bottom", image.at(33, 12)[1] < image.at(33, 32)[1] < image.at(33, 54)[1])


COLLADA = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_images><image id="i"><init_from>picture.png</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON>
<newparam sid="s"><surface type="2D"><init_from>i</init_from></surface></newparam><newparam sid="m"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="c"><lambert><diffuse><texture texture="m" texcoord="UV"/></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="p" name="paint"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="a"><float_array id="b" count="12">-1 -1 0 1 -1 0 1 1 0 -1 1 0</float_array><technique_common><accessor source="#b" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="c"><float_array id="d" count="8">0 0 1 0 1 1 0 1</float_array><technique_common><accessor source="#d" count="4" stride="2">
<param name="S" type="float"/><param name="T" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#a"/></vertices><triangles count="2" material="p"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="TEXCOORD" source="#c" offset="1" set="0"/><p>0 0 1 1 2 2 0 0 2 2 3 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="w"><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="p" target="#p"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>"""


def test_spot(host):
    """The model of the examples that has a picture shows it: a white face, brown nostrils, dark patches."""
    spot = [os.path.join(MODELS, "spot" + ending) for ending in (".obj", ".png")]
    image = host.render(spot[0], "--texture", spot[1], "--eye=-1.5,1,-2", "--size", "320x240", "--model", "unlit")
    for name, place, wanted in (("face", (125, 80), (255, 238, 230)), ("nostril", (120, 108), (157, 90, 53)), ("patch", (205, 125), (64, 64, 64))):
        host.check(name, near([[image.at(*place)]], [[wanted]], 4), str(image.at(*place)))


def test_other_formats(host):
    """The same picture on the same square, whichever format it comes in."""
    data = picture(letters)
    write(host, data)
    view = [*VIEW, "--model", "unlit"]
    plain = host.render_bytes("t.obj", *view)
    points = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    head = "ply\nformat ascii 1.0\ncomment TextureFile picture.png\nelement vertex 4\n"
    rows = "".join(f"{x} {y} {z} {s} {t}\n" for (x, y, z), (s, t) in zip(points, ((0, 0), (1, 0), (1, 1), (0, 1))))
    for s, t in (("s", "t"), ("u", "v"), ("texture_u", "texture_v")):
        host.write("t.ply", head + "".join(f"property float {p}\n" for p in ("x", "y", "z", s, t)) +
                   "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + rows + "4 0 1 2 3\n")
        host.equal(f"PLY, {s} and {t}", host.render_bytes("t.ply", *view), plain)
    host.write("t.ply", head + "".join(f"property float {p}\n" for p in "xyz") + "element face 2\nproperty list uchar int vertex_indices\n"
               "property list uchar float texcoord\nend_header\n" + "".join(f"{x} {y} {z}\n" for x, y, z in points) +
               "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0 1\n")
    host.equal("PLY, of corners", host.render_bytes("t.ply", *view), plain)

    host.write("t.dae", COLLADA)
    host.equal("Collada", host.render_bytes("t.dae", *view), plain)

    def document(image, uv=((0, 1), (1, 1), (1, 0), (0, 0)), info=None, sampler=None, code="f", **more):
        material = {"name": "paint", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, **(info or {})}}, **more.pop("material", {})}
        return gltf({"POSITION": ("f", points), f"TEXCOORD_{(info or {}).get('texCoord', 0)}": (code, list(uv))}, (0, 1, 2, 0, 2, 3),
                    primitive={"material": 0}, materials=[material], textures=[{"source": 0, "sampler": 0}], images=[image],
                    samplers=[sampler or {}], **more)
    uri = {"uri": "data:image/png;base64," + base64.b64encode(data).decode()}
    transform = {"extensions": {"KHR_texture_transform": {"offset": [0, 1], "rotation": math.pi / 2, "scale": [1, 1]}}}
    for name, text in [
            ("a file", document({"uri": "picture.png"})), ("a file by escapes", document({"uri": "pi%63ture.png"})), ("a data URI", document(uri)),
            ("a view", document({"bufferView": "accessor_p"}, accessor_p=("B", list(data)))),
            ("another set", document(uri, info={"texCoord": 1})),
            ("normalised integers", document(uri, [(0, 255), (255, 255), (255, 0), (0, 0)], code="B+")),
            ("a transform", document(uri, [(0, 0), (0, 1), (1, 1), (1, 0)], transform, extensionsUsed=["KHR_texture_transform"]))]:
        host.write("t.gltf", text)
        host.equal(f"glTF: {name}", host.render_bytes("t.gltf", *view), plain)
    host.write("t.gltf", document(uri, sampler={"wrapS": 33071, "wrapT": 33071}))
    host.check("it clamps", "GLINT_MATERIAL_CLAMP" in convert(host, "t.gltf"))
    half = encode([[level for x in range(SIDE) for level in (9, 9, 9, 100)] for _ in range(SIDE)], colour=6)
    uri = {"uri": "data:image/png;base64," + base64.b64encode(half).decode()}
    for mode, holes in (({}, 0), ({"alphaMode": "MASK"}, 1), ({"alphaMode": "MASK", "alphaCutoff": .3}, 0), ({"alphaMode": "BLEND"}, 1)):
        host.write("t.gltf", document(uri, material=mode))
        host.equal(f"glTF: holes of {mode}", convert(host, "t.gltf").count("GLINT_TEXTURE_HAS_KEY"), holes)
    for name, text, why in [
            ("mirrored", document(uri, sampler={"wrapS": 33648}), "a texture repeats along both axes: mirrored, or along one alone, is not drawn"),
            ("a view that is not there", document({"bufferView": 99}), ".*bufferView.*\nt.gltf:0: warning: the texture 'image 0' is not drawn: it is neither PNG nor JPEG"),
            ("a missing file", document({"uri": "no.png"}), "the texture 'no.png' is not drawn: cannot be read"),
            ("no image", json.dumps({**json.loads(document(uri)), "textures": [{}]}), "a texture is not drawn: it has no image of PNG or JPEG")]:
        host.write("t.gltf", text)
        run = host.run("render", "t.gltf", *view, "-o", "out.png")
        host.check(f"glTF: {name}", run.returncode == 0 and re.fullmatch(f"t.gltf:0: warning: {why}\n", run.stderr), run.stderr)
