# SPDX-License-Identifier: MIT
"""Draws every example scene and variant: gallery.py PROGRAM FIGURES COSTS FOLDER writes pictures, animations, what is
measured in them and a page. FIGURES is the program that measures, COSTS docs/gallery-instructions.csv.
"""
import csv
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from markdown import table  # noqa: E402

# What is shown moving, in so many frames, as a panel of 16 bits shows it, which keeps the files small.
MOVING = {"halloween:night": 24, "phong-lighting:light": 18, "phong-lighting:turning": 18, "phong-lighting:orbit": 18}

HEAD = """<!-- SPDX-License-Identifier: MIT -->
<!-- Written by `make figures`, not to be edited. -->
# Gallery

The example scenes (`examples/scenes/`) as glint draws them. They come from four teaching texts: notes on the models of Phong and
Blinn-Phong, a class on several lights, a tutorial on directional light, and a chapter on the Phong model. The table holds what
each text says against what is measured in the pictures (`figures.csv`, levels of 255); below it is every picture. Its title
draws it: `build/host/glint scene TITLE --labels -o out.png`. What a frame takes is counted in an emulator for that picture, drawn
by itself in RGB565, without labels, clear and copy to a framebuffer included (`../gallery-instructions.csv`); the tables of
[accuracy](../accuracy.md#whole-frames) have means of ten frames that follow each other.

*Phong shading* is lighting per fragment, with the normal interpolated, whatever the model; the *Phong model* is a highlight around
the reflected light, wherever it is evaluated. The scenes are lit per fragment, but for objects that are lit per vertex. Nothing in these scenes casts a shadow.
"""

# Of each text: what it says, where that is shown, and what is measured there, with figures by name.
TEXTS = (
    ("Notes on Phong and Blinn-Phong", (
        ("A larger exponent makes a smaller highlight.", ("surfaces:exponents",),
         "Pixels lit by at least half of the highlight's brightest: {exponents_0}, {exponents_1}, {exponents_2}, {exponents_3} and "
         "{exponents_4} at exponents 1, 4, 16, 64 and 256."),
        ("Blinn-Phong needs twice Phong's exponent for a like highlight.", ("surfaces:twice-near", "surfaces:twice-far"),
         "Not twice. Light that differs from Phong's, of Phong's: {near_1}, {near_2} and {near_4} at once, twice and four times the "
         "exponent with the light near the eye; {far_1}, {far_2} and {far_4} from the side."),
        ("A surface of one paint takes its ambient and diffuse colour from that, a white highlight, a fraction for ambient light, "
         "and an exponent.", ("shaders:torus-50", "shaders:torus-100"), "`glint_material_paint`, with a fraction of 0.2."),
        ("Lit per fragment, far fewer triangles make a good highlight than lit per vertex.",
         ("shaders:torus-50", "shaders:cylinder-50", "shaders:sphere-50"), "See [accuracy](../accuracy.md#triangles): errors and costs over triangles."),
        ("A vertex's normal can be made of those of the triangles around it.", (),
         "`glint render --weights equal` adds the unit normals of triangles; `angle` and, by default, `area` weigh them."))),
    ("Class on several lights", (
        ("A dim light from the rear left, a bright one from the front: no highlight, exponent 4, exponent 16.",
         ("three-spheres:phong",), "Pixels lit by at least half of the highlight's brightest: {spheres_1} and {spheres_2}; "
         "by Blinn-Phong {blinn_spheres_1} and {blinn_spheres_2}."),
        ("A greenish body has a tinted ambient colour, (0.1, 0.3, 0.1).", ("three-spheres:greenish",),
         "Where neither light falls: {ambient_green}."),
        ("Each light adds its own diffuse and specular light, in its own colour.", ("halloween:night",),
         "A moon and four lamps. A frame takes {cost:halloween:night:m3} million instructions on Cortex-M3."),
        ("Lit per vertex, a scene is fast enough to be animated.", ("halloween:vertex",),
         "{cost:halloween:vertex:m3} million, {halloween_vertex} levels (root mean square) from the same per fragment."),
        ("Lit per vertex, a mesh shows in its highlights, unless it is dense.", ("three-spheres:vertex", "three-spheres:vertex-dense"),
         "Right sphere against the one per fragment, root mean square: {spheres_vertex} levels with 168 triangles, "
         "{spheres_vertex-dense} with 2976."))),
    ("Tutorial on directional light", (
        ("Without a shininess term specular light floods the scene.", ("teapot:fragment", "teapot:flood"),
         "Bodies' pixels lit by at least half of the brightest: {flooded_fragment} % with exponent 100, {flooded_flood} % with 1."),
        ("Below 1 the curve gets wider still.", ("teapot:flood-wide",),
         "{flooded_flood-wide} % with exponent 0.25. [cos^s](../charts/lobes.svg) for s from 0.25 to 256, the library's and true."),
        ("Lit per vertex, a highlight tells more of the mesh than of the surface; a very dense mesh mends it.",
         ("teapot:vertex-coarse", "teapot:vertex", "teapot:vertex-dense"),
         "Torus against the one of 576 triangles per fragment, root mean square: {teapot_vertex-coarse} levels with 192 triangles, "
         "{teapot_vertex} with 576, {teapot_vertex-dense} with 2304."),
        ("The light's direction is given in camera space.", (), "`glint render --camera-lights`."))),
    ("Chapter on the Phong model", (
        ("Plastic has a highlight of the light's colour, a metal one of its own.", ("surfaces:metal",),
         "Brightest pixels: blue plastic {metal_plastic}, gold {metal_gold}, gold with a white highlight {metal_paint}."),
        ("Specular light is gated by N.L: else it shines through the surface.", ("surfaces:ungated",),
         "Pixels with a highlight where diffuse light is below a level: {shines_gated} gated, {shines_ungated} ungated."),
        ("Terms that sum to more than 1 are clamped, which makes a white patch.", ("surfaces:terms",),
         "{clamped_some} pixels of the sum are clamped in some channel, {clamped_all} in all."),
        ("A diffuse colour of 0.2, which ambient light meets too; without specular light very little is seen.",
         ("phong-lighting:dark", "phong-lighting:dark-specular-quarter", "phong-lighting:dark-diffuse-only"),
         "Ground in the shade {ground_dark}, in plain {ground_plain}; its brightest pixel {spot_dark}, with a specular colour of 0.25 "
         "{spot_dark-specular-quarter}, with none {spot_dark-diffuse-only}."),
        ("A lamp close to a surface: the highlight ends at a sharp edge where the lamp sets.", ("phong-lighting:near",),
         "A step of {jump_near} levels between neighbouring pixels, at N.L = 0."),
        ("A small exponent: Phong's highlight ends in a ring where R.V is 0.", ("phong-lighting:ring", "phong-lighting:ring-blinn-phong"),
         "A step of {jump_ring} levels on the ground; by Blinn-Phong {jump_ring_blinn_phong}. Blinn-Phong's edge on the cylinder, "
         "{jump_half_blinn_phong} levels, is the lamp's setting, N.L = 0."),
        ("Normals go by the inverse transpose of a matrix that scales.", ("phong-lighting:scaled", "phong-lighting:scaled-normals"),
         "Of the squashed cylinder's pixels {lit_right} % are bright; with normals by the matrix itself {lit_wrong} %."),
        ("Light falls with the distance, here as 1 / (1 + k d), or with its square.", ("phong-lighting:plain", "phong-lighting:inverse-square"),
         "Ground in the shade: {ground_plain} and {ground_inverse-square}."),
        ("Terms can be left out, colours come from vertices, the lamp, the cylinder and the eye move.",
         ("phong-lighting:specular-only", "phong-lighting:diffuse-only", "phong-lighting:vertex-colours", "phong-lighting:light",
          "phong-lighting:turning", "phong-lighting:orbit"), "The animations show the highlight stay while colours move, and wander with the eye."))))


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout


def read_list(text):
    """[(name, summary, [(variant, sentence)])] from `glint scene --list`."""
    scenes = []
    for line in text.splitlines():
        variant = re.fullmatch(r"  [\w-]+:([\w-]+)  (.+)", line)
        if variant:
            scenes[-1][2].append(variant.groups())
        else:
            name, summary = re.fullmatch(r"([\w-]+) \(.+?\): (.+)", line).groups()
            scenes.append((name, summary, []))
    return scenes


def read_figures(text, costs):
    """@return values by name; of costs the instructions of a picture's frame, in millions, as `cost:TITLE:CORE`"""
    figures = dict(line.split(",", 1) for line in text.splitlines()[1:])
    with open(costs, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            figures["cost:%(scene)s:%(variant)s:%(cpu)s" % row] = "%.1f" % (int(row["instructions"]) / 1e6)
    return figures


def fill(sentence, figures):
    return re.sub(r"{([^}]+)}", lambda name: figures[name[1]], sentence)


def file_of(title):
    return title.replace(":", "-") + ".png"


def draw_statements(figures):
    page = ""
    for text, statements in TEXTS:
        rows = []
        for statement, titles, measured in statements:
            shown = "<br>".join("[%s](%s)" % (title, file_of(title)) for title in titles)
            rows.append([statement, shown, fill(measured, figures)])
        page += "\n## %s\n\n%s" % (text, table(["the text", "shown in", "measured"], rows))
    return page


def cost_of(title, figures):
    return fill("A frame takes {cost:%s:m3} million instructions on Cortex-M3 and {cost:%s:m0} on Cortex-M0." % (title, title), figures)


def draw_scene(program, folder, name, summary, variants, figures):
    """Draws a scene's pictures. @return its part of the page"""
    page = f"\n## {name}\n\n{summary}\n"
    for variant, sentence in variants:
        title = f"{name}:{variant}"
        run(program, "scene", title, "--labels", "-o", os.path.join(folder, file_of(title)))
        page += f"\n### {title}\n\n![{title}]({file_of(title)})\n\n{sentence}\n\n{cost_of(title, figures)}\n"
        if title in MOVING:
            moving, options = f"{name}-{variant}.apng", ["--animate", str(MOVING[title]), "--format", "rgb565"]
            run(program, "scene", title, *options, "-o", os.path.join(folder, moving))
            page += f"\n![{title}, animated]({moving})\n\nMoving, as a 16-bit panel shows it: `glint scene {title} {' '.join(options)}`.\n"
    return page


def main():
    program, measure, costs, folder = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    for old in os.listdir(folder):
        if old.endswith((".png", ".apng")):
            os.remove(os.path.join(folder, old))
    measured = run(measure)
    figures = read_figures(measured, costs)
    page = HEAD + draw_statements(figures)
    for name, summary, variants in read_list(run(program, "scene", "--list")):
        page += draw_scene(program, folder, name, summary, variants, figures)
    for file_name, text in (("figures.csv", measured), ("README.md", page)):
        with open(os.path.join(folder, file_name), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
