# SPDX-License-Identifier: MIT
"""The figures that charts and pages show, read from the CSV files that are kept in docs/."""
import csv
import os

CPUS = {"m0": "Cortex-M0", "m3": "Cortex-M3", "m4": "Cortex-M4", "rv32": "RV32IMC"}

# What every scene asks for; charts and tables of frames are held against it.
ASKED = "fragment Blinn-Phong local"


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


class Figures:
    def __init__(self, directory):
        self.frames = read(directory, "frame-accuracy.csv")
        self.counts = read(directory, "frame-instructions.csv")
        self.others = read(directory, "other-libraries.csv")
        self.shading = read(os.path.join(directory, "charts"), "shading.csv")

    def cpus(self, rows):
        """Those that rows have, in the order of CPUS."""
        return [cpu for cpu in CPUS if any(row["cpu"] == cpu for row in rows)]

    def instructions(self, scene, size, choice, cpu):
        """Of a frame, in millions."""
        row = one(self.counts, scene=scene, size=size, choice=choice, cpu=cpu)
        return int(row["instructions"]) / 1e6

    def choices(self):
        return list(dict.fromkeys(row["choice"] for row in self.counts))

    def frame(self, scene, size, choice, p="32", format="rgb565", against="scene"):
        return one(self.frames, scene=scene, size=size, choice=choice, p=p, format=format, against=against)

    def psnr(self, *which, **other):
        return float(self.frame(*which, **other)["psnr_db"])
