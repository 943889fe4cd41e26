#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs firmware on an emulated board, and writes what its panel shows: for `make run`, with nothing to compare it with.

run.py --stream PANEL_STREAM --output DIRECTORY [--frames N] BOARD FIRMWARE...

FIRMWARE: an ELF file, and what programmers take. A picture is written at each checkpoint, at most N, and of what stands on
the panel when the program ends, or has said nothing for a while.
"""
import argparse
import os
import shutil
import subprocess
import sys

import show
from qemu import Died
from picture import read_netpbm, write_png

# Seconds without a checkpoint.
PATIENCE = 30


def capture(board, firmware, arguments):
    """@return what the firmware wrote. Pictures lie in arguments.output as PPM, by the names of their checkpoints."""
    board.frames, board.patience = arguments.frames, PATIENCE
    if not board.module:
        return board.capture(firmware, arguments.output)
    stream = os.path.join(arguments.output, "stream")
    try:
        return board.capture(firmware, stream)
    finally:
        with open(stream) as file:
            model = subprocess.run([os.path.abspath(arguments.stream), "-r", str(board.rotation), board.module, "end.ppm"], stdin=file,
                                   stdout=subprocess.PIPE, text=True, cwd=arguments.output)
        if model.returncode:
            print("the panel's model complains:\n" + model.stdout)


def write_pictures(directory):
    """As PNG; a last one that is as the one before it goes. @return their names"""
    found = sorted((path for path in os.scandir(directory) if path.name.endswith(".ppm")), key=lambda path: path.stat().st_mtime_ns)
    names, before = [], None
    for path in found:
        shown = read_netpbm(path.path)
        if path.name not in ("last-0.ppm", "end.ppm") or shown != before:
            names.append(os.path.splitext(path.path)[0] + ".png")
            write_png(path.path, names[-1])
        os.remove(path.path)
        before = shown
    return names


def main():
    parser = argparse.ArgumentParser()
    for name in ("--stream", "--output", "board"):
        parser.add_argument(name)
    parser.add_argument("--frames", type=int)
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    shutil.rmtree(arguments.output, ignore_errors=True)
    os.makedirs(arguments.output)
    print("built: " + " ".join(arguments.firmware))
    if arguments.board not in show.BOARDS:
        print("%s has no emulated panel: what its glass shows is seen on the board alone" % arguments.board)
        return 0
    board = show.BOARDS[arguments.board]
    problem = None
    try:
        lines = capture(board, next(path for path in arguments.firmware if path.endswith(board.takes)), arguments)
        print("".join("  %s\n" % line for line in lines), end="")
    except FileNotFoundError as missing:
        problem = "%s is missing: tools/setup.sh installs it" % missing.filename
    except Died as died:
        problem = "%s did not run to its end: %s" % (arguments.firmware[0], died)
    print("".join("%s\n" % name for name in write_pictures(arguments.output)), end="")
    if problem:
        print(problem, file=sys.stderr)
    return 1 if problem else 0


if __name__ == "__main__":
    sys.exit(main())
