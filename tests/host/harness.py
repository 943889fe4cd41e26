# SPDX-License-Identifier: MIT
"""Runs the program under test in a folder of its own, and counts what holds."""
import math
import os
import re
import subprocess
import tempfile
import traceback

import png

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MODELS = os.path.join(ROOT, "examples", "models")

# A square of side 2 before the camera, facing it, without normals: with the camera at z = 3 and a field of view of 90
# degrees it covers a third of the height.
SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"
SQUARE_VIEW = ["--eye", "0,0,3", "--fov", "90", "--size", "90x90"]


def torus_text(around, along):
    """A torus as OBJ text: radii 1 and 0.4 round z, smooth, without normals."""
    rings = [[((1 + 0.4 * math.cos(v)) * math.cos(u), (1 + 0.4 * math.cos(v)) * math.sin(u), 0.4 * math.sin(v))
              for v in (2 * math.pi * j / along for j in range(along))]
             for u in (2 * math.pi * i / around for i in range(around))]
    lines = [f"v {x:.9f} {y:.9f} {z:.9f}" for ring in rings for x, y, z in ring]
    for i in range(around):
        here, there = i * along + 1, (i + 1) % around * along + 1
        lines += [f"f {here + j} {there + j} {there + (j + 1) % along} {here + (j + 1) % along}" for j in range(along)]
    return "\n".join(lines) + "\n"


class Host:
    def __init__(self, program):
        self.program = os.path.abspath(program)
        self.folder = None
        self.passed = self.failed = 0

    def test(self, name, function):
        """Runs a test in a folder of its own."""
        with tempfile.TemporaryDirectory(prefix="glint-host-") as self.folder:
            try:
                function(self)
            except Exception:  # pylint: disable=broad-except # one broken test must not hide the others
                self.check(name, False, traceback.format_exc())

    # ---- What is checked

    def check(self, name, holds, detail=""):
        self.passed += bool(holds)
        self.failed += not holds
        if not holds:
            print(f"FAILED {name}{': ' if detail else ''}{detail}")

    def equal(self, name, got, wanted):
        self.check(name, got == wanted, f"got {got!r}, expected {wanted!r}")

    # ---- What is run

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        data = content if isinstance(content, bytes) else content.encode()
        with open(self.path(name), "wb") as file:
            file.write(data)
        return name

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def files(self):
        return sorted(os.listdir(self.folder))

    def run(self, *arguments, env=None, before=None):
        """Runs the program; `before` is called in its process, to limit what it may do."""
        return subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True, text=True,
                              timeout=60, check=False, env={**os.environ, **(env or {})}, preexec_fn=before)

    def render_bytes(self, *arguments, to="out.png"):
        """The PNG file that `render` writes; it must, and say nothing but why it shows nothing."""
        run = self.run("render", *arguments, "-o", to)
        if run.returncode != 0 or not re.fullmatch(r"(.*:0: warning: the picture (shows nothing|is black).*\n)?", run.stderr):
            raise AssertionError(f"render {' '.join(arguments)}: status {run.returncode}, {run.stderr.strip()}")
        data = self.read(to)
        os.remove(self.path(to))
        return data

    def render(self, *arguments):
        return png.decode(self.render_bytes(*arguments))

    def info(self, model, *arguments):
        """The `name value` lines of `info`, as a dictionary of strings."""
        run = self.run("info", model, *arguments)
        if run.returncode != 0 or run.stderr:
            raise AssertionError(f"info {model}: status {run.returncode}, {run.stderr.strip()}")
        return dict(line.split(" ", 1) for line in run.stdout.split("\n\n")[0].splitlines())

    def refuses(self, name, arguments, pattern, before=None, env=None):
        """Status 2, one line on stderr that the pattern matches whole, nothing on stdout, no file more or less."""
        files = self.files()
        run = self.run(*arguments, before=before, env=env)
        self.check(name, run.returncode == 2 and run.stdout == "" and run.stderr.endswith("\n") and
                   run.stderr.count("\n") == 1 and re.fullmatch(pattern, run.stderr.rstrip("\n")) is not None and
                   self.files() == files,
                   f"status {run.returncode}, stdout {run.stdout!r}, stderr {run.stderr!r}, files {self.files()}")


class Preloaded:
    """A library of C text, to stand before the C library's own functions."""

    def __init__(self, host, text):
        host.write("preloaded.c", text)
        self.library = os.path.join(host.folder + "-preloaded.so")
        subprocess.run(["cc", "-shared", "-fPIC", "-o", self.library, host.path("preloaded.c")], check=True)
        os.remove(host.path("preloaded.c"))

    def __enter__(self):
        return self.library

    def __exit__(self, *_):
        os.remove(self.library)
