#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs tests/endurance on an emulated board: it writes, line by line, what the host does.

endurance.py --qemu QEMU ELF HOST FRAMES
"""
import argparse
import os
import subprocess
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), "..", "board"))
from qemu import Died, Machine, Tally  # noqa: E402


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("elf")
    parser.add_argument("host")
    parser.add_argument("frames")
    arguments = parser.parse_args()
    tally = Tally()
    host = subprocess.run([arguments.host, arguments.frames], stdout=subprocess.PIPE, text=True)
    wanted = host.stdout.splitlines()[:-1]  # the last one counts tests
    tally.check(host.returncode == 0 and len(wanted) > 1, "the host failed")
    try:
        with Machine(arguments.qemu, "mps2-an385", arguments.elf) as machine:
            for number, line in enumerate(wanted):
                shown = machine.line()
                if not tally.check(shown == line, "line %d: %s instead of %s" % (number + 1, shown, line)):
                    break
            tally.check(machine.end() == 0, "the board's exit status")
        print("  mps2-an385: " + wanted[-1])
    except (Died, OSError, subprocess.SubprocessError) as problem:
        tally.check(False, "mps2-an385: %s" % problem)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
