# SPDX-License-Identifier: MIT
"""--compare: what is printed of a difference, the exit status, and PNG files of another writer, whole and broken."""
import math
import os
import random
import subprocess
import zlib

import png
from png import chunk

TORUS = ["torus:24x12", "--size", "40x30"]
GREY, COLOUR, PALETTE, GREY_ALPHA, COLOUR_ALPHA = 0, 2, 3, 4, 6
CHANNELS = {GREY: 1, COLOUR: 3, PALETTE: 1, GREY_ALPHA: 2, COLOUR_ALPHA: 4}
EQUAL = {"pixels_different": "0", "psnr_db": "inf", "first_difference": "none"}


# ---- A writer of PNG in every form

def head(width, height, depth=8, colour=COLOUR, methods=(0, 0, 0)):
    return png.head(width, height, depth, colour, methods)


def pack_row(levels, depth):
    """Levels of a row, so many bits each, the first one highest."""
    bits = "".join(format(level, f"0{depth}b") for level in levels)
    bits += "0" * (-len(bits) % 8)
    return bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))


def filter_row(kind, row, above, step):
    out = bytearray([kind])
    for i, value in enumerate(row):
        left, up, corner = (row[i - step], above[i], above[i - step]) if i >= step else (0, above[i], 0)
        out.append(value - (0, left, up, (left + up) // 2, png.paeth(left, up, corner))[kind] & 255)
    return bytes(out)


def encode(rows, colour=COLOUR, depth=8, filters=(0, 1, 2, 3, 4), pack=zlib.compress, middle=b"", parts=1):
    """A PNG of rows of pixels, each a tuple of levels, or an index."""
    step, above, raw = max(1, CHANNELS[colour] * depth // 8), b"", b""
    for y, row in enumerate(rows):
        line = pack_row([level for pixel in row for level in pixel], depth)
        raw += filter_row(filters[y % len(filters)], line, above or bytes(len(line)), step)
        above = line
    data = pack(raw)
    size = -(-len(data) // parts)
    return b"".join([png.SIGNATURE, head(len(rows[0]), len(rows), depth, colour), middle,
                     *(chunk(b"IDAT", data[i * size:(i + 1) * size]) for i in range(parts)), chunk(b"IEND", b"")])


def packer(level, strategy=zlib.Z_DEFAULT_STRATEGY, memory=9):
    def pack(raw):
        stream = zlib.compressobj(level, zlib.DEFLATED, 15, memory, strategy)
        return stream.compress(raw) + stream.flush()
    return pack


# ---- What is printed

def compare(host, *arguments):
    """@return exit status, and what was printed of the difference, as a dictionary"""
    run = host.run(*arguments, "--compare", "other.png")
    if run.stderr:
        raise AssertionError(f"{arguments}: {run.stderr}")
    return run.returncode, dict(line.split(" ", 1) for line in run.stdout.splitlines())


def test_differences(host):
    """All figures, against the same ones counted here."""
    rows = host.render(*TORUS).rows
    changed = [list(row) for row in rows]
    for x, y, (r, g, b) in ((7, 4, (3, 0, 0)), (31, 3, (0, 200, 1)), (0, 29, (1, 1, 90))):
        changed[y][x] = (changed[y][x][0] ^ r, changed[y][x][1] ^ g, changed[y][x][2] ^ b)
    off = [[abs(a - b) for a, b in zip(p, q)] for r, s in zip(rows, changed) for p, q in zip(r, s)]
    squares = sum(d * d for pixel in off for d in pixel) / (3 * len(off))
    host.write("other.png", encode(changed))
    status, said = compare(host, "render", *TORUS)
    host.equal("a difference", (status, said), (1, {
        "pixels_compared": "1200", "pixels_different": "3", "largest_difference": ",".join(str(max(p[c] for p in off)) for c in range(3)),
        "psnr_db": "%.3f" % (10 * math.log10(255 ** 2 / squares)), "first_difference": "31,3"}))
    host.write("other.png", encode(rows))
    host.equal("none", compare(host, "render", *TORUS), (0, {"pixels_compared": "1200", "largest_difference": "0,0,0", **EQUAL}))
    run = host.run("render", *TORUS, "--compare", "other.png", "-o", "out.png", "--stats")
    host.check("beside other output", run.returncode == 0 and run.stdout.startswith("passes 1\n") and run.stdout.endswith(
        "\nfirst_difference none\n") and png.decode(host.read("out.png")).rows == rows)
    host.write("other.png", encode(changed))
    os.remove(host.path("out.png"))
    run = host.run("render", *TORUS, "--compare", "other.png", "-o", "out.png")
    host.check("what differs is written", run.returncode == 1 and png.decode(host.read("out.png")).rows == rows)
    host.check("and followed by what a model says", "warning" not in run.stderr)
    for name in ("out.png", "other.png"):
        os.remove(host.path(name))


def test_statuses(host):
    """0, 1 and 2, and a full disk's 2 in place of each."""
    host.write("other.png", host.render_bytes(*TORUS))
    for wanted, more in ((0, []), (1, ["--shininess", "33"]), (2, ["--shininess", "x"])):
        arguments = ["render", *TORUS, *more, "--compare", "other.png"]
        host.equal(f"status {wanted}", host.run(*arguments).returncode, wanted)
        if wanted < 2:
            with open("/dev/full", "wb") as disk:
                full = subprocess.run([host.program, *arguments], cwd=host.folder.name, stdout=disk, stderr=subprocess.PIPE, check=False)
            host.equal(f"a full disk in place of status {wanted}", (full.returncode, full.stderr),
                       (2, b"glint: standard output cannot be written\n"))
    host.write("bad.obj", "usemtl none\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    run = host.run("render", "bad.obj", "--size", "40x30", "--compare", "other.png")
    host.check("warnings with status 1", run.returncode == 1 and "warning:" in run.stderr, run.stderr)
    for name in ("other.png", "bad.obj"):
        os.remove(host.path(name))


def test_scenes_and_formats(host):
    for options in ([], ["--labels"], ["--format", "grey4", "--dither"], ["--format", "mono"], ["--frame", "5", "--format", "rgb565"]):
        arguments = ["scene", "teapot", "--size", "64x48", *options]
        host.run(*arguments, "-o", "other.png")
        status, said = compare(host, *arguments)
        host.equal(f"{options}: its own picture", (status, said["pixels_different"]), (0, "0"))
        host.equal(f"{options}: another frame", compare(host, *arguments, "--frame", "20")[0], 1)
    host.run("scene", "teapot", "-o", "other.png")
    host.equal("a scene's own size", compare(host, "scene", "teapot")[0], 0)
    host.run("scene", "teapot", "--animate", "3", "-o", "other.png")
    host.equal("the first frame of an animation", compare(host, "scene", "teapot")[0], 0)
    os.remove(host.path("other.png"))


# ---- Files of others

def as_grey(rows):
    return [[(pixel[0],) for pixel in row] for row in rows]


def test_kinds_of_files(host):
    """Every colour type and depth, every filter, blocks of every kind."""
    rows = host.render(*TORUS).rows
    grey = as_grey(host.render(*TORUS, "--format", "grey8").rows)
    colours = sorted({pixel for row in rows for pixel in row})[:256]
    host.check("few colours", all(pixel in colours for row in rows for pixel in row))
    palette = chunk(b"PLTE", b"".join(map(bytes, colours)))
    index = [[(colours.index(pixel),) for pixel in row] for row in rows]
    kinds = {"colour": ([], encode(rows)), "colour, in 7 parts": ([], encode(rows, parts=7)),
             "colour, an empty part": ([], encode(rows).replace(chunk(b"IEND", b""), chunk(b"IDAT", b"") + chunk(b"IEND", b""))),
             "alpha": ([], encode([[(*pixel, 255) for pixel in row] for row in rows], COLOUR_ALPHA)),
             "palette": ([], encode(index, PALETTE, middle=palette)),
             "palette, opaque": ([], encode(index, PALETTE, middle=palette + chunk(b"tRNS", b"\xff" * 9))),
             "colour, a suggested palette": ([], encode(rows, middle=palette)),
             "what need not be known": ([], encode(rows, middle=chunk(b"gAMA", b"\0\0\xb1\x8f") + chunk(b"tEXt", b"a\0b"))),
             "more behind the end": ([], encode(rows) + b"more"),
             "grey": (["--format", "grey8"], encode(grey)), "grey as colour": (["--format", "grey8"], encode([[3 * p for p in row] for row in grey])),
             "grey and alpha": (["--format", "grey8"], encode([[(*pixel, 255) for pixel in row] for row in grey], GREY_ALPHA))}
    kinds["grey"] = (["--format", "grey8"], encode(grey, GREY))
    for name, options in (("mono", ["--format", "mono"]), ("grey4", ["--format", "grey4"])):
        levels = as_grey(host.render(*TORUS, *options).rows)
        for depth in (1, 2, 4):
            most = 2 ** depth - 1
            if all(level * most % 255 == 0 for row in levels for (level,) in row):
                kinds[f"{name} in {depth} bits"] = (options, encode([[(level * most // 255,) for (level,) in row] for row in levels], GREY, depth))
                if depth == 1:
                    two = chunk(b"PLTE", b"\xff\xff\xff\0\0\0")
                    kinds["palette of 1 bit"] = (options, encode([[(level == 0,) for (level,) in row] for row in levels], PALETTE, 1, middle=two))
    for title, pack in (("stored", packer(0)), ("fixed codes", packer(9, zlib.Z_FIXED)), ("no matches", packer(9, zlib.Z_HUFFMAN_ONLY)),
                        ("runs", packer(6, zlib.Z_RLE)), ("small blocks", packer(9, memory=1))):
        kinds[title] = ([], encode(rows, pack=pack))
    for name, (options, data) in kinds.items():
        host.write("other.png", data)
        status, said = compare(host, "render", *TORUS, *options)
        host.equal(f"read: {name}", (status, said), (0, {"pixels_compared": "1200", "largest_difference": "0,0,0", **EQUAL}))
    host.check("depths were tried", {"mono in 1 bits", "mono in 2 bits", "mono in 4 bits", "grey4 in 4 bits"} <= set(kinds), str(list(kinds)))
    seen = [[(*pixel, 254 if (x, y) == (5, 6) else 255) for x, pixel in enumerate(row)] for y, row in enumerate(rows)]
    host.write("other.png", encode(seen, COLOUR_ALPHA))
    status, said = compare(host, "render", *TORUS)
    host.equal("alpha counts", (status, said["largest_difference"], said["first_difference"]), (1, "0,0,0,1", "5,6"))
    clear = chunk(b"tRNS", bytes(0 if colour == colours[-1] else 255 for colour in colours))
    host.write("other.png", encode(index, PALETTE, middle=palette + clear))
    where = next(f"{x},{y}" for y, row in enumerate(rows) for x, pixel in enumerate(row) if pixel == colours[-1])
    status, said = compare(host, "render", *TORUS)
    host.equal("a palette's alpha counts", (status, said["largest_difference"], said["first_difference"]), (1, "0,0,0,255", where))
    os.remove(host.path("other.png"))


def test_noise(host):
    """Up to the largest size, against black: what no filter and no match makes shorter."""
    for width, height, colour in ((1024, 1024, COLOUR), (1, 1024, GREY), (1, 1, COLOUR_ALPHA)):
        step = CHANNELS[colour]
        noise = random.Random(width).randbytes(width * height * step)
        raw = b"".join(b"\0" + noise[y * width * step:(y + 1) * width * step] for y in range(height))
        host.write("other.png", png.SIGNATURE + head(width, height, 8, colour) + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))
        status, said = compare(host, "render", "sphere:8x4", "--size", f"{width}x{height}", "--eye", "0,0,9", "--at", "0,0,20")
        largest = [max(noise[c::step]) for c in range(min(step, 3))] * (3 if step == 1 else 1) + [255 - min(noise[3::4])] * (step == 4)
        host.equal(f"{width}x{height} of noise", (status, said["largest_difference"]), (1, ",".join(map(str, largest))))
    os.remove(host.path("other.png"))


# ---- Broken files

def bad_files(rows):
    """(name, file, pattern) of what is refused."""
    good = encode(rows)
    at = good.index(b"IDAT") - 4
    raw = b"".join(b"\0" + bytes(level for pixel in row for level in pixel) for row in rows)
    data = zlib.compress(raw)

    def of(*parts):
        return b"".join([png.SIGNATURE, *parts])

    def of_data(packed, *more):
        return of(head(40, 30), *more, chunk(b"IDAT", packed), chunk(b"IEND", b""))

    end, whole, colours = chunk(b"IEND", b""), chunk(b"IDAT", data), chunk(b"PLTE", b"\0" * 6)
    early, stream = r"is broken: it ends early", r"is broken: its data end early"
    order, length = r"is broken: its chunk {} is out of order", r"is broken: its chunk {} has a wrong length"
    files = [("empty", b"", r"is no PNG file"), ("a signature only", png.SIGNATURE, early), ("a JPEG", b"\xff\xd8\xff" * 9, r"is no PNG file"),
             ("text mode", good.replace(b"\r\n", b"\n"), r"is no PNG file"),
             ("no head", of(whole, end), r"is broken: its chunk IDAT comes before IHDR"),
             ("two heads", of(head(40, 30), head(40, 30), whole, end), r"is broken: its chunk IHDR comes twice"),
             ("a long head", of(chunk(b"IHDR", b"\0" * 14), whole, end), length.format("IHDR")),
             ("no picture", of(head(40, 30), end), r"is broken: it has no picture \(IDAT\)"),
             ("no end", of(head(40, 30), whole), early), ("an unknown chunk", of(head(40, 30), chunk(b"ABCD", b""), whole, end), r"is broken: its chunk ABCD is not known"),
             ("no letters", of(head(40, 30), chunk(b"\x01\xff\n ", b""), whole, end), r"is broken: its chunk \?\?\? {1} is not known"),
             ("data apart", of(head(40, 30), whole[:0], chunk(b"IDAT", data[:9]), chunk(b"tEXt", b""), chunk(b"IDAT", data[9:]), end), order.format("IDAT")),
             ("a length beyond all", good[:at] + b"\xff\xff\xff\xff" + good[at + 4:], early),
             ("a wrong checksum", good[:at + 20] + b"?" + good[at + 21:], r"is broken: its chunk IDAT has a wrong checksum"),
             ("another size", encode([row[:39] for row in rows]), r"is 39x30 pixels, the picture 40x30"),
             ("no width", of(head(0, 30), whole, end), r"is 0x30 pixels: 1x1 to 1024x1024 are read"),
             ("no height", of(head(40, 0), whole, end), r"is 40x0 pixels: .*"), ("wide", of(head(1025, 30), whole, end), r"is 1025x30 pixels: .*"),
             ("high", of(head(40, 2 ** 32 - 1), whole, end), r"is 40x4294967295 pixels: .*"),
             ("16 bits", of(head(40, 30, 16), whole, end), r"has 16 bits a channel: up to 8 are read"),
             ("interlaced", of(head(40, 30, methods=(0, 0, 1)), whole, end), r"is interlaced \(Adam7\), which is not read"),
             ("a transparent colour", of(head(40, 30), chunk(b"tRNS", b"\0" * 6), whole, end), r"has a transparent colour \(tRNS\), which is read of palettes only")]
    files += [(f"methods {methods}", of(head(40, 30, methods=methods), whole, end), r"is broken: its chunk IHDR names no known method")
              for methods in ((1, 0, 0), (0, 1, 0), (0, 0, 2))]
    files += [(f"type {colour} of {depth} bits", of(head(40, 30, depth, colour), whole, end),
               rf"is broken: there is no colour type {colour} of {depth} bits")
              for colour, depth in ((1, 8), (5, 8), (7, 8), (255, 16), (2, 4), (4, 2), (6, 1), (3, 16), (0, 3), (0, 0), (2, 32))]
    small = head(40, 30, 1, PALETTE)
    files += [("no palette", of(small, whole, end), order.format("IDAT")), ("a late palette", of(small, colours, whole, colours, end), order.format("PLTE")),
              ("two palettes", of(small, colours, colours, whole, end), order.format("PLTE")),
              ("a large palette", of(small, chunk(b"PLTE", b"\0" * 9), whole, end), length.format("PLTE")),
              ("an empty palette", of(small, chunk(b"PLTE", b""), whole, end), length.format("PLTE")),
              ("half a colour", of(small, chunk(b"PLTE", b"\0" * 4), whole, end), length.format("PLTE")),
              ("much alpha", of(small, colours, chunk(b"tRNS", b"\0" * 3), whole, end), length.format("tRNS")),
              ("late alpha", of(small, colours, whole, chunk(b"tRNS", b"\0"), end), order.format("tRNS")),
              ("a colour that is not", encode([[(3 if (x, y) == (9, 8) else 1,) for x in range(40)] for y in range(30)], PALETTE, 2, middle=colours),
               r"is broken: pixel 9,8 has no colour in the palette"),
              ("a filter that is not", of_data(zlib.compress(raw[:121] + b"\5" + raw[122:])), r"is broken: row 1 has filter 5, which there is not")]
    files += [("little data", of_data(zlib.compress(raw[:-1])), r"is broken: it has fewer data than its size takes"),
              ("much data", of_data(zlib.compress(raw + b"\0")), r"is broken: it has more data than its size takes"),
              ("a bomb", of_data(zlib.compress(b"\0" * 10 ** 8)), r"is broken: it has more data than its size takes"),
              ("a stored bomb", of_data(packer(0)(raw * 9)), r"is broken: it has more data than its size takes"),
              ("no data", of_data(b""), stream), ("no zlib stream", of_data(b"abcdefgh"), r"is broken: its data are no zlib stream"),
              ("a dictionary", of_data(b"\x78\xbb" + data[2:]), r"is broken: its data are no zlib stream"),
              ("a large window", of_data(b"\x88\x1c" + data[2:]), r"is broken: its data are no zlib stream"),
              ("a wrong sum of the data", of_data(data[:-1] + bytes([data[-1] ^ 1])), r"is broken: the checksum of its data is wrong"),
              ("half a sum", of_data(data[:-2]), stream), ("half the data", of_data(data[:len(data) // 2]), stream),
              ("half a stored block", of_data(packer(0)(raw)[:99]), stream), ("a stored head", of_data(b"\x78\x01\x01\0"), stream),
              ("a stored length", of_data(b"\x78\x01\x01\x02\0\xfe\xff" + raw), r"is broken: a block's length is no length"),
              ("a block of kind 3", of_data(b"\x78\x01\x07" + raw), r"is broken: a block is of no kind"),
              ("a distance before all", of_data(b"\x78\x01\x03\x02\0\0\0"), r"is broken: it repeats what is before its beginning")]
    return files


def test_broken_files(host):
    rows = host.render(*TORUS).rows
    for name, data, pattern in bad_files(rows):
        host.write("other.png", data)
        host.refuses(f"broken: {name}", ["render", *TORUS, "--compare", "other.png", "-o", "out.png"],
                     rf"other\.png:0: {pattern}")
    host.refuses("no file", ["render", *TORUS, "--compare", "no.png", "-o", "out.png"], r"no\.png:0: cannot be opened: .*")
    host.refuses("a folder", ["render", *TORUS, "--compare", ".", "-o", "out.png"], r"\.:0: cannot be read: .*")
    host.refuses("an empty name", ["scene", "teapot", "--compare="], r"glint: --compare : takes the name of a file")
    host.write("other.png", encode(rows))
    host.refuses("a scene's size", ["scene", "teapot", "--compare", "other.png"], r"other\.png:0: is 40x30 pixels, the picture 320x160")
    host.write("large.png", encode(rows) + b"\0" * 16_000_000)
    host.refuses("a large file", ["render", *TORUS, "--compare", "large.png"], r"large\.png:0: is larger than the 16 MB that are read")
    for name in ("other.png", "large.png"):
        os.remove(host.path(name))


def test_mutations(host):
    """A byte changed anywhere, checksums of chunks mended: no file is read otherwise than by the reader in Python."""
    generator, read = random.Random(7), 0
    rows = [[(x * y % 256, x, y) for x in range(9)] for y in range(7)]
    host.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    for trial in range(150):
        parts = png.chunks(encode(rows, pack=packer(trial % 10, trial % 5)))
        body = bytearray(parts[1][1])
        body[generator.randrange(len(body))] ^= 1 << generator.randrange(8)
        data = png.SIGNATURE + b"".join(chunk(kind, bytes(body) if kind == b"IDAT" else own) for kind, own in parts)
        host.write("other.png", data)
        run = host.run("render", "plain.obj", "--size", "9x7", "--compare", "other.png")
        try:
            png.decode(data)
            read += 1
            host.equal(f"mutation {trial} is read", (run.returncode, run.stderr), (1, ""))
        except (ValueError, IndexError, zlib.error):
            host.check(f"mutation {trial} is refused", run.returncode == 2 and run.stderr.startswith("other.png:0: is broken: "), run.stderr)
    host.check("some go unseen, most do not", read < 50, str(read))
    for name in ("plain.obj", "other.png"):
        os.remove(host.path(name))


def test_what_is_compared_stays(host):
    own = host.render_bytes(*TORUS)
    host.write("other.png", own)
    os.symlink("other.png", host.path("link.png"))
    for name in ("other.png", "link.png"):
        host.refuses(f"-o {name}", ["render", *TORUS, "--compare", "other.png", "-o", name],
                     rf"{name}:0: cannot be written: it is the picture to compare with")
    host.equal("it stays", host.read("other.png"), own)
    for name in ("other.png", "link.png"):
        os.remove(host.path(name))

