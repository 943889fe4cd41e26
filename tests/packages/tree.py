# SPDX-License-Identifier: MIT
"""What all checks of packages share: the tree, commands, minimal.c and how it is judged."""
import glob
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "tests", "board"))
from qemu import read_netpbm  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
WARNINGS = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
M0 = ["-mcpu=cortex-m0", "-mthumb", "-ffreestanding"]

# minimal.c: for this machine, and for a Cortex-M0, on the port of no board in particular. Packages have the drivers.
DRIVERS = ["port/panel/panel.c", "port/panel/solomon.c", "port/panel/ssd0323.c"]
HOST = ["examples/firmware/minimal.c", "tests/packages/board.c"]
FIRMWARE = ["examples/firmware/minimal.c", "port/template/board.c", "port/cortex-m/startup.c",
            "port/semihosting/semihosting.c", "port/libc/memory.c"]
LINK = ["-nostdlib", "-Wl,--gc-sections", "-L" + os.path.join(ROOT, "linker"),
        "-T" + os.path.join(ROOT, "linker", "template.ld"), "-lgcc"]


class Failed(Exception):
    """A check's reason."""


def check(good, reason):
    if not good:
        raise Failed(reason)


def path(*parts):
    return os.path.join(ROOT, *parts)


def paths(names):
    return [path(name) for name in names]


def find(pattern):
    """Files of the tree, named from its root."""
    return sorted(os.path.relpath(name, ROOT) for name in glob.glob(path(pattern)))


def read(name):
    with open(path(name), encoding="utf-8") as file:
        return file.read()


def version():
    numbers = re.findall(r"^#define GLINT_VERSION_\w+ (\d+)$", read("src/glint.h"), re.MULTILINE)
    check(len(numbers) == 3, "src/glint.h has no version")
    return ".".join(numbers)


def run(*command, cwd=None, env=None, text=None):
    """What a command prints. It must end well."""
    done = subprocess.run(command, cwd=cwd, env=dict(os.environ, **(env or {})), input=text, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    check(done.returncode == 0, "%s: exit status %d:\n%s" % (" ".join(command[:6]), done.returncode, done.stdout[-3000:]))
    return done.stdout


class Build:
    """Where checks build, and what they compare with."""

    def __init__(self, build):
        self.build = os.path.abspath(build)
        self.reference = run(os.path.join(self.build, "packages", "minimal"))

    def folder(self, name):
        """An empty folder."""
        made = os.path.join(self.build, "packages", name)
        shutil.rmtree(made, ignore_errors=True)
        os.makedirs(made)
        return made

    def same(self, program):
        """Does minimal.c send what it sends when the Makefile builds it?"""
        check(run(program) == self.reference, program + ": sends other bytes to the panel")

    def glass(self, module, stream, turn=0):
        """What a bus stream puts on a panel: (width, height, channels, bytes); the panel must not complain."""
        picture = os.path.join(self.folder("glass-%s" % abs(hash(stream))), "glass.ppm")
        run(os.path.join(self.build, "host", "panel_stream"), "-r", str(turn), module, picture, text=stream)
        return read_netpbm(picture)


def firmware(elf):
    """An ELF file for the Cortex-M0 that has what minimal.c names, and nothing else."""
    symbols = set(line.split()[-1] for line in run("arm-none-eabi-nm", elf).splitlines())
    check("v6S-M" in run("arm-none-eabi-readelf", "-A", elf), elf + ": not for ARMv6-M")
    for name in ("glint_render", "glint_format_grey4", "glint_model_blinn_phong", "glint_light_directional"):
        check(name in symbols, "%s: without %s" % (elf, name))
    for name in ("glint_format_rgb888", "glint_format_mono", "glint_model_phong", "glint_light_spot",
                 "glint_pick", "glint_generate_torus"):
        check(name not in symbols, "%s: with %s, which nothing names" % (elf, name))
