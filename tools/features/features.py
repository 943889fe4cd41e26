#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures what each feature of the library costs: features.py --qemu QEMU --output DIRECTORY [--page PAGE [--check]]
CORE=COMMAND...

COMMAND compiles and links firmware of tools/features/feature.c for a core, with {level} where -Os or -O2's name goes;
macros and the output's name are added. Writes DIRECTORY/features.csv, and the table of PAGE anew, or with --check holds
the figures there against those measured.
"""
import argparse
import concurrent.futures
import csv
import os
import re
import shlex
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "bench"))
from emulate import Tally, library_bytes, lines_of

SIZES = ((320, 240), (128, 64))
BEGIN, END = "<!-- begin of the table -->\n", "<!-- end of the table -->\n"

# A page's figures may be this far from what another release of the compiler gives.
TOLERANCE, TOLERANCE_BYTES = 0.03, 48

GROUPS = (
    ("Models, in place of Blinn-Phong", (
        ("Phong", {"MODEL": "glint_model_phong"}),
        ("Lambert", {"MODEL": "glint_model_lambert"}),
        ("unlit", {"MODEL": "glint_model_unlit"}))),
    ("Evaluation, in place of every fragment", (
        ("per vertex", {"EVALUATION": "glint_per_vertex"}),
        ("per facet", {"EVALUATION": "glint_per_facet"}),
        ("per vertex, RGB888", {"EVALUATION": "glint_per_vertex", "FORMAT": "glint_format_rgb888"}),
        ("per facet, RGB888", {"EVALUATION": "glint_per_facet", "FORMAT": "glint_format_rgb888"}))),
    ("Lights, in place of a directional one", (
        ("point", {"LIGHT": "glint_light_point"}),
        ("spot", {"LIGHT": "glint_light_spot"}),
        ("two directional", {"LIGHTS": "2"}))),
    ("Formats, in place of RGB565", (
        ("RGB565, dithered", {"FORMAT": "glint_format_rgb565_dithered"}),
        ("RGB565, high byte first", {"FORMAT": "glint_format_rgb565_be"}),
        ("RGB565, high byte first, dithered", {"FORMAT": "glint_format_rgb565_be_dithered"}),
        ("RGB888", {"FORMAT": "glint_format_rgb888"}),
        ("RGB888, dithered", {"FORMAT": "glint_format_rgb888_dithered"}),
        ("8-bit grey", {"FORMAT": "glint_format_grey8"}),
        ("8-bit grey, dithered", {"FORMAT": "glint_format_grey8_dithered"}),
        ("4-bit grey", {"FORMAT": "glint_format_grey4"}),
        ("4-bit grey, dithered", {"FORMAT": "glint_format_grey4_dithered"}),
        ("RGB444", {"FORMAT": "glint_format_rgb444"}),
        ("RGB444, dithered", {"FORMAT": "glint_format_rgb444_dithered"}),
        ("1 bit", {"FORMAT": "glint_format_mono"}),
        ("1 bit, dithered", {"FORMAT": "glint_format_mono_dithered"}),
        ("1 bit in pages", {"FORMAT": "glint_format_mono_pages"}),
        ("1 bit in pages, dithered", {"FORMAT": "glint_format_mono_pages_dithered"}))),
    ("Options", (
        ("local viewer", {"VIEWER": "GLINT_VIEWER_LOCAL"}),
        ("colours in the mesh, 888", {"COLOURS": "feature_colours"}),
        ("colours in the mesh, 565", {"COLOURS565": "feature_colours565"}),
        ("ungated highlight", {"MATERIAL_FLAGS": "GLINT_MATERIAL_UNGATED"}),
        ("largest in place of sum", {"MATERIAL_FLAGS": "GLINT_MATERIAL_MAX"}),
        ("double-sided mesh", {"MESH_FLAGS": "GLINT_MESH_DOUBLE_SIDED"}),
        ("gamma tables", {"GAMMA": "feature_gamma"}))),
    ("Functions, not called while instructions are counted", tuple(
        ("`glint_%s`" % name, {"FUNCTION": "glint_" + name})
        for name in ("generate_torus", "generate_sphere", "generate_cylinder", "generate_cone", "generate_plane",
                     "generate_box", "arena_need", "camera_look_at", "strerror", "material_paint", "pose_rotate_x",
                     "pose_then"))),
)

OPTIONS, FUNCTIONS = GROUPS[-2][1], GROUPS[-1][1]

COLUMNS = ("feature", "core", "flash_added", "flash_in_place", "instructions_320x240", "instructions_128x64")


class Builder:
    """Builds and runs feature.c for one core."""

    def __init__(self, qemu, output, core, command):
        self.qemu, self.core, self.command = qemu, core, command
        self.directory = os.path.join(output, "features")
        os.makedirs(self.directory, exist_ok=True)
        self.count = 0

    def build(self, name, level, macros, size=SIZES[0], with_base=False):
        """@return the path of the firmware, without its ending."""
        words = [name, self.core, level, "%dx%d" % size] + (["base"] if with_base else [])
        path = os.path.join(self.directory, re.sub(r"[^\w]+", "-", "-".join(words)))
        defines = ["-DFEATURE_%s=%s" % pair for pair in macros.items()]
        defines += ["-DFEATURE_WIDTH=%d" % size[0], "-DFEATURE_HEIGHT=%d" % size[1]]
        defines += ["-DFEATURE_WITH_BASE"] if with_base else []
        command = shlex.split(self.command.replace("{level}", level))
        subprocess.run(command + defines + ["-Wl,-Map=" + path + ".map", "-o", path + ".elf"], check=True)
        return path

    def flash(self, name, macros, with_base):
        return library_bytes(self.build(name, "Os", macros, with_base=with_base) + ".map")

    def instructions(self, name, macros, size):
        return int(lines_of(self.qemu, "mps2-an385", self.build(name, "O2", macros, size) + ".elf")[-1])

    def measure(self, name, macros):
        counted = [self.instructions(name, macros, size) for size in SIZES]
        return [self.flash(name, macros, with_base) for with_base in (True, False)] + counted


def measure_all(builders):
    """@return {(feature, core): (flash with base, flash, instructions of each size)}; the base itself is ''."""
    features = [("", {})] + [feature for _, group in GROUPS for feature in group]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        running = {(name, builder.core): workers.submit(builder.measure, name or "nothing", macros)
                   for name, macros in features for builder in builders}
        return {key: result.result() for key, result in running.items()}


def rows_of(measured):
    """@return {(feature, core): figures as the table has them}: flash beyond the base's, and instructions."""
    rows = {}
    for (name, core), (both, alone, *counted) in measured.items():
        base = measured[("", core)]
        rows[(name, core)] = [both - base[0], alone - base[1]] + counted if name else [base[0], base[1]] + counted
    return rows


def line_of(name, rows, cores, is_function):
    cells = [name or "the base"]
    for core in cores:
        added, in_place, large, small = rows[(name, core)]
        base = rows[("", core)]
        cells.append("%d" % added if not name else "%+d" % added)
        for count, reference in ((large, base[2]), (small, base[3])):
            if is_function:
                cells.append("")
            else:
                cells.append("%.2f M%s" % (count / 1e6, " (%+.0f %%)" % (100 * (count / reference - 1)) if name else ""))
        if name and in_place < added and not is_function:
            cells[-3] += " (%+d)" % in_place
    return "| " + " | ".join(cells) + " |\n"


def table(rows, cores):
    titles = {"m3": "Cortex-M3", "m0": "ARMv6-M"}
    head = ["feature"] + ["%s: %s" % (titles[core], what) for core in cores
                          for what in ("flash", "frame of 320x240", "of 128x64")]
    text = "| " + " | ".join(head) + " |\n|" + " --- |" * len(head) + "\n" + line_of("", rows, cores, False)
    for title, group in GROUPS:
        text += "| **%s** |%s\n" % (title, " |" * 3 * len(cores))
        for name, macros in group:
            text += line_of(name, rows, cores, "FUNCTION" in macros)
    return text


def split_page(path):
    with open(path) as file:
        before, rest = file.read().split(BEGIN)
    return before, *rest.split(END)


def write_page(path, text):
    before, _, after = split_page(path)
    with open(path, "w") as file:
        file.write(before + BEGIN + text + END + after)


def figures(line):
    """The numbers of a line's cells but the first, in the order that they stand."""
    return [float(number) for number in re.findall(r"[-+]?\d+(?:\.\d+)?(?= M| \(|\)| \|)", line.split("|", 2)[2])]


def check_page(tally, path, text):
    kept = split_page(path)[1].splitlines()
    for line, now in zip(kept, text.splitlines()):
        name = line.split("|")[1].strip()
        tally.check(name == now.split("|")[1].strip(), "%s: the page says '%s'" % (now, name))
        pairs = list(zip(figures(line), figures(now)))
        near = [abs(a - b) <= max(TOLERANCE * abs(b), TOLERANCE_BYTES if abs(b) >= 16 else 0.02) for a, b in pairs]
        tally.check(all(near) and len(figures(line)) == len(figures(now)),
                    "the page is out of date, run `make features`:\n  %s\n  %s" % (line, now))
    tally.check(len(kept) == len(text.splitlines()), "the page has %d lines of table" % len(kept))


def check_claims(tally, rows, cores):
    """What the page says in words."""
    for core in cores:
        base = rows[("RGB888", core)]
        vertex, facet = rows[("per vertex, RGB888", core)], rows[("per facet, RGB888", core)]
        for size in (2, 3):
            tally.check(vertex[size] < base[size], "%s: per vertex takes %d instructions, per fragment %d" % (
                core, vertex[size], base[size]))
            tally.check(facet[size] < base[size], "%s: per facet takes %d instructions, per fragment %d" % (
                core, facet[size], base[size]))
        for name, _ in OPTIONS:
            tally.check(rows[(name, core)][0] == 0, "%s: %s takes flash where no scene has it" % (core, name))
        for name, _ in FUNCTIONS:
            tally.check(rows[(name, core)][0] > 0, "%s: %s takes no flash: was it linked?" % (core, name))


def main():
    parser = argparse.ArgumentParser()
    for name in ("qemu", "output", "page"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("cores", nargs="+")
    arguments = parser.parse_args()
    builders = [Builder(arguments.qemu, arguments.output, *core.split("=", 1)) for core in arguments.cores]
    cores = [builder.core for builder in builders]
    rows = rows_of(measure_all(builders))
    with open(os.path.join(arguments.output, "features.csv"), "w", newline="") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(COLUMNS)
        lines.writerows([(name or "base", core) + tuple(row) for (name, core), row in rows.items()])
    tally = Tally()
    check_claims(tally, rows, cores)
    if arguments.check:
        check_page(tally, arguments.page, table(rows, cores))
    else:
        write_page(arguments.page, table(rows, cores))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
