# SPDX-License-Identifier: MIT
"""A screen in memory (Xvfb), a program on it, keys and mouse as an X server makes them (xdotool), and what shows."""
import os
import re
import struct
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools"))
import png  # noqa: E402

DEADLINE = 30  # seconds until what should show counts as missing; nothing waits longer than it takes


def until(holds):
    """Waits until `holds` returns something true. @return that, or what it returned last"""
    end = time.monotonic() + DEADLINE
    found = holds()
    while not found and time.monotonic() < end:
        time.sleep(0.02)
        found = holds()
    return found


class Screen:
    """An X server of its own; what it shows is read from the file that it keeps its framebuffer in."""
    def __init__(self, width=1400, height=840):
        self.folder = tempfile.TemporaryDirectory(prefix="glint-view-")
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "%dx%dx24" % (width, height),
                                        "-fbdir", self.folder.name, "-nolisten", "tcp", "-noreset"],
                                       pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as file:
            self.display = ":" + file.readline().strip()
        self.environment = {**os.environ, "DISPLAY": self.display, "SDL_VIDEODRIVER": "x11"}

    def close(self):
        self.server.terminate()
        self.server.wait()
        self.folder.cleanup()

    def xdotool(self, *words):
        run = subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True,
                             timeout=DEADLINE, check=False)
        return run.stdout

    def grab(self):
        """Rows of 3 bytes a pixel: the framebuffer is an XWD file."""
        with open(os.path.join(self.folder.name, "Xvfb_screen0"), "rb") as file:
            data = file.read()
        head = struct.unpack(">25I", data[:100])
        size, width, height, stride, colours = head[0], head[4], head[5], head[12], head[19]
        rows = []
        for y in range(height):
            at = size + 12 * colours + y * stride
            row = data[at:at + 4 * width]
            out = bytearray(3 * width)
            out[0::3], out[1::3], out[2::3] = row[2::4], row[1::4], row[0::4]
            rows.append(bytes(out))
        return rows


def read_font():
    """{rows of a glyph: its character}, from the strings in port/host/label.c."""
    with open(os.path.join(ROOT, "port", "host", "label.c")) as file:
        strips = re.findall(r'^        "([ #]{95})",$', file.read(), re.M)
    return {tuple(strips[code // 16 * 8 + y][code % 16 * 6:code % 16 * 6 + 5] for y in range(8)): chr(32 + code)
            for code in range(95)}


class Window:
    """The program under test, at its usual size but where a test changes it."""
    MARGIN, SIDE = 8, 372

    def __init__(self, screen, program, *arguments, size=(320, 240)):
        self.screen, self.size = screen, size
        self.folder = tempfile.TemporaryDirectory(prefix="glint-view-")
        self.program = subprocess.Popen([program, *arguments], env=screen.environment, cwd=self.folder.name)
        self.font = read_font()
        self.id = until(lambda: screen.xdotool("search", "--onlyvisible", "--pid", self.program.pid).split()[:1])[0]
        screen.xdotool("windowfocus", "--sync", self.id)
        self.measure()

    def measure(self):
        """The window's place, once the server tells all of it: of a window that is just being shown it may tell a part."""
        names = ("X", "Y", "WIDTH", "HEIGHT")

        def place():
            found = dict(line.split("=") for line in
                         self.screen.xdotool("getwindowgeometry", "--shell", self.id).split() if "=" in line)
            return [int(found[name]) for name in names] if all(name in found for name in names) else None
        self.x, self.y, self.width, self.height = until(place)

    def close(self):
        self.program.terminate()
        self.program.wait(DEADLINE)
        self.folder.cleanup()

    # ---- What is done

    def keys(self, *keys):
        self.screen.xdotool("key", *keys)

    def drag(self, start, across, down, button=1):
        """Presses at a point of the window, moves in two steps, lets go."""
        x, y = self.x + start[0], self.y + start[1]
        self.screen.xdotool("mousemove", "--sync", x, y, "mousedown", button, "mousemove", "--sync", x + across // 2, y + down // 2,
                            "mousemove", "--sync", x + across, y + down, "mouseup", button)

    def wheel(self, clicks):
        self.screen.xdotool("mousemove", "--sync", self.x + 100, self.y + 100, "click", "--repeat", abs(clicks),
                            4 if clicks > 0 else 5)

    # ---- What shows

    def scale(self):
        return max(1, min((self.width - self.SIDE - 2 * self.MARGIN) // self.size[0], (self.height - 2 * self.MARGIN) // self.size[1]))

    def canvas(self):
        return [row[3 * self.x:3 * (self.x + self.width)] for row in self.screen.grab()[self.y:self.y + self.height]]

    def blocks(self):
        """The picture as it stands on the canvas, magnified: rows of bytes."""
        width, height = self.size[0] * self.scale(), self.size[1] * self.scale()
        return [row[3 * self.MARGIN:3 * (self.MARGIN + width)] for row in self.canvas()[self.MARGIN:self.MARGIN + height]]

    def picture(self):
        """The picture, from the middles of its magnified pixels: a Picture."""
        scale = self.scale()
        rows = []
        for row in self.blocks()[scale // 2::scale]:
            columns = [row[3 * (scale // 2) + c::3 * scale] for c in range(3)]
            rows.append(list(zip(*columns)))
        return png.Picture(self.size[0], self.size[1], 3, rows)

    def read(self, left, top, right, bottom, scale=2):
        """Lines of text in a part of the canvas, each as far as its glyphs are known."""
        lines, canvas = [], self.canvas()
        y = top
        while y + 8 * scale <= bottom:
            line = self.read_line(canvas, left, right, y, scale)
            lines += [line] if line.strip() else []
            y += 9 * scale if line.strip() else 1
        return lines

    def read_line(self, canvas, left, right, y, scale):
        text = ""
        paper = canvas[0][:3]
        for x in range(left, right - 6 * scale, 6 * scale):
            glyph = tuple("".join(" " if canvas[y + row * scale][3 * (x + column * scale):][:3] == paper else "#"
                                  for column in range(5)) for row in range(8))
            if glyph not in self.font:
                return text
            text += self.font[glyph]
        return text.rstrip()

    def side(self):
        """The text beside the picture."""
        left = self.width - self.SIDE + self.MARGIN
        return self.read(left, self.MARGIN, self.width, self.height)
