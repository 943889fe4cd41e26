# SPDX-License-Identifier: MIT
"""What every chart of docs/charts shows: rows of (panel, series, x, y), which the gnuplot script of that name draws."""
import timing
from figures import ASKED, CPUS, LIGHT_COUNTS, LIGHTS, front, only

# The exponent at which methods are compared: that for which their instructions are counted.
POWER_P = "64"

# Errors below this are drawn at it: a hundredth of a step is nothing to see.
SMALLEST_ERROR = 0.01

BEST, ROUNDED, HALF = "best for their price", "RGB565, correctly rounded", "half a step"


def level(panel, name, y, points):
    """A level across what a panel shows."""
    return [(panel, name, x, y) for x in (min(p[0] for p in points), max(p[0] for p in points))]


def best(panel, name, points, largest=False):
    """What no other point beats in both, as steps to the right edge."""
    line = front(points, largest)
    return [(panel, name, x, y) for x, y in line + [(max(p[0] for p in points), line[-1][1])]]


def frames_panel(figures, title, scene, size, cpu):
    rows = [(title, "per " + choice, figures.instructions(scene, size, choice, cpu), figures.psnr(scene, size, choice))
            for choice in figures.choices()]
    with_fpu = "m4f" if cpu == "m4" else cpu
    rows += [(title, "%s, %s" % (row["library"], row["mode"]), float(row["million_instructions"]), float(row["psnr_db"]))
             for row in only(figures.others, scene=scene, size=size, cpu=with_fpu) if row["psnr_db"]]
    points = [row[2:] for row in rows]
    return rows + best(title, BEST, points, largest=True) + level(title, ROUNDED, figures.psnr(scene, size, "correctly rounded"), points)


def frames(figures):
    return [row for cpu, more in (("m4", ", where others use the FPU"), ("m3", ""), ("m0", ""), ("rv32", ""))
            for row in frames_panel(figures, CPUS[cpu] + more, "torus2304", "320x240", cpu)]


def frames_scenes(figures):
    return [row for scene, size in (("torus576", "320x240"), ("torus9216", "320x240"), ("sphere960", "320x240"), ("torus2304", "128x64"))
            for row in frames_panel(figures, "%s at %s" % (scene, size), scene, size, "m3")]


def shading(figures):
    return [(row["format"].upper() + " over " + key, "per " + row["evaluation"], float(row[key]) * scale, float(row["rms"]))
            for format in dict.fromkeys(row["format"] for row in figures.shading)
            for key, scale in (("triangles", 1), ("instructions", 1e-6)) for row in only(figures.shading, format=format)]


def methods(kind, p):
    """Error over instructions of every method of a kind on each core. Those of one variant do the same work from the same
    input, so that each variant has a front of its own."""
    def of(figures):
        rows = []
        for cpu in figures.cpus(only(figures.bench, kind=kind)):
            found = figures.methods(kind, cpu, p)
            points = {(method.variant, method.name): (method.instructions, max(method.error, SMALLEST_ERROR)) for method in found}
            rows += [(CPUS[cpu], "%s: %s" % key, *point) for key, point in points.items()]
            for variant in dict.fromkeys(key[0] for key in points):
                rows += best(CPUS[cpu], "%s, %s" % (variant, BEST), [point for key, point in points.items() if key[0] == variant])
            rows += level(CPUS[cpu], HALF, 0.5, list(points.values()))
        return rows
    return of


def exponent(figures):
    rows = [("", "%s: %s" % (variant, name), p, max(error, SMALLEST_ERROR)) for name, variant, _ in figures.names("power")
            for p, error in figures.errors("power", name, variant)]
    return rows + level("", HALF, 0.5, [row[2:] for row in rows])


# Of a panel: its axis, what one unit of the axis is, and its sweeps with what tells them apart.
SWEEPS = (("triangles, thousands", 1e-3, {"triangles": ""}),
          ("pixels of the screen, thousands", 1e-3, {"pixels": ""}),
          ("lights", 1, {"lights": ""}),
          ("objects of 192 triangles, side by side", 1, {"objects": ""}),
          ("objects that cover each other", 1, {"nearest_first": ", nearest first", "farthest_first": ", farthest first"}),
          ("objects that cover each other, general path", 1,
           {"nearest_first_general": ", nearest first", "farthest_first_general": ", farthest first"}))


def scaling(figures):
    """Points, and straight lines that were fitted to them."""
    rows = []
    for label, unit, sweeps in SWEEPS:
        for sweep, name in sweeps.items():
            for cpu in ("m3", "m0"):
                found = only(figures.scaling, cpu=cpu, sweep=sweep)
                rows += [(label, CPUS[cpu] + name, float(row["count"]) * unit, int(row["instructions"]) / 1e6) for row in found]
                start, slope, most = (float(value) for value in (found[0]["line_start"], found[0]["line_slope"], found[-1]["count"]))
                rows += [(label, CPUS[cpu] + name + ", fitted", x * unit, (start + slope * x) / 1e6) for x in (0, most)]
    return rows


def lights(figures):
    return [("", name % LIGHTS[kind][1], *pair) for cpu, name in (("m3", "glint, %s"), ("m4f", "good float, %s"))
            for kind in LIGHTS for pair in figures.over_lights(kind, cpu)]


def bus(figures):
    """Above the diagonal the bus takes longer than the core."""
    return [("", "%s, %s" % (timing.name_of(frame) + " " + frame[1], part["part"]), timing.core_ms(figures, frame, part),
             timing.bus_ms(frame[1], part))
            for frame in (timing.BENCHMARK[0], timing.BENCHMARK[3], timing.EXAMPLES[0], timing.EXAMPLES[3], timing.EXAMPLES[4])
            for part in figures.parts]


def arena(figures):
    """Each scene against its frame of one pass; the last row of each is the arena where vertices stay."""
    rows = []
    for scene in dict.fromkeys(row["scene"] for row in figures.arena):
        *steps, kept = [(int(row["arena"]) / 1024, int(row["instructions"])) for row in only(figures.arena, scene=scene)]
        rows += [("", scene, x, y / steps[-1][1]) for x, y in sorted(steps + [kept])]
        rows.append(("", scene + ", vertices stay", kept[0], kept[1] / steps[-1][1]))
    return rows


CHARTS = {"power": methods("power", POWER_P), "normalise": methods("normalise", ""), "frames": frames, "frames-scenes": frames_scenes,
          "exponent": exponent, "shading": shading, "scaling": scaling, "bus": bus, "arena": arena, "lights": lights}
