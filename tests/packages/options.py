#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Options of the library: options.py --build FOLDER [--seed N | --write] [VARIANT=FLAGS...].

Checks that a variant's flags set what its name says, and holds the table of docs/packages.md against
examples/firmware/minimal.c with each value of the one option that a user sets: a row that the seed picks, without one
all. --write writes that table instead.
"""
import argparse
import concurrent.futures
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools"))
import markdown  # noqa: E402
from tree import DRIVERS, FIRMWARE, LINK, path, paths, read, run
from qemu import Tally

CORES = {"Cortex-M3": ["-mcpu=cortex-m3", "-mthumb", "-ffreestanding"],
         "Cortex-M0": ["-mcpu=cortex-m0", "-mthumb", "-ffreestanding"]}
ROWS = [(core, level) for core in CORES for level in ("Os", "O2")]
HEAD = ["minimal.c, two files", "flash with 0", "flash with 1", "RAM with 0", "RAM with 1"]

# A figure of the page may be off by so much of itself.
MOST = 0.02

# What each part of a variant's name sets.
SETS = {"small": ("GLINT_SMALL", "1"), "split": ("GLINT_SPLIT_PRODUCTS", "1"), "divide": ("GLINT_DIVIDES", "0"),
        "zeros": ("GLINT_COUNTS_ZEROS", "0")}


def macros(flags):
    text = run("gcc", "-O1", *flags.split(), "-dM", "-E", "-include", path("src/math/product.h"), "-include",
               path("src/math/division.h"), "-x", "c", "/dev/null")
    return dict(re.findall(r"^#define (GLINT_\w+) (\w+)$", text, re.MULTILINE))


def measure(b, core, level, split):
    """Flash and RAM of minimal.c."""
    elf = os.path.join(b, "packages", "option-%s-%s-%d.elf" % (core, level, split))
    os.makedirs(os.path.dirname(elf), exist_ok=True)
    run("arm-none-eabi-gcc", "-" + level, *CORES[core], "-DGLINT_SPLIT_PRODUCTS=%d" % split, "-ffunction-sections",
        "-fdata-sections", "-fno-tree-loop-distribute-patterns", "-I" + os.path.join(b, "single"), "-I" + path("port"),
        "-I" + path("port/libc"), *paths(FIRMWARE + DRIVERS), os.path.join(b, "single", "glint.c"), *LINK, "-o", elf)
    text, data, bss = run("arm-none-eabi-size", elf).splitlines()[1].split()[:3]
    return int(text) + int(data), int(data) + int(bss)


def measured_rows(b, rows):
    """{row: its line in the table}"""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = {key: [pool.submit(measure, b, *key, split) for split in (0, 1)] for key in rows}
    lines = {}
    for (core, level), (whole, split) in found.items():
        (flash0, ram0), (flash1, ram1) = whole.result(), split.result()
        lines[core, level] = ["%s, `-%s`" % (core, level)] + list(map(str, (flash0, flash1, ram0, ram1)))
    return lines


def page_table(rows):
    return markdown.table(HEAD, rows, right=range(1, 5))


def is_near(says, built):
    """Are two rows the same but for figures that moved a little?"""
    a, b = (list(map(int, re.findall(r"\b\d{3,}\b", row))) for row in (says, built))
    return len(a) == len(b) and all(abs(x - y) <= MOST * y for x, y in zip(a, b))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", required=True)
    parser.add_argument("--seed", type=int)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("variants", nargs="*")
    arguments = parser.parse_args()
    page = read("docs/packages.md")
    old = markdown.split(page, "options")[1].splitlines(keepends=True)
    picked = ROWS if arguments.seed is None else [ROWS[arguments.seed % len(ROWS)]]
    measured = measured_rows(arguments.build, picked)
    if arguments.write:
        with open(path("docs/packages.md"), "w", encoding="utf-8") as file:
            file.write(markdown.fill(page, "options", page_table(measured.values())))
        return 0
    tally = Tally()
    default = macros("")
    for variant, flags in (text.split("=", 1) for text in arguments.variants):
        wanted = dict(default, **dict(SETS[part] for part in variant.split("-")))
        got = macros(flags)
        tally.check(all(got[name] == wanted[name] for name, _ in SETS.values()), "%s: sets %s" % (variant, got))
    head, shown = page_table([]), dict(zip(ROWS, old[2:]))
    tally.check(old == head.splitlines(keepends=True) + list(shown.values()) and
                all(is_near(shown[row], markdown.row(cells)) for row, cells in measured.items()),
                "docs/packages.md: another table than `make figures` writes:\n" + page_table(measured.values()))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
