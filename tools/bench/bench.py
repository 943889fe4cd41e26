#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts instructions: bench.py --qemu QEMU --output DIRECTORY --frames CPU=MACHINE=ELF... --float CPU=MACHINE=ELF
--methods CPU=MACHINE=ELF...

Writes DIRECTORY/bench.csv, with instructions a frame and the bytes of the library's tables, those of the float renderer
that it is compared with, which has none, then instructions of each method, or of what a program of that form counts, and the bytes of its own tables; and DIRECTORY/bench-arena.csv, with the arena that the frames need.
"""
import argparse
import concurrent.futures
import csv
import os
import sys

from emulate import library_bytes, lines_of

COLUMNS = ("kind", "name", "variant", "cpu", "instructions", "unit", "table_bytes")


def write(path, columns, rows):
    with open(path, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(columns)
        table.writerows(rows)


def frame_rows(firmware, running, arenas):
    for (cpu, _, elf), result in zip(firmware, running):
        tables = library_bytes(elf[:-len(".elf")] + ".map", "tables.o")
        for line in result.result():
            name, variant, instructions, smallest, best = line.split(",")
            yield "frame", name, variant, cpu, int(instructions), "frame", tables
            # Cores without wide products keep a matrix in two halves: what the one that needs most takes.
            most = arenas.get((name, variant), (0, 0))
            arenas[name, variant] = max(most[0], int(smallest)), max(most[1], int(best))


def float_rows(firmware, running):
    for (cpu, _, _), result in zip(firmware, running):
        for line in result.result():
            name, variant, instructions = line.split(",")
            yield "frame", name, variant, cpu, int(instructions), "frame", 0


def method_rows(firmware, running):
    for (cpu, _, _), result in zip(firmware, running):
        for line in result.result():
            kind, name, variant, hundredths, unit, tables = line.split(",")
            yield kind, name, variant, cpu, "%.2f" % (int(hundredths) / 100), unit, tables


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--frames", nargs="+", required=True)
    parser.add_argument("--float", nargs="+", required=True, dest="floats")
    parser.add_argument("--methods", nargs="+", required=True)
    arguments = parser.parse_args()
    frames = [program.split("=") for program in arguments.frames]
    floats = [program.split("=") for program in arguments.floats]
    methods = [program.split("=") for program in arguments.methods]
    workers = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    running = [workers.submit(lines_of, arguments.qemu, machine, elf) for _, machine, elf in frames + floats + methods]
    arenas = {}
    rows = list(frame_rows(frames, running, arenas))
    rows += float_rows(floats, running[len(frames):])
    rows += method_rows(methods, running[len(frames) + len(floats):])
    write(os.path.join(arguments.output, "bench-arena.csv"), ("name", "variant", "smallest", "best"),
          [key + value for key, value in arenas.items()])
    write(os.path.join(arguments.output, "bench.csv"), COLUMNS, rows)


if __name__ == "__main__":
    sys.exit(main())
