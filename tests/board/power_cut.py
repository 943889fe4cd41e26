#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs tests/board/power_cut_board.c and cuts its power: at seeded instants, some within each part of what it does. It starts
again, and its first frame must be the host's, bit for bit.

power_cut.py --qemu QEMU --nm NM --host SHOW_HOST --stream PANEL_STREAM --output DIRECTORY --cuts COUNT --seed SEED FIRMWARE

An instant is in ticks of a timer of 25 MHz; an instruction takes 64 ns, so that every one can be the last (-icount). The panel's
model is not reset with the core. In every second round of cuts its reset line is connected, and it forgets what it was told; in
the others it is as the cut has left it.
"""
import argparse
import bisect
import concurrent.futures
import os
import random
import re
import shutil
import subprocess
import sys

import show
from qemu import Died, Machine, Tally
from picture import Recorder, Wires, Wrong

MACHINE = "mps2-an385"
INSTANT = 0x21000000  # where the firmware reads when its power is cut
NEVER = 0xffffffff
MISC, LEDS, SPI_CONTROL, SPI_DATA = 0x4002804c, 0x40028000, 0x40021004, 0x40021008
RESET = 3  # the bit of MISC that is high while the panel is not reset
MODELS = {1: "torus576", 2: "teapot"}  # what the firmware writes to LEDS behind each frame
# What it says is done, in this order: start-up code, the panel's start, the scene and glint_init, what comes before the first
# tile, a row of tiles, the rest of the frame, and one more. Some cuts are within each.
PARTS = ["started", "panel", "scene", "tile", "row", "frame", "next-frame"]


class Run:
    """One run of the firmware, its power cut at an instant."""

    def __init__(self, arguments, name, instant, has_reset=True):
        self.directory = os.path.join(arguments.output, name)
        self.starts, self.shown, self.instant = 0, [], instant
        self.has_reset, self.is_reset = has_reset, False
        os.makedirs(self.directory)
        self._emulate(arguments)
        self._show(arguments)
        self.place = next((int(line.split()[-1]) for line in self.lines if line.startswith("cut at ")), None)

    def _emulate(self, arguments):
        trace = os.path.join(self.directory, "trace")
        options = ("-icount", "shift=6,sleep=off", "-device", "loader,addr=%d,data=%d,data-len=4" % (INSTANT, self.instant),
                   "-trace", "memory_region_ops_write", "-D", trace)
        with Machine(arguments.qemu, MACHINE, arguments.firmware, options=options) as machine:
            self.lines = list(iter(machine.line, None))
            self.status = machine.process.wait(60)
        wires = Wires("0x%x.4" % MISC, "0x%x.0" % MISC, SPI_DATA, 
                      others={SPI_CONTROL: self._control, LEDS: self._leds, MISC: self._misc})
        with open(trace) as file, open(os.path.join(self.directory, "stream"), "w") as out:
            recorder = Recorder(wires, out)
            for line in file:
                recorder.read(line)
            recorder.end()
        os.remove(trace)

    def _control(self, recorder, value):
        """The port is switched off only where it starts. What was shown before does not count."""
        if value == 0:
            self.starts += 1
            self.shown = []
            recorder.note("# start %d" % self.starts)

    def _misc(self, recorder, value):
        """The panel's reset line, which is pulled for as long as any panel wants."""
        is_reset = not value >> RESET & 1
        if self.has_reset and is_reset != self.is_reset:
            recorder.note("T 200000\nR %d" % is_reset)
        self.is_reset = is_reset

    def _leds(self, recorder, value):
        self.shown.append(MODELS[value])
        recorder.note("P %d-%s.ppm" % (self.starts, MODELS[value]))

    def _show(self, arguments):
        with open(os.path.join(self.directory, "stream")) as file:
            model = subprocess.run([os.path.abspath(arguments.stream), "-r", "90", "ili9341", "last.ppm"], stdin=file,
                                   stdout=subprocess.PIPE, text=True, cwd=self.directory)
        complaints = [line for line in model.stdout.splitlines() if line.startswith("byte ")]
        # What is wrong with a command shows by the next one.
        self.complaints = [line for line in complaints if int(re.match(r"byte (\d+)", line)[1]) > self._bytes_before() + 1]
        self.is_cut_short = len(complaints) > len(self.complaints)  # what was on its way when the power was cut
        if (model.returncode != 0) != (len(complaints) > 0):
            raise Wrong("the panel's model: " + model.stdout)

    def _bytes_before(self):
        """Bytes on the bus before the last start."""
        count = before = 0
        with open(os.path.join(self.directory, "stream")) as file:
            for line in file:
                count += len(line.split()) - 1 if line[0] in "CD" else 0
                before = count if line.startswith("# start") else before
        return before

    def picture(self, model):
        return os.path.join(self.directory, "%d-%s.ppm" % (self.starts, model))


def judge(tally, arguments, run, name, frames):
    """The frames since the last start are the host's."""
    tally.check(run.status == 0 and run.shown == frames, "%s: exit status %d, showed %s" % (name, run.status, run.shown))
    tally.check(not run.complaints, "%s: the panel's model complains: %s" % (name, run.complaints))
    for model in run.shown:
        show.compare(tally, "%s: %s" % (name, model), run.picture(model), os.path.join(arguments.output, "host", model + "-0.ppm"))


# ---- Instants

def measure(tally, arguments):
    """The frames of a board whose power stays. @return when each part begins and ends, but for pauses in which nothing happens"""
    whole = Run(arguments, "whole", NEVER)
    judge(tally, arguments, whole, "no cut", list(MODELS.values()))
    marks = [(name, int(ticks)) for name, ticks in map(str.split, whole.lines)]
    tally.check([name for name, _ in marks[:len(PARTS)]] == PARTS, "no cut: wrote %s" % whole.lines)
    ends = [ticks for _, ticks in marks[:len(PARTS)]]
    pauses = [ticks for _, ticks in marks[len(PARTS):]]
    tally.check(len(pauses) > 0 and ends == sorted(ends), "no cut: wrote %s" % whole.lines)
    parts = [[(begin, end)] for begin, end in zip([8] + ends, ends)]  # the first ticks are those of the timer's own start
    panel = PARTS.index("panel")
    (begin, end), = parts[panel]
    parts[panel] = list(zip([begin] + pauses[1::2], pauses[::2] + [end]))
    return parts


def choose(parts, cuts, seed):
    """Instants, the same number within each part."""
    chosen, instants = random.Random(seed), []
    for i in range(cuts):
        spans = parts[i % len(PARTS)]
        left = chosen.randrange(sum(end - begin for begin, end in spans))
        for begin, end in spans:
            if left < end - begin:
                break
            left -= end - begin
        instants.append((i % len(PARTS), begin + left))
    return instants


def read_functions(nm, elf):
    """Addresses of functions, ascending, and their names."""
    table = subprocess.run([nm, "-n", elf], stdout=subprocess.PIPE, text=True, check=True).stdout
    found = re.findall(r"^([0-9a-f]+) [tTwW] ([^$.]\S*)$", table, re.M)
    return [int(address, 16) & ~1 for address, _ in found], [name for _, name in found]


def report(runs, functions):
    """Prints where the power was cut. @return the functions"""
    addresses, names = functions
    places = []
    for part, run in runs:
        places.append(names[bisect.bisect_right(addresses, run.place) - 1] if run.place is not None else "nowhere")
        print("  cut at tick %8d, before %-10s is done: in %s" % (run.instant, PARTS[part], places[-1]))
    return places


# ---- The program

def read_arguments():
    parser = argparse.ArgumentParser()
    for name in ("qemu", "nm", "host", "stream", "output"):
        parser.add_argument("--" + name, required=True)
    for name in ("cuts", "seed"):
        parser.add_argument("--" + name, type=int, required=True)
    parser.add_argument("firmware")
    arguments = parser.parse_args()
    shutil.rmtree(arguments.output, ignore_errors=True)
    os.makedirs(os.path.join(arguments.output, "host"))
    return arguments


def main():
    arguments = read_arguments()
    tally = Tally()
    host = os.path.join(arguments.output, "host")
    subprocess.run([arguments.host, "show", "320", "240", "rgb565", host], stdout=subprocess.DEVNULL, check=True)
    try:
        instants = choose(measure(tally, arguments), arguments.cuts, arguments.seed)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            runs = list(pool.map(lambda at: Run(arguments, "cut-%d" % at[0], at[1][1], at[0] // len(PARTS) % 2 == 0), enumerate(instants)))
        again = Run(arguments, "again", instants[0][1])
    except (Died, Wrong, OSError, subprocess.SubprocessError) as problem:
        tally.check(False, str(problem))
        return tally.close()
    for run in runs:
        judge(tally, arguments, run, "cut at tick %d" % run.instant, ["torus576"])
        tally.check(run.place is not None and run.starts <= 2, "cut at tick %d: no cut, or two" % run.instant)
    places = report([(part, run) for (part, _), run in zip(instants, runs)], read_functions(arguments.nm, arguments.firmware))
    print("  %d cuts in %d functions; %d cut a command short" % (len(places), len(set(places)), sum(run.is_cut_short for run in runs)))
    tally.check(len(set(places)) >= min(len(runs) / 2, 10), "cuts are in few functions: %s" % sorted(set(places)))
    tally.check(again.place == runs[0].place, "the same instant is another instruction")
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
