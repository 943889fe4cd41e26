#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the README's program, whose flush is its own, on a board of 320x240: its panel shows what `glint render` draws.

own_flush.py --host GLINT --stream PANEL_STREAM --output DIRECTORY BOARD=FIRMWARE
"""
import os
import sys

import show
from picture import write_png
from qemu import Died, Tally, read_netpbm

WIDTH, HEIGHT, FRAMES, STEP = 320, 240, 4, 5
BYTES = 2 * WIDTH * HEIGHT
SCENE = ["torus:24x12", "--no-clusters", "--eye", "0,0,4", "--fov", "45", "--near", "0.1", "--size", "%dx%d" % (WIDTH, HEIGHT),
         "--format", "rgb565", "--light", "dir:-1,1,1", "--ambient", "0.1,0.05,0", "--diffuse", "1,0.5,0", "--specular", "1"]


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
        picture = os.path.join(arguments.output, "own-%d" % frame)
        write_png(picture + ".ppm", picture + ".png")
        show.check_drawn(tally, "frame %d" % frame, arguments.host, [*SCENE, "--rotate-x", str(frame * STEP)], picture + ".png")
        data = read_netpbm(picture + ".ppm")[3]
        lit = sum(any(data[at:at + 3]) for at in range(0, len(data), 3))
        tally.check(lit > WIDTH * HEIGHT / 8, "frame %d: next to nothing is lit" % frame)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
