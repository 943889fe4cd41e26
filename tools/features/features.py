#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures what each feature of the library costs: features.py --qemu QEMU --output DIRECTORY [--page PAGE [--check LEVELS]]
CORE=COMMAND...

COMMAND compiles and links firmware of tools/features/feature.c for a core, with {level} where -Os or -O2's name goes;
macros and the output's name are added. Writes DIRECTORY/features.csv, and the tables of PAGE anew, or with --check holds
the figures there of levels, Os or O2 or both by a comma, and of these cores, against those measured. Flash and frames in a row are those of one
and the same firmware.
"""
import argparse
import collections
import concurrent.futures
import csv
import os
import re
import shlex
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "bench"))
from emulate import Tally, library_bytes, lines_of  # noqa: E402

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import markdown  # noqa: E402

LEVELS = {"Os": "Built for size, `-Os`", "O2": "Built for speed, `-O2`"}
CORES = {"m3": "Cortex-M3", "m0": "ARMv6-M"}
PART = "tables"  # of the page

# A page's figures may be this far from what another release of the compiler gives.
TOLERANCE, TOLERANCE_BYTES = 0.03, 48

GROUPS = (
    ("Models, in place of Blinn-Phong", (
        ("Phong", {"MODEL": "glint_model_phong"}),
        ("Lambert", {"MODEL": "glint_model_lambert"}),
        ("unlit", {"MODEL": "glint_model_unlit", "EVALUATION_POINTER": "0"}))),
    ("Evaluation, in place of every fragment", (
        ("per vertex", {"EVALUATION": "glint_per_vertex"}),
        ("per facet", {"EVALUATION": "glint_per_facet"}),
        ("per vertex, RGB888", {"EVALUATION": "glint_per_vertex", "FORMAT": "glint_format_rgb888"}),
        ("per facet, RGB888", {"EVALUATION": "glint_per_facet", "FORMAT": "glint_format_rgb888"}))),
    ("Lights, in place of a directional one", (
        ("point", {"LIGHT": "glint_light_point"}),
        ("spot", {"LIGHT": "glint_light_spot"}),
        ("two directional", {"LIGHTS": "2"}))),
    ("Meshes, in place of one in clusters", (
        ("no clusters", {"MESH": "feature_plain_mesh"}),
        ("no clusters, positions in int8", {"MESH": "feature_positions8_mesh"}),
        ("no clusters, octahedral normals, int8", {"MESH": "feature_octahedral8_mesh"}),
        ("no clusters, indices of 8 bits, not drawn", {"MESH": "feature_indices8_mesh"}))),
    ("Formats, in place of RGB565", (
        ("RGB565, dithered", {"FORMAT": "glint_format_rgb565_dithered"}),
        ("RGB565, high byte first", {"FORMAT": "glint_format_rgb565_be"}),
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
    ("Textures of 64x64, in place of one colour", (
        ("RGB565 texels", {"TEXTURE": "glint_texture_rgb565"}),
        ("texels of 16 colours", {"TEXTURE": "glint_texture_palette16"}),
        ("texels of 16 colours, bilinear", {"TEXTURE": "glint_texture_palette16", "MATERIAL_FLAGS": "GLINT_MATERIAL_BILINEAR"}),
        ("RGB565 texels, unlit", {"TEXTURE": "glint_texture_rgb565", "MODEL": "glint_model_unlit", "EVALUATION_POINTER": "0"}))),
    ("What is not opaque, fog, smooth edges", (
        ("opacity", {"BLEND": "GLINT_BLEND_ALPHA", "LAYERS": "&glint_layers"}),
        ("added", {"BLEND": "GLINT_BLEND_ADD", "LAYERS": "&glint_layers"}),
        ("opacity, dithered", {"BLEND": "GLINT_BLEND_DITHERED", "LAYERS": "&glint_layers"}),
        ("fog", {"FOG": "glint_fog_linear"}),
        ("2x2 samples", {"SAMPLES": "&glint_samples_2x2"}))),
    ("Options", (
        ("local viewer", {"VIEWER": "GLINT_VIEWER_LOCAL"}),
        ("colours in the mesh, 888", {"COLOURS": "feature_colours"}),
        ("colours in the mesh, 565", {"COLOURS565": "feature_colours565"}),
        ("ungated highlight", {"MATERIAL_FLAGS": "GLINT_MATERIAL_SPECULAR_UNGATED"}),
        ("largest in place of sum", {"MATERIAL_FLAGS": "GLINT_MATERIAL_MAX_WITH_AMBIENT"}),
        ("double-sided mesh", {"MESH_FLAGS": "GLINT_MESH_DOUBLE_SIDED"}),
        ("gamma tables", {"GAMMA": "feature_gamma"}))),
    ("Functions, not called while instructions are counted", tuple(
        ("`glint_%s`" % name, {"FUNCTION": "glint_" + name})
        for name in ("generate_torus", "generate_plane", "arena_need", "camera_look_at", "strerror", "material_paint", "pose_rotate_x",
                     "pose_then"))),
)

OPTIONS, FUNCTIONS = GROUPS[-2][1], GROUPS[-1][1]

COLUMNS = ("feature", "core", "level", "flash", "flash_beside_base", "instructions_320x240", "instructions_128x64")

# Rows of meshes in smaller types, beside the same mesh in arrays; what cannot be drawn: the torus has more than 256 vertices.
PLAIN, SMALLER, NOT_DRAWN = "no clusters", "no clusters, ", "not drawn"

# Files of the library of which a scene links nothing, as it names nothing that they are for.
TEXTURE = ("textured", "map", "texels")
SUNS = ("sun_setup", "sun_lists", "sun_fine", "sun_spans", "sun_small", "ramps")
PER_FRAGMENT = ("lamps", "cells", "reflect", "arrive", "suns", "sun_vectors") + SUNS
PER_CORNER = ("corners", "reach")
LEFT_OUT = {"": PER_CORNER + TEXTURE, "Lambert": PER_CORNER + ("power",), "unlit": PER_FRAGMENT + PER_CORNER + ("draw", "power"),
            "RGB565 texels": PER_CORNER, "RGB565 texels, unlit": PER_FRAGMENT + PER_CORNER + ("draw", "power"),
            "per vertex": PER_FRAGMENT, "per facet": PER_FRAGMENT, "point": SUNS + PER_CORNER, "spot": SUNS + PER_CORNER}

# What stands in place of something that the base names; firmware that has both takes more flash.
IN_PLACE = ("MODEL", "EVALUATION", "LIGHT", "FORMAT")


Row = collections.namedtuple("Row", "flash beside large small")


class Builder:
    """Builds and runs feature.c for one core."""

    def __init__(self, qemu, output, core, command):
        self.qemu, self.core, self.command = qemu, core, command
        self.directory = os.path.join(output, "features")
        os.makedirs(self.directory, exist_ok=True)

    def path(self, name, level, with_base=False):
        """@return the path of the firmware, without its ending."""
        words = [name or "nothing", self.core, level] + (["base"] if with_base else [])
        return os.path.join(self.directory, re.sub(r"[^\w]+", "-", "-".join(words)))

    def build(self, name, level, macros, with_base=False):
        path = self.path(name, level, with_base)
        defines = ["-DFEATURE_%s=%s" % pair for pair in macros.items()]
        defines += ["-DFEATURE_WITH_BASE"] if with_base else []
        command = shlex.split(self.command.replace("{level}", level))
        subprocess.run(command + defines + ["-Wl,-Map=" + path + ".map", "-o", path + ".elf"], check=True)
        return path

    def measure(self, name, level, macros):
        """@return flash of the firmware, with the base beside what stands in its place, and the instructions it counts."""
        path = self.build(name, level, macros)
        flash, beside = library_bytes(path + ".map"), ""
        if any(macro in IN_PLACE for macro in macros):
            beside = library_bytes(self.build(name, level, macros, with_base=True) + ".map")
        counted = (0, 0) if "FUNCTION" in macros or NOT_DRAWN in name else map(int, lines_of(self.qemu, "mps2-an385", path + ".elf")[-2:])
        return Row(flash, beside, *counted)


def measure_all(builders, levels):
    """@return {(feature, core, level): row}; the base itself is ''."""
    features = [("", {})] + [feature for _, group in GROUPS for feature in group]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        running = {(name, builder.core, level): workers.submit(builder.measure, name, level, macros)
                   for level in levels for name, macros in features for builder in builders}
        return {key: result.result() for key, result in running.items()}


def cells_of(row, base):
    """Of a feature: flash, flash beside the base, and frames, each against the base's."""
    if row is base:
        return ["%d" % row.flash, ""] + ["%.2f M" % (count / 1e6) for count in row[2:]]
    frames = ["%.2f M (%+.0f %%)" % (count / 1e6, 100 * (count / reference - 1)) if count else ""
              for count, reference in zip(row[2:], base[2:])]
    beside = "%+d" % (row.beside - base.flash) if row.beside else ""
    return ["%d (%+d)" % (row.flash, row.flash - base.flash), beside] + frames


def line_of(name, level, rows, cores):
    cells = [name or "the base"]
    for core in cores:
        cells += cells_of(rows[(name, core, level)], rows[("", core, level)])
    return cells


def table(level, rows, cores):
    head = ["feature"] + ["%s: %s" % (CORES[core], what) for core in cores
                          for what in ("flash", "flash beside the base", "frame of 320x240", "of 128x64")]
    lines = [line_of("", level, rows, cores)]
    for title, group in GROUPS:
        lines += [["**%s**" % title] + [""] * 4 * len(cores)] + [line_of(name, level, rows, cores) for name, _ in group]
    return markdown.table(head, lines)


def section(level, rows, cores):
    return "\n## %s\n\n%s" % (LEVELS[level], table(level, rows, cores))


def part_of(path):
    with open(path) as file:
        return markdown.split(file.read(), PART)


def write_page(path, text):
    before, _, after = part_of(path)
    with open(path, "w") as file:
        file.write(before + text + after)


def of_cores(line, cores):
    """A line of the page's tables without the cells of other cores."""
    cells, places = line.split("|"), [2 + 4 * list(CORES).index(core) for core in cores]
    return "|".join(cells[:2] + [cell for place in places for cell in cells[place:place + 4]] + cells[-1:]) if cells[1:] else line


def figures(line):
    """The numbers of a line's cells but the first, in the order that they stand."""
    return [float(number) for number in re.findall(r"[-+]?\d+(?:\.\d+)?(?= M| \(|\)| \|)", line.split("|", 2)[2])]


def is_near(kept, now):
    return abs(kept - now) <= max(TOLERANCE * abs(now), TOLERANCE_BYTES if abs(now) >= 16 else 0.02)


def check_section(tally, path, level, cores, text):
    """A level's table of the page against what was measured of some cores."""
    kept = next((part for part in re.split(r"(?m)^(?=\n## )", part_of(path)[1]) if LEVELS[level] in part), "").rstrip()
    kept = [of_cores(line, cores) for line in ("\n" + kept.lstrip()).splitlines()]
    measured = text.rstrip().splitlines()
    tally.check(len(kept) == len(measured), "the page has %d lines of tables, not %d" % (len(kept), len(measured)))
    for line, now in zip(kept, measured):
        if not now.startswith("|"):
            tally.check(line == now, "the page says '%s' in place of '%s'" % (line, now))
            continue
        name, says = now.split("|")[1].strip(), line.split("|")[1].strip() if "|" in line else line
        tally.check(name == says, "%s: the page says '%s'" % (now, says))
        tally.check(len(figures(line)) == len(figures(now)) and all(map(is_near, figures(line), figures(now))),
                    "the page is out of date, run `make figures`:\n  %s\n  %s" % (line, now))


def check_claims(tally, rows, cores, levels):
    """What the page says in words."""
    for core in cores:
        for level in levels:
            of = {name: row for (name, *which), row in rows.items() if which == [core, level]}
            where = "%s, -%s: " % (core, level)
            for name in of:
                if name.startswith(SMALLER):
                    tally.check(of[name].flash > of[PLAIN].flash, where + name + " takes no flash: was it linked?")
            for name, _ in OPTIONS:
                tally.check(of[name].flash == of[""].flash, where + name + " takes flash where no scene has it")
            for name, _ in FUNCTIONS:
                tally.check(of[name].flash > of[""].flash, where + name + " takes no flash: was it linked?")


def check_left_out(tally, builders, levels):
    """A scene pays for what it names."""
    for builder in builders:
        for level in levels:
            for name, files in LEFT_OUT.items():
                for file in files:
                    count = library_bytes(builder.path(name, level) + ".map", file + ".o)")
                    tally.check(not count, "%s, -%s: %s links %d bytes of %s.c" % (builder.core, level, name or "the base", count, file))


def main():
    parser = argparse.ArgumentParser()
    for name in ("qemu", "output", "page"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--check", type=lambda text: text.split(","), metavar="LEVELS")
    parser.add_argument("cores", nargs="+")
    arguments = parser.parse_args()
    builders = [Builder(arguments.qemu, arguments.output, *core.split("=", 1)) for core in arguments.cores]
    cores = [builder.core for builder in builders]
    levels = arguments.check or list(LEVELS)
    rows = measure_all(builders, levels)
    with open(os.path.join(arguments.output, "features.csv"), "w", newline="") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(COLUMNS)
        lines.writerows([(name or "base", core, level) + row for (name, core, level), row in rows.items()])
    tally = Tally()
    check_claims(tally, rows, cores, levels)
    check_left_out(tally, builders, levels)
    for level in arguments.check or []:
        check_section(tally, arguments.page, level, cores, section(level, rows, cores))
    if not arguments.check:
        write_page(arguments.page, "".join(section(level, rows, cores) for level in levels) + "\n")
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
