#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a trace of a bus puts on a panel, as a PNG: `make panel-stream`, then

picture.py [--turn DEGREES] [--stream PANEL_STREAM] MODULE TRACE PICTURE.png
           [--dc LINE --select LINE (--data ADDRESS | --clock LINE --bit LINE)]

MODULE is the panel (ili9341, ssd1306 ...); --turn turns the picture back by as much as the driver turned it. TRACE is the text
that build/host/panel_stream reads (tests/panel/panel_stream.c), of a logic analyser say; or, where registers are named, what
QEMU writes with `-trace memory_region_ops_write -D TRACE`. Then --data is the register that bytes for the panel are written
to, or --clock and --bit are the lines of a bus by hand; --select is low while the panel is meant, and --dc is high for data.

A LINE is ADDRESS.BIT for a register that holds its level; +ADDRESS.BIT,-ADDRESS.BIT where a 1 at the first sets it and a 1 at
the second clears it (both may be one register's: +0x40011010.4,-0x40011010.20). Addresses are as QEMU writes them.

What the panel's model complains of is printed. Exit status: 0, 1 when it complained, 2 when the arguments or the trace are wrong.
"""
import argparse
import io
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import png  # noqa: E402

STREAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "host", "panel_stream")

# A write in QEMU's trace.
WRITE = re.compile(r"\bmemory_region_ops_write\b.* addr 0x([0-9a-f]+) value 0x([0-9a-f]+)")

WRITE_MEMORY = 0x2c  # the command before pixels in the MIPI display command set


class Wrong(Exception):
    """A trace or a line that makes no sense."""


# ---- Pictures

def read_netpbm(path):
    """A binary PGM or PPM as (width, height, samples per pixel, bytes)."""
    with open(path, "rb") as file:
        data = file.read()
    fields, at = [], 0
    while len(fields) < 4:
        end = at
        while not data[end:end + 1].isspace():
            end += 1
        fields.append(data[at:end])
        at = end + 1
    channels = {b"P5": 1, b"P6": 3}[fields[0]]
    return int(fields[1]), int(fields[2]), channels, data[at:]


def write_png(source, target):
    """Writes a PPM as a PNG."""
    with open(target, "wb") as file:
        file.write(png.encode(*read_netpbm(source)))


# ---- A bus as its registers show it

class Line:
    """A line of a bus, by the registers that move it."""

    def __init__(self, text):
        self.effects = []  # (address, bit, "+", "-" or "")
        for part in text.split(","):
            match = re.fullmatch(r"([+-]?)(0x[0-9a-fA-F]+)\.(\d+)", part)
            if not match:
                raise Wrong("%s is no line: ADDRESS.BIT, or +ADDRESS.BIT,-ADDRESS.BIT" % text)
            self.effects.append((int(match[2], 16), int(match[3]), match[1]))

    def after(self, address, value, level):
        """Its level after a write, where it had `level` before."""
        for register, bit, kind in self.effects:
            if register == address and (kind == "" or value >> bit & 1):
                level = kind == "+" or (kind == "" and bool(value >> bit & 1))
        return level


class Wires:
    """How a board's bus shows in its registers: `data` is one that bytes are written to; or `clock` and `bit` are lines, of
    which the bit counts when the clock rises. `others` are functions for further registers, of the recorder and the value."""

    def __init__(self, dc, select, data=None, clock=None, bit=None, others=None):
        self.lines = {name: Line(text) for name, text in
                      (("select", select), ("dc", dc), ("clock", clock), ("bit", bit)) if text}
        self.data, self.others = data, others or {}
        self.registers = {data, *self.others} | {effect[0] for line in self.lines.values() for effect in line.effects}
        self.registers.discard(None)


class Recorder:
    """Writes what goes over a bus as the text that panel_stream reads. The trace tells no times: the model gets all that it
    may want before each command. `starts_pixels` is the command whose data are pixels, which are counted; None: all data
    are."""

    def __init__(self, wires, out, starts_pixels=WRITE_MEMORY):
        self.wires, self.out, self.starts_pixels = wires, out, starts_pixels
        self.levels = dict.fromkeys(wires.lines)
        self.pending, self.bits, self.writes, self.seen = bytearray(), [], 0, set()
        self.is_pixel, self.pixel_bytes = starts_pixels is None, 0
        self.note("R 1\nT 100000\nR 0")

    def note(self, line):
        """Writes a line, behind the data before it."""
        if self.pending:
            self.out.write("D %s\n" % self.pending.hex(" "))
            self.pending.clear()
        self.out.write(line + "\n")

    def byte(self, value):
        if self.levels["dc"] is None or self.levels["select"] is not False:
            unseen = ["0x%x" % address for address in sorted(self.wires.registers - self.seen)]
            raise Wrong("a byte for no panel: chip select is not low, or D/C was never set" +
                        ("; no write before it is to %s: does QEMU have a register there?" % ", ".join(unseen) if unseen else ""))
        if not self.levels["dc"]:
            self.note("T 200000\nC %02x" % value)
            self.is_pixel = self.starts_pixels in (None, value)
            return
        self.pending.append(value)
        self.pixel_bytes += self.is_pixel

    def write(self, address, value):
        """A write to a register."""
        self.seen.add(address)
        before = dict(self.levels)
        for name, line in self.wires.lines.items():
            self.levels[name] = line.after(address, value, self.levels[name])
        if address in self.wires.others:
            self.wires.others[address](self, value)
        if address == self.wires.data:
            self.byte(value & 255)
        if self.levels.get("clock") and not before.get("clock") and self.levels["select"] is False:
            self.bits.append(int(bool(self.levels["bit"])))
            if len(self.bits) == 8:
                self.byte(int("".join(map(str, self.bits)), 2))
                self.bits = []
        if self.levels["select"] and self.bits:
            raise Wrong("a byte of %d bits" % len(self.bits))

    def read(self, line):
        """A line of a trace."""
        match = WRITE.search(line)
        self.writes += bool(match)
        if match and int(match[1], 16) in self.wires.registers:
            self.write(int(match[1], 16), int(match[2], 16))

    def end(self):
        """The trace is over."""
        self.note("# end")
        if not self.writes:
            raise Wrong("no write of a register: was it traced with memory_region_ops_write?")


# ---- The program

def show(program, module, turn, text, picture):
    """Draws a stream. @return the exit status of panel_stream"""
    with tempfile.TemporaryDirectory() as directory:
        ppm = os.path.join(directory, "picture.ppm")
        done = subprocess.run([program, "-r", turn, module, ppm], input=text, text=True)
        if os.path.exists(ppm):
            write_png(ppm, picture)
        return done.returncode


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--turn", default="0", choices=("0", "90", "180", "270"))
    parser.add_argument("--stream", default=STREAM)
    parser.add_argument("--data", type=lambda text: int(text, 16))
    for name in ("dc", "select", "clock", "bit"):
        parser.add_argument("--" + name)
    for name in ("module", "trace", "picture"):
        parser.add_argument(name)
    arguments = parser.parse_args()
    is_traced = arguments.dc is not None and arguments.select is not None and \
        (arguments.data is not None) != (arguments.clock is not None and arguments.bit is not None)
    if not is_traced and any((arguments.dc, arguments.select, arguments.data, arguments.clock, arguments.bit)):
        parser.error("registers: --dc, --select, and --data or --clock and --bit")
    if not os.path.exists(arguments.stream):
        parser.error("%s is not there: make panel-stream" % arguments.stream)
    try:
        with open(arguments.trace) as trace:
            if is_traced:
                text = io.StringIO()
                recorder = Recorder(Wires(arguments.dc, arguments.select, arguments.data, arguments.clock, arguments.bit), text)
                for line in trace:
                    recorder.read(line)
                recorder.end()
                text = text.getvalue()
            else:
                text = trace.read()
        return show(arguments.stream, arguments.module, arguments.turn, text, arguments.picture)
    except (Wrong, OSError) as problem:
        print("%s: %s" % (arguments.trace, problem), file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
