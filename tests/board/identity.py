#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the checksums of tests/board/identity.c across builds: host programs against firmware in QEMU.

One check for each program and line: its checksum equals that of the first program's first line for the same picture,
whatever the tile size and the arena. Firmware of --part may draw fewer pictures, and where its arena does not suffice for
a way to draw one, it says so; but each picture that it names it must draw in some way, and the first program must know it.
"""
import argparse
import concurrent.futures
import os
import subprocess
import sys

from qemu import Died, Machine, Tally

# In place of a checksum, where the arena is too small.
DOES_NOT_FIT = "does not fit"


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


def read(tally, program, lines):
    """@return [(picture, way to draw it, checksum)] of what the program wrote."""
    frames = []
    for line in lines:
        parts = line.split(" | ")
        if tally.check(len(parts) == 3, "%s: %s" % (program, line)):
            frames.append(parts)
    return frames


def judge(tally, program, frames, pictures):
    """Holds checksums against those that pictures have; a picture's first is what is right."""
    for picture, how, checksum in frames:
        first = pictures.setdefault(picture, checksum)
        tally.check(checksum == first and len(checksum) == 8,
                    "%s: %s, %s: %s, elsewhere %s" % (program, picture, how, checksum, first))


def judge_part(tally, program, frames, pictures):
    drawn = [frame for frame in frames if frame[2] != DOES_NOT_FIT]
    known = [frame for frame in drawn if tally.check(frame[0] in pictures, "%s: what is %s?" % (program, frame[0]))]
    judge(tally, program, known, pictures)
    left_out = {frame[0] for frame in frames} - {frame[0] for frame in drawn}
    tally.check(drawn and not left_out, "%s: %d frames, not drawn in any way: %s" % (program, len(drawn), sorted(left_out)))
    print("  %s: %d frames of %d pictures; %d more ways to draw them do not fit" % (
        program, len(drawn), len({frame[0] for frame in drawn}), len(frames) - len(drawn)))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu")
    parser.add_argument("--host", nargs="+", required=True, help="commands; the first sets what is right")
    parser.add_argument("--firmware", nargs="+", default=[], help="MACHINE=ELF")
    parser.add_argument("--part", nargs="+", default=[], help="MACHINE=ELF of boards that draw a part")
    arguments = parser.parse_args()
    tally, pictures, expected = Tally(), {}, 0
    firmware = [pair.split("=", 1) for pair in arguments.firmware + arguments.part]
    parts = {pair.split("=", 1)[1] for pair in arguments.part}
    programs = arguments.host + [elf for _, elf in firmware]
    workers = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    running = [workers.submit(host_lines, program) for program in arguments.host]
    running += [workers.submit(board_lines, arguments.qemu, machine, elf) for machine, elf in firmware]
    for program, result in zip(programs, running):
        try:
            frames = read(tally, program, result.result())
        except (Died, OSError, subprocess.SubprocessError) as problem:
            tally.check(False, "%s: %s" % (program, problem))
            continue
        if program in parts:
            judge_part(tally, program, frames, pictures)
            continue
        judge(tally, program, frames, pictures)
        expected = expected or len(frames)
        tally.check(frames and len(frames) == expected, "%s: %d frames instead of %d" % (program, len(frames), expected))
        print("  %s: %d frames" % (program, len(frames)))
    tally.check(len(set(pictures.values())) == len(pictures), "two different pictures have the same checksum")
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
