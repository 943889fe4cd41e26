# SPDX-License-Identifier: MIT
"""The gallery that is checked in is what the program draws."""
import csv
import os
import re
import subprocess
import sys

import png
from harness import ROOT

GALLERY = os.path.join(ROOT, "docs", "gallery")


def costs_shown(page):
    """(title, millions on Cortex-M3, millions on Cortex-M0) of each picture of the page"""
    return re.findall(r"^### (\S+)$(?:(?!^#).)*?^A frame takes ([\d.]+) million instructions on Cortex-M3 and ([\d.]+) on Cortex-M0\.$",
                      page, flags=re.M | re.S)


def costs_counted(path):
    with open(path, encoding="utf-8", newline="") as file:
        counts = {(row["scene"] + ":" + row["variant"], row["cpu"]): int(row["instructions"]) for row in csv.DictReader(file)}
    return [(title, *("%.1f" % (counts[title, core] / 1e6) for core in ("m3", "m0"))) for title, cpu in counts if cpu == "m3"]


def content(name, data):
    return png.shown(data) if name.endswith("png") else data


def test_gallery(host):
    made = host.path("gallery")
    figures = os.path.join(os.path.dirname(host.program), "..", "tests", "host", "gallery_figures")
    costs = os.path.join(ROOT, "docs", "gallery-instructions.csv")
    run = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "gallery", "gallery.py"), host.program, figures, costs, made],
                         capture_output=True, text=True, check=False)
    host.equal("gallery.py", (run.returncode, run.stdout, run.stderr), (0, "", ""))
    files = sorted(os.listdir(made))
    host.equal("the gallery's files (make figures)", sorted(os.listdir(GALLERY)) if os.path.isdir(GALLERY) else [], files)
    for name in files:
        with open(os.path.join(made, name), "rb") as new, open(os.path.join(GALLERY, name), "rb") as old:
            host.check(f"docs/gallery/{name} is up to date (make figures)", content(name, new.read()) == content(name, old.read()))
    with open(os.path.join(made, "README.md"), encoding="utf-8") as file:
        page = file.read()
    shown = re.findall(r"!\[.*?\]\((.+?)\)", page)
    host.equal("the page shows every picture once", sorted(shown), [name for name in files if name.endswith("png")])
    host.equal("under each picture stands what its frame takes", costs_shown(page), costs_counted(costs))
    size = sum(os.path.getsize(os.path.join(made, name)) for name in files if name.endswith(".apng"))
    host.check("the animations are small", size <= 1200000, f"{size} bytes")


# What the page's sentences say, of the figures beside them.
TRUE_OF_FIGURES = (
    "exponents_0 > 2 * exponents_1 > 4 * exponents_2 > 8 * exponents_3 > 16 * exponents_4 / 2",
    "near_4 < near_2 / 4 and far_4 < far_2 < far_1",
    "spheres_1 > 2 * spheres_2 and blinn_spheres_1 > 2 * spheres_1",
    "spheres_vertex > 2 * spheres_vertex_dense and teapot_vertex_coarse > teapot_vertex > teapot_vertex_dense",
    "flooded_fragment < 10 and flooded_flood > 50 and flooded_flood_wide > flooded_flood",
    "shines_ungated > 50 * shines_gated",
    "clamped_some > clamped_all > 0",
    "jump_near > 50 and jump_ring > 20 and jump_ring_blinn_phong < 4 and jump_half_blinn_phong > 50",
    "lit_wrong > 2 * lit_right",
    "halloween_vertex > 4",
    "metal_size_1 < metal_size_0 / 2",
    "viewer_moves > 8 and orbit_moves > 100 and camera_light_moves < 3 and orbit_most > 1.5 * orbit_least",
    "models_apart > 40 and models_apart_unshiny <= 1 and near_apart < 1 and far_apart < 1",
    "normals_facets > 4 * normals_means",
    "lights_off < 3",
    "shade_larger > 2 * shade_added",
    "near_step_1 > near_step_2 > near_step_4 > near_step_8 and near_step_8 < 4 and near_step_16 < 4",
    "ring_step_2 > ring_step_4 > ring_step_8 > ring_step_16 and ring_step_16 < 4",
    "quarter_adds > 20 and dark_orbit_least > 20",
    "pixels_a_triangle > 4 and teapot_vertex_dense > 2",
)


# Figures that sentences below pictures hold.
CAPTIONS = {
    "shaders:cylinder-100": ("cylinder-50_0", "cylinder-100_0", "cylinder-50_1", "cylinder-100_1"),
    "three-spheres:blinn-phong": ("wider_1", "wider_2"),
    "teapot:fragment": ("streak_upper", "streak_lower"),
    "teapot:vertex-dense": ("teapot_vertex-dense", "teapot_vertex"),
    "phong-lighting:vertex-colours": ("spot_vertex-colours",),
    "phong-lighting:far-viewer": ("viewer_moves",),
    "surfaces:twice-far": ("far_aspect_0", "far_aspect_1", "far_aspect_2", "far_aspect_3"),
}


def test_figures(host):
    """The sentences of the gallery's page are true of what is measured."""
    program = os.path.join(os.path.dirname(host.program), "..", "tests", "host", "gallery_figures")
    text = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    measured = dict(line.split(",", 1) for line in text.splitlines()[1:])
    captions = dict(re.findall(r"^  (\S+)  (.+)$", subprocess.run([host.program, "scene", "--list"], capture_output=True, text=True,
                                                                check=True).stdout, flags=re.M))
    for title, names in CAPTIONS.items():
        for name in names:
            host.check(f"{title} says {name}", re.search(r"(?<![\d.])%s(?![\d]|\.\d)" % re.escape(measured[name]), captions[title]),
                       f"{measured[name]}: {captions[title]}")
    figures = {name.replace("-", "_"): float(value) for name, value in measured.items() if not value.startswith("(")}
    for sentence in TRUE_OF_FIGURES:
        host.check(sentence, eval(sentence, {}, figures), str(figures))  # pylint: disable=eval-used # of these sentences
    levels = {name: [int(level) for level in value.strip("()").split()] for name, value in measured.items() if value.startswith("(")}
    host.check("gold's highlight is golden", levels["metal_gold"][2] < 128 < levels["metal_gold"][0], str(levels))
    host.check("plastic's is white", min(levels["metal_plastic"]) > 200 and min(levels["metal_paint"]) > 200, str(levels))
    host.equal("a product of two colours", [levels["shine_yellow"][0::2], levels["shine_red"]], [[0, 0], [0, 0, 0]])
    host.equal("ambient light is the same under any light", levels["ambient_light_1"], levels["ambient_light_2"])
    host.equal("tinted ambient light", levels["ambient_green"], [26, 77, 26])
    host.check("without specular light little is seen", max(levels["spot_dark-diffuse-only"]) < 40, str(levels))


def test_readme_picture(host):
    """The picture in the README is what `make demo` draws."""
    made = host.path("demo.png")
    run = subprocess.run([host.program, "demo", "--models", os.path.join(ROOT, "examples", "models"), "-o", made],
                         capture_output=True, text=True, check=False)
    host.equal("demo", run.returncode, 0)
    with open(made, "rb") as new, open(os.path.join(ROOT, "docs", "demo.png"), "rb") as old:
        host.check("docs/demo.png is up to date (make figures)", png.shown(new.read()) == png.shown(old.read()))
