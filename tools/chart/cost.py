# SPDX-License-Identifier: MIT
"""What choices cost, beside what they look like: torus576 at 320x240 in the benchmark's light, from `make bench`."""
import timing
from figures import one
from markdown import table

SCENE, SIZE = "torus576", "320x240"
PART = "STM32F103"
PLAIN = SIZE + " infinite 32x32 anew"  # what a scene and a configuration have that say nothing else

# Headings of a table, and of each row what it is, the look and the format that bench.csv has.
SHADING = (("unlit", "unlit", ""), ("flat: lit once a triangle", "per facet", ""), ("lit at vertices", "per vertex", ""),
           ("lit at fragments", "", ""))
MATERIALS = (("Blinn-Phong, s = 32", "", ""), ("s = 8", "p 8", ""), ("s = 256", "p 256", ""), ("Phong", "phong", ""),
             ("the larger of ambient and lit", "max", ""), ("colours of vertices", "mesh colours", ""),
             ("a texture of 64x64, RGB565", "textured", ""), ("the same, unlit", "textured unlit", ""),
             ("the same, unlit and bilinear", "textured unlit bilinear", ""))
LAYERS = (("opaque, no fog, one sample a pixel", "", ""), ("opacity of one half", "opacity", ""), ("added to what is behind", "added", ""),
          ("opacity of one half, dithered", "opacity dithered", ""), ("linear fog", "fog", ""), ("squared fog", "fog squared", ""),
          ("2x2 samples", "2x2 samples", ""))
# Drawn in the chart of that name too.
EDGES = (("RGB565", "", ""), ("dithered", "", "rgb565 dithered"), ("2x2 samples", "2x2 samples", ""),
         ("2x2 samples, dithered", "2x2 samples", "rgb565 dithered"))
LIGHTS = (("1 directional", "", ""), ("2 directional, from two sides", "2 directional", ""), ("1 point", "1 point", ""),
          ("4 points", "4 points", ""), ("8 points", "8 points", ""), ("1 spot", "1 spot", ""), ("4 spots", "4 spots", ""),
          ("8 spots", "8 spots", ""))
FORMATS = (("RGB565", "", ""), ("RGB565, dithered", "", "rgb565 dithered"), ("RGB444", "", "rgb444"),
           ("RGB444, dithered", "", "rgb444 dithered"), ("RGB888", "", "rgb888"),
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
    plain = instructions_and_ms(figures, PLAIN)[0]
    return [timing.cell(million), timing.cell(ms), "%.2f" % (million / plain)]


def picture(look, output):
    name = "-".join([look or "plain"] + [output] * bool(output)).replace(" ", "-")
    return '<img src="cost/%s.png" width="160" height="120" alt="%s">' % (name, name)


def choices(rows, *more):
    """A table of choices with their pictures, and of `more` columns: a heading, and the cell of a format."""
    def block(figures):
        head = ["", "", "million instructions, Cortex-M3", "ms, %s" % PART, "times the plain frame"] + [heading for heading, _ in more]
        return table(head, [[picture(look, output), what] +
                            price(figures, variant(look, output)) +
                            [cell(figures, output) for _, cell in more] for what, look, output in rows])
    return block


def variant(look, output):
    return " ".join([PLAIN] + [word for word in (look, output) if word])


def edges(figures):
    """How near edges come to 64 samples a pixel."""
    head = ["", "", "million instructions, Cortex-M3", "ms, %s" % PART, "times the plain frame", "PSNR, dB", "PSNR of edges, dB"]
    rows = []
    for what, look, output in EDGES:
        row = one(figures.edges, look=look, format=output)
        rows.append([picture(look, output), what] + price(figures, variant(look, output)) + [row["psnr_db"], row["edges_psnr_db"]])
    return table(head, rows)


def mean_error(figures, output):
    """Of means over 5x5 pixels: what is left of rounding from a distance."""
    return "%.2f" % float(one(figures.means, format=output or "rgb565")["mean_rms_lsb8"])


def tiles(figures):
    """Tile sizes and shares of the arena: the same picture."""
    rows = [("by default", PLAIN), ("materials kept by `keeps_arena`", SIZE + " infinite 32x32"), ("local viewer", SIZE + " local 32x32 anew"),
            ("local viewer, materials kept", SIZE + " local 32x32")]
    rows += [("and tiles of " + size, "%s local %s" % (SIZE, size)) for size in ("16x16", "32x16", "64x32", "64x64")]
    rows += [("and %s of the arena" % share, "%s local 32x32 %s" % (SIZE, share)) for share in ("half", "quarter", "sixteenth")]
    return table(["", "million instructions, Cortex-M3", "ms, %s" % PART, "times the plain frame"],
                 [[what] + price(figures, variant) for what, variant in rows])


BLOCKS = {"cost shading": choices(SHADING), "cost materials": choices(MATERIALS), "cost layers": choices(LAYERS), "cost edges": edges, "cost lights": choices(LIGHTS),
          "cost formats": choices(FORMATS, ("rms error of 5x5 means, steps of 255", mean_error)), "cost tiles": tiles}
