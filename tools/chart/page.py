# SPDX-License-Identifier: MIT
"""What pages say in figures: each block of text between a page's markers, as a function of the figures."""
import os
import sys
import textwrap

import cost
import timing
from figures import ASKED, CPUS, LIGHTS, front, one, only

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import markdown  # noqa: E402
from markdown import bullets, listed, table  # noqa: E402

EXPONENTS = ("1", "2", "8", "32", "64", "256", "1024")

# What the contract asks for in every frame, and the columns of frames that keep it and of all their pixels.
CLAUSES = (
    ("RGB565: 99.9 % within the bound", "rgb565", "frames_within_bound", "within_bound_percent"),
    ("RGB888: 99.9 % within the bound", "rgb888", "frames_within_bound", "within_bound_percent"),
    ("RGB565: 99.99 % within one step of the rounded reference", "rgb565", "frames_within_one", "within_one_percent"),
    ("RGB888: 99.99 % within one step of the rounded reference", "rgb888", "frames_within_one", "within_one_percent"),
    ("RGB565: all within two", "rgb565", "frames_within_two", "within_two_percent"),
    ("RGB888: all within two", "rgb888", "frames_within_two", "within_two_percent"),
)

# The frame that figures in words are about, and the likeness that it is to have.
SCENE, SIZE, LIGHT, LEAST_PSNR = "torus2304", "320x240", "1 directional", 41.5

# The same lighting in float, well made; beside the library it is measured with an FPU.
GOOD_FLOAT = "good float"


def row_name(row):
    return "%s %s, %s, p = %s: %%s" % (row["scene"], row["size"], row["choice"], row["p"])


def contract(figures):
    """In how many frames the contract is met, and where it is missed."""
    own = only(figures.frames, against="own")
    rows = []
    for title, kind, key, share in CLAUSES:
        judged = only(own, format=kind)
        missed = [row_name(row) % ("%d of %s frames, %s %% of all their pixels within" % (
            int(row["frames"]) - int(row[key]), row["frames"], row[share])) for row in judged if row[key] != row["frames"]]
        rows.append([title, "%d of %d frames" % (sum(int(row[key]) for row in judged),
                                                 sum(int(row["frames"]) for row in judged)), "; ".join(missed) or "nowhere"])
    psnr = figures.psnr(SCENE, SIZE, ASKED)
    rows.append(["%s at %s, local viewer: at least %.1f dB" % (SCENE, SIZE, LEAST_PSNR),
                 "%d of 1" % (psnr >= LEAST_PSNR), "%.2f dB" % psnr])
    shown = [row for row in own if row["format"] == "rgb565"]
    return table(["contract", "met in", "missed in"], rows) + (
        "\nLeft out because N.L is within 2 / 2^15 of 0, where a highlight begins at once: %d of %d pixels.\n" % (
            sum(int(row["left_out"]) for row in shown), sum(int(row["pixels"]) for row in shown)))


def steps(figures):
    """The largest errors of Blinn-Phong over both sizes and viewers."""
    rows = []
    for kind, title in (("rgb565", "RGB565"), ("rgb888", "RGB888")):
        for scene in dict.fromkeys(row["scene"] for row in figures.frames):
            judged = [row for row in only(figures.frames, scene=scene, format=kind, against="own")
                      if "Blinn-Phong" in row["choice"]]
            rows.append([title, scene] + ["%.2f" % max(float(row["worst_steps"]) for row in only(judged, p=p))
                                          for p in EXPONENTS])
    return table(["largest error, steps of", "scene"] + ["p = " + p for p in EXPONENTS], rows)


def gallery(figures):
    """The example scenes: the worst of each over its variants."""
    rows = []
    for scene, kind in dict.fromkeys((row["scene"], row["format"]) for row in figures.gallery):
        judged = only(figures.gallery, scene=scene, format=kind)
        worst = max(judged, key=lambda row: float(row["worst_over_bound"]))
        rows.append([scene, kind.upper(), "%d" % len(judged), "%d" % sum(int(row["pixels"]) for row in judged),
                     "%d" % sum(int(row["missed"]) for row in judged)] +
                    ["%.7g" % min(float(row[key]) for row in judged)
                     for key in ("within_bound_percent", "within_one_percent", "within_two_percent")] +
                    ["%s of the bound (%s steps), in %s" % (worst["worst_over_bound"], worst["worst_steps"],
                                                            worst["variant"])])
    return table(["scene", "format", "variants", "pixels", "coverage differs", "within the bound, %", "within one step, %",
                  "within two, %", "worst pixel"], rows)


def frames(figures):
    cpus = list(CPUS)
    rows = []
    for choice in figures.choices():
        evaluation, rest = choice.split(" ", 1)
        rows.append(["per " + evaluation, rest, "%.1f" % figures.psnr(SCENE, SIZE, choice)] +
                    ["%.2f" % figures.instructions(SCENE, LIGHT, choice, cpu) for cpu in cpus])
    return table(["evaluation", "model and viewer", "PSNR, dB"] + ["million instructions, " + CPUS[cpu] for cpu in cpus],
                 rows)


def scenes(figures):
    """The exact image of every benchmark scene, and what it takes."""
    cpus = list(CPUS)
    rows = []
    for scene, size in figures.benchmark():
        floats = {row["library"]: row["million_instructions"] for row in figures.others
                  if (row["scene"], row["size"], row["cpu"]) == (scene, size, "m4f")}
        floats.update((GOOD_FLOAT, "%.2f" % million) for name, look, shown, million in with_fpu(figures)
                      if (name, look, shown) == (scene, "", size))
        rows.append([scene, size, "%.1f" % figures.psnr(scene, size, ASKED),
                     "%.1f" % figures.psnr(scene, size, "correctly rounded")] +
                    ["%.2f" % figures.asked(scene, size, cpu) for cpu in cpus] +
                    [floats.get(name, "") for name in (GOOD_FLOAT, "TGX")])
    return table(["scene", "size", "PSNR, dB", "RGB565 allows"] + ["million instructions, " + CPUS[cpu] for cpu in cpus] +
                 [GOOD_FLOAT + ", Cortex-M4 with FPU", "TGX per vertex, the same"], rows)


def times(ratio):
    return ("%.0f times" if ratio >= 10 else "%.1f times") % ratio


def others(figures):
    """Other libraries' instructions as multiples of those that the library's exact image takes."""
    cpus = [cpu for cpu in CPUS if cpu != "rv32"]
    own = {cpu: figures.asked(SCENE, SIZE, cpu) for cpu in cpus}
    rows = [["**glint**", "per fragment", "%.1f" % figures.psnr(SCENE, SIZE, ASKED)] +
            ["%.2f" % own[cpu] for cpu in cpus]]
    measured = only(figures.others, scene=SCENE, size=SIZE)
    for library, mode in dict.fromkeys((row["library"], row["mode"]) for row in measured):
        of = only(measured, library=library, mode=mode)
        counts = {row["cpu"].replace("m4f", "m4"): row["million_instructions"] for row in of}
        rows.append([library, mode, of[0]["psnr_db"]] +
                    ["%s (%s)" % (counts[cpu], times(float(counts[cpu]) / own[cpu])) if cpu in counts else ""
                     for cpu in cpus])
    for name, look, size, million in with_fpu(figures):
        if (name, look, size) == (SCENE, "", SIZE):
            rows.append([GOOD_FLOAT, "per fragment", "%.1f" % figures.float_psnr(SCENE, LIGHT, ASKED)] +
                        ["%.2f (%s)" % (million, times(million / own[cpu])) if cpu == "m4" else "" for cpu in cpus])
    return table(["library", "mode", "PSNR, dB"] + ["million instructions, " + CPUS[cpu] +
                                                    (" with FPU" if cpu == "m4" else "") for cpu in cpus], rows)


def with_fpu(figures):
    """@return (scene, look, size, million instructions of good float on Cortex-M4 with FPU) of frames of `make bench`"""
    found = []
    for row in only(figures.bench, kind="frame", cpu="m4f"):
        size, _, look = row["variant"].partition(" local float")
        found.append((row["name"], look.strip(), size, int(row["instructions"]) / 1e6))
    return found


def examples_beside_float(figures):
    """@return (scene and look, size, {core: million instructions}, those of good float with an FPU) of example scenes and of boxes"""
    own = {scene for scene, _ in figures.benchmark()}
    found = []
    for scene, look, size, million in with_fpu(figures):
        if scene in own:
            continue
        variant = " ".join([size, "local 32x32"] + [look] * bool(look))
        counts = {row["cpu"]: int(row["instructions"]) / 1e6
                  for row in only(figures.bench, kind="frame", name=scene, variant=variant)}
        found.append((", ".join([scene] + [look] * bool(look)), size, counts, million))
    return found


def examples_in_float(figures):
    """The first look of each scene."""
    first = {name.split(",")[0]: name for name, *_ in reversed(examples_beside_float(figures))}
    return table(["scene", "size", "glint, million instructions, Cortex-M0", "Cortex-M3", GOOD_FLOAT + ", Cortex-M4 with FPU",
                  "glint, Cortex-M3, against that"],
                 [[name, size, "%.2f" % counts["m0"], "%.2f" % counts["m3"], "%.2f" % million, times(counts["m3"] / million)]
                  for name, size, counts, million in examples_beside_float(figures) if name in first.values()])


def benchmark_beside_float(figures):
    """Where float takes less than the library's exact image, and where more."""
    own = figures.benchmark()
    fewer, more = [], []
    for scene, look, size, million in with_fpu(figures):
        if (scene, size) in own and not look:
            count = figures.asked(scene, size, "m4")
            (fewer if million < count else more).append("%s at %s (%.2f million, glint %.2f)" % (scene, size, million, count))
    sentences = ["With an FPU, good float takes fewer instructions than glint in %s." % listed(fewer)] if fewer else []
    return " ".join(sentences + (["It takes more in %s." % listed(more)] if more else []))


def cycles_beside_float(figures):
    """By the model of cycles."""
    ratios = {frame: timing.count(figures, frame, "m4") / timing.count(figures, frame, "m4f", way="float")
              for frame in timing.BENCHMARK + timing.SMALL + timing.EXAMPLES}
    less = [frame for frame in ratios if ratios[frame] <= 1]
    said = ["%s at %s (%.2f times)" % (timing.name_of(frame), frame[1], ratios[frame]) for frame in less]
    return ("In cycles, [as they are modelled](boards.md#milliseconds-of-a-frame), glint on Cortex-M4 takes less than good float "
            "with an FPU in %s, and %.1f to %s as many in the other %d frames that are listed there." % (
                listed(said), min((ratio for ratio in ratios.values() if ratio > 1), default=1), times(max(ratios.values())),
                len(ratios) - len(less)) if less else "In cycles glint takes more than good float everywhere.")


def examples_behind_float(figures):
    ratios = [counts["m3"] / million for _, _, counts, million in examples_beside_float(figures)]
    behind = [ratio for ratio in ratios if ratio > 1]
    return ("In %d of all %d frames good float with an FPU takes fewer instructions; there glint takes %.1f to %s as "
            "many." % (len(behind), len(ratios), min(behind), times(max(behind))) if behind else
            "In these frames glint takes fewer instructions than good float with an FPU.")


def psnr_range(figures, evaluation, choices):
    """The least and the largest PSNR of an evaluation over all lights."""
    values = [psnr for kind in LIGHTS for choice in choices
              for _, _, psnr in figures.over_lights(kind, "m3", "%s %s" % (evaluation, choice))]
    return min(values), max(values)


def worth_of_evaluations(figures):
    shading = dict.fromkeys(choice.split(" ", 1)[1] for choice in figures.choices())
    return ("Per fragment, Blinn-Phong with a local viewer has %.1f to %.1f dB under all of these lights. No way per vertex has more "
            "than %.1f dB there, and none per facet more than %.1f." % (
                *psnr_range(figures, "fragment", ["Blinn-Phong local"]), psnr_range(figures, "vertex", shading)[1],
                psnr_range(figures, "facet", shading)[1]))


def eight_lights_take(figures):
    """In place of one, by evaluation."""
    def ratios(*evaluations):
        pairs = [figures.over_lights(kind, "m3", evaluation + " Blinn-Phong local") for kind in LIGHTS for evaluation in evaluations]
        found = [pair[-1][1] / pair[0][1] for pair in pairs]
        return min(found), max(found)

    return ("Eight lights in place of one take %.1f to %.1f times the instructions per facet and per vertex, and %.1f to %.1f times "
            "per fragment, on Cortex-M3 (Blinn-Phong, local viewer)." % (*ratios("facet", "vertex"), *ratios("fragment")))


def each_light_takes(figures):
    """On average from the third light on; the first brings what the frame takes besides."""
    millions = {alone: {count: million for count, million, _ in figures.over_lights(kind, "m3")} for kind, (alone, _) in LIGHTS.items()}
    return "From two lights to eight each one more takes %s million instructions there on average." % listed(
        ["%.2f (%s)" % ((many[8] - many[2]) / 6, alone) for alone, many in millions.items()])


def many_lights_beside_float(figures):
    ratios = [figures.over_lights(kind, "m3")[-1][1] / figures.over_lights(kind, "m4f")[-1][1] for kind in LIGHTS]
    return "With eight lights glint takes %.1f to %s as many instructions as good float with an FPU." % (min(ratios), times(max(ratios)))


def best(figures):
    """Sentences before all else."""
    exact = figures.psnr(SCENE, SIZE, ASKED)
    ideal = figures.psnr(SCENE, SIZE, "correctly rounded")
    counts = {cpu: figures.asked(SCENE, SIZE, cpu) for cpu in ("m3", "m0")}
    spent = {part["cpu"]: "%.0f ms at %s MHz" % (timing.core_ms(figures, (SCENE, SIZE, ""), part), part["core_mhz"]) for part in figures.parts}
    text = ("Lit per fragment, a torus of 2304 triangles at 320x240 has a PSNR of %.1f dB against double precision, where RGB565 "
            "itself allows %.1f. Built for speed (`-O2`), a frame of it takes %.1f million instructions on a Cortex-M3 and %.1f on "
            "a Cortex-M0: %s and %s by a [model of cycles](boards.md#milliseconds-of-a-frame). "
            "[Whole frames](#whole-frames) holds that against other libraries and against float, and says where those "
            "take fewer." % (exact, ideal, counts["m3"], counts["m0"], spent["m3"], spent["m0"]))
    return textwrap.fill(text, 118, break_on_hyphens=False, break_long_words=False) + "\n"


def format_count(value):
    return "%.0f" % value if value >= 99.5 else "%.1f" % value


def format_error(value):
    return "%.2f" % value if value < 10 else "%.0f" % value


def best_for_price(found):
    """@return name and variant of the methods that none of their variant beats in both"""
    kept = set()
    for variant in {method.variant for method in found}:
        own = [method for method in found if method.variant == variant]
        best = front([(method.instructions, method.error) for method in own])
        kept |= {(method.name, variant) for method in own if (method.instructions, method.error) in best}
    return kept


def emphasised(text, strong):
    return "**%s**" % text if strong else text


def methods(kind, p, exponents, of="of"):
    """A block of every method of a kind: errors and instructions; bold are the library's, and the best for their price."""
    def block(figures):
        cpus = figures.cpus(only(figures.bench, kind=kind))
        found = {cpu: {(method.name, method.variant): method for method in figures.methods(kind, cpu, p)} for cpu in cpus}
        best = {cpu: best_for_price(found[cpu].values()) for cpu in cpus}
        rows = []
        for name, variant, shipped in figures.names(kind):
            errors = dict(figures.errors(kind, name, variant))
            cells = [emphasised(name, shipped), variant]
            cells += [format_error(errors[e]) if e in errors else "" for e in map(float, exponents or ("0",))]
            cells += [emphasised(format_count(found[cpu][(name, variant)].instructions), (name, variant) in best[cpu])
                      for cpu in cpus]
            rows.append(cells + [only(figures.bench, kind=kind, name=name, variant=variant)[0]["table_bytes"]])
        return table(["method", of] + (["p = " + e for e in exponents] or ["error"]) + [CPUS[cpu] for cpu in cpus] +
                     ["table, bytes"], rows)
    return block


def breaks(figures):
    """At which exponents each power method stays within half a step."""
    rows = []
    for name, variant, shipped in figures.names("power"):
        errors = figures.errors("power", name, variant)
        rows.append([emphasised(name, shipped), variant, ranges(errors) or "none"])
    return table(["method", "of", "exponents at which it is within half a step"], rows)


def ranges(errors):
    """Runs of exponents whose error is at most half a step."""
    runs = []
    for index, (p, error) in enumerate(errors):
        if error > 0.5:
            continue
        if runs and runs[-1][1] == index - 1:
            runs[-1] = (runs[-1][0], index)
        else:
            runs.append((index, index))
    return ", ".join("%g" % errors[a][0] if a == b else "%g to %g" % (errors[a][0], errors[b][0]) for a, b in runs)


def shading(figures):
    """Errors and instructions of each evaluation over every other number of triangles, both formats side by side."""
    formats = list(dict.fromkeys(row["format"] for row in figures.shading))
    shown = list(dict.fromkeys(row["triangles"] for row in figures.shading))[::2]
    rows = []
    for row in only(figures.shading, format=formats[0]):
        if row["triangles"] not in shown:
            continue
        both = [one(figures.shading, format=format, evaluation=row["evaluation"], triangles=row["triangles"]) for format in formats]
        rows.append(["per " + row["evaluation"], row["triangles"]] + ["%.1f" % float(of["rms"]) for of in both] +
                    ["%.0f" % float(of["largest"]) for of in both] + ["%.1f" % (float(of["instructions"]) / 1e6) for of in both])
    names = [format.upper() for format in formats]
    return table(["evaluation", "triangles"] + ["root mean square error, " + name for name in names] +
                 ["largest, " + name for name in names] + ["million instructions on Cortex-M3, " + name for name in names], rows)


def evaluation_matters_less(figures):
    return (figures.psnr(SCENE, SIZE, "vertex Blinn-Phong local") > figures.psnr(SCENE, SIZE, "fragment Blinn-Phong infinite")
            > figures.psnr(SCENE, SIZE, "fragment Lambert"))


def exact_is_ideal(figures):
    ideal = figures.psnr(SCENE, SIZE, "correctly rounded")
    return all((figures.psnr(SCENE, SIZE, choice) > ideal - 0.5) == (choice == ASKED) for choice in figures.choices())


def facet_is_cheapest(figures):
    return all(figures.instructions(SCENE, LIGHT, "facet Blinn-Phong local", cpu) ==
               min(figures.instructions(SCENE, LIGHT, evaluation + " Blinn-Phong local", cpu)
                   for evaluation in ("facet", "vertex", "fragment")) for cpu in CPUS)


# Triangles per vertex that lighting per fragment is held against.
MANY = "2304"


def fragments_need_fewer(figures):
    """With how many triangles lighting per fragment reaches what lighting per vertex does with MANY, and at what cost."""
    words = []
    for format in dict.fromkeys(row["format"] for row in figures.shading):
        vertex = one(figures.shading, format=format, evaluation="vertex", triangles=MANY)
        as_good = [row for row in only(figures.shading, format=format, evaluation="fragment") if float(row["rms"]) <= float(vertex["rms"])]
        if not as_good:
            continue
        fragment = min(as_good, key=lambda row: int(row["triangles"]))
        words.append("%s: %s triangles per fragment reach what %s per vertex do (%.1f and %.1f steps), for %.1f in place of "
                     "%.1f million instructions." % (format.upper(), fragment["triangles"], MANY, float(fragment["rms"]),
                                                     float(vertex["rms"]), float(fragment["instructions"]) / 1e6,
                                                     float(vertex["instructions"]) / 1e6))
    return " ".join(words)


def vertices_fall_behind(figures):
    behind = [figures.psnr(scene, SIZE, ASKED) - figures.psnr(scene, SIZE, "vertex Blinn-Phong local")
              for scene in ("torus9216", "torus2304", "torus576")]
    return behind == sorted(behind)


def always(figures):
    return True


def findings(*sentences):
    """A block of those sentences, or functions that make them, that the figures bear out."""
    def block(figures):
        return bullets(sentence(figures) if callable(sentence) else sentence
                       for sentence, holds in sentences if holds(figures))
    return block


frame_findings = findings(
    ("The viewer is worth more than the evaluation: per vertex with a local viewer is nearer to the picture than per "
     "fragment with an infinite one.", evaluation_matters_less),
    ("Per fragment with a local viewer is within half a decibel of what the format allows, and no other evaluation or viewer "
     "is.", exact_is_ideal),
    ("Per facet takes the fewest instructions on every core here, and shows every triangle.", facet_is_cheapest))

scene_findings = findings(("The larger the triangles, the further lighting per vertex falls behind.", vertices_fall_behind))

float_findings = findings((benchmark_beside_float, always), (cycles_beside_float, always), (examples_behind_float, always))

light_findings = findings((worth_of_evaluations, always), (eight_lights_take, always), (each_light_takes, always),
                          (many_lights_beside_float, always))

shading_findings = findings((fragments_need_fewer, always))

# Of tables of tile sizes and of shares of the arena: sizes, shares, meshes, and how variants of SCENE begin.
TILES, SHARES = ("16x16", "32x16", "32x32", "64x32", "64x64"), ("half", "quarter", "sixteenth")
MESHES, VARIANT = ("torus576", "sphere960", "torus2304", "torus9216"), "320x240 local "


def tile_sizes(figures):
    rows = [["million instructions, " + title] + ["%.2f" % (int(one(figures.bench, kind="frame", name=SCENE, cpu=cpu,
                                                                    variant=VARIANT + tile)["instructions"]) / 1e6) for tile in TILES]
            for cpu, title in (("m3", "Cortex-M3"), ("m0", "ARMv6-M"))]
    rows.append(["smallest arena, bytes"] + [one(figures.bench_arena, name=SCENE, variant=VARIANT + tile)["least"] for tile in TILES])
    return table(["%s at 320x240" % SCENE, *TILES], rows)


def arena_shares(figures):
    """Instructions in a part of the arena, over those where all is drawn in one pass."""
    rows = []
    for mesh in MESHES:
        whole, *parts = (int(one(figures.bench, kind="frame", name=mesh, cpu="m3", variant=VARIANT + "32x32" + share)["instructions"])
                         for share in ("", *(" " + share for share in SHARES)))
        rows.append([mesh, one(figures.bench_arena, name=mesh, variant=VARIANT + "32x32")["one_pass"]] +
                    ["%.1f" % (part / whole) for part in parts])
    return table(["320x240, Cortex-M3", "one pass, bytes", *SHARES], rows)


POWERS = ("1", "8", "64", "256", "1024")

PAGES = {
    "docs/accuracy.md": {
        "best": best, "contract": contract, "steps": steps, "gallery": gallery, "frames": frames, "frame findings": frame_findings, "scenes": scenes,
        "scene findings": scene_findings, "others": others, "float findings": float_findings,
        "examples in float": examples_in_float, "light findings": light_findings, "shading": shading, "shading findings": shading_findings,
        "power": methods("power", "64", POWERS),
        "breaks": breaks, "normalise": methods("normalise", "", ())},
    "docs/cost.md": cost.BLOCKS,
    "docs/design.md": {"tile sizes": tile_sizes, "arena shares": arena_shares},
    "docs/boards.md": {"times": timing.frame_times},
}


def fill(text, blocks, figures):
    """@return a page's text with what its blocks say now"""
    for name, block in blocks.items():
        text = markdown.fill(text, name, block(figures))
    return text
