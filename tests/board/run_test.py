#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`make run`, as a first user calls it: a model and a program of one's own on a board, and what it says when it cannot.

run_test.py --host GLINT --build DIRECTORY BOARD

The panel must show what `glint render` draws of the model. The program lies outside of the tree with a header of its own,
and has a variable that nothing uses.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile

import show
from qemu import Tally

MODEL = "examples/models/glow.obj"
ONE = 65536


def make(*words):
    """`make run`. @return its exit status, the last line of stdout, and what it says beside that but make's own lines"""
    done = subprocess.run(["make", "--no-print-directory", "run", *words], capture_output=True, text=True)
    said = [line for line in done.stderr.splitlines() if not line.startswith("make")]
    return done.returncode, done.stdout.splitlines(), said


def eye(header, board):
    """Where examples/firmware/model_main.c has its camera, in units: its height, and how far it is."""
    with open(header) as file:
        x, y, z = map(int, re.search(r"\{(\d+), (\d+), (\d+)\}, /\* extent", file.read()).groups())
    radius = int((x * x + z * z) ** 0.5)
    distance = max(radius // board.width * board.height, y + radius // 4) // 5 * 12 + radius
    return distance // 4 / ONE, distance / ONE


def prices(lines):
    """{frame: what its price says}, without the cycles, which not all cores have."""
    return {int(found[1]): found[2] for found in (re.match(r"  frame (\d+): (\d+\.\d+ (?:million instructions|ms))", line) for line in lines)
            if found}


def check_model(tally, name, board, build, host):
    status, lines, said = make("BUILD=" + build, "BOARD=" + name, "MODEL=" + MODEL, "FRAMES=2")
    pictures = [os.path.join(build, "run", name, "frame-%d.png" % frame) for frame in range(2)]
    tally.check((status, lines[-2:], said) == (0, pictures, []), "%s, a model: %d, %s, %s" % (name, status, lines, said))
    # A user who plans by prices would have none, or those of other work than that of a frame.
    counted = () if name in ("virt", "sifive_e") else range(1 if name == "pico" else 0, 2)
    tally.check(list(prices(lines)) == list(counted), "%s, a model: prices %s" % (name, lines))
    dither = ["--dither"] if board.format == "mono" else []  # as panels of one bit do by themselves
    height, distance = eye(os.path.join(build, "run", "model.h"), board)
    for frame, picture in enumerate(pictures):
        show.check_drawn(tally, "%s, frame %d of a model" % (name, frame), host,
                         [MODEL, "--centre", "--scale", "fit", "--rotate-y", str(330 + 10 * frame), "--light", "dir:-0.5,0.7,0.7", "--light",
                          "dir:0.8,0.1,0.6:0.25,0.25,0.25", "--size",
                          "%dx%d" % (board.width, board.height), "--format", board.format, "--eye", "0,%.9f,%.9f" % (height, distance),
                          *dither], picture)
    return prices(lines)


def check_program(tally, name, build, before):
    """The model's program as one's own: what it shows must not change, nor what a frame costs."""
    pictures = os.path.join(build, "run", name)
    with open(os.path.join(pictures, "frame-0.png"), "rb") as file:
        wanted = file.read()
    with tempfile.TemporaryDirectory() as folder:
        with open("examples/firmware/model_main.c") as file, open(os.path.join(folder, "main.c"), "w") as own:
            own.write('#define MODEL_HEADER "mine.h"\n' + file.read().replace("int main(", "static int left_over;\n\nint main("))
        shutil.copy(os.path.join(build, "run", "model.h"), os.path.join(folder, "mine.h"))
        status, lines, _ = make("BUILD=" + build, "BOARD=" + name, "PROGRAM=" + os.path.join(folder, "main.c"), "FRAMES=1")
    if name != "pico":  # of its first frame there is none
        tally.check(prices(lines).get(0) == before.get(0), "%s, a program: it costs %s, not %s" % (name, prices(lines), before))
    tally.check(status == 0 and os.listdir(pictures).count("frame-0.png") == 1, "%s, a program: %d, %s" % (name, status, lines))
    with open(os.path.join(pictures, "frame-0.png"), "rb") as file:
        tally.check(file.read() == wanted, "%s, a program: it shows something else" % name)


def check_errors(tally, build):
    for words, sentence in ((("BOARD=mine", "MODEL=" + MODEL), "there is no board 'mine': BOARD is one of .*pico"),
                            (("BOARD=pico", "PROGRAM=none.c"), "there is no program 'none.c': .*"),
                            (("BOARD=pico", "MODEL=none.obj"), "none.obj:0: cannot be opened: .*"),
                            (("BOARD=pico", "CROSS=none-"), "the compiler none-gcc is missing: .*")):
        status, _, said = make("BUILD=" + build, *words)
        tally.check(status == 2 and len(said) == 1 and re.match(sentence, said[0]), "%s: %d, %s" % (words, status, said))
    status, lines, _ = make("BUILD=" + build, "BOARD=template", "PROGRAM=examples/firmware/minimal.c")
    tally.check(status == 0 and lines[-1].startswith("template has no emulated panel"), "template: %d, %s" % (status, lines))


def main():
    parser = argparse.ArgumentParser()
    for name in ("--host", "--build", "board"):
        parser.add_argument(name)
    arguments = parser.parse_args()
    tally = Tally()
    paid = check_model(tally, arguments.board, show.BOARDS[arguments.board], arguments.build, arguments.host)
    check_program(tally, arguments.board, arguments.build, paid)
    check_errors(tally, arguments.build)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
