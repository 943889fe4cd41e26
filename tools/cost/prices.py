#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The cost model: what each item that a frame consists of takes: prices.py COUNTS [--check]

COUNTS is what build/cost/count writes: the items of the benchmark's frames and of the gallery's pictures
(port/host/counts.h). The instructions and cycles that docs/bench.csv and docs/gallery-instructions.csv have of the same
frames are what they should come to. Prices are fitted to the benchmark's frames but those of JUDGED, by least squares of
relative errors without negative values (nnls.py), and kept in docs/prices.csv. From these follow port/host/prices.h,
which the host program reads, and docs/prices-judged.csv: the errors on JUDGED, and on the pictures that are no frame of the
benchmark. With --check nothing is written: what is kept is held against each other, and the errors against MOST.
"""
import argparse
import csv
import io
import os
import re
import sys

from nnls import nnls

sys.path[:0] = [os.path.join(os.path.dirname(__file__), *folders)
                for folders in (("..", "chart"), ("..", "..", "tests", "board"))]
from figures import one, read
from qemu import Tally
from timing import SLOW_MHZ

PRICES, JUDGED_FILE, HEADER, ITEMS = "docs/prices.csv", "docs/prices-judged.csv", "port/host/prices.h", "port/host/counts.h"

# Columns of prices: what of docs/bench.csv they add up to.
COLUMNS = {"instructions_m0": ("m0", "instructions"), "instructions_m3": ("m3", "instructions"),
           "instructions_m4": ("m4", "instructions"), "instructions_rv32": ("rv32", "instructions"),
           "cycles_m0": ("m0", "cycles_slow_multiply"), "cycles_m0plus": ("m0", "cycles"), "cycles_m3": ("m3", "cycles"),
           "cycles_m4": ("m4", "cycles")}

# Cores in print; the clock of a part of docs/parts.csv, or else that of a Cortex-M0 that multiplies in 32 cycles.
CORES = {"m0": None, "m0plus": "m0", "m3": "m3", "m4": "m4", "rv32": None}

# Frames that prices are not fitted to, and what these may be off by on them.
JUDGED = (("cube", "128x64 local 32x32"), ("pyramid", "128x64 local 32x32 4 points"), ("boxes20", "128x64 local 32x32 4 points"),
          ("boxes200", "320x240 local 32x32"), ("three-spheres", "320x160 local 32x32 blinn-phong"),
          ("three-spheres", "320x160 local 32x32 vertex-dense"), ("teapot", "320x160 local 32x32 flood-wide"),
          ("shaders", "320x180 local 32x32 torus-50"), ("shaders", "320x180 local 32x32 sphere-50"),
          ("phong-lighting", "320x240 local 32x32 near"), ("phong-lighting", "320x240 local 32x32 ring"),
          ("phong-lighting", "320x240 local 32x32 scaled-vertex-colours"), ("halloween", "320x240 local 32x32 night"),
          ("halloween", "320x240 local 32x32 floodlit"), ("surfaces", "320x160 local 32x32 metal"),
          ("surfaces", "320x160 local 32x32 ungated"), ("surfaces", "320x160 local 32x32 twice-near"),
          ("torus2304", "320x240 local 32x32"), ("torus9216", "128x64 local 32x32"), ("torus576", "320x240 local 32x32 4 spots"))
MOST = 0.2

# Of the square of a column's length: what keeps prices apart that the frames do not tell apart. From 0.05 to 0.4, the more it
# is the less is the largest error on frames that are not fitted to, and the more the mean one: this keeps the largest below MOST.
RIDGE = 3.7e-1


def text_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return file.read()


def csv_of(columns, rows):
    file = io.StringIO()
    table = csv.writer(file, lineterminator="\n")
    table.writerow(columns)
    table.writerows(rows)
    return file.getvalue()


def items():
    """Names of items, and what one is, as the program counts them."""
    return re.findall(r'X\((\w+), "([^"]*)"\)', text_of(ITEMS))


class Frames:
    """What was counted here and in the emulator, by scene and variant."""

    def __init__(self, path):
        with open(path, newline="") as file:
            self.counts = {(row["name"], row["variant"]): row for row in csv.DictReader(file)}
        self.emulated = {(row["name"], row["variant"], row["cpu"]): row for row in read("docs", "bench.csv") if row["kind"] == "frame"}
        self.benchmark = [frame for frame in self.counts if frame + ("m3",) in self.emulated]
        pictures = read("docs", "gallery-instructions.csv")
        self.emulated.update({(row["scene"], row["variant"], row["cpu"]): row for row in pictures})
        known = {(name, variant.split(" ")[-1]) for name, variant in self.benchmark}
        self.pictures = [frame for frame in dict.fromkeys((row["scene"], row["variant"]) for row in pictures) if frame not in known]

    def counted(self, frame, column):
        """What the emulator counted, or None."""
        cpu, what = COLUMNS[column]
        value = self.emulated.get(frame + (cpu,), {}).get(what)
        return float(value) if value else None

    def priced(self, frame, prices):
        return sum(price * float(self.counts[frame][item]) for item, price in prices.items())


def fit(frames, column):
    """The price of each item."""
    names = [name for name, _ in items()]
    known = [frame for frame in frames.benchmark if frame not in JUDGED]
    rows = [[float(frames.counts[frame][name]) / frames.counted(frame, column) for name in names] for frame in known]
    return dict(zip(names, nnls(rows, [1.0] * len(rows), RIDGE)))


def prices_text(frames):
    fitted = {column: fit(frames, column) for column in COLUMNS}
    return csv_of(["item", "one"] + list(COLUMNS),
                  [[name, what] + ["%.4g" % fitted[column][name] for column in COLUMNS] for name, what in items()])


def judged_text(frames, rows):
    """Of each frame that is judged: counted, and the error of what is priced, percent."""
    result = []
    for frame in (*JUDGED, *frames.pictures):
        for column in COLUMNS:
            prices = {row["item"]: float(row[column]) for row in rows}
            counted = frames.counted(frame, column)
            if counted:
                result.append([*frame, column, "%.0f" % counted, "%.1f" % (100 * (frames.priced(frame, prices) / counted - 1))])
    return csv_of(["name", "variant", "column", "counted", "error_percent"], result)


def clock(core):
    part = CORES[core]
    return int(one(read("docs", "parts.csv"), cpu=part)["core_mhz"]) if part else SLOW_MHZ


def header_text(rows):
    columns = list(COLUMNS)
    lines = ["/* SPDX-License-Identifier: MIT */", "/* Made from docs/prices.csv and docs/parts.csv by `make prices`, not to be edited. */",
             "static const cost_core cores[] = {"]
    cores = []
    for core in CORES:
        index = [columns.index(what + core) if what + core in columns else -1 for what in ("instructions_", "cycles_")]
        cores.append('{"%s", %d, %d, %d},' % (core, clock(core) if index[1] >= 0 else 0, *index))
    lines.append("    " + " ".join(cores))
    lines += ["};", "", "/* Of each item: " + ", ".join(columns[:4]) + ",", " * " + ", ".join(columns[4:]) + ". */", "static const double prices[][%d] = {" % len(columns)]
    lines += ["    [COUNTS_%s] = {%s}," % (row["item"], ", ".join(row[column] for column in columns)) for row in rows]
    return "\n".join(lines + ["};", ""])


def rows_of(text):
    return list(csv.DictReader(io.StringIO(text)))


def check_solver(tally):
    """2 x + y = 3, x - y = 3 and 4 y = z by hand: 5 x + y = 9 and x + 18 y = 4 z, but y is 0 where that is below 0."""
    for z, wanted in ((-4, (9 / 5, 0)), (4, (146 / 89, 71 / 89))):
        found = nnls([[2.0, 1.0], [1.0, -1.0], [0.0, 4.0]], [3.0, 3.0, float(z)])
        tally.check(all(abs(a - b) < 1e-6 for a, b in zip(found, wanted)), "nnls: %s for %s" % (found, wanted))


def check(frames):
    tally = Tally()
    check_solver(tally)
    rows = rows_of(text_of(PRICES))
    if not tally.check([(row["item"], row["one"]) for row in rows] == items(),
                       "%s has other items than %s: make prices, then make chart" % (PRICES, ITEMS)):
        return tally.close()
    tally.check(text_of(HEADER) == header_text(rows), "%s is not made from %s: make prices" % (HEADER, PRICES))
    judged = rows_of(judged_text(frames, rows))
    kept = rows_of(text_of(JUDGED_FILE))
    tally.check([{**row, "error_percent": ""} for row in kept] == [{**row, "error_percent": ""} for row in judged],
                "%s tells of other frames than were emulated: make prices, then make chart" % JUDGED_FILE)
    for name, variant in (*JUDGED, *frames.pictures):
        worst = max((row for row in judged if (row["name"], row["variant"]) == (name, variant)),
                    key=lambda row: abs(float(row["error_percent"])))
        tally.check(abs(float(worst["error_percent"])) <= 100 * MOST,
                    "%s, %s: %s is off by %s %%" % (name, variant, worst["column"], worst["error_percent"]))
    tally.check(set(JUDGED) < set(frames.benchmark), "a frame of JUDGED is not in the benchmark")
    return tally.close()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("counts")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    frames = Frames(arguments.counts)
    if arguments.check:
        return check(frames)
    prices = prices_text(frames)
    for path, text in ((PRICES, prices), (HEADER, header_text(rows_of(prices))), (JUDGED_FILE, judged_text(frames, rows_of(prices)))):
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
