#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes what frames of examples/firmware/animate_main.c take: times.py --plugin PLUGIN [--part] BOARD=FIRMWARE...

A line for each scene and board: board,scene,passes,frame_ms,bus_ms, the mean of all frames but the scene's first. In QEMU
a plugin counts the instructions of a frame, of firmware that is marked (marked.c), and ../cycles/costs.py weighs them;
what the bus takes follows from its clock and the pixels' bytes; commands, below 1 % of them, are left out. The Pico's
emulator has cycles, DMA and bus itself. With --part it draws the first scenes only, as ../../tests/board/animate.py does.
"""
import argparse
import collections
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path += [os.path.join(HERE, "..", *folders) for folders in (("cycles",), ("stack",), ("..", "tests", "board"))]
import costs  # noqa: E402
from animate import FRAMES, PART, SCENES  # noqa: E402
from qemu import Died, Machine  # noqa: E402
from show import BOARDS, names_of  # noqa: E402

# Core of the model, its clock and the bus's in Hz on the board itself, and whether the core draws while bytes are sent.
Timed = collections.namedtuple("Timed", "core clock bus overlaps")
TIMED = {"mps2-an385": Timed("m3", 25e6, 6.25e6, True),
         "netduinoplus2": Timed("m4", 168e6, 10.5e6, False),
         "pico": Timed(None, 125e6, None, True)}  # told by its emulator


def mean(values):
    """Of all but the first."""
    return sum(values[1:]) / (len(values) - 1)


def passes_of(lines):
    return [int(line.split()[1]) for line in lines if line.startswith("passes ")]


def times_in_qemu(board, firmware, plugin):
    """@return what the firmware wrote, and (milliseconds, of these on the bus) of each frame"""
    timed = TIMED[board]
    with tempfile.NamedTemporaryFile() as counts:
        with Machine("qemu-system-arm", board, firmware,
                     options=("-plugin", "%s,out=%s" % (os.path.abspath(plugin), counts.name))) as machine:
            lines = list(iter(machine.line, None))
            if machine.process.wait(60):
                raise Died("%s: %s" % (board, lines[-5:]))
        core = [1e3 * float(costs.cycles(frame, timed.core)) / timed.clock for frame in costs.read(counts.name)]
    bus = 1e3 * 8 * BOARDS[board].panel.frame_bytes / timed.bus
    return lines, [(max(drawing, bus) if timed.overlaps else drawing + bus, bus) for drawing in core]


def times_on_pico(firmware):
    """The same; its first frame includes the start."""
    with tempfile.NamedTemporaryFile() as stream:
        return BOARDS["pico"].capture(firmware, stream.name), BOARDS["pico"].frame_times(stream.name)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--plugin", required=True)
    parser.add_argument("--part", action="store_true")
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    BOARDS["pico"].frames = PART * FRAMES if arguments.part else None
    print("board,scene,passes,frame_ms,bus_ms")
    for board, firmware in (pair.split("=", 1) for pair in arguments.firmware):
        lines, times = times_on_pico(firmware) if board == "pico" else times_in_qemu(board, firmware, arguments.plugin)
        scenes = list(SCENES)[:len(names_of(lines)) // FRAMES]
        if len(times) != len(scenes) * FRAMES or len(passes_of(lines)) != len(scenes):
            raise Died("%s: %d frames, %d of them measured" % (board, len(names_of(lines)), len(times)))
        for i, (scene, passes) in enumerate(zip(scenes, passes_of(lines))):
            frames = times[i * FRAMES:(i + 1) * FRAMES]
            print("%s,%s,%d,%.2f,%.2f" % (board, scene, passes, *map(mean, zip(*frames))))
    return 0


if __name__ == "__main__":
    sys.exit(main())
