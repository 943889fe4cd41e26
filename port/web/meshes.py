# SPDX-License-Identifier: MIT
"""Stands in for the meshes of the example scenes: meshes.py FOLDER HEADER...

Of each header in examples/meshes it takes the line that says how the converter wrote it. FOLDER/meshes/NAME.h then
only declares the mesh, and FOLDER/meshes.c has a list of what to convert: the page does that when it starts, with the
converter that it brings along, from models that take a third of the space of their meshes.
"""
import pathlib
import re
import sys


def command_of(header):
    """The converter's arguments, and the name of the mesh."""
    words = re.search(r"^ \*  +glint convert (.*)$", header.read_text(), re.M).group(1).split()
    return words, header.stem


def main():
    folder = pathlib.Path(sys.argv[1])
    meshes = [command_of(pathlib.Path(name)) for name in sys.argv[2:]]
    (folder / "meshes").mkdir(parents=True, exist_ok=True)
    for _, name in meshes:
        (folder / "meshes" / f"{name}.h").write_text(f'#include "glint.h"\nextern glint_mesh {name}_mesh;\n')
    lines = ["/* Made by port/web/meshes.py. */", '#include "meshes.h"']
    lines += [f"glint_mesh {name}_mesh;" for _, name in meshes]
    lines += ["const web_mesh web_meshes[] = {"]
    for words, name in meshes:
        words = [word.strip('"') for word in words]
        text = '\\0" "'.join(words)  # apart, or digits would follow the 0
        lines.append(f'    {{&{name}_mesh, "{text}", {len(" ".join(words)) + 1}}},')
    lines += ["    {0, 0, 0},", "};", ""]
    (folder / "meshes.c").write_text("\n".join(lines))


main()
