#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what a firmware takes, from its linker map: size.py MAP [--flash N] [--ram N] [--library N]

Flash is code, constants and the initial values of data; RAM is stack, data and zeroed data; library is the part of
flash that comes from libglint.a. With limits (bytes), exits with 1 when one is exceeded.
"""
import argparse
import re
import sys

IN_FLASH = {".text", ".data"}
IN_RAM = {".stack", ".data", ".bss"}


def sections(lines):
    """Yields (output section, size, object), with object None for the output section itself."""
    output, pending = None, None
    size_at = re.compile(r"^\s+0x[0-9a-f]+\s+0x([0-9a-f]+)(?:\s+(\S.*))?$")
    for line in lines:
        name = re.match(r"^(\.[\w.]+|/DISCARD/)(.*)$", line)
        part = re.match(r"^ (\.[\w.$]+|COMMON)(.*)$", line)
        if name:
            output, pending, rest = name[1], None, name[2]
        elif part:
            pending, rest = part[1], part[2]
        elif line.startswith(" " * 16) and not line.startswith(" " * 17 + " "):
            rest = line
        else:
            continue
        match = size_at.match(rest) or size_at.match(" " + rest.strip())
        if match and output:
            text = (match[2] or "").strip()
            if pending and text and not text.startswith("load address"):
                yield output, int(match[1], 16), text
            elif name or not pending:
                yield output, int(match[1], 16), None


def measure(path):
    with open(path) as file:
        text = file.read()
    lines = text.split("Linker script and memory map", 1)[1].splitlines()
    whole, library = {}, 0
    for output, size, source in sections(lines):
        if source is None:
            whole.setdefault(output, size)
        elif output in IN_FLASH and "libglint.a(" in source:
            library += size
    return {
        "flash": sum(whole.get(name, 0) for name in IN_FLASH),
        "ram": sum(whole.get(name, 0) for name in IN_RAM),
        "stack": whole.get(".stack", 0),
        "library": library,
    }


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("map")
    for limit in ("flash", "ram", "library"):
        parser.add_argument("--" + limit, type=int)
    arguments = parser.parse_args()
    size = measure(arguments.map)
    print("%s: flash %d (library %d), RAM %d (stack %d)" % (
        arguments.map.rsplit(".", 1)[0], size["flash"], size["library"], size["ram"], size["stack"]))
    status = 0
    for limit in ("flash", "ram", "library"):
        most = getattr(arguments, limit)
        if most is not None and size[limit] > most:
            print("%s: %s takes %d bytes, %d more than the %d it may" % (
                arguments.map, limit, size[limit], size[limit] - most, most))
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
