#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the unit tests' firmware: unit.py --qemu QEMU MACHINE=ELF...; closes with the sum of what they report."""
import argparse
import re
import sys

from qemu import Died, Machine, Tally, check_stack


def run(qemu, name, elf, tally):
    closing = None
    try:
        with Machine(qemu, name, elf) as machine:
            while True:
                line = machine.line()
                if line is None:
                    break
                check_stack(tally, elf, line)
                match = re.match(r"^(\d+) passed, (\d+) failed$", line)
                if match:
                    closing = int(match[1]), int(match[2])
                print("  %s: %s" % (name, line.replace(" passed, ", " good, ") if match else line))
            status = machine.process.wait(60)
    except (Died, OSError) as problem:
        tally.check(False, "%s: %s" % (name, problem))
        return
    if not closing or closing[0] + closing[1] == 0:
        tally.check(False, "%s: no test ran; exit status %d" % (name, status))
        return
    tally.passed += closing[0]
    tally.failed += closing[1]
    tally.check(status == (1 if closing[1] else 0), "%s: exit status %d" % (name, status))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    tally = Tally()
    for firmware in arguments.firmware:
        name, elf = firmware.split("=", 1)
        run(arguments.qemu, name, elf, tally)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
