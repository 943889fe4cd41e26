#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tile sizes in figures: tiles.py BENCH.csv ARENA.csv prints the table; with --page PAGE, 1 when the page has another."""
import argparse
import csv
import sys

SIZES = ("16x16", "32x16", "32x32", "64x32", "64x64")
SCENE, VARIANT = "torus2304", "320x240 local "


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def table(frames, arenas):
    lines = ["| %s at 320x240 | " % SCENE + " | ".join(SIZES) + " |", "| --- |" + " --- |" * len(SIZES)]
    for cpu, title in (("m3", "Cortex-M3"), ("m0", "ARMv6-M")):
        counts = {row["variant"]: int(row["instructions"]) for row in frames
                  if row["name"] == SCENE and row["cpu"] == cpu}
        lines.append("| million instructions, %s | " % title +
                     " | ".join("%.2f" % (counts[VARIANT + size] / 1e6) for size in SIZES) + " |")
    smallest = {row["variant"]: int(row["smallest"]) for row in arenas if row["name"] == SCENE}
    lines.append("| smallest arena, bytes | " + " | ".join("%d" % smallest[VARIANT + size] for size in SIZES) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--page")
    parser.add_argument("frames")
    parser.add_argument("arenas")
    arguments = parser.parse_args()
    text = table(read(arguments.frames), read(arguments.arenas))
    if not arguments.page:
        sys.stdout.write(text)
        return 0
    with open(arguments.page) as file:
        if text in file.read():
            return 0
    print("%s does not have this table:\n%s" % (arguments.page, text))
    return 1


if __name__ == "__main__":
    sys.exit(main())
