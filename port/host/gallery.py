# SPDX-License-Identifier: MIT
"""Draws every example scene and variant: gallery.py PROGRAM FOLDER writes pictures, an animation and a page."""
import os
import re
import subprocess
import sys

# The scene that is shown moving, and how: as a panel of 16 bits shows it, which keeps the file small.
MOVING, MOVING_OPTIONS = "halloween", ["--animate", "24", "--format", "rgb565"]

HEAD = """<!-- SPDX-License-Identifier: MIT -->
<!-- Written by `make gallery`, not to be edited. -->
# Gallery

The example scenes (`examples/scenes/`) as glint draws them, in the order of the texts that they are taken from, each with
what to look for. The title of a picture is what draws it: `build/host/glint scene TITLE -o out.png`.
"""


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


def draw_scene(program, folder, name, summary, variants):
    """Draws a scene's pictures. @return its part of the page"""
    page = f"\n## {name}\n\n{summary}\n"
    if name == MOVING:
        file = f"{name}.apng"
        run(program, "scene", name, *MOVING_OPTIONS, "-o", os.path.join(folder, file))
        page += f"\n![{name}, animated]({file})\n\nAll of it, as a 16-bit panel shows it: `glint scene {name} {' '.join(MOVING_OPTIONS)}`.\n"
    for variant, sentence in variants:
        file = f"{name}-{variant}.png"
        run(program, "scene", f"{name}:{variant}", "--labels", "-o", os.path.join(folder, file))
        page += f"\n### {name}:{variant}\n\n![{name}:{variant}]({file})\n\n{sentence}\n"
    return page


def main():
    program, folder = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    for old in os.listdir(folder):
        if old.endswith((".png", ".apng")):
            os.remove(os.path.join(folder, old))
    page = HEAD
    for name, summary, variants in read_list(run(program, "scene", "--list")):
        page += draw_scene(program, folder, name, summary, variants)
    with open(os.path.join(folder, "README.md"), "w", encoding="utf-8") as file:
        file.write(page)


if __name__ == "__main__":
    main()
