#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs examples/firmware/show_main.c on boards and compares what their panels show with what the host draws.

show.py --host SHOW_HOST --stream PANEL_STREAM --output DIRECTORY BOARD=FIRMWARE...

The stock firmware runs in an emulator that has no panel; what goes over the bus is captured and given to a model of the
panel's controller (tests/panel), whose picture must equal the host's pixel for pixel, without a complaint of the model.
Each picture is left as DIRECTORY/BOARD/<name>-<frame>.png.
"""
import argparse
import collections
import os
import re
import select
import shutil
import subprocess
import sys
import tempfile
import threading

from panel import glass
from qemu import Died, Machine, Tally, check_stack
from picture import WRITE_MEMORY, Recorder, Wires, Wrong, read_netpbm, write_png
import png  # tools/, where picture.py has it from

FRAMES = ["torus576-0", "torus576-1", "teapot-0", "teapot-1"]
ONE_MODEL = ("lm3s811evb",)  # boards whose flash holds but the torus


def names_of(lines):
    """Pictures that firmware said were done, as files are named."""
    return [line[:-len(" done")].replace(" ", "-") for line in lines if line.endswith(" done")]


def rows_of(path):
    """The rows of a picture, grey as red, green and blue."""
    with open(path, "rb") as file:
        return [[pixel * (3 // len(pixel)) for pixel in row] for row in png.decode(file.read()).rows]


def check_drawn(tally, what, host, arguments, picture):
    """Checks that a picture is what `glint render` draws by these arguments."""
    with tempfile.TemporaryDirectory() as folder:
        drawn = os.path.join(folder, "drawn.png")
        run = subprocess.run([host, "render", *arguments, "-o", drawn], capture_output=True, text=True)
        tally.check(run.returncode == 0 and rows_of(drawn) == rows_of(picture), "%s: not what glint render draws; %s" % (what, run.stderr))


class Pico:
    """Raspberry Pi Pico in rp2040js."""
    module, width, height, format, rotation, takes = "st7789-240x240", 240, 240, "rgb565", 0, ".bin"
    frames = None  # the emulator ends after so many, where it is told so
    patience = None  # seconds that it may take, where it is told so

    @staticmethod
    def run(firmware, stream, bus="real", frames=None, seconds=None):
        """@return what the firmware wrote, line by line, and its exit status: 0 when it has run for so many seconds."""
        script = os.path.join(os.path.dirname(__file__), "..", "pico", "run.js")
        try:
            run = subprocess.run(["node", script, firmware, stream, bus] + ([str(frames)] if frames else []),
                                 stdout=subprocess.PIPE, text=True, timeout=seconds)
        except subprocess.TimeoutExpired as late:
            with open(stream, "rb+") as file:  # whole lines
                file.truncate(file.read().rfind(b"\n") + 1)
            return (late.stdout or b"").decode().splitlines(), 0
        return run.stdout.splitlines(), run.returncode

    def capture(self, firmware, stream, bus="real"):
        """@return what the firmware wrote; Died when it did not end well."""
        lines, status = self.run(firmware, stream, bus, self.frames, self.patience)
        if status:
            raise Died("exit status %d: %s" % (status, lines[-5:]))
        return lines

    @staticmethod
    def times(stream):
        """Emulated nanoseconds in all, and those that bytes were on the bus."""
        with open(stream) as file:
            words = file.read().splitlines()[-1].split()
        return int(words[2]), int(words[6])

    @staticmethod
    def frame_times(stream):
        """(milliseconds, of these on the bus) of each picture, of the first one from the start on."""
        with open(stream) as file:
            done = [tuple(map(int, pair)) for pair in
                    re.findall(r"^# instructions \d+ nanoseconds (\d+) bus (\d+)$", file.read(), re.M)]
        return [((time - time_before) / 1e6, (bus - bus_before) / 1e6)
                for (time, bus), (time_before, bus_before) in zip(done, [(0, 0)] + done)]

    def more(self, tally, firmware, stream):
        """Sending and drawing overlap: a bus that takes no time saves less than the time on it."""
        free = stream + "-free"
        self.capture(firmware, free, "free")
        (total, on_bus), (total_free, _) = self.times(stream), self.times(free)
        waited = total - total_free
        print("  pico: %.1f ms in all, %.1f ms on the bus, of which the core waited for %.1f ms" % (
            total / 1e6, on_bus / 1e6, waited / 1e6))
        tally.check(on_bus - waited > min(on_bus, total_free) / 4, "the core waits for the bus: DMA does not overlap")


class Emulated:
    """A board in QEMU, which stops at each checkpoint to be looked at."""
    qemu, module, options, rotation, takes = "qemu-system-arm", None, (), 0, ".elf"
    counting = ()  # options by which a plugin counts
    frames = None  # it ends after so many, where it is told so
    patience = None  # seconds without a word after which it is looked at and ends, where it is told so

    def next_line(self, machine):
        """What the firmware writes next; in place of a silence, that a last picture is done."""
        try:
            return machine.line(self.patience)
        except Died:
            if self.patience is None:
                raise
            machine.command("stop")
            self.frames = 0
            return "last 0 done"

    def capture(self, firmware, output):
        """@return what the firmware wrote, line by line; Died when it did not end well. Firmware that says "reset 0 done" is
        reset there, and runs on to its first checkpoint."""
        lines, prefix = [], ""
        with Machine(self.qemu, self.machine, firmware, ["stop"], options=self.options + self.counting) as machine:
            for line in iter(lambda: self.next_line(machine), None):
                lines.append(line)
                if line == "reset 0 done":
                    machine.command("system_reset")
                    prefix = "reset-"  # a newline now would be read after the reset, and let the next picture go
                elif line.endswith(" done"):
                    name = prefix + line[:-len(" done")].replace(" ", "-") + ".ppm"
                    self.look(machine, firmware, output, name)
                    if prefix or self.frames is not None and len(names_of(lines)) >= self.frames:
                        return lines
                    machine.go_on()
            status = machine.process.wait(60)
        if status:
            raise Died("exit status %d: %s" % (status, lines[-5:]))
        return lines


class Dumped(Emulated):
    """A board whose panel QEMU has: what its screen shows. Nothing of ours stands in between."""

    def __init__(self, machine, width, height, format, step):
        """`step`: from one of the panel's levels to the next on QEMU's screen."""
        self.machine, self.width, self.height, self.format, self.step = machine, width, height, format, step

    def look(self, machine, _, directory, name):
        dump = os.path.join(directory, "screen")
        machine.screendump(dump)
        levels = bytes(self.step * level for level in glass(dump, self.width, self.height, self.step) for _ in range(3))
        with open(os.path.join(directory, name), "wb") as file:
            file.write(b"P6\n%d %d\n255\n" % (self.width, self.height) + levels)


class Virt(Emulated):
    """QEMU's RISC-V machine: no panel, but a framebuffer, read out of memory."""
    qemu, machine = "qemu-system-riscv32", "virt"
    width, height, format = 320, 240, "rgb565"

    @staticmethod
    def address(elf, name):
        table = subprocess.run(["riscv64-unknown-elf-nm", elf], stdout=subprocess.PIPE, text=True, check=True).stdout
        return int(re.search(r"^([0-9a-f]+) . %s$" % name, table, re.M)[1], 16)

    def look(self, machine, firmware, directory, name):
        memory = os.path.join(os.path.abspath(directory), "framebuffer")
        machine.command("pmemsave", val=self.address(firmware, "virt_framebuffer"), size=2 * self.width * self.height,
                        filename=memory)
        self.convert(memory, os.path.join(directory, name))

    def convert(self, source, target):
        with open(source, "rb") as file:
            data = file.read()
        out = bytearray()
        for at in range(0, len(data), 2):
            word = data[at] | data[at + 1] << 8
            for level, most in ((word >> 11, 31), (word >> 5 & 63, 63), (word & 31, 31)):
                out.append((level * 255 + most // 2) // most)
        with open(target, "wb") as file:
            file.write(b"P6\n%d %d\n255\n" % (self.width, self.height) + out)


# A panel of tests/panel, and what the host draws for it.
Panel = collections.namedtuple("Panel", "module width height format rotation frame_bytes starts_pixels")


def colour_panel(module):
    return Panel(module, 320, 240, "rgb565", 90, 2 * 320 * 240, WRITE_MEMORY)


# Parameters go with D/C low: all else are pixels.
SSD1306, SH1106 = (Panel(module, 128, 64, "mono", 0, 128 * 64 // 8, None) for module in ("ssd1306", "sh1106"))


class Trace(threading.Thread):
    """Records what QEMU writes into a pipe in place of a file, which would have thousands of bytes for each of a picture's."""

    def __init__(self, path, recorder):
        super().__init__(daemon=True)
        os.mkfifo(path)
        self.pipe = os.open(path, os.O_RDWR | os.O_NONBLOCK)  # as a writer too: so it has no end
        self.recorder, self.rest, self.problem = recorder, "", None
        self.lock, self.is_over = threading.Lock(), False

    def run(self):
        while not self.is_over:
            if select.select([self.pipe], [], [], 0.1)[0]:
                self.catch_up()

    def catch_up(self):
        """Reads all that is in the pipe."""
        with self.lock:
            while select.select([self.pipe], [], [], 0)[0]:
                *lines, self.rest = (self.rest + os.read(self.pipe, 1 << 20).decode()).split("\n")
                try:
                    for line in lines if self.problem is None else ():
                        self.recorder.read(line)
                except Wrong as problem:
                    self.problem = problem

    def end(self):
        """@return what was wrong with it, or None"""
        self.is_over = True
        self.join()
        self.catch_up()
        os.close(self.pipe)
        return self.problem


class Traced(Emulated):
    """A board in QEMU, which logs every write to a register (tools/panel/picture.py). `sent`: bytes of pixels of each picture."""

    def __init__(self, machine, panel, wires):
        self.machine, self.panel, self.wires = machine, panel, wires
        self.module, self.width, self.height, self.format, self.rotation = panel[:5]

    def look(self, _machine, _firmware, _stream, name):
        self.trace.catch_up()
        self.sent.append(self.recorder.pixel_bytes - sum(self.sent))
        self.recorder.note("P " + name)

    def capture(self, firmware, stream):
        self.sent = []
        with tempfile.TemporaryDirectory() as directory, open(stream, "w") as out:
            path = os.path.join(directory, "trace")
            self.options = ("-trace", "memory_region_ops_write", "-D", path)
            self.recorder = Recorder(self.wires, out, self.panel.starts_pixels)
            self.trace = Trace(path, self.recorder)
            self.trace.start()
            try:
                lines = super().capture(firmware, stream)
            finally:
                problem = self.trace.end()
            try:
                self.recorder.end()
            except Wrong as wrong:
                problem = problem or wrong
        if problem:
            raise Died(str(problem))
        return lines


def clock_of(hertz, divisor):
    """What a write to the register that divides the bus's clock notes."""
    return lambda recorder, value: recorder.note("H %d" % (hertz / divisor(value)))


def mps2(machine, data=0x40021008, misc=0x4002804c):
    """Arm MPS2: a PL022 and, in the FPGA, chip select (bit 0) and D/C (bit 4)."""
    return Traced(machine, colour_panel("ili9341"),
                  Wires("0x%x.4" % misc, "0x%x.0" % misc, data, others={data + 8: clock_of(25000000, lambda value: value)}))


def stm32(machine, panel, hertz, port_a, port_c):
    """SPI1, with chip select on PA4 and D/C on PC4, both by the ports' set/reset registers. The crystal does not start in
    QEMU: its internal oscillator clocks it."""
    return Traced(machine, panel, Wires(*("+0x%x.4,-0x%x.20" % (port, port) for port in (port_c, port_a)), 0x4001300c,
                                        others={0x40013000: clock_of(hertz, lambda value: 2 << (value >> 3 & 7))}))


def microbit():
    """A bus by hand, by registers that set and clear pins."""
    clock, bit, select, dc = ("+0x50000508.%d,-0x5000050c.%d" % (pin, pin) for pin in (23, 21, 16, 18))
    return Traced("microbit", SSD1306, Wires(dc, select, clock=clock, bit=bit))


def sifive_e():
    """A bus by hand, by a register that holds the levels of all pins."""
    clock, bit, select, dc = ("0x1001200c.%d" % pin for pin in (5, 3, 2, 1))
    return Traced("sifive_e", SH1106, Wires(dc, select, clock=clock, bit=bit))


BOARDS = {"lm3s6965evb": Dumped("lm3s6965evb", 128, 64, "grey4", 17),
          "lm3s811evb": Dumped("lm3s811evb", 96, 16, "mono", 255),
          "pico": Pico(), "virt": Virt(), "microbit": microbit(), "sifive_e": sifive_e(),
          "netduinoplus2": stm32("netduinoplus2", colour_panel("st7789-240x320"), 16000000, 0x40020018, 0x40020818),
          "stm32vldiscovery": stm32("stm32vldiscovery", SSD1306, 8000000, 0x40010810, 0x40011010),
          "mps2-an385": mps2("mps2-an385"), "mps2-an385-m0": mps2("mps2-an385"),
          "mps2-an386": mps2("mps2-an386"), "mps2-an500": mps2("mps2-an500"),
          "mps2-an505": mps2("mps2-an505", 0x40206008, 0x4030204c)}  # as they lie behind the gates to the buses


def compare(tally, name, shown, wanted):
    try:
        got, expected = read_netpbm(shown), read_netpbm(wanted)
    except OSError as problem:
        tally.check(False, "%s: %s" % (name, problem))
        return
    tally.check(got[:3] == expected[:3], "%s: %dx%d shown" % (name, got[0], got[1]))
    different = [at // 3 for at in range(0, len(expected[3]), 3) if got[3][at:at + 3] != expected[3][at:at + 3]]
    tally.check(not different, "%s: %d pixels differ, the first at %s; see %s" % (
        name, len(different), different and (different[0] % got[0], different[0] // got[0]), shown))
    pixels = got[0] * got[1]
    tally.check(sum(1 for byte in got[3] if byte) > 3 * min(200, pixels // 60), name + ": next to nothing is lit")
    write_png(shown, os.path.splitext(shown)[0] + ".png")


def draw_on_host(program, host, board, directory):
    """Draws what the board must show. @return the names of its pictures"""
    return subprocess.run([host, program, str(board.width), str(board.height), board.format, directory],
                          stdout=subprocess.PIPE, text=True, check=True).stdout.split()


def run(arguments, tally, name, firmware, shown=(), program="show", frames=FRAMES, sent=None):
    """Runs firmware and compares what it showed, (picture, the host's frame) each. `sent`: bytes of pixels that each sends
    over a bus that is traced, where that is not the whole picture. @return what it wrote, line by line."""
    board = BOARDS[name]
    directory = os.path.join(arguments.output, name)
    host = os.path.join(directory, "host")
    os.makedirs(host)
    drawn = draw_on_host(program, arguments.host, board, host)
    tally.check(drawn == frames, "%s: the host drew %s" % (name, drawn))
    if program == "show" and name in ONE_MODEL:
        frames = FRAMES[:2]
    stream = os.path.abspath(os.path.join(directory, "stream")) if board.module else directory
    try:
        lines = board.capture(firmware, stream)
    except (Died, OSError, subprocess.SubprocessError) as problem:
        tally.check(False, "%s: %s" % (name, problem))
        return []
    for line in lines:
        print("  %s: %s" % (name, line))
        check_stack(tally, os.path.splitext(firmware)[0] + ".elf", line)
    if isinstance(board, Traced):
        wanted = sent or [board.panel.frame_bytes] * len(names_of(lines))
        tally.check(board.sent == wanted, "%s: %s bytes of pixels are sent, not %s" % (name, board.sent, wanted))
    if board.module:
        show_stream(arguments, tally, name, board, firmware, directory, stream, shown)
    for picture, frame in shown or zip(frames, frames):
        compare(tally, "%s %s" % (name, picture), os.path.join(directory, picture + ".ppm"),
                os.path.join(host, frame + ".ppm"))
    return lines


def show_stream(arguments, tally, name, board, firmware, directory, stream, shown):
    """The model of the panel's controller takes what went over the bus, and writes its pictures beside it."""
    with open(stream) as file:
        model = subprocess.run([os.path.abspath(arguments.stream), "-r", str(board.rotation), board.module, "last.ppm"], stdin=file,
                               stdout=subprocess.PIPE, text=True, cwd=directory)
    print("  %s: %s" % (name, model.stdout.strip().splitlines()[-1:]))
    tally.check(model.returncode == 0, "%s: the panel's model complains: %s" % (name, model.stdout))
    if hasattr(board, "more") and not shown:
        board.more(tally, firmware, stream)


def read_arguments(*flags):
    parser = argparse.ArgumentParser()
    for flag in flags:
        parser.add_argument(flag, action="store_true")
    for name in ("host", "stream", "output"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    shutil.rmtree(arguments.output, ignore_errors=True)
    return arguments


def main():
    arguments = read_arguments()
    tally = Tally()
    for firmware in arguments.firmware:
        run(arguments, tally, *firmware.split("=", 1))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
