#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the charts of docs/charts and fills the figures into docs/accuracy.md and other pages: chart.py [--check DIRECTORY]

With --check the charts are drawn into DIRECTORY and held against those kept, and the pages against what they should say.
"""
import argparse
import html
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from charts import CHARTS
from figures import Figures
from page import PAGES, fill
from plot import overlap, text_width

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "tests", "board"))
from qemu import Tally

DATA, KEPT = "docs", "docs/charts"


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def draw(figures, directory):
    os.makedirs(directory, exist_ok=True)
    for name, chart in CHARTS.items():
        write(os.path.join(directory, name + ".svg"), chart(figures))


def texts(svg):
    """@return the box of every level text in an SVG by gnuplot, and the text"""
    pattern = (r'<g transform="translate\(([-\d.]+),([-\d.]+)\)"[^>]* font-size="([\d.]+)"\s*text-anchor="(\w+)">\s*'
               r'<text>([^<]*)</text>')
    for x, y, size, anchor, text in re.findall(pattern, svg):
        width, height = text_width(html.unescape(text), float(size)), float(size)
        left = float(x) - width * {"start": 0, "middle": 0.5, "end": 1}[anchor]
        yield (left, float(y) - 0.8 * height, left + width, float(y)), text


def check_readable(tally, name, svg):
    placed = list(texts(svg))
    pairs = [(a[1], b[1]) for i, a in enumerate(placed) for b in placed[:i] if overlap(a[0], b[0])]
    tally.check(placed and not pairs, "%s: texts cover each other: %s" % (name, pairs))


def check(figures, directory):
    tally = Tally()
    draw(figures, directory)
    for name in CHARTS:
        drawn, kept = (os.path.join(place, name + ".svg") for place in (directory, KEPT))
        tally.check(text_of(drawn) == text_of(kept), "%s is not what `make figures` draws: %s" % (kept, drawn))
        check_readable(tally, kept, text_of(kept))
    for path, blocks in PAGES.items():
        tally.check(fill(text_of(path), blocks, figures) == text_of(path), "%s: run `make figures`" % path)
    return tally.close()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", metavar="DIRECTORY")
    arguments = parser.parse_args()
    figures = Figures(DATA)
    if arguments.check:
        return check(figures, arguments.check)
    draw(figures, KEPT)
    for path, blocks in PAGES.items():
        write(path, fill(text_of(path), blocks, figures))
    return 0


if __name__ == "__main__":
    sys.exit(main())
