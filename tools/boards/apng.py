# SPDX-License-Identifier: MIT
"""Animated PNG files (PNG specification, third edition), of frames that each hold the rectangle that changed."""
import collections
import os
import struct
import sys
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from png import SIGNATURE, chunk, chunks, head  # noqa: E402

# A rectangle of a picture: rows behind their filters, not yet compressed.
Part = collections.namedtuple("Part", "x y width height rows")


def filtered(row, above):
    """A row of 3 bytes a pixel by the filter whose differences are smallest, after the byte that tells which."""
    left = bytes(3) + row[:-3]
    ways = [row] + [bytes((a - b) & 255 for a, b in zip(row, before)) for before in (left, above)]
    sums = [sum(min(value, 256 - value) for value in way) for way in ways]
    best = sums.index(min(sums))
    return bytes((best,)) + ways[best]


def part_of(picture, before, width, height):
    """What differs from the picture before; all of it where there is none, and a pixel where nothing does."""
    rows = [picture[3 * width * y:3 * width * (y + 1)] for y in range(height)]
    x, y, right, bottom = 0, 0, width, height
    if before is not None:
        old = [before[3 * width * y:3 * width * (y + 1)] for y in range(height)]
        changed = [y for y in range(height) if rows[y] != old[y]] or [0]
        columns = [x for x in range(width)
                   if any(rows[y][3 * x:3 * x + 3] != old[y][3 * x:3 * x + 3] for y in changed)] or [0]
        x, y, right, bottom = columns[0], changed[0], columns[-1] + 1, changed[-1] + 1
    cut = [row[3 * x:3 * right] for row in rows[y:bottom]]
    above = [bytes(len(cut[0]))] + cut[:-1]
    ways = b"".join(map(filtered, cut, above)), b"".join(b"\0" + row for row in cut)  # dithered pixels repeat as they are
    return Part(x, y, right - x, bottom - y, min(ways, key=lambda way: len(zlib.compress(way, 9))))


def parts_of(pictures, width, height):
    """Of pictures that follow each other, 3 bytes a pixel."""
    return [part_of(picture, before, width, height) for picture, before in zip(pictures, [None] + pictures)]


def write(path, parts, milliseconds):
    """The first part is the whole picture; each stays so long."""
    out = [SIGNATURE, head(parts[0].width, parts[0].height, 8, 2), chunk(b"acTL", struct.pack(">2I", len(parts), 0))]
    sequence = 0
    for i, (part, stays) in enumerate(zip(parts, milliseconds)):
        out.append(chunk(b"fcTL", struct.pack(">5I2H2B", sequence, part.width, part.height, part.x, part.y, stays, 1000, 0, 0)))
        data = zlib.compress(part.rows, 9)
        out.append(chunk(b"fdAT", struct.pack(">I", sequence + 1) + data) if i else chunk(b"IDAT", data))
        sequence += 2 if i else 1
    with open(path, "wb") as file:
        file.write(b"".join(out + [chunk(b"IEND", b"")]))


def read(path):
    """Parts of a file that `write` wrote, and how many milliseconds each stays."""
    parts, stays, place = [], [], None
    with open(path, "rb") as file:
        data = file.read()
    for kind, body in chunks(data):
        if kind == b"fcTL":
            _, width, height, x, y, milliseconds = struct.unpack_from(">5IH", body)
            place = (x, y, width, height)
            stays.append(milliseconds)
        elif kind in (b"IDAT", b"fdAT"):
            parts.append(Part(*place, zlib.decompress(body[4 if kind == b"fdAT" else 0:])))
    return parts, stays
