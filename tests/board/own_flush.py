#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the README's program, whose flush is its own, on a board of 320x240: its panel shows what `glint render` draws.

own_flush.py --host GLINT --stream PANEL_STREAM --output DIRECTORY BOARD=FIRMWARE
"""
import importlib.util
import os
import subprocess
import sys

import show
from qemu import Died, Tally, read_netpbm

# By its path: another module here has its name.
SPEC = importlib.util.spec_from_file_location("png", os.path.join(os.path.dirname(__file__), "..", "..", "tools", "png.py"))
png = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(png)

WIDTH, HEIGHT, FRAMES, STEP = 320, 240, 4, 5
BYTES = 2 * WIDTH * HEIGHT
SCENE = ["torus:24x12", "--no-clusters", "--eye", "0,0,4", "--fov", "45", "--near", "0.1", "--size", "%dx%d" % (WIDTH, HEIGHT),
         "--format", "rgb565", "--light", "dir:-1,1,1", "--ambient", "0.1,0.05,0", "--diffuse", "1,0.5,0", "--specular", "1"]


def wanted(program, turn, path):
    """Rows of pixels of a frame, by the host program."""
    subprocess.run([program, "render", *SCENE, "--rotate-x", str(turn), "-o", path], check=True)
    with open(path, "rb") as file:
        return png.decode(file.read()).rows


def shown(path):
    """Rows of pixels of the panel."""
    width, _, _, data = read_netpbm(path)
    pixels = [tuple(data[at:at + 3]) for at in range(0, len(data), 3)]
    return [pixels[at:at + width] for at in range(0, len(pixels), width)]


def main():
    arguments = show.read_arguments()
    tally = Tally()
    name, firmware = arguments.firmware[0].split("=", 1)
    board = show.BOARDS[name]
    os.makedirs(arguments.output)
    stream = os.path.abspath(os.path.join(arguments.output, "stream"))
    try:
        lines = board.capture(firmware, stream)
    except Died as problem:
        tally.check(False, "%s: %s" % (name, problem))
        return tally.close()
    tally.check(lines == ["own %d done" % frame for frame in range(FRAMES)], "%s: %s" % (name, lines))
    tally.check(board.sent == [BYTES] * FRAMES, "%s: %s bytes of pixels are sent" % (name, board.sent))
    show.show_stream(arguments, tally, name, board, firmware, arguments.output, stream, True)
    for frame in range(FRAMES):
        rows = shown(os.path.join(arguments.output, "own-%d.ppm" % frame))
        drawn = wanted(arguments.host, frame * STEP, os.path.join(arguments.output, "host-%d.png" % frame))
        tally.check((len(rows), len(rows[0])) == (HEIGHT, WIDTH), "frame %d: %d rows of %d" % (frame, len(rows), len(rows[0])))
        different = [(x, y) for y in range(HEIGHT) for x in range(WIDTH) if rows[y][x] != drawn[y][x]]
        tally.check(not different, "frame %d: %d pixels differ, the first at %s" % (frame, len(different), different[:1]))
        lit = sum(pixel != (0, 0, 0) for row in drawn for pixel in row)
        tally.check(lit > WIDTH * HEIGHT / 8, "frame %d: next to nothing is lit" % frame)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
