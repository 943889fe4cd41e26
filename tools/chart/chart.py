#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the charts of docs/charts and fills the figures into docs/accuracy.md and other pages: chart.py [--check] DIRECTORY

DIRECTORY gets the rows that the gnuplot scripts beside this file draw. With --check the charts are drawn there too and held
against those kept, and the pages against what they should say.
"""
import argparse
import html
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, ".."), os.path.join(HERE, "..", "..", "tests", "board")]
from figures import Figures  # noqa: E402
from page import PAGES, fill  # noqa: E402
from qemu import Tally  # noqa: E402
from series import CHARTS  # noqa: E402

DATA, KEPT = "docs", "docs/charts"

TITLES = {
    "ways": "Every way to light a torus of 576 triangles at 320x240 by 1, 2, 4 and 8 lights: PSNR over instructions",
    "frames": "A torus of 2304 triangles at 320x240, one directional light: PSNR over instructions",
    "regions": "Where plain methods fail (errors below 0.1 are drawn at it)",
    "power": "cos^p: error over instructions (mark: p = 64; bar: up to the worst p from 1 to 1024)",
    "normalise": "One over a square root, and unit vectors: error over instructions",
    "shading": "A torus with a highlight (p = 50), 320x240: error against the true smooth surface",
    "depth": "Errors over depth, as a multiple of that of the nearest geometry: rooms, terrains and far objects",
    "bus": "Time of a frame in RGB565: what the core takes against what the bus takes",
    "arena": "What a smaller arena costs, Cortex-M3",
    "edges": "A torus of 576 triangles at 320x240 in RGB565: what smooth edges cost and add"}


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def quoted(words):
    return " ".join('\\"%s\\"' % word for word in dict.fromkeys(words))


def draw(name, rows, directory):
    """@return the SVG that a chart's script draws of its rows"""
    data = os.path.join(directory, name + ".tsv")
    write(data, "".join("\t".join(["%s\t%s\t%.9g\t%.9g" % row[:4], *row[4:]]) + "\n" for row in rows))
    variables = 'data = "%s"; heading = "%s"; panels = "%s"; series = "%s"' % (
        data, TITLES[name], quoted(row[0] for row in rows), quoted(row[1] for row in rows))
    drawn = subprocess.run(["gnuplot", "-e", variables, os.path.join("tools/chart", name + ".gp")], capture_output=True, text=True,
                           check=True)
    svg = drawn.stdout.replace('font-family="DejaVu Sans"', 'font-family="DejaVu Sans,Verdana,Helvetica,sans-serif"')
    return "\n".join(line.rstrip() for line in svg.splitlines() if line.strip()) + "\n"


def texts(svg):
    """@return the box of every level text in an SVG by gnuplot, and the text; a letter is 0.6 of its height wide, on average"""
    pattern = (r'<g transform="translate\(([-\d.]+),([-\d.]+)\)"[^>]* font-size="([\d.]+)"\s*text-anchor="(\w+)">\s*'
               r'<text>([^<]+)</text>')
    for x, y, size, anchor, text in re.findall(pattern, svg):
        width, height = 0.6 * float(size) * len(html.unescape(text)), float(size)
        left = float(x) - width * {"start": 0, "middle": 0.5, "end": 1}[anchor]
        yield (left, float(y) - 0.8 * height, left + width, float(y)), text


def overlap(a, b):
    """Returns whether two boxes (left, top, right, bottom) share an area."""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def check_readable(tally, name, svg):
    placed = list(texts(svg))
    pairs = [(a[1], b[1]) for i, a in enumerate(placed) for b in placed[:i] if overlap(a[0], b[0])]
    tally.check(placed and not pairs, "%s: texts cover each other: %s" % (name, pairs))
    width = int(re.search(r'<svg\s+width="(\d+)"', svg)[1])
    beyond = [text for box, text in placed if box[0] < 0 or box[2] > width]
    tally.check(not beyond, "%s: texts leave the chart: %s" % (name, beyond))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    parser.add_argument("directory")
    arguments = parser.parse_args()
    figures, tally = Figures(DATA), Tally()
    os.makedirs(arguments.directory, exist_ok=True)
    for name, rows_of in CHARTS.items():
        kept, svg = os.path.join(KEPT, name + ".svg"), draw(name, rows_of(figures), arguments.directory)
        write(os.path.join(arguments.directory, name + ".svg") if arguments.check else kept, svg)
        tally.check(text_of(kept) == svg, "%s is not what `make figures` draws" % kept)
        check_readable(tally, kept, svg)
    for path, blocks in PAGES.items():
        now, filled = text_of(path), fill(text_of(path), blocks, figures)
        if not arguments.check:
            write(path, filled)
        tally.check(not arguments.check or now == filled, "%s: run `make figures`" % path)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
