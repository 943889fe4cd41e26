# SPDX-License-Identifier: MIT
"""The gallery that is checked in is what the program draws."""
import os
import re
import shutil
import subprocess
import sys

from harness import ROOT

GALLERY = os.path.join(ROOT, "docs", "gallery")


def test_gallery(host):
    made = host.path("gallery")
    figures = os.path.join(os.path.dirname(host.program), "gallery-figures")
    costs = os.path.join(ROOT, "docs", "modelled-instructions.csv")
    run = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "gallery", "gallery.py"), host.program, figures, costs, made],
                         capture_output=True, text=True, check=False)
    host.equal("gallery.py", (run.returncode, run.stdout, run.stderr), (0, "", ""))
    files = sorted(os.listdir(made))
    host.equal("the gallery's files (make gallery)", sorted(os.listdir(GALLERY)) if os.path.isdir(GALLERY) else [], files)
    for name in files:
        with open(os.path.join(made, name), "rb") as new, open(os.path.join(GALLERY, name), "rb") as old:
            host.check(f"docs/gallery/{name} is up to date (make gallery)", new.read() == old.read())
    with open(os.path.join(made, "README.md"), encoding="utf-8") as file:
        shown = re.findall(r"!\[.*?\]\((.+?)\)", file.read())
    host.equal("the page shows every picture once", sorted(shown), [name for name in files if name.endswith("png")])
    size = sum(os.path.getsize(os.path.join(made, name)) for name in files if name.endswith(".apng"))
    host.check("the animations are small", size <= 1200000, f"{size} bytes")
    shutil.rmtree(made)


def test_readme_picture(host):
    """The picture in the README is what `make demo` draws."""
    made = host.path("demo.png")
    run = subprocess.run([host.program, "demo", "--models", os.path.join(ROOT, "examples", "models"), "-o", made],
                         capture_output=True, text=True, check=False)
    host.equal("demo", run.returncode, 0)
    with open(made, "rb") as new, open(os.path.join(ROOT, "docs", "demo.png"), "rb") as old:
        host.check("docs/demo.png is up to date (make demo)", new.read() == old.read())
