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
from twins import draw_twins  # noqa: E402

# What is shown moving, in so many frames, as a panel of 16 bits shows it, which keeps the files small.
MOVING = {"halloween:night": 12, "phong-lighting:light": 18, "phong-lighting:turning": 18, "phong-lighting:orbit": 18,
          "phong-lighting:dark-orbit": 9, "phong-lighting:camera-light": 9, "still-life:turning": 12}

HEAD = """<!-- SPDX-License-Identifier: MIT -->
<!-- Written by `make figures`, not to be edited. -->
# Gallery

The example scenes (`examples/scenes/`) as glint draws them. They come from four teaching texts: notes on the models of Phong and
Blinn-Phong, a class on several lights, a tutorial on directional light, and a chapter on the Phong model, but for the still life,
which shows textures, glass, a glow, fog and smooth edges. The table holds what each text says, in words of ours, and whether it holds, by what is measured in the
pictures (`figures.csv`, levels of 255). What two texts say stands with the first. Below the table is every picture; its title draws
it: `build/host/glint scene TITLE --labels -o out.png`. What a frame takes is counted in an emulator for that picture, drawn by
itself in RGB565, without labels, clear and copy to a framebuffer included (`../gallery-instructions.csv`); the tables of
[accuracy](../accuracy.md#whole-frames) have means of ten frames that follow each other.

*Phong shading* is lighting per fragment, with the normal interpolated, whatever the model; the *Phong model* is a highlight around
the reflected light, wherever it is evaluated. The scenes are lit per fragment, but for objects that are lit per vertex. Nothing
in these scenes casts a shadow: the cylinder stands on a dark disc instead.
"""

TWINS = """
## twins

What the library cannot draw, for it leaves out no step: `tools/gallery/twins.py` draws by the formulas, with a step left out.
"""

# Of each text: what it says, where that is shown, and whether it holds, with figures by name.
TEXTS = (
    ("Notes on Phong and Blinn-Phong", (
        ("The model sums an ambient, a diffuse and a specular part.", ("surfaces:terms",), "Holds: each alone, and their sum."),
        ("Light and surface have a colour for each part: six in all.", ("surfaces:six-colours",),
         "Holds: cyan light adds {shine_white} to a white shine, {shine_yellow} to a yellow one, {shine_red} to a red one; the shade of "
         "white and of green is {shade_white} and {shade_green}."),
        ("The highlight is seen where reflected light points at the viewer.", ("phong-lighting:orbit",),
         "Holds: it moves by {orbit_moves} pixels while the eye goes round."),
        ("R = 2 (N.L) N - L, by either way to write it.", ("three-spheres:phong",),
         "Holds: every picture is [held](../accuracy.md#the-contract) against this formula in double precision."),
        ("V points from the place that is lit to the eye.", ("phong-lighting:plain", "phong-lighting:far-viewer"),
         "Holds, and matters: with one V for all places the ground's highlight is {viewer_moves} pixels away. "
         "[In decibels](../accuracy.md#whole-frames)."),
        ("The cosine alone falls too slowly: it is raised to a power.", ("teapot:flood", "teapot:fragment"),
         "Holds: at least half of the brightest in {flooded_flood} % of the bodies' pixels with exponent 1, in {flooded_fragment} % with 100."),
        ("A negative cosine counts as 0.", ("phong-lighting:ring",), "Holds: the highlight ends where R.V is 0."),
        ("A larger exponent makes a smaller highlight.", ("surfaces:exponents",),
         "Holds. Pixels lit by at least half of the highlight's brightest: {exponents_0}, {exponents_1}, {exponents_2}, {exponents_3} and "
         "{exponents_4} at exponents 1, 4, 16, 64 and 256."),
        ("A sum above 1 is set to 1.", ("surfaces:terms",),
         "Holds: {clamped_some} pixels of the sum are clamped in some channel, {clamped_all} in all."),
        ("In practice: one paint for ambient and diffuse light, a white highlight, an ambient fraction of 0.1 or 0.2, an exponent.",
         ("shaders:torus-50", "shaders:torus-100"), "Holds: made by `glint_material_paint`, with a fraction of 0.2."),
        ("Blinn-Phong takes a little less computation.", ("three-spheres:phong", "three-spheres:blinn-phong", "phong-lighting:ring",
                                                          "phong-lighting:ring-blinn-phong"),
         "Holds: {cost:three-spheres:phong:m3} and {cost:three-spheres:blinn-phong:m3} million instructions on Cortex-M3, "
         "{cost:phong-lighting:ring:m3} and {cost:phong-lighting:ring-blinn-phong:m3} where highlights cover the picture."),
        ("Its results are of the same quality.", ("surfaces:twice-near", "phong-lighting:ring-blinn-phong"),
         "Holds near the eye's direction: {near_4} of Phong's light differs at four times the exponent. At small exponents it is better: it has no ring."),
        ("Only the specular part differs.", ("twins:difference",),
         "Holds: the two pictures are up to {models_apart} levels apart, and {models_apart_unshiny}, which is rounding, with specular colours of 0."),
        ("H is L + V of unit vectors, made unit.", ("twins:half-vector",), "Holds: without either step the highlight floods or moves."),
        ("Where R points at the eye, N is H: both models have their highlight in one place.", ("surfaces:twice-near",),
         "Holds: their middles are {near_apart} pixels apart."),
        ("Blinn-Phong needs twice Phong's exponent for a like highlight.", ("surfaces:twice-near", "surfaces:twice-far"),
         "Does not hold. Light that differs from Phong's, of Phong's: {near_1}, {near_2} and {near_4} at once, twice and four times the "
         "exponent with the light near the eye; {far_1}, {far_2} and {far_4} from the side."),
        ("Per fragment, the normal is interpolated and the model evaluated at each pixel.", ("shaders:sphere-50",), "Shown: the third column."),
        ("That takes more computation than per vertex.", ("teapot:vertex", "teapot:fragment"),
         "Holds: {cost:teapot:vertex:m3} and {cost:teapot:fragment:m3} million instructions on Cortex-M3."),
        ("Normals are made unit before interpolation and after.", ("twins:normals",),
         "Holds: a twin that leaves out either is wrong. The library does both, so that a mesh's normals may have any length."),
        ("Per fragment, far fewer triangles make a good highlight.", ("shaders:torus-50", "shaders:cylinder-50", "shaders:sphere-50"),
         "Holds: [errors and costs](../accuracy.md#triangles) over triangles."),
        ("Lambert's model is evaluated per fragment too.", ("shaders:torus-50",), "Shown: the fourth column; it has no highlight."),
        ("A facet's normal is the unit cross product of two edges, turned outwards.", ("surfaces:normals",),
         "Shown: `glint_per_facet`. `glint convert --repair` turns triangles outwards."),
        ("Smooth surfaces prefer normals at vertices.", ("surfaces:normals",),
         "Holds: from the torus by its formula, normals of facets are {normals_facets} levels away (root mean square)."),
        ("A vertex's normal can be the mean of its facets'.", ("surfaces:normals",),
         "Holds: {normals_means} levels away. `--weights equal` adds unit normals; by default, `angle`, they weigh by their corner's angle."),
        ("Light at vertices and colours interpolated is Gouraud shading.", ("teapot:vertex",), "Shown: `glint_per_vertex`."),
        ("A torus and a cylinder have points and normals by formulas.", ("shaders:torus-50", "shaders:cylinder-50"),
         "Shown: the meshes `torus:NxM` and `cylinder:NxM` of `glint convert`."))),
    ("Class on several lights", (
        ("Ambient light is dim, about 0.2, and better tinted: (0.1, 0.3, 0.1) for a greenish body.", ("three-spheres:greenish",),
         "Holds: where neither light falls, {ambient_green}."),
        ("A matt surface has diffuse light alone, in a colour of its own.", ("three-spheres:phong",), "Shown: the left sphere."),
        ("The higher the exponent, the shinier.", ("three-spheres:phong",),
         "Holds: {spheres_1} pixels at exponent 4, {spheres_2} at 16; by Blinn-Phong {blinn_spheres_1} and {blinn_spheres_2}."),
        ("Each light adds its own diffuse and specular part, in its own colour.", ("surfaces:two-lights", "halloween:night"),
         "Holds: the sphere under both is {lights_off} levels (root mean square) from the sum of the others."),
        ("Ambient light does not depend on the lights.", ("surfaces:two-lights",),
         "Holds: in the shade of light 1 {ambient_light_1}, of light 2 {ambient_light_2}."),
        ("Three spheres under a dim light from the rear left and a bright one from the front upper right: no highlight, exponent 4, "
         "exponent 16.", ("three-spheres:phong",), "Shown."),
        ("A depth buffer sorts a scene out.", ("halloween:night",), "Shown: rails run through pickets, a hat sits in a pumpkin."),
        ("Something that moves, for Halloween.", ("halloween:night",), "Shown."),
        ("Lit per vertex, a scene is fast enough to be animated.", ("halloween:vertex", "halloween:night"),
         "Holds on fast cores: {cost:halloween:vertex:m3} million instructions on Cortex-M3, {cost:halloween:night:m3} per fragment; the "
         "pictures are {halloween_vertex} levels (root mean square) apart."),
        ("Lit per vertex, a mesh shows in its highlights, unless it is dense.", ("three-spheres:vertex", "three-spheres:vertex-dense"),
         "Holds: right sphere against the one per fragment, root mean square: {spheres_vertex} levels with 168 triangles, "
         "{spheres_vertex-dense} with 2976."))),
    ("Tutorial on directional light", (
        ("Highlights are sharp on metal, blurred on plastic.", ("surfaces:metal",),
         "Shown by exponents: {metal_size_1} pixels on gold with 32, {metal_size_0} on plastic with 8."),
        ("Their place and intensity vary with the observer.", ("phong-lighting:orbit",),
         "Holds: over a round the brightest is {orbit_least} to {orbit_most} levels, and moves by {orbit_moves} pixels."),
        ("The highlight is brightest along R, and dims away from it.", ("surfaces:exponents",),
         "Holds: [cos^s](../charts/lobes.svg) for s from 0.25 to 256, the library's and true."),
        ("Without a shininess term specular light floods the scene.", ("teapot:flood",),
         "Holds: {flooded_flood} % of the bodies' pixels, by half of the brightest or more."),
        ("Below 1 the curve gets wider still.", ("teapot:flood-wide",), "Holds: {flooded_flood-wide} % with exponent 0.25."),
        ("A teapot with exponent 100.", ("teapot:fragment",), "Shown."),
        ("The light's direction is given in camera space.", ("phong-lighting:camera-light", "phong-lighting:orbit"),
         "Shown: over a round the highlight moves by {camera-light_moves} pixels in place of {orbit_moves}. `glint render --camera-lights`."),
        ("Light is computed in camera space.", ("phong-lighting:camera-light",),
         "Holds: lights and normals are [turned there](../design.md#the-path) first."),
        ("Specular light only where N.L is above 0.", ("surfaces:ungated",),
         "Holds: else it shines through the body. Pixels with a highlight where diffuse light is below a level: {shines_gated} gated, "
         "{shines_ungated} ungated."),
        ("The larger of what is lit and of ambient light counts.", ("surfaces:ambient-max", "teapot:fragment"),
         "A choice: pixels of ambient light alone {shade_added} where it is added, {shade_larger} where the larger counts; the brightest "
         "{spot_added} and {spot_larger}. The teapot's scenes take the larger."),
        ("Lit per vertex, a highlight tells more of the mesh than of the surface.", ("teapot:vertex-coarse", "teapot:vertex"),
         "Holds: torus against the one of 576 triangles per fragment, root mean square of pixels that both cover: "
         "{teapot_vertex-coarse} levels with 192 triangles, {teapot_vertex} with 576."),
        ("A very dense mesh or light per pixel betters that.", ("teapot:vertex-dense", "teapot:fragment"),
         "Holds: {teapot_vertex-dense} levels with 2304 triangles."),
        ("Only a triangle for each pixel would solve it.", ("teapot:vertex-dense",),
         "Holds: these errors are left at {pixels_a_triangle} pixels a triangle. [Errors](../charts/shading.svg) over triangles."))),
    ("Chapter on the Phong model", (
        ("Phong shading, which is light per fragment, is not the Phong model.", ("shaders:sphere-50",), "Shown: Phong's model per vertex, at the left."),
        ("The exponent may be any number above 0; a small one looks rough.", ("teapot:flood-wide", "phong-lighting:ring"),
         "Holds: 0.25 and 0.3 are drawn; 0 too, and less is refused."),
        ("A surface absorbs a part of specular light.", ("phong-lighting:plain", "phong-lighting:specular-quarter"),
         "Shown: a specular colour of 1 on the cylinder, and of 0.25."),
        ("Plastic has a highlight of the light's colour, a metal one of its own.", ("surfaces:metal",),
         "Shown. Brightest pixels: blue plastic {metal_plastic}, gold {metal_gold}, gold paint {metal_paint}."),
        ("The model is made up, cheap, and looks decent.", ("three-spheres:phong",),
         "Shown: {cost:three-spheres:phong:m3} million instructions on Cortex-M3."),
        ("The scene: a cylinder on the ground and a light that is drawn or not and circles.", ("phong-lighting:plain", "phong-lighting:light"), "Shown."),
        ("The cylinder squashed: its normals go by the inverse transpose.", ("phong-lighting:scaled", "phong-lighting:scaled-normals"),
         "Holds: of the squashed cylinder's pixels {lit_right} % are bright; with normals by the matrix itself {lit_wrong} %."),
        ("The cylinder in the colours of its vertices.", ("phong-lighting:vertex-colours", "phong-lighting:scaled-vertex-colours"),
         "Shown: they replace its diffuse colour."),
        ("The cylinder turns.", ("phong-lighting:turning",), "Shown: colours turn, the highlight stays."),
        ("Keys choose among all these.", (), "Shown by the keys of [the window](../view.md)."),
        ("The exponent goes up and down.", ("phong-lighting:shininess-up", "phong-lighting:shininess-down"), "Shown: 6 and 2, from 4."),
        ("Specular or diffuse light alone; ambient light stays.", ("phong-lighting:specular-only", "phong-lighting:diffuse-only"), "Shown."),
        ("Light weakens with the distance, not with its square.", ("phong-lighting:plain", "phong-lighting:inverse-square"),
         "A choice: ground in the shade {ground_plain} by 1 / (1 + k d), {ground_inverse-square} by the square."),
        ("Diffuse and specular light above 1 make a white area.", ("surfaces:terms",), "Holds: the patch on the sum."),
        ("A weak specular colour, 0.25, makes a difference.", ("phong-lighting:specular-quarter", "phong-lighting:diffuse-only"),
         "Holds: it adds up to {quarter_adds} levels to the cylinder."),
        ("A diffuse colour of 0.2, which ambient light meets too: without specular light very little is seen.",
         ("phong-lighting:dark", "phong-lighting:dark-specular-quarter", "phong-lighting:dark-diffuse-only"),
         "Holds: ground in the shade {ground_dark}, in plain {ground_plain}; its brightest pixel {spot_dark}, with a specular colour of 0.25 "
         "{spot_dark-specular-quarter}, with none {spot_dark-diffuse-only}."),
        ("Then it looks like black plastic, from any side.", ("phong-lighting:dark-orbit",),
         "Holds: over a round the highlight adds {dark-orbit_least} to {dark-orbit_most} levels."),
        ("A lamp close to a surface: the highlight ends at a sharp edge where the lamp sets.", ("phong-lighting:near",),
         "Holds: a step of {jump_near} levels between neighbouring pixels, at N.L = 0."),
        ("Smooth surfaces, with large exponents, rarely show it.", ("phong-lighting:near", "phong-lighting:near-smooth"),
         "Holds: a step of {near_step_1}, {near_step_2}, {near_step_4}, {near_step_8} and {near_step_16} levels at exponents 1, 2, 4, 8 and 16."),
        ("A small exponent: the highlight ends in a ring, where R and V are more than 90 degrees apart.", ("phong-lighting:ring",),
         "Holds: a step of {jump_ring} levels on the ground, at R.V = 0."),
        ("There should be some specular light beyond.", ("phong-lighting:ring-blinn-phong",),
         "Blinn-Phong has it: its step is {jump_ring_blinn_phong}. The edge on the cylinder, {jump_half_blinn_phong} levels, is the lamp's "
         "setting, N.L = 0."),
        ("Phong's model works best with large exponents.", ("phong-lighting:ring", "phong-lighting:dark"),
         "Holds: the ring's step is {ring_step_2}, {ring_step_4}, {ring_step_8} and {ring_step_16} levels at exponents 0.125, 0.25, 0.5 and 1."))))


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
        for statement, titles, verdict in statements:
            shown = "<br>".join("[%s](%s)" % (title, file_of(title)) for title in titles)
            rows.append([statement, shown, fill(verdict, figures)])
        page += "\n## %s\n\n%s" % (text, table(["the text", "shown in", "verdict"], rows))
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
    page += TWINS
    for title, sentence in draw_twins(folder):
        page += f"\n### {title}\n\n![{title}]({file_of(title)})\n\n{sentence}\n"
    for file_name, text in (("figures.csv", measured), ("README.md", page)):
        with open(os.path.join(folder, file_name), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
