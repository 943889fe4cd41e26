# SPDX-License-Identifier: MIT
"""What choices cost, beside what they look like: torus576 at 320x240 in the benchmark's light, from `make bench`."""
import timing
from figures import one
from markdown import table

SCENE, SIZE = "torus576", "320x240"
PART = "STM32F103"

# Headings of a table, and of each row what it is, the look and the format that bench.csv has.
SHADING = (("unlit", "unlit", ""), ("flat: lit once a triangle", "per facet", ""), ("lit at vertices", "per vertex", ""),
           ("lit at fragments", "", ""))
MATERIALS = (("Blinn-Phong, s = 32", "", ""), ("s = 8", "p 8", ""), ("s = 256", "p 256", ""), ("Phong", "phong", ""),
             ("the larger of ambient and lit", "max", ""), ("colours of vertices", "mesh colours", ""))
LIGHTS = (("1 directional", "", ""), ("2 directional, from two sides", "2 directional", ""), ("1 point", "1 point", ""),
          ("4 points", "4 points", ""), ("8 points", "8 points", ""), ("1 spot", "1 spot", ""), ("4 spots", "4 spots", ""),
          ("8 spots", "8 spots", ""))
FORMATS = (("RGB565", "", ""), ("RGB444", "", "rgb444"), ("RGB444, dithered", "", "rgb444 dithered"), ("RGB888", "", "rgb888"),
           ("256 greys", "", "grey8"), ("16 greys", "", "grey4"), ("16 greys, dithered", "", "grey4 dithered"),
           ("1 bit", "", "mono"), ("1 bit, dithered", "", "mono dithered"))


def instructions_and_ms(figures, variant):
    """On Cortex-M3: millions of instructions, milliseconds on PART."""
    row = one(figures.bench, kind="frame", name=SCENE, variant=variant, cpu="m3")
    part = one(figures.parts, part=PART)
    return int(row["instructions"]) / 1e6, int(row["cycles"]) / 1e3 / float(part["core_mhz"])


def price(figures, variant):
    """Cells: millions, milliseconds, and times those of the plain frame."""
    million, ms = instructions_and_ms(figures, variant)
    plain = instructions_and_ms(figures, "%s local 32x32" % SIZE)[0]
    return [timing.cell(million), timing.cell(ms), "%.2f" % (million / plain)]


def picture(look, output):
    name = "-".join([look or "plain"] + [output] * bool(output)).replace(" ", "-")
    return '<img src="cost/%s.png" width="160" height="120" alt="%s">' % (name, name)


def choices(rows):
    """A table of choices with their pictures."""
    def block(figures):
        head = ["", "", "million instructions, Cortex-M3", "ms, %s" % PART, "times the plain frame"]
        return table(head, [[picture(look, output), what] +
                            price(figures, " ".join(["%s local 32x32" % SIZE] + [word for word in (look, output) if word]))
                            for what, look, output in rows])
    return block


def tiles(figures):
    """Tile sizes and shares of the arena: the same picture."""
    rows = [("tiles of " + size, "%s local %s" % (SIZE, size)) for size in ("16x16", "32x16", "32x32", "64x32", "64x64")]
    rows += [("%s of the arena of one pass" % share, "%s local 32x32 %s" % (SIZE, share)) for share in ("half", "quarter", "sixteenth")]
    rows += [("infinite viewer", "%s infinite 32x32" % SIZE), ("materials anew each frame", "%s local 32x32 anew" % SIZE)]
    return table(["", "million instructions, Cortex-M3", "ms, %s" % PART, "times the plain frame"],
                 [[what] + price(figures, variant) for what, variant in rows])


BLOCKS = {"cost shading": choices(SHADING), "cost materials": choices(MATERIALS), "cost lights": choices(LIGHTS),
          "cost formats": choices(FORMATS), "cost tiles": tiles}
