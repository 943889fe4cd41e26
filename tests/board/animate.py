#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs examples/firmware/animate_main.c on boards with panels in colour: each picture must equal the host's.

animate.py --host SHOW_HOST --stream PANEL_STREAM --output DIRECTORY [--part] BOARD=FIRMWARE...

As show.py does; and each scene must be framed for its display. Pictures are left in DIRECTORY/BOARD. With --part the
Pico's slow emulator draws the first scenes only.
"""
import os
import sys

import show
from qemu import Tally, read_netpbm

FRAMES = 4

# Each scene; and whether it stands before one colour, so that its outline shows how it is framed.
SCENES = {"teapot": True, "three-spheres": True, "surfaces": True, "phong-lighting": False, "shaders": True,
          "halloween": False, "still-life": False}
PART = 2
NAMES = ["%s-%d" % (scene, frame) for scene in SCENES for frame in range(FRAMES)]

# Parts of the display's width that a row of bodies must reach into, on both sides, without touching the edge.
MARGIN = 0.06

# A step of a dithered level of 5 bits, of 255.
STEP = 9


def check_frame(tally, what, path):
    """A row of bodies reaches from side to side, and none is cut off."""
    width, height, _, data = read_netpbm(path)
    stands = [[any(abs(a - b) > STEP for a, b in zip(data[3 * (y * width + x):][:3], data)) for x in range(width)] for y in range(height)]
    columns = [x for x in range(width) if any(row[x] for row in stands)]
    rows = [y for y in range(height) if any(stands[y])]
    tally.check(0 < columns[0] < MARGIN * width and (1 - MARGIN) * width < columns[-1] + 1 < width,
                "%s: columns %d to %d of %d are used" % (what, columns[0], columns[-1], width))
    tally.check(0 < rows[0] and rows[-1] + 1 < height and abs(rows[0] + rows[-1] + 1 - height) < height / 8,
                "%s: rows %d to %d of %d are used" % (what, rows[0], rows[-1], height))


def main():
    arguments = show.read_arguments("--part")
    tally = Tally()
    for pair in arguments.firmware:
        name, firmware = pair.split("=", 1)
        scenes = len(SCENES)
        if arguments.part and name == "pico":
            scenes = PART
            show.BOARDS[name].frames = PART * FRAMES
        shown = NAMES[:scenes * FRAMES]
        show.run(arguments, tally, name, firmware, shown=list(zip(shown, shown)), program="animate", frames=NAMES)
        pictures = os.path.join(arguments.output, name)
        for scene, is_row in list(SCENES.items())[:scenes]:
            paths = [os.path.join(pictures, "%s-%d.ppm" % (scene, frame)) for frame in range(FRAMES)]
            if not tally.check(all(map(os.path.exists, paths)), "%s: %s was not shown whole" % (name, scene)):
                continue
            tally.check(len({read_netpbm(path)[3] for path in paths}) == FRAMES, "%s: %s does not move" % (name, scene))
            if is_row:
                check_frame(tally, "%s %s" % (name, scene), paths[0])
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
