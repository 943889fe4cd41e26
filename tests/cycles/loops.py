#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Loops whose cycles are counted by hand, against the model: loops.py --qemu QEMU --plugin FILE CORE=MACHINE=ELF..."""
import argparse
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "tools", "bench"))
from emulate import Died, Tally, counted_lines_of  # noqa: E402
from costs import cycles, waits  # noqa: E402

# Cycles of a round, the last two those of a subtraction and of a branch back that is taken.
ROUNDS = {
    "m0": {
        "several": (3, 3, 1, 3),
        "product": (2, 2, 32, 1, 1, 3),
        "chase": (2, 2, 2, 1, 2, 1, 3),
        "call": (4, 3, 4 + 2, 1, 3),
        "skip": (3, 1, 1, 1, 3),
        "table": (2, 3, 1, 3),
    },
    "m0+": {
        "several": (3, 3, 1, 2),
        "product": (2, 2, 1, 1, 1, 2),
        "chase": (2, 2, 2, 1, 2, 1, 2),
        "call": (3, 3, 3 + 2, 1, 2),
        "skip": (2, 1, 1, 1, 2),
        "table": (2, 3, 1, 2),
    },
    # A refill of 2; the second load does not wait for its address, in "chase" it does.
    "m3": {
        "several": (3, 3, 1, 3),
        "product": (2, 1, 1, 1, 1, 3),
        "chase": (2, 2, 1, 1, 2, 1, 3),
        "call": (3, 3, 1 + 2 + 2, 1, 3),
        "skip": (3, 1, 1, 1, 3),
        "table": (2, 3, 1, 3),
        "long": (4, 5.5, 2, 7, 1, 3),
        "wide": (1, 2, 1, 3, 1, 1, 6, 1, 3),
    },
}
ROUNDS["m4"] = dict(ROUNDS["m3"], long=(1, 1, 1, 7, 1, 3))
ROUNDS["m4f"] = dict(ROUNDS["m4"], float=(2, 1, 2, 1, 3, 14, 14, 3, 1, 3))

# Words of a round that a core reads in one wait state: those that instructions lie in, the first one at the end of a word,
# what is fetched behind each branch that is taken, the last of which is the loop's own, and data.
WAITS = {
    "m0": {"several": (3, 1), "product": (4, 1), "chase": (4, 1), "call": (2, 1, 1, 1, 2, 1), "skip": (1, 1, 3, 1), "table": (1, 2, 3, 1)},
    "m0+": {"several": (3, 0), "product": (4, 0), "chase": (4, 1), "call": (2, 0, 1, 1, 2, 0), "skip": (1, 1, 3, 0), "table": (1, 2, 3, 0)},
}

# What runs on a core's firmware is weighed for each of these.
WEIGHED = {"m0": ("m0", "m0+"), "m3": ("m3",), "m4": ("m4",), "m4f": ("m4f",)}
COUNT = 100


def expected(core, name):
    """The branch back is not taken in the last round."""
    loop = ROUNDS[core][name]
    return COUNT * sum(loop) - (loop[-1] - 1)


def table_of(elf):
    """Where the firmware's table lies."""
    symbols = subprocess.run(["arm-none-eabi-nm", elf], capture_output=True, text=True, check=True).stdout
    return tuple(int(re.search(r"^(\w+) . %s$" % name, symbols, re.M)[1], 16) for name in ("cycles_table", "cycles_table_end"))


def judge(tally, core, name, counts):
    for weighed in WEIGHED[core]:
        found = float(cycles(counts, weighed.rstrip("f")))
        tally.check(found == expected(weighed, name),
                    "%s: %s: %g cycles, %g by hand" % (weighed, name, found, expected(weighed, name)))
        if weighed in WAITS:
            loop = WAITS[weighed][name]
            words = COUNT * sum(loop) - loop[-1]
            tally.check(waits(counts, weighed) == words, "%s: %s: waits for %d words, %d by hand" % (weighed, name, waits(counts, weighed), words))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("--plugin", required=True)
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    tally = Tally()
    for core, machine, elf in (program.split("=") for program in arguments.firmware):
        try:
            names, counted = counted_lines_of(arguments.qemu, machine, elf, arguments.plugin, table_of(elf))
        except Died as problem:
            tally.check(False, "%s: %s" % (core, problem))
            continue
        tally.check(sorted(names) == sorted(ROUNDS[core]), "%s: loops %s" % (core, " ".join(names)))
        for name, counts in zip(names, counted):
            judge(tally, core, name, counts)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
