#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs firmware that writes a line of CSV for each count of instructions: count.py --qemu QEMU --head COLUMNS
CPU=MACHINE=ELF... The lines come out with the core before the count, in the order of the programs.
"""
import argparse
import concurrent.futures
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "bench"))
from emulate import lines_of


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("--head", required=True)
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    firmware = [program.split("=", 2) for program in arguments.firmware]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        running = [workers.submit(lines_of, arguments.qemu, machine, elf) for _, machine, elf in firmware]
        print(arguments.head)
        for (cpu, _, _), result in zip(firmware, running):
            for line in result.result():
                rest, count = line.rsplit(",", 1)
                print("%s,%s,%d" % (rest, cpu, int(count)))


if __name__ == "__main__":
    sys.exit(main())
