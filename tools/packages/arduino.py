#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the library with the panel drivers as a ZIP file for Arduino and PlatformIO: arduino.py FOLDER VERSION. Both
compile what lies below src/, so the drivers lie in src/panel/ there."""
import os
import re
import sys
import zipfile

from pack import ROOT, find


def keywords():
    """What the IDE colours: types, functions and constants of the public headers."""
    text = ""
    for header in find("src/*.h") + find("port/panel/*.h"):
        with open(os.path.join(ROOT, header), encoding="utf-8") as file:
            text += re.sub(r"/\*.*?\*/", "", file.read(), flags=re.DOTALL)
    kinds = {"KEYWORD1": r"^typedef [^;{]*\b(glint_\w+);|^\} (glint_\w+);", "KEYWORD2": r"^\w[\w *]*\b(glint_\w+)\(",
             "LITERAL1": r"^extern [^;\"]*\b(glint_\w+)[;\[]|^ *#define (GLINT_\w+)(?<!_H)\b|^    (GLINT_\w+)\b"}
    found = [(name, kind) for kind, pattern in kinds.items()
             for name in sorted({next(filter(None, match.groups())) for match in re.finditer(pattern, text, re.MULTILINE)})]
    return "".join("%s\t%s\n" % pair for pair in found)


def main():
    folder, version = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "glint-%s.zip" % version)
    names = ["LICENSE", "README.md", "library.json", "library.properties"] + find("examples/arduino/*/*") + \
        find("src/*.h") + find("src/*/*.[ch]") + find("port/panel/*.[ch]")
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as pack:
        pack.writestr("glint/keywords.txt", keywords())
        for name in names:
            pack.write(os.path.join(ROOT, name), "glint/" + name.replace("port/panel/", "src/panel/"))
    print(path)


if __name__ == "__main__":
    main()
