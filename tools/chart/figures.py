# SPDX-License-Identifier: MIT
"""The figures that charts and pages show, read from the CSV files that are kept in docs/."""
import collections
import csv
import os

CPUS = {"m0": "Cortex-M0", "m3": "Cortex-M3", "m4": "Cortex-M4", "rv32": "RV32IMC"}

# What every scene asks for; charts and tables of frames are held against it.
ASKED = "fragment Blinn-Phong local"

# Kinds of light and numbers of them that frames of LIT are counted with, and what one and several of them are called.
LIT = "torus576"
LIGHTS = {"directional": ("directional", "directional"), "point": ("point", "points"), "spot": ("spot", "spots")}
LIGHT_COUNTS = (1, 2, 4, 8)


class Missing(Exception):
    """A figure that a chart or a page needs is not there."""


def read(directory, name):
    path = os.path.join(directory, name)
    try:
        with open(path, newline="") as file:
            return list(csv.DictReader(file))
    except FileNotFoundError:
        raise Missing("%s is not there: run `make figures`" % path)


def only(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def one(rows, **wanted):
    found = only(rows, **wanted)
    if len(found) != 1:
        raise Missing("%d rows have %s" % (len(found), wanted))
    return found[0]


def front(points, largest=False):
    """The points that no other beats in both of x and y (Pareto, 1896), by rising x; smaller is better, or larger y."""
    best, kept = None, []
    for point in sorted(points, key=lambda p: (p[0], -p[1] if largest else p[1])):
        if best is None or (point[1] > best if largest else point[1] < best):
            best = point[1]
            kept.append(point)
    return kept


Method = collections.namedtuple("Method", "name variant instructions error shipped")


class Figures:
    def __init__(self, directory):
        self.frames = read(directory, "frame-accuracy.csv")
        self.gallery = read(directory, "gallery-accuracy.csv")
        self.counts = read(directory, "frame-instructions.csv")
        self.ways = read(directory, "ways-accuracy.csv")
        self.others = read(directory, "other-libraries.csv")
        self.bench = read(directory, "bench.csv")
        self.bench_arena = read(directory, "bench-arena.csv")
        self.accuracy = read(directory, "accuracy.csv")
        self.shading = read(os.path.join(directory, "charts"), "shading.csv")
        self.depth = read(os.path.join(directory, "charts"), "depth.csv")
        self.regions = read(os.path.join(directory, "charts"), "regions.csv")
        self.means = read(os.path.join(directory, "charts"), "means.csv")
        self.edges = read(os.path.join(directory, "charts"), "edges.csv")
        self.parts = read(directory, "parts.csv")
        self.arena = read(os.path.join(directory, "charts"), "arena.csv")

    def cpus(self, rows):
        """Those that rows have, in the order of CPUS."""
        return [cpu for cpu in CPUS if any(row["cpu"] == cpu for row in rows)]

    def methods(self, kind, cpu, p):
        """Of each method of a kind; `p` is "" where there is none."""
        return [Method(row["name"], row["variant"], float(row["instructions"]),
                       *self.error(kind, row["name"], row["variant"], p)) for row in only(self.bench, kind=kind, cpu=cpu)]

    def error(self, kind, name, variant, p):
        """Largest, in steps of 8 bits, and whether the method is the library's own."""
        row = one(self.accuracy, kind=kind, name=name, variant=variant, p=p)
        return float(row["max_error_lsb8"]), row["shipped"] == "shipped"

    def errors(self, kind, name, variant):
        """@return (p, largest error) by rising p; p is 0 where there is none"""
        return sorted((float(row["p"] or 0), float(row["max_error_lsb8"]))
                      for row in only(self.accuracy, kind=kind, name=name, variant=variant))

    def names(self, kind):
        """@return name, variant and whether the library's own, of every method of a kind"""
        return list(dict.fromkeys((row["name"], row["variant"], row["shipped"] == "shipped")
                                  for row in only(self.accuracy, kind=kind)))

    def instructions(self, scene, lights, choice, cpu):
        """Of a frame at 320x240, in millions."""
        row = one(self.counts, scene=scene, lights=lights, choice=choice, cpu=cpu)
        return int(row["instructions"]) / 1e6

    def asked(self, scene, size, cpu):
        """Of a frame of a benchmark scene as it is, in millions."""
        row = one(self.bench, kind="frame", name=scene, variant=size + " local 32x32", cpu=cpu)
        return int(row["instructions"]) / 1e6

    def good_float(self, scene, size):
        """Of such a frame in good float on Cortex-M4 with FPU, in millions."""
        return int(one(self.bench, kind="frame", name=scene, variant=size + " local float", cpu="m4f")["instructions"]) / 1e6

    def float_psnr(self, scene, lights, choice):
        return float(one(self.ways, scene=scene, lights=lights, choice=choice)["float_psnr_db"])

    def benchmark(self):
        """@return (scene, size) of every benchmark scene"""
        return list(dict.fromkeys((row["scene"], row["size"]) for row in self.frames))

    def over_lights(self, kind, cpu, choice=ASKED):
        """@return (number of lights of that kind, millions of instructions of a frame, PSNR) by rising number"""
        column = "float_psnr_db" if cpu == "m4f" else "psnr_db"
        found = []
        for count in LIGHT_COUNTS:
            lights = "%d %s" % (count, LIGHTS[kind][count > 1])
            psnr = one(self.ways, scene=LIT, lights=lights, choice=choice)[column]
            found.append((count, self.instructions(LIT, lights, choice, cpu), float(psnr)))
        return found

    def choices(self):
        return list(dict.fromkeys(row["choice"] for row in self.counts))

    def frame(self, scene, size, choice, p="32", format="rgb565", against="scene"):
        return one(self.frames, scene=scene, size=size, choice=choice, p=p, format=format, against=against)

    def psnr(self, *which, **other):
        return float(self.frame(*which, **other)["psnr_db"])
