#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares what the emulated board's panel shows with what the host draws, pixel for pixel.

QEMU's panel model is the judge: it shows each pixel as 4x4 of its screen, in 16 greys. Where a frame differs, the panel's
picture, the host's, and their difference (white) stay in the output directory.
"""
import argparse
import os
import shutil
import subprocess
import sys
import time

from qemu import SILENCE, Died, Machine, Tally, check_stack, read_netpbm, write_grey

WIDTH, HEIGHT, MAGNIFIED, STEP = 128, 64, 4, 17

# The frames that a panel must show at least: two models, ten frames each; variants of three scenes.
TURNTABLE_FRAMES, SCENE_FRAMES = 20, 43


def glass(path, across=WIDTH, down=HEIGHT, step=STEP):
    """What the panel shows, a level for each pixel, a step of the screen's from one to the next, from a screendump."""
    width, height, channels, data = read_netpbm(path)
    if (width, height) != (across * MAGNIFIED, down * MAGNIFIED):
        raise Died("the screen is %dx%d" % (width, height))
    pixels = []
    for y in range(down):
        for x in range(across):
            block = set()
            for row in range(y * MAGNIFIED, (y + 1) * MAGNIFIED):
                at = (row * width + x * MAGNIFIED) * channels
                block.update(data[at:at + MAGNIFIED * channels])
            if len(block) != 1 or min(block) % step:
                raise Died("pixel %d,%d is not one grey, a multiple of %d" % (x, y, step))
            pixels.append(block.pop() // step)
    return pixels


def pattern():
    """The sum of tests/board/pattern.c."""
    return [(x * 7 + y * 11 + x * y // 5) & 15 for y in range(HEIGHT) for x in range(WIDTH)]


def compare(tally, name, shown, wanted, output):
    different = [index for index, pair in enumerate(zip(shown, wanted)) if pair[0] != pair[1]]
    path = os.path.join(output, name)
    write_grey(path + "-panel.pgm", WIDTH, HEIGHT, shown)
    write_grey(path + "-host.pgm", WIDTH, HEIGHT, wanted)
    if different:
        write_grey(path + "-difference.pgm", WIDTH, HEIGHT, [15 if a != b else 0 for a, b in zip(shown, wanted)])
    tally.check(not different, "%s: %d pixels differ, the first at %s; see %s-*.pgm" % (
        name, len(different), different and (different[0] % WIDTH, different[0] // WIDTH), path))
    lit = sum(1 for level in shown if level)
    tally.check(lit > 200, "%s: only %d pixels are lit" % (name, lit))


def watch(machine, tally, elf, output, wanted):
    """Takes a picture at each checkpoint until the firmware ends. @return the names of the frames seen."""
    seen = []
    while True:
        line = machine.line()
        if line is None:
            return seen
        if not line.endswith(" done"):
            print("  firmware: " + line)
            check_stack(tally, elf, line)
            continue
        name = line[:-len(" done")].replace(" ", "-")
        dump = os.path.join(output, name + "-screen.ppm")
        machine.screendump(dump)
        compare(tally, name, glass(dump), wanted(name), output)
        os.remove(dump)
        seen.append(name)
        machine.go_on()


def run(arguments, tally, elf, names, wanted):
    try:
        with Machine(arguments.qemu, "lm3s6965evb", elf, ["stop"]) as machine:
            seen = watch(machine, tally, elf, arguments.output, wanted)
            tally.check(seen == names, "%s: frames %s instead of %s" % (elf, seen, names))
            status = machine.process.wait(60)
            tally.check(status == 0, "%s: exit status %d %s" % (elf, status, " ".join(machine.errors)))
    except (Died, OSError, subprocess.SubprocessError) as problem:
        tally.check(False, "%s: %s" % (elf, problem))


def shown_alone(arguments, tally, elf, enough):
    """Waits until the panel of a board that no debugger listens to shows enough: firmware runs there as well."""
    dump = os.path.join(arguments.output, "alone-screen.ppm")
    end = time.monotonic() + SILENCE
    shown = []
    try:
        with Machine(arguments.qemu, "lm3s6965evb", elf, debugger=False) as machine:
            while not enough(shown) and time.monotonic() < end:
                time.sleep(0.1)
                machine.screendump(dump)
                shown = glass(dump)
            tally.check(machine.command("query-status")["status"] == "running", elf + ": the core has stopped")
    except (Died, OSError, ValueError) as problem:
        tally.check(False, "%s without a debugger: %s" % (elf, problem))
    tally.check(enough(shown), "%s without a debugger: not on the panel" % elf)


def exit_status(arguments, tally, elf):
    try:
        with Machine(arguments.qemu, "lm3s6965evb", elf) as machine:
            status = machine.end()
        tally.check(status == 0, "%s: exit status %d" % (elf, status))
    except (Died, OSError, subprocess.SubprocessError) as problem:
        tally.check(False, "%s: %s" % (elf, problem))


def draw_on_host(arguments, tally, program, directory, least):
    """@return the names of what the host drew."""
    drawn = subprocess.run([arguments.host, program, directory], stdout=subprocess.PIPE, text=True)
    names = drawn.stdout.split()
    tally.check(drawn.returncode == 0, "the host cannot draw the frames of " + program)
    tally.check(len(set(names)) >= least, "%s: the host drew %d different frames, not %d" % (
        program, len(set(names)), least))
    return names


def main():
    parser = argparse.ArgumentParser()
    for name in ("qemu", "output", "host", "pattern", "minimal", "turntable", "scenes"):
        parser.add_argument("--" + name, required=True)
    arguments = parser.parse_args()
    host = os.path.join(arguments.output, "host")
    shutil.rmtree(arguments.output, ignore_errors=True)
    os.makedirs(host)
    tally = Tally()
    run(arguments, tally, arguments.pattern, ["pattern-0"], lambda name: pattern())
    shown_alone(arguments, tally, arguments.pattern, lambda pixels: pixels == pattern())
    shown_alone(arguments, tally, arguments.minimal, lambda pixels: sum(map(bool, pixels)) > 200)
    exit_status(arguments, tally, arguments.minimal)
    for program, least in (("turntable", TURNTABLE_FRAMES), ("scenes", SCENE_FRAMES)):
        names = draw_on_host(arguments, tally, program, host, least)
        run(arguments, tally, getattr(arguments, program), names,
            lambda name: list(read_netpbm(os.path.join(host, name + ".pgm"))[3]))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
