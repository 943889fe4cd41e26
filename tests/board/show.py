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
import shutil
import subprocess
import sys
import tempfile

from panel import glass
from qemu import Died, Machine, Tally, check_stack
from picture import WRITE_MEMORY, Recorder, Wires, Wrong, read_netpbm, write_png

FRAMES = ["torus576-0", "torus576-1", "teapot-0", "teapot-1"]
ONE_MODEL = ("lm3s811evb",)  # boards whose flash holds but the torus


def names_of(lines):
    """Pictures that firmware said were done, as files are named."""
    return [line[:-len(" done")].replace(" ", "-") for line in lines if line.endswith(" done")]


class Pico:
    """Raspberry Pi Pico in rp2040js."""
    module, width, height, format, rotation = "st7789-240x240", 240, 240, "rgb565", 0
    frames = None  # the emulator ends after so many, where it is told so

    @staticmethod
    def run(firmware, stream, bus="real", frames=None):
        """@return what the firmware wrote, line by line, and its exit status."""
        script = os.path.join(os.path.dirname(__file__), "..", "pico", "run.js")
        run = subprocess.run(["node", script, firmware, stream, bus] + ([str(frames)] if frames else []),
                             stdout=subprocess.PIPE, text=True)
        return run.stdout.splitlines(), run.returncode

    def capture(self, firmware, stream, bus="real"):
        """@return what the firmware wrote; Died when it did not end well."""
        lines, status = self.run(firmware, stream, bus, self.frames)
        if status:
            raise Died("exit status %d: %s" % (status, lines[-5:]))
        return lines

    @staticmethod
    def times(stream):
        """Emulated nanoseconds in all, and those that bytes were on the bus."""
        with open(stream) as file:
            words = file.read().splitlines()[-1].split()
        return int(words[2]), int(words[6])

    def more(self, tally, firmware, stream):
        """Sending and drawing overlap: a bus that takes no time saves less than the time on it."""
        free = stream + "-free"
        self.capture(firmware, free, "free")
        (total, on_bus), (total_free, _) = self.times(stream), self.times(free)
        waited = total - total_free
        print("  pico: %.1f ms in all, %.1f ms on the bus, of which the core waited for %.1f ms" % (
            total / 1e6, on_bus / 1e6, waited / 1e6))
        tally.check(on_bus - waited > min(on_bus, total_free) / 4, "the core waits for the bus: DMA does not overlap")


class Dumped:
    """A board whose panel QEMU has: what its screen shows, at each checkpoint. Nothing of ours stands in between."""
    module, rotation = None, 0

    def __init__(self, machine, width, height, format, step):
        """`step`: from one of the panel's levels to the next on QEMU's screen."""
        self.machine, self.width, self.height, self.format, self.step = machine, width, height, format, step

    def levels(self, dump):
        return bytes(self.step * level for level in glass(dump, self.width, self.height, self.step))

    def capture(self, firmware, directory):
        """Firmware that says "reset 0 done" is reset there, and runs on to its first checkpoint."""
        lines, prefix = [], ""
        dump = os.path.join(directory, "screen.ppm")
        with Machine("qemu-system-arm", self.machine, firmware, ["stop"]) as machine:
            for line in iter(machine.line, None):
                lines.append(line)
                if line == "reset 0 done":
                    machine.command("system_reset")
                    prefix = "reset-"
                    continue  # a newline now would be read after the reset, and let the next picture go
                elif line.endswith(" done"):
                    machine.screendump(dump)
                    with open(os.path.join(directory, prefix + line[:-len(" done")].replace(" ", "-") + ".ppm"), "wb") as file:
                        file.write(b"P6\n%d %d\n255\n" % (self.width, self.height) +
                                   bytes(level for level in self.levels(dump) for _ in range(3)))
                    if prefix:
                        return lines
                if line.endswith(" done"):
                    machine.go_on()
            status = machine.process.wait(60)
        if status:
            raise Died("exit status %d: %s" % (status, lines[-1:]))
        return lines


class Virt:
    """QEMU's RISC-V machine: no panel, but a framebuffer, read out of memory at each checkpoint."""
    module, width, height, format, rotation = None, 320, 240, "rgb565", 0

    @staticmethod
    def address(elf, name):
        table = subprocess.run(["riscv64-unknown-elf-nm", elf], stdout=subprocess.PIPE, text=True, check=True).stdout
        return int(re.search(r"^([0-9a-f]+) . %s$" % name, table, re.M)[1], 16)

    def capture(self, firmware, directory):
        lines, memory = [], os.path.join(os.path.abspath(directory), "framebuffer")
        with Machine("qemu-system-riscv32", "virt", firmware, ["stop"]) as machine:
            for line in iter(machine.line, None):
                lines.append(line)
                if line.endswith(" done"):
                    machine.command("pmemsave", val=self.address(firmware, "virt_framebuffer"),
                                    size=2 * self.width * self.height, filename=memory)
                    self.convert(memory, os.path.join(directory, line[:-len(" done")].replace(" ", "-") + ".ppm"))
                    machine.go_on()
            status = machine.process.wait(60)
        if status:
            raise Died("exit status %d: %s" % (status, lines[-1:]))
        return lines

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


class Traced:
    """A board in QEMU, which logs every write to a register (tools/panel/picture.py).

    A frame ends when so many pixel bytes have been sent as it has."""

    def __init__(self, machine, panel, wires):
        self.machine, self.panel, self.wires = machine, panel, wires
        self.module, self.width, self.height, self.format, self.rotation = panel[:5]

    def frame_at(self, count):
        """The frame that ends with so many bytes of pixels, or None."""
        return count // self.panel.frame_bytes - 1 if count % self.panel.frame_bytes == 0 else None

    def capture(self, firmware, stream):
        with tempfile.TemporaryDirectory() as directory:
            trace = os.path.join(directory, "trace")
            with Machine("qemu-system-arm", self.machine, firmware,
                         options=("-trace", "memory_region_ops_write", "-D", trace)) as machine:
                lines = list(iter(machine.line, None))
                status = machine.process.wait(60)
            if status:
                raise Died("exit status %d: %s" % (status, lines[-5:]))
            names = names_of(lines)

            def end_frames(recorder, count):
                number = self.frame_at(count)
                if number is not None and number >= len(names):
                    raise Died("pixels of more frames than the firmware names")
                if number is not None:
                    recorder.note("P %s.ppm" % names[number])

            try:
                with open(trace) as file, open(stream, "w") as out:
                    Recorder(self.wires, out, self.panel.starts_pixels, end_frames).record(file)
            except Wrong as problem:
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


def run(arguments, tally, name, firmware, shown=(), program="show", frames=FRAMES):
    """Runs firmware and compares what it showed, (picture, the host's frame) each. @return what it wrote, line by line."""
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
