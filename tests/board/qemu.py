# SPDX-License-Identifier: MIT
"""Runs firmware in QEMU, and pictures; shared by the suites of tests/board."""
import json
import os
import queue
import re
import socket
import subprocess
import sys
import tempfile
import threading
import time

sys.path += [os.path.join(os.path.dirname(__file__), "..", "..", "tools", tool) for tool in ("panel", "stack")]
import stack  # noqa: E402
from picture import read_netpbm  # noqa: E402, F401 (for the suites)

# Seconds after which an emulated program that says nothing is taken for dead. Generous: a loaded machine is no failure.
SILENCE = 180

# Machines that an emulator of their own runs, and what it must be told; all others are Arm's.
OTHER_EMULATORS = dict.fromkeys(("virt", "sifive_e"), [os.environ.get("QEMU_RISCV", "qemu-system-riscv32"), "-bios", "none"])
OTHER_EMULATORS["sim"] = ["qemu-system-xtensa", "-cpu", "lx106"]


class Died(Exception):
    """The program ended or fell silent where it should not have."""


class Machine:
    """A running emulator: what the firmware writes, and QEMU's own monitor."""

    def __init__(self, qemu, machine, elf, arguments=(), debugger=True, options=()):
        """Without a debugger, firmware has nobody to write to. `options` are the emulator's own."""
        self.directory = tempfile.TemporaryDirectory()
        control = os.path.join(self.directory.name, "qmp")
        config = "enable=on,target=native,chardev=text,arg=firmware" + "".join(",arg=" + a for a in arguments)
        self.process = subprocess.Popen(
            OTHER_EMULATORS.get(machine, [qemu]) +
            ["-M", machine, "-display", "none", "-serial", "none", "-monitor", "none", "-nodefaults",
             "-chardev", "stdio,id=text,signal=off", "-qmp", "unix:%s,server=on,wait=off" % control, "-kernel", elf] +
            (["-semihosting-config", config] if debugger else []) + list(options),
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.control_path, self.control = control, None
        self.lines = queue.Queue()
        self.errors = []
        threading.Thread(target=self._read, daemon=True).start()
        threading.Thread(target=self._read_errors, daemon=True).start()

    def _read(self):
        for line in self.process.stdout:
            self.lines.put(line.decode("ascii", "replace").rstrip("\r\n"))
        self.lines.put(None)

    def _read_errors(self):
        for line in self.process.stderr:
            self.errors.append(line.decode("utf-8", "replace").rstrip())

    def line(self, seconds=None):
        """The next line the firmware writes; None when it has ended. Died after a silence."""
        try:
            return self.lines.get(timeout=seconds or SILENCE)
        except queue.Empty:
            raise Died("no output for %d s" % (seconds or SILENCE))

    def go_on(self):
        self.process.stdin.write(b"\n")
        self.process.stdin.flush()

    def command(self, name, **arguments):
        """A command of QEMU's machine protocol."""
        if self.control is None:
            self._connect()
        self.control.write(json.dumps({"execute": name, "arguments": arguments}).encode() + b"\n")
        self.control.flush()
        while True:
            answer = json.loads(self.control.readline())
            if "error" in answer:
                raise Died("monitor: %s" % answer["error"])
            if "return" in answer:
                return answer["return"]

    def _connect(self):
        connection = socket.socket(socket.AF_UNIX)
        connection.settimeout(SILENCE)
        for _ in range(100):
            try:
                connection.connect(self.control_path)
                break
            except OSError:
                time.sleep(0.1)
        self.control = connection.makefile("rwb")
        self.control.readline()
        self.command("qmp_capabilities")

    def screendump(self, path):
        self.command("screendump", filename=os.path.abspath(path))

    def end(self):
        """Waits for the firmware to end. @return its exit status."""
        while self.line() is not None:
            pass
        return self.process.wait(SILENCE)

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.directory.cleanup()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


# Programs whose deepest chain of calls is known (tools/stack); tests are called through pointers of their own.
BOUNDED = ("show.elf", "animate.elf", "turntable.elf", "scenes.elf")


def check_stack(tally, elf, line):
    """
    Holds "stack used N" against the worst case, which test-stack holds against what the linker script reserves; or, where that
    is not known, against three quarters of what is reserved.
    """
    match = re.match(r"^stack used (\d+)$", line)
    if match and os.path.basename(elf) in BOUNDED:
        worst = stack.check(elf, stack.read(elf, stack.read_table()))[0]
        print("  %s: %s, at most %d" % (elf, line, worst))
        tally.check(0 < int(match[1]) <= worst, "%s: %s, but at most %d was found" % (elf, line, worst))
    elif match:
        with open(elf[:-len(".elf")] + ".size") as file:
            reserved = int(re.search(r"\(stack (\d+)\)", file.read())[1])
        tally.check(0 < 4 * int(match[1]) <= 3 * reserved, "%s: %s of %d bytes" % (elf, line, reserved))


class Tally:
    """Counts checks, prints those that fail, and closes as every suite does."""

    def __init__(self):
        self.passed = self.failed = 0

    def check(self, good, what):
        if good:
            self.passed += 1
        else:
            self.failed += 1
            print("FAILED: " + what)
        return good

    def close(self):
        print("%d passed, %d failed" % (self.passed, self.failed))
        return 1 if self.failed or not self.passed else 0


def write_grey(path, width, height, pixels):
    with open(path, "wb") as file:
        file.write(b"P5\n%d %d\n15\n" % (width, height) + bytes(pixels))
