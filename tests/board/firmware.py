#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks what firmware takes, that every program was linked, and that the shortest examples are short and C++20 too."""
import argparse
import os
import subprocess
import sys

from qemu import Tally


def check_example(tally, example):
    """At most 31 lines below that of the licence; and -Wextra asks for every field, which C++20's designated initialisers
    need not name."""
    with open(example) as file:
        lines = len(file.readlines()) - 1
    tally.check(lines <= 31, "%s has %d lines, more than 31" % (example, lines))
    compiled = subprocess.run(["clang++", "-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
                               "-Wno-missing-field-initializers", "-Isrc", "-Iport", "-Iexamples", "-fsyntax-only", "-x", "c++",
                               example], capture_output=True, text=True)
    tally.check(compiled.returncode == 0, "%s as C++20: %s" % (example, compiled.stderr))


def main():
    parser = argparse.ArgumentParser()
    for limit in ("flash", "ram", "library"):
        parser.add_argument("--" + limit, required=True)
    parser.add_argument("--examples", nargs="+", required=True)
    parser.add_argument("--programs", nargs="+", required=True)
    parser.add_argument("map")
    arguments = parser.parse_args()
    tally = Tally()
    for limit in ("flash", "ram", "library"):
        size = subprocess.run([sys.executable, "tools/size.py", arguments.map,
                               "--" + limit, getattr(arguments, limit)], capture_output=True, text=True)
        tally.check(size.returncode == 0, size.stdout + size.stderr)
    for program in arguments.programs:
        tally.check(os.path.getsize(program) > 0, program)
        with open(program[:-len(".elf")] + ".size") as file:
            print("  " + file.read().strip())
    for example in arguments.examples:
        check_example(tally, example)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
