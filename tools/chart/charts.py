# SPDX-License-Identifier: MIT
"""Every chart of docs/charts, as a function from the figures to an SVG."""
import math

import timing
from figures import ASKED, CPUS, LIGHT_COUNTS, LIGHTS, LIT, LIT_SIZE, front, only
from plot import Axis, Chart, Panel

# The exponent at which methods are compared: that for which their instructions are counted.
POWER_P = "64"

EVALUATIONS = {"facet": ("per facet", "gold"), "vertex": ("per vertex", "blue"),
               "fragment": ("per fragment", "red")}


def grid(chart, count, columns, left=64, top=86, gap=(66, 84), right=16, bottom=48):
    """@return the boxes of `count` panels in rows of `columns`, filling the chart."""
    rows = (count + columns - 1) // columns
    width = (chart.width - left - right - chart.right_labels * columns - gap[0] * (columns - 1)) / columns
    height = (chart.height - top - bottom - gap[1] * (rows - 1)) / rows
    step = width + gap[0] + chart.right_labels
    return [(left + step * (i % columns), top + (height + gap[1]) * (i // columns), width, height)
            for i in range(count)]


def span(values, below=0.8, above=1.3):
    """A range of a logarithmic axis around values."""
    return min(values) * below, max(values) * above


def staircase(points, x_end):
    """A front as a line that keeps what is reached until the next point."""
    line = []
    for x, y in points:
        if line:
            line.append((x, line[-1][1]))
        line.append((x, y))
    return line + [(x_end, line[-1][1])]


# Points of one colour nearer to each other than this, in pixels, share a label.
MERGED = 10


def merge(panel, points):
    """@return the points (x, y, label, colour), with the labels of close ones of a colour put together at the first."""
    merged = []
    for x, y, label, colour in points:
        here = panel.place(x, y)
        near = [i for i, other in enumerate(merged)
                if other[2] and other[3] == colour and math.dist(here, panel.place(*other[:2])) < MERGED]
        if near:
            other = merged[near[0]]
            merged[near[0]] = (*other[:2], joined(other[2], label), colour)
            label = ""
        merged.append((x, y, label, colour))
    return merged


def joined(first, second):
    """"Phong local" and "Blinn-Phong local" as "Phong, Blinn-Phong local"."""
    head, _, tail = first.rpartition(" ")
    if head and second.endswith(" " + tail):
        first = head
    return first + ", " + second


def mark_of(choice):
    """@return label and colour of a choice of shading"""
    evaluation, rest = choice.split(" ", 1)
    return rest, EVALUATIONS[evaluation][1]


def frames(figures, scene="torus2304", size="320x240"):
    cpus = [cpu for cpu in ("m4", "m3", "m0", "rv32") if cpu in figures.cpus(figures.counts)]
    rows = (len(cpus) + 1) // 2
    chart = Chart("Whole frames of %s at %s: PSNR over instructions" % (scene, size),
                  [*EVALUATIONS.values(), ("other libraries", "grey"), ("dashed: best for their price", "green")],
                  1020, 74 + 440 * rows)
    for cpu, box in zip(cpus, grid(chart, len(cpus), 2)):
        title = CPUS[cpu] + (", where others use the FPU" if cpu == "m4" else "")
        chart.panels.append(frames_panel(figures, title, scene, size, cpu, box))
    return chart.svg()


def frames_scenes(figures):
    """The other benchmark scenes, on one core."""
    scenes = (("torus576", "320x240"), ("torus9216", "320x240"), ("sphere960", "320x240"), ("torus2304", "128x64"))
    chart = Chart("The other benchmark scenes on Cortex-M3: PSNR over instructions",
                  [*EVALUATIONS.values(), ("dashed: best for their price", "green")],
                  1020, 74 + 440 * ((len(scenes) + 1) // 2))
    for (scene, size), box in zip(scenes, grid(chart, len(scenes), 2)):
        chart.panels.append(frames_panel(figures, "%s at %s" % (scene, size), scene, size, "m3", box))
    return chart.svg()


def frames_panel(figures, title, scene, size, cpu, box):
    points = [(figures.instructions(scene, size, choice, cpu), figures.psnr(scene, size, choice),
               *mark_of(choice)) for choice in figures.choices()]
    with_fpu = "m4f" if cpu == "m4" else cpu
    others = [(float(row["million_instructions"]), float(row["psnr_db"]), "%s, %s" % (row["library"], row["mode"]), "grey")
              for row in figures.others
              if (row["scene"], row["size"], row["cpu"]) == (scene, size, with_fpu) and row["psnr_db"]]
    ideal = figures.psnr(scene, size, "correctly rounded")
    low = math.floor(min(y for _, y, *_ in points + others)) - 2
    panel = Panel(title, box, Axis("million instructions per frame", *span([p[0] for p in points + others], 0.6), log=True),
                  Axis("PSNR, dB", low, math.ceil(ideal) + 3))
    for x, y, label, colour in merge(panel, points) + others:
        panel.point(x, y, label, colour, filled=colour != "grey")
    panel.rule(ideal, "RGB565, correctly rounded", right=True)
    panel.line(staircase(front([point[:2] for point in points + others], largest=True), panel.x.high), "green", 1.2, dash=2)
    return panel


# Of the chart of triangles: column, label, unit.
SHADING_COLUMNS = (("triangles", "triangles", 1), ("instructions", "million instructions per frame on Cortex-M3", 1e-6))


def shading(figures):
    shaded = {name: EVALUATIONS[name] for name in dict.fromkeys(row["evaluation"] for row in figures.shading)}
    chart = Chart("A torus with a highlight (p = 50), 320x240: error against the true smooth surface",
                  list(shaded.values()), 960, 790)
    panels = [(format, *column) for format in dict.fromkeys(row["format"] for row in figures.shading) for column in SHADING_COLUMNS]
    errors = [float(row["rms"]) for row in figures.shading]
    for (format, key, label, scale), box in zip(panels, grid(chart, 4, 2)):
        values = [float(row[key]) * scale for row in figures.shading]
        panel = Panel(format.upper(), box, Axis(label, *span(values), log=True),
                      Axis("root mean square error, steps of 8 bits", *span(errors, 0.6), log=True))
        for name, (words, colour) in shaded.items():
            rows = only(figures.shading, format=format, evaluation=name)
            panel.line([(float(row[key]) * scale, float(row["rms"])) for row in rows], colour, 2, marks=True)
            panel.point(float(rows[-1][key]) * scale, float(rows[-1]["rms"]), words, colour)
        chart.panels.append(panel)
    return chart.svg()


# Of what a method is given and returns: the variant column, in the order that it first appears.
VARIANT_COLOURS = ("blue", "red", "gold", "violet", "grey")

# Errors below this are drawn at it: a hundredth of a step is nothing to see.
SMALLEST_ERROR = 0.01


def variant_colours(figures, kind):
    return dict(zip(dict.fromkeys(variant for _, variant, _ in figures.names(kind)), VARIANT_COLOURS))


def methods(figures, kind, p, title, unit, compared=None):
    """
    Error over instructions of every method of a kind, a panel for each core. Those of one variant do the same work from
    the same input, so that each variant has a front of its own.
    @param compared the one variant that is named and compared; thin lines lead to the others
    """
    cpus, colours = figures.cpus([row for row in figures.bench if row["kind"] == kind]), variant_colours(figures, kind)
    subtitle = list(colours.items()) + [("dashed: best for their price", "ink"), ("circled: the library's", "ink")]
    chart = Chart(title, subtitle, 1020, 74 + 400 * ((len(cpus) + 1) // 2))
    for cpu, box in zip(cpus, grid(chart, len(cpus), 2)):
        chart.panels.append(methods_panel(figures.methods(kind, cpu, p), CPUS[cpu], box, colours, unit, compared))
    return chart.svg()


def methods_panel(found, title, box, colours, unit, compared):
    errors = [max(method.error, SMALLEST_ERROR) for method in found]
    panel = Panel(title, box,
                  Axis("instructions per " + unit, *span([method.instructions for method in found]), log=True),
                  Axis("largest error, steps of 8 bits", *span(errors, 0.6, 2), log=True))
    for method, error in zip(found, errors):
        label = method.name if compared in (None, method.variant) else ""
        panel.point(method.instructions, error, label, colours[method.variant], circled=method.shipped and bool(label))
    if compared:
        for name in dict.fromkeys(method.name for method in found):
            panel.line([(method.instructions, error) for method, error in zip(found, errors) if method.name == name],
                       "grey", 0.7)
    panel.rule(0.5, "half a step")
    for variant, colour in colours.items():
        if compared not in (None, variant):
            continue
        own = [(method.instructions, error) for method, error in zip(found, errors) if method.variant == variant]
        panel.line(staircase(front(own), panel.x.high), colour, 1, dash=2)
    return panel


def power(figures):
    return methods(figures, "power", POWER_P, "cos^p, p = %s: error over instructions" % POWER_P, "call")


def normalise(figures):
    return methods(figures, "normalise", "", "One over a square root, and unit vectors: error over instructions", "call")


def exponent(figures):
    colours = variant_colours(figures, "power")
    chart = Chart("cos^p: error over the exponent p", [*colours.items(), ("thick: the library's", "ink")], 1020, 640,
                  right_labels=180)
    values = [float(row["p"]) for row in figures.accuracy if row["kind"] == "power"]
    panel = Panel("", grid(chart, 1, 1)[0], Axis("exponent p", min(values), max(values), True, [4.0**power for power in range(-1, 7)]),
                  Axis("largest error, steps of 8 bits", SMALLEST_ERROR, 300, log=True))
    for name, variant, shipped in figures.names("power"):
        pairs = [(p, max(error, SMALLEST_ERROR)) for p, error in figures.errors("power", name, variant)]
        panel.line(pairs, colours[variant], 3 if shipped else 1.2, label=name)
    panel.rule(0.5, "half a step", right=True)
    chart.panels.append(panel)
    return chart.svg()


# Of a panel: its axis, what one unit of the axis is, and its sweeps with what tells them apart.
SWEEPS = (("triangles, thousands", 1e-3, {"triangles": ""}),
          ("pixels of the screen, thousands", 1e-3, {"pixels": ""}),
          ("lights", 1, {"lights": ""}),
          ("objects of 192 triangles, side by side", 1, {"objects": ""}),
          ("objects that cover each other", 1, {"nearest_first": "nearest first", "farthest_first": "farthest first"}),
          ("objects that cover each other, general path", 1,
           {"nearest_first_general": "nearest first", "farthest_first_general": "farthest first"}))


def scaling(figures):
    colours = {"m3": "blue", "m0": "red"}
    chart = Chart("How the cost of a frame grows", [("Cortex-M3", "blue"), ("Cortex-M0", "red"),
                                                    ("lines: straight, fitted to the points", "grey")], 960, 1140)
    for (label, unit, sweeps), box in zip(SWEEPS, grid(chart, len(SWEEPS), 2)):
        rows = [row for sweep in sweeps for row in only(figures.scaling, sweep=sweep)]
        most = max(float(row["count"]) for row in rows) * unit
        panel = Panel("", box, Axis(label, 0, most * 1.08),
                      Axis("million instructions per frame", 0, max(int(row["instructions"]) for row in rows) / 1e6 * 1.1))
        for cpu, colour in colours.items():
            for sweep, name in sweeps.items():
                of_sweep = only(rows, cpu=cpu, sweep=sweep)
                start, slope = float(of_sweep[0]["line_start"]), float(of_sweep[0]["line_slope"])
                panel.line([(x, (start + slope * x / unit) / 1e6) for x in (0, most)], colour, 1.2)
                for row in of_sweep:
                    last = row is of_sweep[-1]
                    panel.point(float(row["count"]) * unit, int(row["instructions"]) / 1e6, name if last else "", colour)
        chart.panels.append(panel)
    return chart.svg()


# Of the lines over the number of lights: colours of the kinds, and the cores with their names and dashes.
LIGHT_COLOURS = dict(zip(LIGHTS, ("blue", "red", "gold")))
LIGHT_CORES = {"m3": ("glint, %s", 1), "m4f": ("good float, %s", 2)}


def lights(figures):
    chart = Chart("%s at %s: instructions over the number of lights" % (LIT, LIT_SIZE),
                  [("solid: glint on Cortex-M3", "ink"), ("dashed: good float on Cortex-M4 with FPU", "ink")], 820, 520,
                  right_labels=170)
    lines = {(kind, cpu): figures.over_lights(kind, cpu) for cpu in LIGHT_CORES for kind in LIGHTS}
    panel = Panel("", grid(chart, 1, 1)[0], Axis("lights", 0, max(LIGHT_COUNTS)),
                  Axis("million instructions per frame", 0, max(y for line in lines.values() for _, y in line) * 1.08))
    for (kind, cpu), line in lines.items():
        name, dash = LIGHT_CORES[cpu]
        panel.line(line, LIGHT_COLOURS[kind], 2, name % LIGHTS[kind][1], dash, marks=True)
    chart.panels.append(panel)
    return chart.svg()


def bus(figures):
    """Above the diagonal the bus takes longer than the core."""
    groups = ((timing.BENCHMARK[:1], "torus 320x240", "blue"), (timing.BENCHMARK[3:4], "torus 128x64", "red"),
              (timing.EXAMPLES[:1], "teapot", "teal"), (timing.EXAMPLES[3:4], "phong-lighting", "violet"),
              (timing.EXAMPLES[4:], "halloween", "gold"))
    chart = Chart("Time of a frame in RGB565: what the core takes against what the bus takes",
                  [(name, colour) for _, name, colour in groups] + [("above the line the bus takes longer", "grey")], 820, 560)
    low, high = 0.5, 3000
    panel = Panel("", grid(chart, 1, 1)[0], Axis("core, ms by the model of cycles", low, high, log=True),
                  Axis("bus, ms", low, 200, log=True))
    panel.line([(low, low), (200, 200)], "grey", 1, dash=2)
    for drawn, _, colour in groups:
        for frame in drawn:
            for part in figures.parts:
                panel.point(timing.core_ms(figures, frame, part), timing.bus_ms(frame[1], part), part["part"], colour)
    chart.panels.append(panel)
    return chart.svg()


# Of the chart over arenas: the scenes' colours.
ARENA_SCENES = {"torus2304": "blue", "spot": "red", "teapot": "teal", "halloween": "gold"}


def arena(figures):
    """Each scene against its frame of one pass; the last row of each is the arena where vertices stay."""
    chart = Chart("What a smaller arena costs, Cortex-M3", [(name, colour) for name, colour in ARENA_SCENES.items()], 820, 520)
    panel = Panel("", grid(chart, 1, 1)[0], Axis("arena, KB", 5, 1000, log=True),
                  Axis("instructions, times those of one pass", 0.9, 80, log=True))
    for scene, colour in ARENA_SCENES.items():
        rows = [(int(row["arena"]) / 1024, int(row["instructions"])) for row in only(figures.arena, scene=scene)]
        *steps, (kept, count) = rows
        panel.line([(x, y / steps[-1][1]) for x, y in sorted(rows)], colour, 1.5)
        panel.point(kept, count / steps[-1][1], "", colour)
    chart.panels.append(panel)
    return chart.svg()


CHARTS = {"power": power, "normalise": normalise, "frames": frames, "frames-scenes": frames_scenes,
          "exponent": exponent, "shading": shading, "scaling": scaling, "bus": bus, "arena": arena,
          "lights": lights}
