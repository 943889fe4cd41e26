# SPDX-License-Identifier: MIT
"""What docs/accuracy.md says of what scenes model, and of what dropping and error budgets save."""
from figures import CPUS, only
from table import bullets, listed, table

KERNELS = ("general", "ambient", "diffuse", "gated", "specular", "curved_diffuse", "curved_specular", "even", "channels")

# Of pairs of a triangle and a tile: those whose kernel looks at no specular light, and at no light at all. The general
# kernel looks fragment by fragment.
MATT, UNLIT = ("diffuse", "gated", "curved_diffuse", "even"), ("ambient",)

BUDGETS = (1, 2, 4)

# Of which nothing can be dropped: what looking for it takes.
CONTROL = "plane"


def mean(rows, key):
    return sum(float(row[key]) for row in rows) / len(rows)


def sizes(figures):
    """@return scene and size of all that was drawn, but for the control"""
    return list(dict.fromkeys((row["scene"], row["size"]) for row in figures.modelled if row["scene"] != CONTROL))


def in_way(figures, scene, size, way):
    return only(figures.modelled, scene=scene, size=size, way=way)


def budget_that_shows(figures, scene, size):
    """The largest budget, where kernels tell it from none."""
    way = "budget %d" % BUDGETS[-1]
    mix = [[[row[kernel + "_covered"] for kernel in KERNELS] for row in in_way(figures, scene, size, which)]
           for which in ("exact", way)]
    return [way] if mix[0] != mix[1] else []


def kernels(figures):
    """Pixels that each kernel covers."""
    rows = []
    for scene, size in sizes(figures):
        for way in ["exact"] + budget_that_shows(figures, scene, size):
            drawn = in_way(figures, scene, size, way)
            parts = {kernel: mean(drawn, kernel + "_parts") for kernel in KERNELS}
            rows.append([scene, size, way] + ["%.0f" % mean(drawn, kernel + "_covered") for kernel in KERNELS] +
                        ["%.0f" % sum(parts.values())] +
                        ["%.0f" % sum(parts[kernel] for kernel in which) for which in (("general",), MATT, UNLIT)])
    return table(["scene", "size", "drawn"] + [kernel.replace("_", " ") for kernel in KERNELS] +
                 ["pairs", "general", "without specular", "unlit"], rows)


def lightings(figures):
    """What the general kernel and vertices leave out, where they light anything."""
    rows = []
    for scene, size in sizes(figures):
        drawn = in_way(figures, scene, size, "undropped")
        count = mean(drawn, "lightings")
        dropped = [mean(drawn, key) for key in ("facing_away", "out_of_reach", "no_highlight")]
        if count >= 1:
            rows.append([scene, size, "%.0f" % count] + ["%.1f" % (100 * part / count) for part in dropped] +
                        ["%.1f" % (100 * (1 - sum(dropped) / count))])
    return table(["scene", "size", "lit, times lights", "facing away, %", "out of reach, %", "without highlight, %",
                  "in full, %"], rows)


def instructions(figures, scene, size, way, cpu):
    """Of a frame, in millions, the mean of its variants."""
    return mean(only(figures.modelled_counts, scene=scene, size=size, way=way, cpu=cpu), "instructions") / 1e6


def price_of_looking(figures, light):
    """What is looked for and not found takes so much of the control, percent."""
    counts = {row["way"]: int(row["instructions"])
              for row in only(figures.modelled_counts, scene=CONTROL, variant=light, cpu="m3")}
    return 100 * (1 - counts["undropped"] / counts["exact"])


def saved(figures, scene, size, way, against, cpu):
    """Percent."""
    return 100 * (1 - instructions(figures, scene, size, way, cpu) / instructions(figures, scene, size, against, cpu))


def largest(figures, scene, size, way):
    """The largest error, steps."""
    return max(int(row["largest_steps"]) for row in in_way(figures, scene, size, way))


def percent(value):
    return "%.1f" % (value if abs(value) >= 0.05 else 0)


def savings(figures):
    cpus = figures.cpus(figures.modelled_counts)
    rows = []
    for cpu in reversed(cpus):
        for scene, size in sizes(figures):
            rows.append([CPUS[cpu], scene, size] +
                        ["%.2f" % instructions(figures, scene, size, way, cpu) for way in ("undropped", "exact")] +
                        [percent(saved(figures, scene, size, "exact", "undropped", cpu))] +
                        [cell for budget in BUDGETS for way in ["budget %d" % budget]
                         for cell in ("%.2f" % instructions(figures, scene, size, way, cpu),
                                      percent(saved(figures, scene, size, way, "exact", cpu)),
                                      "%d" % largest(figures, scene, size, way))])
    return table(["core", "scene", "size", "nothing dropped", "as shipped", "saved, %"] +
                 [title for budget in BUDGETS for title in ("budget %d" % budget, "saved, %", "largest error, steps")], rows)


def between(values):
    low, high = percent(min(values)), percent(max(values))
    return low if low == high else "%s to %s" % (low, high)


def findings(figures):
    """Sentences with what was measured on Cortex-M3."""
    benchmark = [key for key in sizes(figures) if any(row["scene"] == key[0] for row in figures.frames)]
    gallery = [key for key in sizes(figures) if key not in benchmark]
    lines = ["Dropping saves %s %% of a benchmark frame and %s %% of a gallery frame on Cortex-M3, with every bit kept." % tuple(
        between([saved(figures, *key, "exact", "undropped", "m3") for key in group]) for group in (benchmark, gallery))]
    lines.append("Where nothing can be dropped, on a plane that is lit and in its highlight all over, looking for it takes %s %% "
                 "of the frame with a directional light and %s %% with a point light, which the general kernel draws." % (
                     percent(price_of_looking(figures, "directional")), percent(price_of_looking(figures, "point"))))
    for budget in BUDGETS:
        way = "budget %d" % budget
        gain = {key: saved(figures, *key, way, "exact", "m3") for key in sizes(figures)}
        best = max(gain, key=gain.get)
        lines.append("A budget of %d %s saves %s %% of a benchmark frame, %s %% of a gallery frame, most on %s at %s; no channel is "
                     "off by more than %d." % (
                         budget, "step" if budget == 1 else "steps", between([gain[key] for key in benchmark]),
                         between([gain[key] for key in gallery]), *best,
                         max(largest(figures, *key, way) for key in gain)))
        dearer = ["%s at %s (%.1f %%)" % (*key, -gain[key]) for key in gain if percent(gain[key]).startswith("-")]
        if dearer:
            lines.append("It takes more instructions than no budget on %s: what it spares does not pay for what it looks "
                         "at." % listed(dearer))
    return bullets(lines)
