#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs firmware that writes pictures, and keeps what it writes: pictures.py --qemu QEMU --machine MACHINE ELF FILE."""
import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "board"))
from qemu import Died, Machine, SILENCE


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("--machine", required=True)
    parser.add_argument("elf")
    parser.add_argument("file")
    arguments = parser.parse_args()
    with Machine(arguments.qemu, arguments.machine, arguments.elf) as machine, open(arguments.file, "w") as file:
        try:
            for line in iter(machine.line, None):
                file.write(line + "\n")
            status = machine.process.wait(SILENCE)
        except Died as problem:
            print("%s: %s" % (arguments.elf, problem))
            status = 1
    if status:
        print("%s: exit status %d: %s" % (arguments.elf, status, " ".join(machine.errors)))
    return 1 if status else 0


if __name__ == "__main__":
    sys.exit(main())
