# SPDX-License-Identifier: MIT
"""Pictures that the library cannot draw, for it leaves out no step: by the formulas, with one step left out; and the difference
of two pictures of the gallery.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import png  # noqa: E402

PAINT, BACKGROUND, EXPONENT, AMPLIFIED = (0.2, 0.35, 0.8), (51, 56, 64), 40, 4
WIDTH, HEIGHT, RADIUS = 320, 140, 48
SIDES, LONGER = 8, 3


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def shade(normal, light, half):
    """Blinn-Phong of vectors as they are given. @return (red, green, blue), the highlight before it is clamped"""
    lit = max(dot(normal, light), 0)
    shine = max(dot(normal, half), 0) ** EXPONENT if lit > 0 else 0
    return tuple(min(round(255 * (paint * (0.2 + 0.6 * lit) + 0.6 * shine)), 255) for paint in PAINT), shine


def draw(path, pixel_of):
    """Three bodies side by side: pixel_of(number, x, y), from -1 to 1, gives a colour and a highlight, or None beside it.
    @return each one's strongest highlight"""
    rows, most = bytearray(), [0, 0, 0]
    for y in range(HEIGHT):
        for x in range(WIDTH):
            number = min(3 * x // WIDTH, 2)
            found = pixel_of(number, (x + 0.5 - WIDTH * (2 * number + 1) / 6) / RADIUS, (HEIGHT / 2 - y - 0.5) / RADIUS)
            rows += bytes(found[0] if found else BACKGROUND)
            most[number] = max(most[number], found[1] if found else 0)
    with open(path, "wb") as file:
        file.write(png.encode(WIDTH, HEIGHT, 3, bytes(rows)))
    return most


def cylinder(number, x, y):
    """Of SIDES sides: normals made unit before and after interpolation, not after, and not before."""
    if abs(y) > 1 or abs(x) >= 1:
        return None
    side = math.floor((math.asin(x) / math.pi + 0.5) * (SIDES / 2))
    ends = [math.pi * (2 * (side + i) / SIDES - 0.5) for i in (0, 1)]
    share = (x - math.sin(ends[0])) / (math.sin(ends[1]) - math.sin(ends[0]))
    lengths = [LONGER if number == 2 and (side + i) % 2 else 1 for i in (0, 1)]
    weights = ((1 - share) * lengths[0], share * lengths[1])
    normal = tuple(sum(w * f(a) for w, a in zip(weights, ends)) for f in (math.sin, lambda _: 0, math.cos))
    light = unit((0.75, 0, 1))
    return shade(normal if number == 1 else unit(normal), light, unit(add(light, (0, 0, 1))))


def sphere(number, x, y):
    """The half vector of unit vectors made unit, not made unit, and of a vector to the eye that is not unit."""
    if x * x + y * y >= 1:
        return None
    normal = (x, y, math.sqrt(1 - x * x - y * y))
    light, to_eye = unit((-0.8, 0.6, 0.6)), add((0, 0, 6), tuple(-c for c in normal))
    half = add(light, to_eye if number == 2 else unit(to_eye))
    return shade(normal, light, half if number == 1 else unit(half))


def difference(folder, path, first, second):
    a, b = (png.read(os.path.join(folder, name)) for name in (first, second))
    pixels = bytes(min(AMPLIFIED * abs(p - q), 255) for up, down in zip(a.rows, b.rows) for left, right in zip(up, down)
                   for p, q in zip(left, right))
    with open(path, "wb") as file:
        file.write(png.encode(a.width, a.height, 3, pixels))


def draw_twins(folder):
    """Draws all. @return [(title, sentence)]"""
    cylinders = draw(os.path.join(folder, "twins-normals.png"), cylinder)
    spheres = draw(os.path.join(folder, "twins-half-vector.png"), sphere)
    difference(folder, os.path.join(folder, "twins-difference.png"), "three-spheres-phong.png", "three-spheres-blinn-phong.png")
    return [
        ("twins:normals", "A cylinder of %d sides, Blinn-Phong with exponent %d. From the left: normals made unit before and after "
         "interpolation; not after, where the highlight reaches %.2f of %.2f; not before, with every second vertex's normal %d times "
         "as long, which bends the bright band." % (SIDES, EXPONENT, cylinders[1], cylinders[0], LONGER)),
        ("twins:half-vector", "From the left: the half vector of unit vectors, made unit; not made unit: its length, up to %.1f, is "
         "raised to the power of %d as well; made of a vector to the eye as long as the distance, which draws the highlight towards the "
         "eye." % (spheres[1] ** (1 / EXPONENT), EXPONENT)),
        ("twins:difference", "three-spheres:phong from three-spheres:blinn-phong, %d times amplified: only highlights differ." % AMPLIFIED),
    ]
