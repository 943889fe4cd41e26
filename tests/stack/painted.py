#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Stack of public functions, painted: painted.py --qemu QEMU --csv FILE NAME=ELF...

Runs firmware of tests/stack/painted.c, writes a row for each function and a column for each NAME, and fails where a function
uses more than its bar: tasks have that much, and a user who gives one as much must not lose memory beside it.
"""
import argparse
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "board"))
from qemu import Died, Machine, Tally  # noqa: E402

# Bytes. Large textured triangles in layers take most of a frame; glint_check draws one below what it keeps itself.
BAR = 2048
BARS = {"glint_check": 2560}
# Beside frames, the program draws hundreds of scenes before it writes a line.
SECONDS = 1800


def read(qemu, elf):
    """{function: bytes}"""
    with Machine(qemu, "mps2-an385", elf) as machine:
        lines = list(iter(lambda: machine.line(SECONDS), None))
        status = machine.process.wait(60)
    if status:
        raise Died("%s: exit status %d: %s" % (elf, status, " ".join(lines[-1:] + machine.errors)))
    return {function: int(count) for function, count in map(str.split, lines)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("--csv", required=True)
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    names, elfs = zip(*(firmware.split("=", 1) for firmware in arguments.firmware))
    tally = Tally()
    try:
        found = [read(arguments.qemu, elf) for elf in elfs]
    except Died as problem:
        tally.check(False, str(problem))
        return tally.close()
    with open(arguments.csv, "w", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(("function",) + names)
        for function in found[0]:
            counts = [of[function] for of in found]
            rows.writerow([function] + counts)
            bar = BARS.get(function, BAR)
            tally.check(max(counts) <= bar, "%s uses %s bytes of stack, more than %d" % (function, counts, bar))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
