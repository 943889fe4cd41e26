#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tile sizes and shares of an arena in figures: tiles.py BENCH.csv ARENA.csv prints both tables; with --page PAGE, 1 when
the page has others; with --write too, puts them into the page, between its markers."""
import argparse
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from markdown import fill, table  # noqa: E402

SIZES = ("16x16", "32x16", "32x32", "64x32", "64x64")
SCENE, VARIANT = "torus2304", "320x240 local "


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def sizes(frames, arenas):
    rows = []
    for cpu, title in (("m3", "Cortex-M3"), ("m0", "ARMv6-M")):
        counts = {row["variant"]: int(row["instructions"]) for row in frames
                  if row["name"] == SCENE and row["cpu"] == cpu}
        rows.append(["million instructions, %s" % title] + ["%.2f" % (counts[VARIANT + size] / 1e6) for size in SIZES])
    smallest = {row["variant"]: int(row["least"]) for row in arenas if row["name"] == SCENE}
    rows.append(["smallest arena, bytes"] + ["%d" % smallest[VARIANT + size] for size in SIZES])
    return table(["%s at 320x240" % SCENE, *SIZES], rows)


SHARES = ("half", "quarter", "sixteenth")
MESHES = ("torus576", "sphere960", "torus2304", "torus9216")


def shares(frames, arenas):
    """Instructions in a part of the arena, over those where all is drawn in one pass."""
    counts = {(row["name"], row["variant"]): int(row["instructions"]) for row in frames
              if row["name"] in MESHES and row["cpu"] == "m3"}
    best = {row["name"]: int(row["one_pass"]) for row in arenas if row["variant"] == VARIANT + "32x32"}
    rows = []
    for mesh in MESHES:
        whole = counts[mesh, VARIANT + "32x32"]
        rows.append([mesh, "%d" % best[mesh]] +
                    ["%.1f" % (counts[mesh, VARIANT + "32x32 " + share] / whole) for share in SHARES])
    return table(["320x240, Cortex-M3", "one pass, bytes", *SHARES], rows)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--page")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("frames")
    parser.add_argument("arenas")
    arguments = parser.parse_args()
    frames, arenas = read(arguments.frames), read(arguments.arenas)
    texts = {"tile sizes": sizes(frames, arenas), "arena shares": shares(frames, arenas)}
    if not arguments.page:
        sys.stdout.write("\n".join(texts.values()))
        return 0
    with open(arguments.page) as file:
        page = file.read()
    wanted = page
    for name, text in texts.items():
        wanted = fill(wanted, name, text)
    if arguments.write:
        with open(arguments.page, "w") as file:
            file.write(wanted)
    elif wanted != page:
        print("%s has other tables than the benchmark's: make figures" % arguments.page)
    return 0 if arguments.write else wanted != page


if __name__ == "__main__":
    sys.exit(main())
