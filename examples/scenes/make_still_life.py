#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes what the still life is made of: meshes with texture coordinates, and textures by formula.

usage: make_still_life.py > examples/scenes/still_life_data.h

The same bytes on every machine: what decides about a texel or a step is rounded, which leaves libm's last bit out.
"""
import math

STEPS = 32767


# ---- Noise ----


def roll(*lattice):
    """A number from 0 to 1 for a point of whole coordinates (mixing as of MurmurHash3's end)."""
    state = 0
    for number in lattice:
        state = (state ^ (number & 0xFFFF)) * 0x85EBCA6B & 0xFFFFFFFF
        state = (state ^ state >> 13) * 0xC2B2AE35 & 0xFFFFFFFF
        state ^= state >> 16
    return state / 0xFFFFFFFF


def smooth(t):
    return t * t * (3 - 2 * t)


def noise(x, y, z, seed):
    """Interpolates between rolls at the corners of a cell, from 0 to 1."""
    base = [math.floor(c) for c in (x, y, z)]
    part = [smooth(c - b) for c, b in zip((x, y, z), base)]
    total = 0
    for corner in range(8):
        at = [corner >> axis & 1 for axis in range(3)]
        weight = math.prod(p if a else 1 - p for a, p in zip(at, part))
        total += weight * roll(seed, *(b + a for b, a in zip(base, at)))
    return total


def octaves(x, y, z, seed, count):
    total, weight, sum_of_weights = 0, 1, 0
    for i in range(count):
        total += weight * noise(x, y, z, seed + i)
        sum_of_weights += weight
        weight *= 0.55
        x, y, z = 2.03 * x, 2.03 * y, 2.03 * z
    return round(total / sum_of_weights, 6)


# ---- Textures: functions from a texel's middle, u and v from 0 to 1, to a number of a palette of 16 ----


def ramp(dark, light, count):
    return [tuple(a + (b - a) * i / (count - 1) for a, b in zip(dark, light)) for i in range(count)]


def shade(level, count, column, row):
    """A number below count for a level from 0 to 1, by ordered dithering."""
    bayer = (0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5)
    threshold = (bayer[column % 4 + 4 * (row % 4)] + 0.5) / 16
    return max(0, min(count - 1, math.floor(round(level * (count - 1), 6) + threshold)))


WOOD = ramp((0x3A, 0x20, 0x0E), (0xE8, 0xB4, 0x70), 14) + [(0x20, 0x20, 0x24), (0x9A, 0x98, 0x94)]


def wood(along, across, board, column, row):
    """A board's grain, in texels along and across it."""
    grain = octaves(along / 18, across / 1.6, board * 7, 40, 3)
    return shade(0.3 + 0.35 * roll(9, board) + 0.75 * (grain - 0.45), 14, column, row)


def crate(column, row):
    edge = 10
    nearest = min(column, 63 - column, row, 63 - row)
    if nearest < edge:
        is_upright = min(column, 63 - column) < edge
        along, across = (row, column) if is_upright else (column, row)
        end = min(along, 63 - along)
        if math.hypot(across % 64 - (4.5 if across < 32 else 58.5), end - 4.5) < 1.3:
            return 15 if row % 2 == 0 else 14
        if nearest == 0:
            return 1
        if nearest == edge - 1:
            return 9
        if not is_upright and end == edge:
            return 2
        return wood(along, across, 3 + is_upright + 2 * (across > 32), column, row)
    if nearest == edge:
        return 0
    slant = row - (63 - column)
    if abs(slant) < 7:
        if abs(slant) == 6:
            return 1 if slant > 0 else 10
        return wood(column - row, slant, 11, column, row)
    plank = (column - edge - 1) // 11
    if (column - edge - 1) % 11 == 10:
        return 0
    return max(0, wood(row, column, 20 + plank, column, row) - (3 if 7 <= slant < 10 else 2))


GLOBE = [(0x0C, 0x24, 0x5C), (0x14, 0x3C, 0x84), (0x1C, 0x58, 0xA8), (0x38, 0x80, 0xC0), (0x68, 0xAC, 0xD0), (0xDC, 0xCC, 0x90),
         (0x24, 0x58, 0x24), (0x38, 0x78, 0x30), (0x5C, 0x94, 0x3C), (0x88, 0xA4, 0x4C), (0xC0, 0xA4, 0x60), (0xA0, 0x7C, 0x48),
         (0x7C, 0x60, 0x40), (0xA8, 0xA4, 0xA0), (0xE0, 0xE8, 0xF0), (0xF8, 0xFC, 0xFF)]


def globe(column, row, width=128, height=64):
    longitude, colatitude = 2 * math.pi * (column + 0.5) / width, math.pi * (row + 0.5) / height
    x, y, z = math.sin(colatitude) * math.sin(longitude), math.cos(colatitude), math.sin(colatitude) * math.cos(longitude)
    height_of = octaves(1.6 * x + 9, 1.6 * y + 9, 1.6 * z + 9, 5, 5) - 0.5
    wet = octaves(2.5 * x + 20, 2.5 * y + 20, 2.5 * z + 20, 70, 3) - 0.5
    cold = abs(y) + 0.5 * (octaves(4 * x + 30, 4 * y + 30, 4 * z + 30, 90, 2) - 0.5)
    if cold > 0.93:
        return 15
    if height_of < 0:
        return shade(1 + 7 * height_of, 5, column, row)
    if cold > 0.83:
        return 14
    if height_of < 0.012:
        return 5
    if height_of > 0.16:
        return 13 if height_of > 0.2 else 12
    if abs(y) < 0.5 and wet < -0.04:
        return 10 + (height_of > 0.09)
    return 6 + shade(0.5 + 2.5 * height_of - 2 * wet, 4, column, row)


# The still life, as it stands on the table, whose side is 4: middles, sizes, and the crate's angle.
CRATE, CRATE_HALF, CRATE_TURN = (-0.62, -0.3), 0.62, 24
BALL, BALL_RADIUS = (0.62, 0.32), 0.62

TILES = ramp((0x38, 0x2A, 0x24), (0xEC, 0xE2, 0xCC), 8) + ramp((0x10, 0x14, 0x1A), (0x40, 0x58, 0x6C), 8)


def shut_out(x, z):
    """How much of the sky things hide from the table, from 0 to 1."""
    angle = math.radians(CRATE_TURN)
    dx, dz = x - CRATE[0], z - CRATE[1]
    across = max(abs(dx * math.cos(angle) - dz * math.sin(angle)) - CRATE_HALF, 0)
    along = max(abs(dx * math.sin(angle) + dz * math.cos(angle)) - CRATE_HALF, 0)
    of_crate = math.exp(-math.hypot(across, along) / 0.16)
    of_ball = math.exp(-(math.hypot(x - BALL[0], z - BALL[1]) / 0.38) ** 2)
    return max(0.75 * of_crate, of_ball)


def tiles(column, row, size=128):
    x, z = 4 * (column + 0.5) / size - 2, 4 * (row + 0.5) / size - 2
    is_dark = (column * 8 // size + row * 8 // size) % 2
    is_joint = column % 16 == 0 or row % 16 == 0
    vein = 1 - min(1, 9 * abs(octaves(2.2 * x, 2.2 * z, is_dark, 130, 3) - 0.5))
    level = 0.92 - 0.22 * vein if not is_dark else 0.6 + 0.3 * vein
    level *= (0.6 if is_joint else 1) * (1 - 0.85 * shut_out(x, z))
    return 8 * is_dark + shade(level, 8, column, row)


FENCE = [(0, 0, 0)] + ramp((0x5C, 0x60, 0x68), (0xFF, 0xFC, 0xF0), 15)


def fence(column, row):
    """Two pickets before two rails; around them are holes."""
    place, grain = column % 16, round(4 * octaves(column / 1.5, row / 9, 0, 170, 2))
    if 3 <= place < 13 and 1.2 * abs(place - 7.5) <= row < 31:  # the last row is a hole, as the first one repeats there
        return (10, 12, 13, 13, 12, 12, 12, 11, 10, 7)[place - 3] - 2 + grain
    if 10 <= row < 14 or 23 <= row < 27:
        is_shaded = place in (13, 14) or row in (13, 26)
        return 2 + grain if is_shaded else 5 + grain
    return 0


LEAF = [(0, 0, 0)] + ramp((0x6C, 0x14, 0x08), (0xF4, 0x9C, 0x28), 13) + [(0xF8, 0xC8, 0x60), (0x50, 0x28, 0x10)]


# Tips and notches of the right half of a maple's leaf, from the top to the stalk.
HALF_LEAF = [(0, 1), (0.13, 0.66), (0.26, 0.72), (0.2, 0.36), (0.4, 0.56), (0.5, 0.74), (0.6, 0.56), (0.98, 0.44), (0.76, 0.2),
             (0.84, 0.08), (0.46, -0.06), (0.7, -0.24), (0.56, -0.3), (0.6, -0.5), (0.26, -0.4), (0, -0.38)]
VEINS = ((0, 0.95), (0.48, 0.66), (0.86, 0.38), (0.54, -0.4))


def is_inside(outline, x, y):
    inside = False
    for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            inside = not inside
    return inside


def leaf(column, row):
    """A maple's leaf; around it is a hole."""
    x, y = (column - 31.5) / 31.5, (30.5 - row) / 31.5
    if abs(x - 0.06 * (y + 0.3)) < 0.03 and -0.95 < y < -0.25:
        return 15
    if not is_inside(HALF_LEAF + [(-a, b) for a, b in HALF_LEAF[-2:0:-1]], x, y):
        return 0
    for tip_x, tip_y in VEINS:
        along, length = (abs(x) * tip_x + (y + 0.3) * (tip_y + 0.3)), tip_x ** 2 + (tip_y + 0.3) ** 2
        away = abs(abs(x) * (tip_y + 0.3) - (y + 0.3) * tip_x)
        if 0 < along < 0.9 * length and round(away - 0.022 * math.sqrt(length), 6) < 0:
            return 14
    return 1 + shade(0.15 + 0.8 * octaves(4 * x + 5, 4 * y + 5, 0, 200, 3) + 0.35 * (0.6 - math.hypot(x, y)), 13, column, row)


# ---- Meshes ----


def quantise(vector):
    return tuple(math.floor(round(STEPS * c, 4) + 0.5) for c in vector)


def sphere(around, along):
    """Meridians meet at a seam, where u is 0 and 1; the pole is a vertex of each."""
    points, places, triangles = [], [], []
    for i in range(along + 1):
        for j in range(around + 1):
            a, b = math.pi * i / along, 2 * math.pi * (j % around) / around
            points.append(quantise((math.sin(a) * math.sin(b), math.cos(a), math.sin(a) * math.cos(b))))
            places.append(quantise((j / around if 0 < i < along else min(1, (j + 0.5) / around), i / along)))
    for i in range(along):
        for j in range(around):
            a, b = i * (around + 1) + j, (i + 1) * (around + 1) + j
            triangles += ([(a, b, b + 1)] if i < along - 1 else []) + ([(a, b + 1, a + 1)] if i else [])
            if i == along - 1:
                triangles.append((a, b, a + 1))
                triangles.remove((a, b + 1, a + 1))
    return points, points, places, triangles


def box():
    """Six sides, each of which shows all of a texture."""
    points, normals, places, triangles = [], [], [], []
    sides = (((0, 0, 1), (1, 0, 0)), ((1, 0, 0), (0, 0, -1)), ((0, 0, -1), (-1, 0, 0)), ((-1, 0, 0), (0, 0, 1)),
             ((0, 1, 0), (1, 0, 0)), ((0, -1, 0), (1, 0, 0)))
    for out, right in sides:
        up = (out[1] * right[2] - out[2] * right[1], out[2] * right[0] - out[0] * right[2], out[0] * right[1] - out[1] * right[0])
        first = len(points)
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            points.append(quantise(o + a * r + b * u for o, r, u in zip(out, right, up)))
            normals.append(quantise(out))
            places.append(quantise(((1 + a) / 2, (1 - b) / 2)))
        triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return points, normals, places, triangles


def square():
    corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    return ([quantise((x, y, 0)) for x, y in corners], [quantise((0, 0, 1))] * 4,
            [quantise(((1 + x) / 2, (1 - y) / 2)) for x, y in corners], [(0, 1, 2), (0, 2, 3)])


# ---- The header ----


def rows(kind, name, items):
    """An array, in lines of up to 120 characters."""
    lines, line = [], "   "
    for item in items:
        text = " {%s}," % ", ".join(map(str, item)) if isinstance(item, tuple) else " %s," % item
        if len(line) + len(text) > 120:
            lines.append(line)
            line = "   "
        line += text
    return "static const %s = {\n%s\n};\n" % (kind % name, "\n".join(lines + [line]))


def write_mesh(name, mesh):
    points, normals, places, triangles = mesh
    print(rows("int16_t %s[][3]", name + "_positions", points))
    if normals is not points:
        print(rows("int16_t %s[][3]", name + "_normals", normals))
    print(rows("int16_t %s[][2]", name + "_coordinates", places))
    print(rows("uint16_t %s[][3]", name + "_triangles", triangles))


def write_texture(name, texel, width, height, palette, key=None):
    texels = [texel(column, row) for row in range(height) for column in range(width)]
    pairs = ["%d" % (left << 4 | right) for left, right in zip(texels[::2], texels[1::2])]
    colours = ["0x%04x" % (int(r) >> 3 << 11 | int(g) >> 2 << 5 | int(b) >> 3) for r, g, b in palette]
    flags = "" if key is None else ", GLINT_TEXTURE_HAS_KEY, %d" % key
    print(rows("uint8_t %s[]", name + "_texels", pairs))
    print(rows("uint16_t %s[16]", name + "_palette", colours))
    print("static const glint_texture %s_texture = {&glint_texture_palette16, %s_texels, %s_palette, %d, %d%s};\n"
          % (name, name, name, width, height, flags))


def main():
    # REUSE-IgnoreStart
    print("/* SPDX-License-Identifier: MIT */\n/* Meshes and textures of the still life, written by "
          "examples/scenes/make_still_life.py. */\n#ifndef STILL_LIFE_DATA_H\n#define STILL_LIFE_DATA_H\n\n"
          "#include \"glint.h\"\n\n/* clang-format off */\n")
    # REUSE-IgnoreEnd
    write_mesh("globe", sphere(32, 16))
    write_mesh("crate", box())
    write_mesh("square", square())
    write_texture("globe", globe, 128, 64, GLOBE)
    write_texture("crate", crate, 64, 64, WOOD)
    write_texture("tiles", tiles, 128, 128, TILES)
    write_texture("fence", fence, 32, 32, FENCE, 0)
    write_texture("leaf", leaf, 64, 64, LEAF, 0)
    print("#endif")


if __name__ == "__main__":
    main()
