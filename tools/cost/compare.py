#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the pictures that were drawn with those that are kept and that pages show: compare.py DRAWN KEPT PAGE..."""
import os
import re
import sys

sys.path[:0] = [os.path.join(os.path.dirname(__file__), ".."), os.path.join(os.path.dirname(__file__), "..", "..", "tests", "board")]
import png
from qemu import Tally


def content(path):
    with open(path, "rb") as file:
        return file.read()


def main():
    drawn, kept, *pages = sys.argv[1:]
    tally = Tally()
    names = sorted(os.listdir(drawn))
    tally.check(names == sorted(os.listdir(kept)), "%s has other pictures than are drawn" % kept)
    shown = set(re.findall(os.path.basename(kept) + r"/([\w.-]+\.png)", "".join(content(page).decode() for page in pages)))
    for name in names:
        path = os.path.join(kept, name)
        tally.check(os.path.exists(path) and png.shown(content(os.path.join(drawn, name))) == png.shown(content(path)),
                    "%s is not what is drawn: make figures" % path)
        tally.check(name in shown, "%s do not show %s" % (pages, name))
    tally.check(shown <= set(names), "%s show what is not there: %s" % (pages, sorted(shown - set(names))))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
