# SPDX-License-Identifier: MIT
"""Reads and writes PNG files for tests and tools; shares nothing with the writer under test: zlib and CRC are Python's own."""
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


class Picture:
    """Pixels of an 8-bit grey or RGB picture: rows[y][x] is a tuple of 1 or 3 levels."""

    def __init__(self, width, height, channels, rows):
        self.width, self.height, self.channels, self.rows = width, height, channels, rows

    def at(self, x, y):
        return self.rows[y][x]

    def as_bytes(self):
        """(width, height, channels, bytes)"""
        return self.width, self.height, self.channels, bytes(level for row in self.rows for pixel in row for level in pixel)

    def levels(self, channel=0):
        return {pixel[channel] for row in self.rows for pixel in row}

    def box(self, background):
        """Smallest rectangle (left, top, right, bottom), all inclusive, of what is not background; None for nothing."""
        where = [(x, y) for y, row in enumerate(self.rows) for x, pixel in enumerate(row) if pixel != background]
        if not where:
            return None
        columns, lines = [x for x, _ in where], [y for _, y in where]
        return min(columns), min(lines), max(columns), max(lines)


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def head(width, height, depth, colour, methods=(0, 0, 0)):
    return chunk(b"IHDR", struct.pack(">2I5B", width, height, depth, colour, *methods))


def encode(width, height, channels, data):
    """A PNG of grey or RGB bytes, without filters."""
    row = width * channels
    raw = b"".join(b"\0" + data[y * row:(y + 1) * row] for y in range(height))
    return SIGNATURE + head(width, height, 8, 2 if channels == 3 else 0) + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b"")


def chunks(data):
    """[(kind, body)] of a file's bytes, whose order and checksums are right."""
    if data[:8] != SIGNATURE:
        raise ValueError("no PNG signature")
    at, found = 8, []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        (crc,) = struct.unpack(">I", data[at + 8 + length:at + 12 + length])
        if crc != zlib.crc32(kind + body):
            raise ValueError(f"wrong CRC in {kind}")
        found.append((kind, body))
        at += 12 + length
    if at != len(data) or found[0][0] != b"IHDR" or found[-1] != (b"IEND", b""):
        raise ValueError("chunks out of order")
    return found


def paeth(left, up, corner):
    by_left, by_up, by_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
    return left if by_left <= by_up and by_left <= by_corner else up if by_up <= by_corner else corner


def unfilter(kind, row, above, step):
    out = bytearray(step) + row  # behind what is left of the row
    if kind in (1, 3, 4):
        corners = bytes(step) + above
        for i, value in enumerate(row):
            left, up, corner = out[i], above[i], corners[i]
            if kind == 1:
                guess = left
            elif kind == 3:
                guess = (left + up) // 2
            else:
                guess = paeth(left, up, corner)
            out[i + step] = (value + guess) & 255
    elif kind == 2:
        return bytes([(value + up) & 255 for value, up in zip(row, above)])
    elif kind != 0:
        raise ValueError("no such filter")
    return bytes(out[step:])


def unpack(packed, width, height, channels):
    """Rows of bytes; ValueError or zlib.error when they are not right."""
    raw, size = zlib.decompress(packed), width * channels
    if len(raw) != height * (size + 1):
        raise ValueError("wrong amount of data")
    rows = []
    for y in range(height):
        line = raw[y * (size + 1):(y + 1) * (size + 1)]
        rows.append(unfilter(line[0], line[1:], rows[-1] if rows else bytes(size), channels))
    return rows


def decode(data):
    """The Picture in a PNG file's bytes; ValueError or zlib.error when they are not right."""
    parts = chunks(data)
    width, height, depth, colour, *methods = struct.unpack(">IIBBBBB", parts[0][1])
    if depth != 8 or colour not in (0, 2) or methods != [0, 0, 0]:
        raise ValueError("neither 8-bit grey nor RGB")
    channels = 3 if colour == 2 else 1
    rows = unpack(b"".join(body for kind, body in parts if kind == b"IDAT"), width, height, channels)
    return Picture(width, height, channels, [list(zip(*(row[c::channels] for c in range(channels)))) for row in rows])


def shown(data):
    """What a PNG or an APNG shows, however it is packed: its chunks, with rows of bytes in place of packed data."""
    parts, found, packed = chunks(data), [], b""
    *size, _, colour = struct.unpack(">IIBB", parts[0][1][:10])
    for kind, body in parts:
        if kind in (b"IDAT", b"fdAT"):
            packed += body[4:] if kind == b"fdAT" else body
            continue
        if packed:
            found.append(unpack(packed, *size, 3 if colour == 2 else 1))
            packed = b""
        if kind == b"fcTL":
            size = struct.unpack(">2I", body[4:12])
        found.append((kind, body))
    return found


def read(path):
    with open(path, "rb") as file:
        return decode(file.read())
