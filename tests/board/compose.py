#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs examples/firmware/compose_main.c on a board: painters, a label, a picked triangle and regions as on the host.

compose.py --host SHOW_HOST --stream PANEL_STREAM --output DIRECTORY BOARD=FIRMWARE

As show.py does. Behind the first frame only the model's view and the clock's region go over the bus.
"""
import os
import sys

import show
from qemu import Tally, read_netpbm

NAMES = ["compose-%d" % frame for frame in range(3)]
WHOLE, PARTS = 2 * 320 * 240, 2 * (224 * 240 + 96 * 96)


def main():
    arguments = show.read_arguments()
    tally = Tally()
    for pair in arguments.firmware:
        name, firmware = pair.split("=", 1)
        show.run(arguments, tally, name, firmware, shown=list(zip(NAMES, NAMES)), program="compose", frames=NAMES,
                 sent=[WHOLE, PARTS, PARTS])
        paths = [os.path.join(arguments.output, name, frame + ".ppm") for frame in NAMES]
        tally.check(all(map(os.path.exists, paths)) and len({read_netpbm(path)[3] for path in paths}) == len(paths),
                    "%s: the pictures are not all there, or the same" % name)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
