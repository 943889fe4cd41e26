#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts instructions of whole frames: bench.py --qemu QEMU --output DIRECTORY CPU=ELF...

Writes DIRECTORY/bench.csv, with instructions a frame and the bytes of the library's tables, and
DIRECTORY/bench-arena.csv, with the arena that the frames need.
"""
import argparse
import concurrent.futures
import csv
import os
import sys

from emulate import Died, library_bytes, lines_of

COLUMNS = ("kind", "name", "variant", "cpu", "instructions", "unit", "table_bytes")


def write(path, columns, rows):
    with open(path, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(columns)
        table.writerows(rows)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    firmware = [pair.split("=", 1) for pair in arguments.firmware]
    workers = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    running = [workers.submit(lines_of, arguments.qemu, "mps2-an385", elf) for _, elf in firmware]
    frames, arenas = [], {}
    for (cpu, elf), result in zip(firmware, running):
        tables = library_bytes(elf[:-len(".elf")] + ".map", "tables.o")
        for line in result.result():
            name, variant, instructions, smallest, best = line.split(",")
            frames.append(("frame", name, variant, cpu, int(instructions), "frame", tables))
            if arenas.setdefault((name, variant), (smallest, best)) != (smallest, best):
                raise Died("%s needs another arena: %s" % (elf, line))
    write(os.path.join(arguments.output, "bench-arena.csv"), ("name", "variant", "smallest", "best"),
          [key + value for key, value in arenas.items()])
    write(os.path.join(arguments.output, "bench.csv"), COLUMNS, frames)


if __name__ == "__main__":
    sys.exit(main())
