#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The program that shows what a recorded bus stream puts on a panel, from outside: its picture, complaints and errors."""
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "board"))
from qemu import Tally, read_netpbm

WAKE = "T 120000\nC 11\nT 120000\n"
START = WAKE + "C 3a\nD 55\nC 36\nD %s\nC 29\n"
RED, BLACK = b"\xff\x00\x00", b"\x00\x00\x00"


class Stream:
    def __init__(self, program, directory):
        self.program, self.directory, self.tally = program, directory, Tally()

    def run(self, arguments, text):
        return subprocess.run([self.program] + arguments, input=text, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True)

    def picture(self, module, text, turn="0", status=0):
        """@return (width, height, pixels as a list of 3 bytes each)"""
        path = os.path.join(self.directory, "picture.ppm")
        done = self.run(["-r", turn, module, path], text)
        self.tally.check(done.returncode == status, "%s: exit status %d: %s" % (module, done.returncode, done.stderr))
        width, height, channels, data = read_netpbm(path)
        self.tally.check(channels == 3, module + ": not in colour")
        return width, height, [bytes(data[i:i + 3]) for i in range(0, len(data), 3)]

    def fails(self, arguments, text, status, said):
        done = self.run(arguments, text)
        self.tally.check(done.returncode == status, "%s: exit status %d" % (arguments, done.returncode))
        self.tally.check(said in done.stdout + done.stderr, "%s: %s%s" % (arguments, done.stdout, done.stderr))


def test_turned(stream):
    """A red row across the top of the picture, black elsewhere, as ILI9341 modules take it turned and upright."""
    for turn, access, width, height in (("0", "48", 240, 320), ("90", "28", 320, 240), ("180", "88", 240, 320),
                                        ("270", "e8", 320, 240)):
        text = START % access
        text += "C 2a\nD 00 00 %02x %02x\n" % divmod(width - 1, 256) + "C 2b\nD 00 00 %02x %02x\n" % divmod(height - 1, 256)
        text += "C 2c\n" + ("D" + " f8 00" * width + "\n") + ("D" + " 00 00" * width + "\n") * (height - 1)
        got = stream.picture("ili9341", text, turn)
        stream.tally.check(got == (width, height, [RED] * width + [BLACK] * (width * (height - 1))), "turned by " + turn)


def test_frames(stream):
    """Pictures in the middle of a stream."""
    path = os.path.join(stream.directory, "first.ppm")
    text = "T 1000\nC 8d 14 20 00 a1 c8 af\nC 21 00 7f 22 00 07\nD%s\nP %s\nC a7\n" % (" 00" * 1024, path)
    after = stream.picture("ssd1306", text)
    stream.tally.check(set(after[2]) == {b"\xff\xff\xff"}, "inverse")
    stream.tally.check(set(read_netpbm(path)[3]) == {0}, "the picture before")


def test_lines(stream):
    picture = os.path.join(stream.directory, "any.ppm")
    stream.fails(["ili9341", picture], "T 1000\nC 02\n", 1, "byte 1, command 02: no such command")
    stream.fails(["ili9341", picture], "R 1\nT 5\nR 0\nT 120000\nC 00\n", 1, "reset too short")
    stream.fails(["ili9341", picture], "H 20000000\nT 120000\nC 00\n", 1, "bus clock too high")
    stream.fails(["ili9341", picture], "# nothing\n\nT 120000\nC 00\n", 0, "1 bytes, 0 pixels, 0 complaints")
    for wrong in ("X 1", "C 1g", "C 100", "D -1", "T", "T x", "T 1 2", "R 2", "H -5", "P /nowhere/at/all"):
        stream.fails(["ili9341", picture], wrong + "\n", 2, "")
    stream.fails(["none", picture], "", 2, "modules: ili9341 ")
    stream.fails(["-r", "45", "ili9341", picture], "", 2, "modules:")
    stream.fails(["ili9341", "/nowhere/at/all"], "", 2, "/nowhere/at/all: cannot be written")


def main():
    with tempfile.TemporaryDirectory() as directory:
        stream = Stream(os.path.abspath(sys.argv[1]), directory)
        for test in (test_turned, test_frames, test_lines):
            test(stream)
        return stream.tally.close()


if __name__ == "__main__":
    sys.exit(main())
