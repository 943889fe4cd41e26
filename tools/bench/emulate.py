# SPDX-License-Identifier: MIT
"""Runs firmware that counts instructions; shared by the scripts that measure."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "tests", "board"))
from qemu import Died, Machine, Tally

# An instruction takes a nanosecond of emulated time; tools/bench/counter.h counts on it.
COUNTED = ("-icount", "shift=0")


def lines_of(qemu, machine_name, elf):
    """What the firmware writes; Died when it does not end well."""
    lines = []
    with Machine(qemu, machine_name, elf, options=COUNTED) as machine:
        while True:
            line = machine.line()
            if line is None:
                break
            lines.append(line)
        status = machine.process.wait(60)
    if status:
        raise Died("%s: exit status %d: %s" % (elf, status, " ".join(lines[-1:] + machine.errors)))
    return lines


def library_bytes(path, part=""):
    """Flash that the library takes, from a linker map; of the object `part` alone when it is given."""
    sys.path.insert(0, os.path.join(os.path.dirname(__file__), ".."))
    import size
    with open(path) as file:
        text = file.read()
    lines = text.split("Linker script and memory map", 1)[1].splitlines()
    return sum(count for output, count, source in size.sections(lines)
               if source and output in size.IN_FLASH and "libglint.a(" + part in source)
