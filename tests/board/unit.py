#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the unit tests' firmware and closes with the sum of what it reports.

unit.py --qemu QEMU --cases tests/unit/unit.h --part BOARD=FIRMWARE... --whole BOARD=FIRMWARE...

Firmware of --part may leave cases out, and says which: "not run here: NAME".
"""
import argparse
import os
import re
import sys

from qemu import Died, Machine, Tally, check_stack
from show import Pico

LEFT_OUT = "not run here: "


def lines_in_qemu(qemu, name, elf):
    """@return what the firmware wrote, and its exit status."""
    with Machine(qemu, name, elf) as machine:
        return list(iter(machine.line, None)), machine.process.wait(60)


def lines_of(qemu, name, firmware):
    if name == "pico":
        return Pico.run(firmware, os.devnull)
    return lines_in_qemu(qemu, name, firmware)


def closing(tally, name, lines):
    """@return how many cases ran, and how many of them failed."""
    for line in lines:
        match = re.match(r"^(\d+) passed, (\d+) failed$", line)
        if match:
            tally.passed += int(match[1])
            tally.failed += int(match[2])
            print("  %s: %s good, %s bad" % (name, match[1], match[2]))
            return int(match[1]) + int(match[2]), int(match[2])
        print("  %s: %s" % (name, line))
    return 0, 0


def run(qemu, name, firmware, tally, cases, is_part):
    try:
        lines, status = lines_of(qemu, name, firmware)
    except (Died, OSError) as problem:
        tally.check(False, "%s: %s" % (name, problem))
        return
    count, failed = closing(tally, name, lines)
    left_out = {line[len(LEFT_OUT):] for line in lines if line.startswith(LEFT_OUT)}
    tally.check(count > 0, "%s: no test ran" % name)
    tally.check(left_out <= cases and bool(left_out) == is_part and count + len(left_out) >= len(cases),
                "%s: %d ran of %d, left out: %s" % (name, count, len(cases), sorted(left_out)))
    tally.check(status == (1 if failed else 0), "%s: exit status %d" % (name, status))
    for line in lines:
        check_stack(tally, os.path.splitext(firmware)[0] + ".elf", line)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("--cases", required=True)
    parser.add_argument("--part", nargs="+", default=[])
    parser.add_argument("--whole", nargs="+", default=[])
    arguments = parser.parse_args()
    with open(arguments.cases) as file:
        cases = set(re.findall(r"^    CASE\((\w+)\)", file.read(), re.M))
    tally = Tally()
    tally.check(len(cases) > 20, "%s: %d cases" % (arguments.cases, len(cases)))
    for firmware in arguments.part + arguments.whole:
        name, path = firmware.split("=", 1)
        run(arguments.qemu, name, path, tally, cases, firmware in arguments.part)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
