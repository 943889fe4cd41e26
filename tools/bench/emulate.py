# SPDX-License-Identifier: MIT
"""Runs firmware that counts instructions; shared by the scripts that measure."""
import os
import sys
import tempfile

sys.path[:0] = [os.path.join(os.path.dirname(__file__), *folders)
                for folders in (("..", "..", "tests", "board"), ("..", "cycles"))]
from costs import read
from qemu import Died, Machine, Tally

# An instruction takes a nanosecond of emulated time; tools/bench/counter.h counts on it.
COUNTED = ("-icount", "shift=0")


def lines_of(qemu, machine_name, elf, options=(), is_last=None):
    """What the firmware writes, or up to a line that is the last one wanted; Died when it does not end well. `options` are the
    emulator's own."""
    lines = []
    with Machine(qemu, machine_name, elf, options=COUNTED + tuple(options)) as machine:
        while True:
            line = machine.line()
            if line is None:
                break
            if is_last and lines and is_last(lines[-1]):  # all that belongs to it is written by now
                return lines
            lines.append(line)
        status = machine.process.wait(60)
    if status:
        raise Died("%s: exit status %d: %s" % (elf, status, " ".join(lines[-1:] + machine.errors)))
    return lines


def counted_lines_of(qemu, machine_name, elf, plugin, tables=None, is_last=None):
    """The same, and what the plugin counted for each line of it: with words that are read where code lies if it knows where
    `tables` do, (first address, end)."""
    with tempfile.NamedTemporaryFile() as file:
        option = "%s,out=%s" % (os.path.abspath(plugin), file.name) + (",tables=%x:%x" % tables if tables else "")
        lines = lines_of(qemu, machine_name, elf, ("-plugin", option), is_last)
        counted = read(file.name)[:len(lines) if is_last else None]
    if len(lines) != len(counted):
        raise Died("%s: %d lines, %d of them counted" % (elf, len(lines), len(counted)))
    return lines, counted


def library_bytes(path, part=""):
    """Flash that the library takes, from a linker map; of the object `part` alone when it is given."""
    sys.path.insert(0, os.path.join(os.path.dirname(__file__), ".."))
    import size
    with open(path) as file:
        text = file.read()
    lines = text.split("Linker script and memory map", 1)[1].splitlines()
    return sum(count for output, count, source in size.sections(lines)
               if source and output in size.IN_FLASH and "libglint.a(" + part in source)
