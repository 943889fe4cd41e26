#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts frames that grow: scaling.py --qemu QEMU --output CSV CPU=ELF...

Beside the count stands the straight line that fits each sweep best (least squares, relative), and how far the count is from it.
"""
import argparse
import concurrent.futures
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "bench"))
from emulate import lines_of


def fit(points):
    """Line a + b x that leaves the least squares of relative errors."""
    weights = [1.0 / (y * y) for _, y in points]
    total = sum(weights)
    mean_x = sum(w * x for w, (x, _) in zip(weights, points)) / total
    mean_y = sum(w * y for w, (_, y) in zip(weights, points)) / total
    slope = (sum(w * (x - mean_x) * (y - mean_y) for w, (x, y) in zip(weights, points)) /
             sum(w * (x - mean_x) ** 2 for w, (x, _) in zip(weights, points)))
    return mean_y - slope * mean_x, slope


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    firmware = [pair.split("=", 1) for pair in arguments.firmware]
    workers = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    running = [workers.submit(lines_of, arguments.qemu, "mps2-an385", elf) for _, elf in firmware]
    with open(arguments.output, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(("cpu", "sweep", "count", "instructions", "line_start", "line_slope", "off_line"))
        for (cpu, _), result in zip(firmware, running):
            sweeps = {}
            for line in result.result():
                sweep, count, instructions = line.split(",")
                sweeps.setdefault(sweep, []).append((int(count), int(instructions)))
            for sweep, points in sweeps.items():
                start, slope = fit(points)
                for count, instructions in points:
                    off = instructions / (start + slope * count) - 1
                    table.writerow((cpu, sweep, count, instructions, round(start), "%.1f" % slope, "%.3f" % off))
    return 0


if __name__ == "__main__":
    sys.exit(main())
