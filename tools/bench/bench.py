#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts instructions and models cycles: bench.py --qemu QEMU --output DIRECTORY --plugin FILE --frames CPU=MACHINE=ELF...
--float CPU=MACHINE=ELF... --methods CPU=MACHINE=ELF...

Writes DIRECTORY/bench.csv: of frames, instructions, the bytes of the library's tables, and cycles as ../cycles/costs.py
models them, for ARMv6-M those of a Cortex-M0+ and those of a Cortex-M0 that multiplies in 32; the same of the float
renderer that they are compared with, which has no tables; then instructions of each method, or of what a program of
that form counts, and the bytes of its own tables. And DIRECTORY/bench-arena.csv, with the arena that the frames need.
"""
import argparse
import concurrent.futures
import csv
import os
import sys

from emulate import Died, counted_lines_of, library_bytes, lines_of
from costs import cycles, instructions

COLUMNS = ("kind", "name", "variant", "cpu", "instructions", "unit", "table_bytes", "cycles", "cycles_slow_multiply")

# What the cycles of a core are modelled as.
MODELLED = {"m3": "m3", "m4": "m4", "m4f": "m4", "m0": "m0+"}
SLOW_MULTIPLY = {"m0": "m0"}

# Most instructions of a frame that the marks enclose and the counter does not: two readings of it, and its unit of 40.
MARKED = 100


def write(path, columns, rows):
    with open(path, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(columns)
        table.writerows(rows)


def modelled(cpu, count, counted):
    """The two columns of cycles of a frame of `count` instructions, from what was counted of some such frames."""
    if counted is None:
        return "", ""
    frames = round(instructions(counted) / count)
    if abs(instructions(counted) - frames * count) > frames * MARKED:
        raise Died("%d instructions a frame, but %d in %d of them" % (count, instructions(counted), frames))
    return tuple(round(cycles(counted, of[cpu]) / frames) if cpu in of else "" for of in (MODELLED, SLOW_MULTIPLY))


def frame_rows(firmware, running, arenas):
    for (cpu, _, elf), result in zip(firmware, running):
        tables = library_bytes(elf[:-len(".elf")] + ".map", "tables.o")
        for line, counted in zip(*result.result()):
            name, variant, count, least, one_pass = line.split(",")
            yield ("frame", name, variant, cpu, int(count), "frame", tables) + modelled(cpu, int(count), counted)
            # Cores without wide products keep a matrix in two halves: what the one that needs most takes.
            most = arenas.get((name, variant), (0, 0))
            arenas[name, variant] = max(most[0], int(least)), max(most[1], int(one_pass))


def float_rows(firmware, running):
    for (cpu, _, _), result in zip(firmware, running):
        for line, counted in zip(*result.result()):
            name, variant, count = line.split(",")
            yield ("frame", name, variant, cpu, int(count), "frame", 0) + modelled(cpu, int(count), counted)


def method_rows(firmware, running):
    for (cpu, _, _), result in zip(firmware, running):
        for line in result.result():
            kind, name, variant, hundredths, unit, tables = line.split(",")
            yield kind, name, variant, cpu, "%.2f" % (int(hundredths) / 100), unit, tables, "", ""


def count_frames(arguments, cpu, machine, elf):
    """Lines, and what was counted for each: nothing on cores that no cycles are modelled of."""
    if cpu in MODELLED:
        return counted_lines_of(arguments.qemu, machine, elf, arguments.plugin)
    lines = lines_of(arguments.qemu, machine, elf)
    return lines, [None] * len(lines)


def main():
    parser = argparse.ArgumentParser()
    for option in ("--qemu", "--output", "--plugin"):
        parser.add_argument(option, required=True)
    for option in ("--frames", "--float", "--methods"):
        parser.add_argument(option, nargs="+", required=True)
    arguments = parser.parse_args()
    frames, floats, methods = ([program.split("=") for program in programs]
                               for programs in (arguments.frames, arguments.float, arguments.methods))
    workers = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    running = [workers.submit(count_frames, arguments, *program) for program in frames + floats]
    running += [workers.submit(lines_of, arguments.qemu, machine, elf) for _, machine, elf in methods]
    arenas = {}
    rows = list(frame_rows(frames, running, arenas))
    rows += float_rows(floats, running[len(frames):])
    rows += method_rows(methods, running[len(frames) + len(floats):])
    write(os.path.join(arguments.output, "bench-arena.csv"), ("name", "variant", "least", "one_pass"),
          [key + value for key, value in arenas.items()])
    write(os.path.join(arguments.output, "bench.csv"), COLUMNS, rows)


if __name__ == "__main__":
    sys.exit(main())
