#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a wait state of flash costs, and what functions and tables in RAM gain: hot.py --qemu QEMU --plugin FILE --page PAGE
[--write] PLAIN HOT, folders of the same firmware without and with GLINT_HOT_SECTION.

Writes the table of the page, or holds it against the bytes and against the first row, counted again.
"""
import argparse
import concurrent.futures
import os
import re
import sys

sys.path[:0] = [os.path.join(os.path.dirname(__file__), *folders) for folders in (("..",), ("..", "bench"))]
import markdown
from costs import cycles, waits
from emulate import Tally, counted_lines_of, library_bytes

CORE = "m0+"

# What a row is called, the firmware, and which line of it that is.
ROWS = (("2304 triangles, lit at fragments", "frames", "torus2304,320x240 local 32x32,"),
        ("576, lit at fragments", "frames", "torus576,320x240 local 32x32,"),
        ("576, unlit", "workloads", "torus576,320x240 local 32x32 unlit,"),
        ("576, 8 points", "workloads", "torus576,320x240 local 32x32 8 points,"))
HEAD = ("torus, 320x240", "all in flash", "loops in RAM", "tables too", "all of glint in RAM")

# A percentage of the page may be off by so much, bytes by so much of themselves.
POINTS, SHARE = 1, 0.02


def tables_of(path):
    """Where constants of the library lie, by a linker map: they follow each other."""
    with open(path) as file:
        memory = file.read().split("Linker script and memory map", 1)[1]
    found = [(int(at, 16), int(size, 16)) for at, size in
             re.findall(r"^ \.rodata\S*\s+(0x\w+)\s+(0x\w+)\s+\S*libglint\.a\(", memory, re.MULTILINE)]
    return found[0][0], found[-1][0] + found[-1][1]


def count(arguments, folder, program, rows):
    """What was counted for each of the rows that are this program's, all frames of it."""
    elf = os.path.join(folder, program + ".elf")
    wanted = [start for _, of, start in rows if of == program]
    missing = set(wanted)

    def is_last(line):
        missing.difference_update([start for start in wanted if line.startswith(start)])
        return not missing

    lines, counted = counted_lines_of(arguments.qemu, "mps2-an385", elf, arguments.plugin, tables_of(elf[:-len(".elf")] + ".map"), is_last)
    return {start: frame for start in wanted for line, frame in zip(lines, counted) if line.startswith(start)}


def measured_rows(arguments, rows):
    """The table's lines of these rows."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        runs = [[pool.submit(count, arguments, folder, program, rows) for program in ("frames", "workloads")
                 if any(of == program for _, of, _ in rows)] for folder in (arguments.plain, arguments.hot)]
        plain, hot = ({start: found for run in of for start, found in run.result().items()} for of in runs)
    for what, _, start in rows:
        flash, loops = plain[start], hot[start]
        least = cycles(flash, CORE)
        taken = [least + waits(flash, CORE), cycles(loops, CORE) + waits(loops, CORE),
                 cycles(loops, CORE) + waits(loops, CORE, tables=0), least + waits(flash, CORE, code=0, tables=0)]
        yield [what] + ["%+.1f%%" % (100 * (all_of / least - 1)) for all_of in taken]


def ram_row(arguments):
    """Bytes of RAM more than with code and tables in flash, of firmware with one format and one light."""
    def ram(folder):
        with open(os.path.join(folder, "frames.size")) as file:
            return int(re.search(r"RAM (\d+)", file.read())[1])
    path = os.path.join(arguments.plain, "frames.map")
    loops, (begin, end) = ram(arguments.hot) - ram(arguments.plain), tables_of(path)
    return ["bytes of RAM", "0"] + ["%d" % more for more in (loops, loops + end - begin, library_bytes(path))]


def numbers(line):
    return [float(number) for number in re.findall(r"[+-]?\d+(?:\.\d+)?", line)]


def is_near(says, found):
    """Is a row, or that of bytes, what was found, but for figures that moved a little?"""
    a, b = numbers(says), numbers(found)
    return len(a) == len(b) and all(abs(x - y) <= (POINTS if "%" in found else SHARE * y) for x, y in zip(a, b))


def main():
    parser = argparse.ArgumentParser()
    for option in ("--qemu", "--plugin", "--page"):
        parser.add_argument(option, required=True)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("plain")
    parser.add_argument("hot")
    arguments = parser.parse_args()
    rows = ROWS if arguments.write else ROWS[:1]
    found = list(measured_rows(arguments, rows)) + [ram_row(arguments)]
    with open(arguments.page, encoding="utf-8") as file:
        page = file.read()
    if arguments.write:
        with open(arguments.page, "w", encoding="utf-8") as file:
            file.write(markdown.fill(page, "loops", markdown.table(HEAD, found, right=range(1, len(HEAD)))))
        return 0
    tally = Tally()
    shown = markdown.split(page, "loops")[1].splitlines()
    for says, cells in ((shown[2], found[0]), (shown[-1], found[-1])):
        tally.check(says.startswith("| %s |" % cells[0]) and is_near(says.split("|", 2)[2], "|".join(cells[1:])),
                    "%s: %s, but another is measured: %s" % (arguments.page, says, markdown.row(cells)))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
