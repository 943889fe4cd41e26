#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the models of the scenes that no generator of the converter makes.

usage: make_models.py FOLDER

The same bytes on every machine: coordinates have 4 decimals, which leaves libm's last bit out.
"""
import math
import os
import sys


class Model:
    """Triangles with a normal at each corner; y up, front faces counter-clockwise."""

    def __init__(self):
        self.points, self.normals, self.triangles = [], [], []

    def add(self, point, normal):
        self.points.append(point)
        self.normals.append(normal)
        return len(self.points) - 1

    def triangle(self, a, b, c):
        if len({a, b, c}) == 3:
            self.triangles.append((a, b, c))

    def quad(self, a, b, c, d):
        self.triangle(a, b, c)
        self.triangle(a, c, d)

    def write(self, folder, name, what):
        with open(os.path.join(folder, name), "w", encoding="ascii") as out:
            # REUSE-IgnoreStart
            out.write("# SPDX-License-Identifier: MIT\n# %s Written by examples/scenes/make_models.py.\n" % what)
            # REUSE-IgnoreEnd
            for point in self.points:
                out.write("v %s\n" % numbers(point))
            for normal in self.normals:
                out.write("vn %s\n" % numbers(normal))
            for triangle in self.triangles:
                out.write("f %s\n" % " ".join("%d//%d" % (i + 1, i + 1) for i in triangle))


def numbers(vector):
    return " ".join("%.4f" % (round(x, 4) + 0.0) for x in vector)


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def scale(a, factor):
    return tuple(x * factor for x in a)


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return scale(a, 1 / length)


# ---- Pumpkins: ten ribs, dimples at both ends, and openings cut out along the outlines of a face ----


def skin(longitude, latitude):
    """A point of the pumpkin; degrees, longitude 0 towards z."""
    a, b = math.radians(longitude), math.radians(latitude)
    out = math.cos(b)
    rib = 0.87 + 0.13 * abs(math.cos(5 * a)) ** 0.7
    dimple = 0.3 * math.exp(-((out / 0.3) ** 2)) * (1 if latitude > 0 else 0.5)
    height = 0.84 * math.sin(b) * (1 - dimple) * (0.94 + 0.06 * rib)
    return (out * rib * math.sin(a), height, out * rib * math.cos(a))


def skin_normal(longitude, latitude):
    step = 1.0
    latitude = max(-89.0, min(89.0, latitude))
    along = minus(skin(longitude + step, latitude), skin(longitude - step, latitude))
    up = minus(skin(longitude, latitude + step), skin(longitude, latitude - step))
    return unit(cross(along, up))


def distance(outline, x, y):
    """To the nearest edge of a polygon, below 0 inside."""
    nearest, inside = 1e9, False
    for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
        dx, dy = x1 - x0, y1 - y0
        t = max(0.0, min(1.0, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)))
        nearest = min(nearest, math.hypot(x - x0 - t * dx, y - y0 - t * dy))
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * dx / dy:
            inside = not inside
    return -nearest if inside else nearest


def snap(grid, corner):
    """Moves the grid point nearest to a corner of an outline onto it, so that the corner stays sharp.

    Where that would fold the grid, as beside the crease between two ribs, the corner stays blunt.
    """
    best = min((p for p in grid if abs(p[0]) < 80), key=lambda p: math.dist(skin(*p)[:2], corner))
    longitude, latitude = best
    for _ in range(20):  # Newton's method, by differences
        x, y = skin(longitude, latitude)[:2]
        ax, ay = minus(skin(longitude + 0.1, latitude)[:2], (x, y))
        bx, by = minus(skin(longitude, latitude + 0.1)[:2], (x, y))
        determinant = ax * by - ay * bx
        ex, ey = corner[0] - x, corner[1] - y
        longitude += 0.1 * (ex * by - ey * bx) / determinant
        latitude += 0.1 * (ax * ey - ay * ex) / determinant
    error = math.dist(skin(longitude, latitude)[:2], corner)
    if error < 1e-3 and abs(longitude - best[0]) < 3 and abs(latitude - best[1]) < 3.2:
        best[0], best[1] = longitude, latitude


def grid_of(longitudes, latitudes):
    """Points as [longitude, latitude] and triangles over them; the poles are the last two."""
    n, rows = len(longitudes), len(latitudes)
    points = [[lon, lat] for lat in latitudes for lon in longitudes] + [[0.0, -90.0], [0.0, 90.0]]
    south, north = n * rows, n * rows + 1
    triangles = []
    for i in range(n):
        j = (i + 1) % n
        triangles.append((south, j, i))
        for row in range(rows - 1):
            a, b = row * n, row * n + n
            quad = (a + i, a + j, b + j, b + i)
            # The diagonals mirror each other about the middle of the face.
            if longitudes[i] >= 0:
                triangles += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
            else:
                triangles += [(quad[0], quad[1], quad[3]), (quad[1], quad[2], quad[3])]
        triangles.append(((rows - 1) * n + i, (rows - 1) * n + j, north))
    return points, triangles


# Where the inside of a wall is, as part of the way from the middle out.
WALL = 0.86


class Carver:
    """Cuts triangles where the distance to the outlines is 0; what is inside falls out."""

    def __init__(self, points, outlines):
        self.shell, self.lining = Model(), Model()
        self.level, self.cuts = [], {}
        for longitude, latitude in points:
            point = skin(longitude, latitude)
            self.shell.add(point, skin_normal(longitude, latitude))
            outside = point[2] <= 0 or not outlines
            level = 1.0 if outside else min(distance(outline, point[0], point[1]) for outline in outlines)
            self.level.append(0.0 if abs(level) < 1e-6 else level)

    def cut(self, a, b):
        """The point between a, outside, and b, inside, where the outline passes."""
        if self.level[a] == 0:
            return a
        if (a, b) not in self.cuts:
            t = self.level[a] / (self.level[a] - self.level[b])
            shell = self.shell
            normal = unit(mix(shell.normals[a], shell.normals[b], t))
            self.cuts[a, b] = shell.add(mix(shell.points[a], shell.points[b], t), normal)
        return self.cuts[a, b]

    def triangle(self, corners):
        kept = [self.level[i] >= 0 for i in corners]
        if all(kept):
            self.shell.triangle(*corners)
            return
        if not any(kept):
            return
        while not (kept[0] and not kept[2]):  # the first is kept, the last falls out
            corners, kept = corners[1:] + corners[:1], kept[1:] + kept[:1]
        a, b, c = corners
        if kept[1]:
            ends = self.cut(b, c), self.cut(a, c)
            self.shell.quad(a, b, ends[0], ends[1])
        else:
            ends = self.cut(a, b), self.cut(a, c)
            self.shell.triangle(a, ends[0], ends[1])
        self.wall(*ends)

    def wall(self, start, end):
        """The wall's thickness along a cut, whose kept side is on the left."""
        if start == end:
            return
        p, q = self.shell.points[start], self.shell.points[end]
        normal = unit(cross(minus(q, p), scale(p, -1)))
        outer = self.lining.add(p, normal), self.lining.add(q, normal)
        inner = self.lining.add(scale(p, WALL), normal), self.lining.add(scale(q, WALL), normal)
        self.lining.quad(outer[0], inner[0], inner[1], outer[1])


    def line(self):
        """The inside of the wall, as far as it can be seen through the face: sides and back."""
        inner = {}
        for corners in self.shell.triangles:
            points = [self.shell.points[i] for i in corners]
            if all(p[2] > 0.55 * math.hypot(*p) for p in points):
                continue
            for i, p in zip(corners, points):
                if i not in inner:
                    inner[i] = self.lining.add(scale(p, WALL), scale(self.shell.normals[i], -1))
            self.lining.triangle(*[inner[i] for i in reversed(corners)])


def carve(longitudes, latitudes, outlines):
    points, triangles = grid_of(longitudes, latitudes)
    for outline in outlines:
        for corner in outline:
            snap(points[:-2], corner)
    carver = Carver(points, outlines)
    for triangle in triangles:
        carver.triangle(triangle)
    carver.line()
    return used(carver.shell), carver.lining


def used(model):
    """Without the points that no triangle has."""
    kept = Model()
    index = {}
    for triangle in model.triangles:
        for i in triangle:
            if i not in index:
                index[i] = kept.add(model.points[i], model.normals[i])
        kept.triangles.append(tuple(index[i] for i in triangle))
    return kept


def face_grid():
    front = [4.5 * i for i in range(-14, 15)]
    back = [63 + 9.0 * i for i in range(1, 26)]
    latitudes = [-78, -68, -58, -50] + [-45 + 5.0 * i for i in range(18)] + [48, 56, 66, 74, 82]
    return front + back, latitudes


def mirrored(points):
    """The right half of an outline and its mirror image; the first and the last lie in the middle."""
    return points + [(-x, y) for x, y in points[-2:0:-1]]


def mouth(half, upper, lower, bend, teeth, depth):
    """A grin of `half` width with zigzag edges; `upper` and `lower` are the heights of its middle."""
    top, bottom = [], []
    for i in range(teeth + 1):
        x = half * 0.88 * i / teeth
        tooth = depth if (teeth - i) % 2 == 1 else 0
        top.append((x, upper + bend * x * x - tooth))
        bottom.append((x, lower + 1.35 * bend * x * x + (depth if tooth == 0 and i < teeth else 0)))
    corner = (half, upper + bend * half * half - 0.04)
    return mirrored(bottom + [corner] + top[::-1])


def merry_face():
    eye = [(0.15, 0.15), (0.51, 0.13), (0.31, 0.47)]
    return [eye, [(-x, y) for x, y in eye], [(-0.1, -0.06), (0.1, -0.06), (0, 0.12)],
            mouth(0.68, -0.2, -0.5, 0.42, 4, 0.1)]


def grim_face():
    eye = [(0.11, 0.12), (0.5, 0.16), (0.58, 0.45), (0.34, 0.3)]
    return [eye, [(-x, y) for x, y in eye], mouth(0.62, -0.16, -0.5, 0.3, 3, 0.13)]


# ---- Tubes, for stems and trees ----


def tube(model, path, radii, sides, ribs=0.0):
    """Round a path from its first point to its last, where it closes if the radius is 0."""
    rings = []
    for k, (centre, radius) in enumerate(zip(path, radii)):
        along = unit(minus(path[min(k + 1, len(path) - 1)], path[max(k - 1, 0)]))
        side = unit(cross(along, (0.31, 0.17, 0.94)))
        other = cross(along, side)
        ring = []
        for i in range(sides):
            a = 2 * math.pi * i / sides
            out = add(scale(side, math.cos(a)), scale(other, math.sin(a)))
            ring.append(model.add(add(centre, scale(out, radius * (1 - ribs * (i % 2)))), out))
        rings.append(ring)
    for low, high in zip(rings, rings[1:]):
        for i in range(sides):
            j = (i + 1) % sides
            model.quad(low[i], low[j], high[j], high[i])
    return rings


def stem():
    model = Model()
    path = [(0, 0, 0), (0, 0.07, 0), (0.01, 0.18, 0), (0.05, 0.3, 0.01), (0.12, 0.4, 0.02)]
    rings = tube(model, path, [0.22, 0.12, 0.085, 0.08, 0.095], 12, 0.22)
    normal = unit((0.5, 0.85, 0.1))
    rim = [model.add(model.points[i], normal) for i in rings[-1]]
    centre = model.add(path[-1], normal)
    for i, a in enumerate(rim):
        model.triangle(a, rim[(i + 1) % len(rim)], centre)
    return model


class Dice:
    """Numbers from 0 to 1, the same everywhere (Park and Miller, 1988)."""

    def __init__(self, seed):
        self.state = seed

    def roll(self, low, high):
        self.state = self.state * 16807 % 2147483647
        return low + (high - low) * self.state / 2147483647


def grow(model, dice, start, direction, length, radius, depth):
    path, at = [start], start
    for _ in range(3):
        bend = (dice.roll(-0.35, 0.35), dice.roll(-0.1, 0.3), dice.roll(-0.35, 0.35))
        direction = unit(add(direction, bend))
        at = add(at, scale(direction, length / 3))
        path.append(at)
    last = radius * 0.55 if depth else 0.004
    radii = [radius + (last - radius) * k / 3 for k in range(4)]
    tube(model, path, radii, 6 if depth > 1 else 4)
    if depth == 0:
        return
    for i in range(3):
        turn = 2 * math.pi * (i + dice.roll(0, 0.6)) / 3
        aside = (math.cos(turn), 0.25, 0.7 * math.sin(turn))
        new = unit(add(scale(direction, 0.75), scale(aside, 0.8)))
        grow(model, dice, path[3 if i else 2], new, length * dice.roll(0.55, 0.75), last * 0.9, depth - 1)


def tree():
    model = Model()
    grow(model, Dice(20), (0, -0.1, 0), (0.12, 1, 0), 1.7, 0.2, 3)
    return model


# ---- Flat things ----


def extrude(outline, depth):
    """A convex outline, counter-clockwise, from z = -depth to depth."""
    model = Model()
    for sign in (1, -1):
        face = [model.add((x, y, sign * depth), (0, 0, sign)) for x, y in outline[::sign]]
        for i in range(1, len(face) - 1):
            model.triangle(face[0], face[i], face[i + 1])
    for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
        normal = unit((y1 - y0, x0 - x1, 0))
        corners = [(x0, y0, depth), (x0, y0, -depth), (x1, y1, -depth), (x1, y1, depth)]
        model.quad(*[model.add(corner, normal) for corner in corners])
    return model


def tombstone():
    arc = [(0.5 * math.cos(math.radians(a)), 0.9 + 0.5 * math.sin(math.radians(a))) for a in range(0, 181, 15)]
    return extrude([(-0.5, -0.3), (0.5, -0.3)] + arc, 0.12)


def picket():
    return extrude([(-0.1, -0.1), (0.1, -0.1), (0.1, 1), (0, 1.2), (-0.1, 1)], 0.035)


def wing():
    """The right half of a bat, its hinge along z."""
    model = Model()
    outline = [(0, 0.10), (0.05, 0.2), (0.09, 0.1), (0.45, 0.3), (1, 0.12), (0.8, 0.02), (0.72, -0.14), (0.52, -0.04),
               (0.4, -0.2), (0.24, -0.08), (0.1, -0.2), (0, -0.26)]
    points = [model.add((x, 0.02 * x, -y), (0, 1, 0)) for x, y in outline]
    hub = model.add((0.2, 0, -0.05), (0, 1, 0))
    for a, b in zip(points, points[1:] + points[:1]):
        model.triangle(hub, b, a)
    return model


def flame():
    """A drop, its foot at y = 0."""
    model = Model()
    profile = [(0, 0), (0.13, 0.05), (0.2, 0.16), (0.2, 0.3), (0.14, 0.48), (0.07, 0.68), (0, 0.95)]
    sides, rings = 12, []
    for k, (radius, y) in enumerate(profile):
        r0, y0 = profile[max(k - 1, 0)]
        r1, y1 = profile[min(k + 1, len(profile) - 1)]
        out, up = y1 - y0, r0 - r1
        ring = []
        for i in range(sides if radius else 1):
            s, c = math.sin(2 * math.pi * i / sides), math.cos(2 * math.pi * i / sides)
            normal = (out * s, up, out * c) if radius else (0, 1 if k else -1, 0)
            ring.append(model.add((radius * s, y, radius * c), unit(normal)))
        rings.append(ring)
    for low, high in zip(rings, rings[1:]):
        for i in range(sides):
            j = (i + 1) % sides
            model.quad(low[i % len(low)], low[j % len(low)], high[j % len(high)], high[i % len(high)])
    return model


def glow():
    """Rings of 24 points round the z axis: what the scene colours from the moon outwards."""
    model = Model()
    radii, sides = [1, 1.25, 1.6, 2.1, 3, 4.5, 8, 20], 24
    centre = model.add((0, 0, 0), (0, 0, 1))
    before = [centre] * sides
    for radius in radii:
        ring = []
        for i in range(sides):
            a = 2 * math.pi * i / sides
            ring.append(model.add((radius * math.cos(a), radius * math.sin(a), 0), (0, 0, 1)))
        for i in range(sides):
            j = (i + 1) % sides
            model.triangle(before[i], ring[i], ring[j])
            if before[i] != before[j]:
                model.triangle(before[i], ring[j], before[j])
        before = ring
    return model


def stars():
    """Small triangles over x and y from -1 to 1."""
    model, dice = Model(), Dice(7)
    for _ in range(90):
        x, y, size = dice.roll(-1, 1), dice.roll(-1, 1), dice.roll(0.0035, 0.0065)
        corners = [(x - size, y - size, 0), (x + size, y - size, 0), (x, y + size, 0)]
        model.triangle(*[model.add(corner, (0, 0, 1)) for corner in corners])
    return model


def skewed_cylinder():
    """Round the z axis, for a scale of 0.3 along y: normals that this scale takes to where it takes points."""
    model = Model()
    sides, half_height, squash = 30, 0.85, 0.3
    corners = [(math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides)) for i in range(sides)]
    rings = [[model.add((x, y, z), unit((x, y * squash * squash, 0))) for x, y in corners]
             for z in (-half_height, 0, half_height)]
    for low, high in zip(rings, rings[1:]):
        for i in range(sides):
            j = (i + 1) % sides
            model.quad(low[i], low[j], high[j], high[i])
    for z in (-half_height, half_height):
        outward = (0, 0, 1 if z > 0 else -1)
        rim = [model.add((x, y, z), outward) for x, y in corners]
        middle = model.add((0, 0, z), outward)
        for i in range(sides):
            a, b = rim[i], rim[(i + 1) % sides]
            model.triangle(middle, *((a, b) if z > 0 else (b, a)))
    return model


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = sys.argv[1]
    for name, face in (("merry", merry_face()), ("grim", grim_face())):
        shell, lining = carve(*face_grid(), face)
        shell.write(folder, "pumpkin-%s.obj" % name, "A carved pumpkin's skin.")
        lining.write(folder, "pumpkin-%s-lining.obj" % name, "The thickness of its wall along the cuts, and its inside.")
    whole, _ = carve([9.0 * i for i in range(40)], [-75 + 10.0 * i for i in range(16)] + [82], [])
    whole.write(folder, "pumpkin.obj", "A pumpkin.")
    stem().write(folder, "stem.obj", "A pumpkin's stem.")
    tree().write(folder, "tree.obj", "A bare tree.")
    tombstone().write(folder, "tombstone.obj", "A tombstone.")
    picket().write(folder, "picket.obj", "A fence's picket.")
    wing().write(folder, "bat-wing.obj", "The right half of a bat, to be drawn from both sides.")
    flame().write(folder, "flame.obj", "A flame.")
    glow().write(folder, "glow.obj", "Rings of 24 vertices.")
    skewed_cylinder().write(folder, "cylinder-skewed.obj", "A cylinder with the normals of a wrong transform.")
    stars().write(folder, "stars.obj", "Ninety stars.")


if __name__ == "__main__":
    main()
