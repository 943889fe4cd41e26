# SPDX-License-Identifier: MIT
"""What frames take of a part's core, by the model of cycles (../cycles/costs.py), and of its bus."""
import math

from figures import one
from markdown import table

# Scene, size and look of `make bench`.
BENCHMARK = (("torus2304", "320x240", ""), ("torus576", "320x240", ""), ("torus576", "320x240", "8 points"),
             ("torus2304", "128x64", ""), ("torus576", "128x64", ""))
SMALL = (("cube", "128x64", ""), ("boxes20", "128x64", ""), ("boxes200", "320x240", ""))
EXAMPLES = (("teapot", "320x160", "fragment"), ("three-spheres", "320x160", "blinn-phong"),
            ("shaders", "320x180", "torus-50"), ("phong-lighting", "320x240", "near"), ("halloween", "320x240", "night"))

# Of a Cortex-M0 whose multiplier is the small one.
SLOW_MHZ = 48


def count(figures, frame, cpu, column="cycles", way="32x32"):
    """Of a frame, in millions."""
    scene, size, look = frame
    variant = " ".join([size, "local", way] + [look] * bool(look))
    return int(one(figures.bench, kind="frame", name=scene, variant=variant, cpu=cpu)[column]) / 1e6


def core_ms(figures, frame, part, way="32x32"):
    cpu = part["cpu"] + "f" * (way == "float")
    return count(figures, frame, cpu, way=way) * 1e3 / float(part["core_mhz"])


def bus_ms(size, part):
    """Of a frame's pixels at 16 bits."""
    return math.prod(map(int, size.split("x"))) * 16 / 1e3 / float(part["bus_mhz"])


def cell(value):
    return "%.0f" % value if value >= 99.5 else "%.1f" % value if value >= 9.95 else "%.2f" % value


def name_of(frame):
    return ", ".join([frame[0]] + [frame[2]] * bool(frame[2]))


def frame_times(figures):
    """Every part, a core whose multiplier is slow, and good float on the part with an FPU."""
    fpu = figures.parts[-1]
    head = ["frame", "size"]
    for part in figures.parts:
        head += ["%s, %s at %s MHz: million instructions" % (part["part"], part["core"], part["core_mhz"]), "ms"]
    head += ["Cortex-M0 at %d MHz that multiplies in 32 cycles: ms" % SLOW_MHZ, "good float, %s: million instructions" % fpu["part"], "ms"]
    rows = []
    for frame in BENCHMARK + SMALL + EXAMPLES:
        row = [name_of(frame), frame[1]]
        for part in figures.parts:
            row += [cell(count(figures, frame, part["cpu"], "instructions")), cell(core_ms(figures, frame, part))]
        row += [cell(count(figures, frame, "m0", "cycles_slow_multiply") * 1e3 / SLOW_MHZ),
                cell(count(figures, frame, "m4f", "instructions", "float")), cell(core_ms(figures, frame, fpu, "float"))]
        rows.append(row)
    return table(head, rows)
