#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs examples/firmware/moving_main.c on a board: meshes in RAM that change each frame look as on the host.

moving.py --host SHOW_HOST --stream PANEL_STREAM --output DIRECTORY BOARD=FIRMWARE...

As show.py does. Both meshes must move: the wave on the left half of the panel, the arm on the right half.
"""
import os
import sys

import show
from qemu import Tally, read_netpbm

NAMES = ["moving-%d" % frame for frame in range(5)]


def halves(path):
    """The pixels of the left half, and those of the right one."""
    width, height, _, data = read_netpbm(path)
    rows = [data[3 * width * y:3 * width * (y + 1)] for y in range(height)]
    middle = 3 * (width // 2)
    return b"".join(row[:middle] for row in rows), b"".join(row[middle:] for row in rows)


def main():
    arguments = show.read_arguments()
    tally = Tally()
    for pair in arguments.firmware:
        name, firmware = pair.split("=", 1)
        show.run(arguments, tally, name, firmware, shown=list(zip(NAMES, NAMES)), program="moving", frames=NAMES)
        paths = [os.path.join(arguments.output, name, frame + ".ppm") for frame in NAMES]
        if tally.check(all(map(os.path.exists, paths)), "%s: the pictures are not all there" % name):
            for side, pictures in zip(("wave", "arm"), zip(*map(halves, paths))):
                tally.check(len(set(pictures)) == len(NAMES), "%s: the %s stands still" % (name, side))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
