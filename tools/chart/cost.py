# SPDX-License-Identifier: MIT
"""What choices cost, beside what they look like: torus576 at 320x240 in the benchmark's light, from `make bench`."""
import timing
from figures import one, only
from table import table

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


def budgets(figures):
    """Error budgets, in steps of the format."""
    rows = [row for row in only(figures.modelled_counts, scene=SCENE, size=SIZE, cpu="m3") if row["way"].startswith(("exact", "budget"))]
    exact = int(one(rows, way="exact")["instructions"])
    return table(["", "million instructions, Cortex-M3", "times those without"],
                 [[row["way"].replace("exact", "without").replace("budget", "error budget of") + " steps" * (row["way"] != "exact"),
                   timing.cell(int(row["instructions"]) / 1e6), "%.2f" % (int(row["instructions"]) / exact)] for row in rows])


# Columns of prices, and what they are called.
PRICED = {"instructions_m0": "instructions, Cortex-M0", "instructions_m3": "Cortex-M3", "instructions_m4": "Cortex-M4",
          "instructions_rv32": "RV32IMC", "cycles_m0": "cycles, Cortex-M0 that multiplies in 32", "cycles_m0plus": "Cortex-M0+",
          "cycles_m3": "Cortex-M3", "cycles_m4": "Cortex-M4"}


def prices(figures):
    """What each item of a frame takes; items that add nothing are left out."""
    def cell(row, column):
        return "%.4g" % float(row[column]) if float(row[column]) < 1e4 else "%.0f" % float(row[column])
    return table(["one", *PRICED.values()], [[row["one"]] + [cell(row, column) for column in PRICED] for row in figures.prices
                                             if any(float(row[column]) for column in PRICED)])


def judged_prices(columns, is_shown):
    """What they are off by on frames that they were not fitted to, percent: those whose variant is shown."""
    def block(figures):
        judged = [row for row in figures.judged_prices if is_shown(row["variant"])]
        rows, errors = [], {column: [float(row["error_percent"]) for row in only(judged, column=column)] for column in columns}
        for name, variant in dict.fromkeys((row["name"], row["variant"]) for row in judged):
            rows.append(["%s, %s" % (name, variant.replace(" local 32x32", ""))] +
                        [one(judged, name=name, variant=variant, column=column)["error_percent"] for column in columns])
        for what, of in (("mean, without sign", lambda values: sum(values) / len(values)), ("worst", max)):
            rows.append(["**%s**" % what] + ["**%.1f**" % of(list(map(abs, errors[column]))) for column in columns])
        return table(["off by, %"] + [PRICED[column] for column in columns], rows)
    return block


# Frames of the benchmark name size and tiles; pictures of the gallery have been counted on two cores.
judged_frames = judged_prices(list(PRICED), lambda variant: " " in variant)
judged_pictures = judged_prices(["instructions_m0", "instructions_m3"], lambda variant: " " not in variant)


BLOCKS = {"cost shading": choices(SHADING), "cost materials": choices(MATERIALS), "cost lights": choices(LIGHTS),
          "cost formats": choices(FORMATS), "cost tiles": tiles, "cost budgets": budgets,
          "cost prices": prices, "cost judged": judged_frames, "cost pictures": judged_pictures}
