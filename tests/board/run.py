#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs firmware on an emulated board, and writes what its panel shows: for `make run`, with nothing to compare it with.

run.py --stream PANEL_STREAM --output DIRECTORY [--frames N] [--patience SECONDS] [--plugin FILE --cpu NAME] BOARD FIRMWARE...

FIRMWARE: an ELF file, and what programmers take. A picture is written at each checkpoint, at most N, and of what stands on
the panel when the program ends, or has said nothing for a while. With the plugin of tools/cycles, the instructions of each
frame of glint_render are counted, and the cycles that a core of that name takes for them.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile

sys.path.append(os.path.join(os.path.dirname(__file__), "..", "..", "tools", "cycles"))
import costs
import show
from qemu import Died
from picture import read_netpbm, write_png

# How tools/cycles/costs.py calls the compiler's cores. Some Cortex-M0 multiply in 1 cycle, as a Cortex-M0+ does, others in 32.
CORES = {"cortex-m0": ("m0+", "m0"), "cortex-m0plus": ("m0+",), "cortex-m3": ("m3",), "cortex-m4": ("m4",)}


def capture(board, firmware, arguments):
    """@return what the firmware wrote. Pictures lie in arguments.output as PPM, by the names of their checkpoints."""
    board.frames, board.patience = arguments.frames, arguments.patience
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


def prices(board, cpu, counts, stream):
    """A line for each frame: what it costs, the sending included. The Pico's first one has the start in it, and none."""
    if board is show.BOARDS["pico"]:
        for number, (all_of, bus) in list(enumerate(board.frame_times(stream)))[1:]:
            yield "  frame %d: %.1f ms, the bus is busy for %.1f ms" % (number, all_of, bus)
    for number, frame in enumerate(costs.read(counts)):
        cycles = " to ".join("%.3f" % (costs.cycles(frame, core) / 1e6) for core in CORES.get(cpu, ()))
        yield "  frame %d: %.3f million instructions" % (number, costs.instructions(frame) / 1e6) + (
            ", by the model %s million cycles of a %s" % (cycles, cpu) if cycles else "")


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
    for name in ("--stream", "--output", "--plugin", "--cpu", "board"):
        parser.add_argument(name)
    parser.add_argument("--frames", type=int)
    parser.add_argument("--patience", type=float, default=30, help="seconds without a checkpoint")
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    shutil.rmtree(arguments.output, ignore_errors=True)
    os.makedirs(arguments.output)
    print("built: " + " ".join(arguments.firmware))
    if arguments.board not in show.BOARDS:
        print("%s has no emulated panel: what its glass shows is seen on the board alone" % arguments.board)
        return 0
    board = show.BOARDS[arguments.board]
    counts = tempfile.NamedTemporaryFile()
    if arguments.plugin:
        board.counting = ("-plugin", "%s,out=%s" % (os.path.abspath(arguments.plugin), counts.name))
    problem = None
    try:
        lines = capture(board, next(path for path in arguments.firmware if path.endswith(board.takes)), arguments)
        print("".join("  %s\n" % line for line in lines), end="")
        print("".join("%s\n" % line for line in prices(board, arguments.cpu, counts.name, os.path.join(arguments.output, "stream"))), end="")
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
