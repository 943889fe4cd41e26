#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tool that draws what a trace of a bus puts on a panel (tools/panel/picture.py), from outside: traced.py PANEL_STREAM."""
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "board"))
from qemu import Tally  # noqa: E402
from picture import png  # noqa: E402

TOOL = os.path.join(HERE, "..", "..", "tools", "panel", "picture.py")
WIDTH, HEIGHT = 128, 64
START = bytes([0x8d, 0x14, 0x20, 0x00, 0xa1, 0xc8, 0xaf, 0x21, 0, 127, 0x22, 0, 7])
MEMORY = bytes((13 * at + at // 7) & 255 for at in range(WIDTH * HEIGHT // 8))

# A register of a port, and pins in it.
PORT, CLEAR, DATA = 0x40010810, 0x50, 0x4001300c
SELECT, DC, CLOCK, BIT = 3, 4, 5, 6


def wanted():
    """Lit pixels are white: bytes are columns of 8, the top one lowest."""
    return [[(255 * (MEMORY[y // 8 * WIDTH + x] >> y % 8 & 1),) * 3 for x in range(WIDTH)] for y in range(HEIGHT)]


def written(address, value):
    return "42@1.5:memory_region_ops_write cpu 0 mr 0x55 addr 0x%x value 0x%x size 4 name 'port'\n" % (address, value)


class Held:
    """Pins whose register holds their levels, a data register."""
    flags = ["--dc", "0x%x.%d" % (PORT, DC), "--select", "0x%x.%d" % (PORT, SELECT), "--data", "0x%x" % DATA]

    def __init__(self):
        self.levels = 1 << SELECT

    def pin(self, pin, level):
        self.levels = self.levels | 1 << pin if level else self.levels & ~(1 << pin)
        return written(PORT, self.levels)

    def byte(self, value):
        return written(0x40000000, value) + written(DATA, value)


class SetReset(Held):
    """One register sets pins by its lower half and clears them by its upper half."""
    flags = ["--dc", "+0x%x.%d,-0x%x.%d" % (PORT, DC, PORT, DC + 16),
             "--select", "+0x%x.%d,-0x%x.%d" % (PORT, SELECT, PORT, SELECT + 16), "--data", "0x%x" % DATA]

    def pin(self, pin, level):
        return written(PORT, 1 << (pin if level else pin + 16))


class ByHand(Held):
    """As the first, without a data register: the clock rises as the bit changes, in one write."""
    flags = Held.flags[:4] + ["--clock", "0x%x.%d" % (PORT, CLOCK), "--bit", "0x%x.%d" % (PORT, BIT)]

    def byte(self, value):
        text = ""
        for bit in range(7, -1, -1):
            self.pin(CLOCK, 0)
            text += written(PORT, self.levels)
            self.pin(CLOCK, 1)
            text += self.pin(BIT, value >> bit & 1)
        return text


class ByHandApart(SetReset):
    """Registers that set and clear, and bits by hand."""
    flags = [text for name, pin in (("--dc", DC), ("--select", SELECT), ("--clock", CLOCK), ("--bit", BIT))
             for text in (name, "+0x%x.%d,-0x%x.%d" % (PORT, pin, PORT + CLEAR, pin))]

    def pin(self, pin, level):
        return written(PORT if level else PORT + CLEAR, 1 << pin)

    def byte(self, value):
        return "".join(self.pin(CLOCK, 0) + self.pin(BIT, value >> bit & 1) + self.pin(CLOCK, 1) for bit in range(7, -1, -1))


def trace_of(bus, start=START):
    """A start and a frame; between them the bus sends a byte to something else."""
    text = bus.pin(DC, 0) + bus.pin(SELECT, 0) + "".join(map(bus.byte, start)) + bus.pin(SELECT, 1)
    return text + bus.pin(DC, 1) + bus.pin(SELECT, 0) + "".join(map(bus.byte, MEMORY)) + bus.pin(SELECT, 1)


class Tool:
    def __init__(self, stream, directory):
        self.stream, self.directory, self.tally = stream, directory, Tally()
        self.picture = os.path.join(directory, "picture.png")

    def run(self, what, text, flags, status, said="", module="ssd1306"):
        trace = os.path.join(self.directory, "trace")
        with open(trace, "w") as file:
            file.write(text)
        if os.path.exists(self.picture):
            os.remove(self.picture)
        done = subprocess.run([sys.executable, TOOL, "--stream", self.stream, module, trace, self.picture] + flags,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.tally.check(done.returncode == status, "%s: exit status %d: %s" % (what, done.returncode, done.stdout))
        self.tally.check(said in done.stdout, "%s: %s" % (what, done.stdout))

    def check_picture(self, what, pixels):
        self.tally.check(os.path.exists(self.picture) and png.read(self.picture).rows == pixels, what + ": another picture")


def test_wirings(tool):
    for wiring in (Held, SetReset, ByHand, ByHandApart):
        tool.run(wiring.__name__, trace_of(wiring()), wiring.flags, 0, " 0 complaints")
        tool.check_picture(wiring.__name__, wanted())
    tool.run("turned", trace_of(Held()), Held.flags + ["--turn", "180"], 0)
    tool.check_picture("turned", [row[::-1] for row in wanted()[::-1]])


def test_text(tool):
    tool.run("text", "T 1000\nC %s\nD %s\n" % (START.hex(" "), MEMORY.hex(" ")), [], 0)
    tool.check_picture("text", wanted())


def test_wrong(tool):
    bus = ByHand()
    half = bus.pin(DC, 0) + bus.pin(SELECT, 0) + bus.byte(0)[:-300] + bus.pin(SELECT, 1)
    tool.run("half a byte", half, ByHand.flags, 2, "a byte of ")
    tool.run("not selected", written(PORT, 1 << SELECT) + written(DATA, 0), Held.flags, 2, "chip select is not low")
    tool.run("no such register", written(DATA, 0), Held.flags, 2, "no write before it is to 0x%x: does QEMU" % PORT)
    tool.run("no trace", "nothing\n", Held.flags, 2, "no write of a register")
    tool.run("no line", "", ["--dc", "A4", "--select", "0x1.1", "--data", "0x2"], 2, "A4 is no line")
    tool.run("no data", "", Held.flags[:4], 2, "--data or --clock and --bit")
    tool.run("a complaint", trace_of(Held(), START + b"\x82"), Held.flags, 1, "no such command")
    tool.run("no module", "", [], 2, "modules:", module="none")


def main():
    with tempfile.TemporaryDirectory() as directory:
        tool = Tool(os.path.abspath(sys.argv[1]), directory)
        for test in (test_wirings, test_text, test_wrong):
            test(tool)
        return tool.tally.close()


if __name__ == "__main__":
    sys.exit(main())
