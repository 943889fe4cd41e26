# SPDX-License-Identifier: MIT
"""What every chart of docs/charts shows: rows of (panel, series, x, y), which the gnuplot script of that name draws."""
import cost
import timing
from figures import ASKED, CPUS, LIGHTS, front, one, only

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


def frames_panel(figures, title, cpu):
    scene, size, lights = "torus2304", "320x240", "1 directional"
    rows = [(title, "per " + choice, figures.instructions(scene, lights, choice, cpu), figures.psnr(scene, size, choice))
            for choice in figures.choices()]
    with_fpu = "m4f" if cpu == "m4" else cpu
    rows += [(title, "%s, %s" % (row["library"], row["mode"]), float(row["million_instructions"]), float(row["psnr_db"]))
             for row in only(figures.others, scene=scene, size=size, cpu=with_fpu) if row["psnr_db"]]
    if cpu == "m4":
        rows.append((title, "good float, per fragment", figures.good_float(scene, size), figures.float_psnr(scene, lights, ASKED)))
    points = [row[2:] for row in rows]
    return rows + best(title, BEST, points, largest=True) + level(title, ROUNDED, figures.psnr(scene, size, "correctly rounded"), points)


def frames(figures):
    return [row for cpu, more in (("m4", ", others with FPU"), ("m3", ""), ("m0", ""))
            for row in frames_panel(figures, CPUS[cpu] + more, cpu)]


def ways(figures):
    """Each choice by kind of light and core, from the fewest lights to the most."""
    cores = {**CPUS, "m4f": "good float (M4F)"}
    return [("%s: %s" % (core, LIGHTS[kind][1]), "per " + choice, million, psnr) for kind in LIGHTS for cpu, core in cores.items()
            for choice in figures.choices() for _, million, psnr in figures.over_lights(kind, cpu, choice)]


def shading(figures):
    return [(row["format"].upper() + " over " + key, "per " + row["evaluation"], float(row[key]) * scale, float(row["rms"]))
            for format in dict.fromkeys(row["format"] for row in figures.shading)
            for key, scale in (("triangles", 1), ("instructions", 1e-6)) for row in only(figures.shading, format=format)]


def worst(figures, kind, variant, name):
    """The largest error over the exponents of the contract."""
    return "%.4g" % max(max(error, SMALLEST_ERROR) for p, error in figures.errors(kind, name, variant) if p == 0 or 1 <= p <= 1024)


def methods(kind, p):
    """Error over instructions of every method of a kind on each core, and its largest over exponents. Methods of one variant do the
    same work from the same input, so that each variant has a front of its own."""
    def of(figures):
        rows = []
        for cpu in figures.cpus(only(figures.bench, kind=kind)):
            found = figures.methods(kind, cpu, p)
            points = {(method.variant, method.name): (method.instructions, max(method.error, SMALLEST_ERROR)) for method in found}
            rows += [(CPUS[cpu], "%s: %s" % key, *point, worst(figures, kind, *key)) for key, point in points.items()]
            for variant in dict.fromkeys(key[0] for key in points):
                rows += best(CPUS[cpu], "%s, %s" % (variant, BEST), [point for key, point in points.items() if key[0] == variant])
            rows += level(CPUS[cpu], HALF, 0.5, list(points.values()))
        return rows
    return of


# Of colours, in the table of regions, and the least error that is drawn.
STEPS, SMALLEST_STEPS = "steps of 255", 0.1


def regions(figures):
    """By topic, a row for each region where plain methods fail: the plain method, the library and its bound."""
    rows, y, topic = [], 0, None
    for row in only(figures.regions, unit=STEPS):
        plain, own, bound = (max(float(row[column]), SMALLEST_STEPS) for column in ("plain", "rgb888", "rgb888_bound"))
        if row["topic"] != topic:
            topic = row["topic"]
            rows.append((topic, "topic", SMALLEST_STEPS, y, topic))
            y += 1
        rows += [(row["region"], "contract", bound, y), (row["region"], "glint", own, y, "%.4f" % plain),
                 (row["region"], "plain method", plain, y, "", row["region"], row["plain_method"])]
        y += 1
    return rows


def bus(figures):
    """Above the diagonal the bus takes longer than the core."""
    return [(part["part"], timing.name_of(frame) + " " + frame[1], timing.core_ms(figures, frame, part), timing.bus_ms(frame[1], part))
            for part in figures.parts
            for frame in (timing.BENCHMARK[0], timing.BENCHMARK[3], timing.EXAMPLES[0], timing.EXAMPLES[3], timing.EXAMPLES[4])]


def arena(figures):
    """Each scene against its frame of one pass; the last row of each is the arena where vertices stay."""
    rows = []
    for scene in dict.fromkeys(row["scene"] for row in figures.arena):
        *steps, kept = [(int(row["arena"]) / 1024, int(row["instructions"])) for row in only(figures.arena, scene=scene)]
        rows += [("", scene, x, y / steps[-1][1]) for x, y in sorted(steps + [kept])]
        rows.append(("", scene + ", vertices stay", kept[0], kept[1] / steps[-1][1]))
    return rows


def edges(figures):
    """Edges of the object over what the frame costs: without samples and with, dithered and not."""
    return [("edges", what, cost.instructions_and_ms(figures, cost.variant(look, output))[0],
             float(one(figures.edges, look=look, format=output)["edges_psnr_db"])) for what, look, output in cost.EDGES]


def depth(figures):
    """Errors over the depth ratio: of colours with each evaluation, and of depth, which all share."""
    rows = []
    for panel, column in (("mean error of colours, steps of 255", "mean_lsb8"), ("largest error of colours, steps of 255", "max_lsb8")):
        rows += [(panel, "per " + row["evaluation"], 2.0 ** int(row["log2_ratio"]), float(row[column])) for row in figures.depth]
    return rows + [("mean error of depth, %", "any evaluation", 2.0 ** int(row["log2_ratio"]), float(row["depth_percent"]))
                   for row in only(figures.depth, evaluation="facet")]


CHARTS = {"ways": ways, "frames": frames, "regions": regions, "power": methods("power", POWER_P), "normalise": methods("normalise", ""),
          "shading": shading, "depth": depth, "bus": bus, "arena": arena, "edges": edges}
