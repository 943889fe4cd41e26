#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs tests/board/faults.c: each fault of the bus ends its frame by a named error, and the next frame is whole.

faults.py --host SHOW_HOST --stream PANEL_STREAM --output DIRECTORY BOARD=FIRMWARE...
"""
import sys

import show
from qemu import Tally

# How the frames end whose bus stops, is far too slow, and fails.
ERRORS = ["timeout", "timeout", "fault"]

# The next frame after each, and the first after a reset in mid-frame.
SHOWN = list(zip(show.FRAMES, show.FRAMES)) + [("reset-" + show.FRAMES[0], show.FRAMES[0])]


def main():
    arguments = show.read_arguments()
    tally = Tally()
    for firmware in arguments.firmware:
        name = firmware.split("=", 1)[0]
        lines = show.run(arguments, tally, *firmware.split("=", 1), shown=SHOWN)
        ended = [line for line in lines if line in ("timeout", "fault", "something else")]
        tally.check(ended == ERRORS, "%s: frames ended by %s" % (name, ended))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
