#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the library as one source and two headers, glint.c, glint.h and glint_extras.h: single.py FOLDER.

glint.h has the headers that it includes as well; glint.c has everything else, each header where it is first included.
Macros that a .c file defines end with it.
"""
import glob
import os
import re
import sys

SOURCES = os.path.normpath(os.path.join(os.path.dirname(__file__), "..", "..", "src"))
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+"([^"]+)".*\n?', re.MULTILINE)
DEFINE = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)", re.MULTILINE)
# REUSE-IgnoreStart
LICENCE = re.compile(r"^/\* SPDX-License-Identifier: MIT \*/\n")
# REUSE-IgnoreEnd

UNUSED = """#if defined(__clang__)
#pragma clang diagnostic ignored "-Wunused-function" /* each core uses some of the small functions that headers have */
#endif
"""


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def inline(path, done):
    """The text of a file, with each header that is not in `done` in the place of its first #include."""
    done.add(path)

    def replace(match):
        header = os.path.normpath(os.path.join(os.path.dirname(path), match.group(1)))
        return "" if header in done else inline(header, done)

    text, count = LICENCE.subn("", read(path))
    if count != 1:
        sys.exit("%s: no licence line at its top" % path)
    return "/* ---- %s ---- */\n\n%s\n" % (os.path.relpath(path, SOURCES), INCLUDE.sub(replace, text).strip("\n"))


def write(path, parts):
    with open(path, "w", encoding="utf-8") as file:
        # REUSE-IgnoreStart
        file.write("/* SPDX-License-Identifier: MIT */\n/* glint as one source and two headers; `make single` writes them. */\n")
        # REUSE-IgnoreEnd
        file.write("\n" + "\n".join(parts))


def main():
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    done = set()
    write(os.path.join(folder, "glint.h"), [inline(os.path.join(SOURCES, "glint.h"), done)])
    extras = inline(os.path.join(SOURCES, "glint_extras.h"), done)
    write(os.path.join(folder, "glint_extras.h"), ['#include "glint.h"\n', extras])
    parts = ['#include "glint_extras.h"\n', UNUSED]
    for path in sorted(glob.glob(os.path.join(SOURCES, "*", "*.c"))):
        ends = "".join("#undef %s\n" % name for name in sorted(set(DEFINE.findall(read(path)))))
        parts.append(inline(path, done) + ("\n" + ends if ends else ""))
    write(os.path.join(folder, "glint.c"), parts)


if __name__ == "__main__":
    main()
