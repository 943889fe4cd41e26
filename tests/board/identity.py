#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the checksums of tests/board/identity.c across builds: host programs against firmware in QEMU.

One check for each program and line: its checksum equals that of the first program's first line for the same picture,
whatever the tile size and the arena.
"""
import argparse
import concurrent.futures
import os
import subprocess
import sys

from qemu import Died, Machine, Tally


def host_lines(program):
    return subprocess.run(program.split(), capture_output=True, text=True, timeout=600).stdout.splitlines()


def board_lines(qemu, machine_name, elf):
    lines = []
    with Machine(qemu, machine_name, elf) as machine:
        while True:
            line = machine.line()
            if line is None:
                break
            lines.append(line)
        status = machine.process.wait(60)
    if status:
        lines.append("exit status %d" % status)
    return lines


def judge(tally, program, lines, pictures, expected):
    """@return the number of frames; pictures maps each picture to the checksum that was first seen for it."""
    frames = 0
    for line in lines:
        parts = line.split(" | ")
        if len(parts) != 3:
            tally.check(False, "%s: %s" % (program, line))
            continue
        picture, how, checksum = parts
        frames += 1
        first = pictures.setdefault(picture, checksum)
        tally.check(checksum == first and len(checksum) == 8,
                    "%s: %s, %s: %s, elsewhere %s" % (program, picture, how, checksum, first))
    tally.check(frames > 0 and expected in (0, frames), "%s: %d frames instead of %d" % (program, frames, expected))
    return frames


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu")
    parser.add_argument("--host", nargs="+", required=True, help="commands; the first sets what is right")
    parser.add_argument("--firmware", nargs="+", default=[], help="MACHINE=ELF")
    arguments = parser.parse_args()
    tally, pictures, expected = Tally(), {}, 0
    firmware = [pair.split("=", 1) for pair in arguments.firmware]
    programs = arguments.host + [elf for _, elf in firmware]
    workers = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    running = [workers.submit(host_lines, program) for program in arguments.host]
    running += [workers.submit(board_lines, arguments.qemu, machine, elf) for machine, elf in firmware]
    for program, result in zip(programs, running):
        try:
            lines = result.result()
        except (Died, OSError, subprocess.SubprocessError) as problem:
            tally.check(False, "%s: %s" % (program, problem))
            continue
        frames = judge(tally, program, lines, pictures, expected)
        expected = expected or frames
        print("  %s: %d frames" % (program, frames))
    tally.check(len(set(pictures.values())) == len(pictures), "two different pictures have the same checksum")
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
