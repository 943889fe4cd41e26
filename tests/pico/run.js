// SPDX-License-Identifier: MIT
// Runs firmware of the Raspberry Pi Pico: node run.js FIRMWARE.bin [STREAM [BUS [FRAMES]]]. Writes its text to stdout and
// ends with its exit status, or with 0 after so many frames; what goes over SPI0 goes to STREAM, as
// tests/panel/panel_stream.c reads it, with a picture asked for at each checkpoint: P name-number.ppm. Before it stands a
// comment with the instructions that the core has taken until then, the time, and for how long bytes were on the bus:
// "# instructions COUNT nanoseconds COUNT bus COUNT". The last line is a comment, "# nanoseconds TOTAL on the bus BUS".
// Where BUS is "free" bytes take no time, else it is "real": the difference is what the core waited for the bus.
// Firmware that writes "bus: stopped", "slow", "broken", "reset" or "mended" gets it so a while later
// (tests/board/faults.c); after a reset it runs as far as its first checkpoint, whose picture is reset-name-number.ppm.
import fs from "node:fs";
import path from "node:path";
import { createRequire } from "node:module";

// The packages lie where they were installed, not beside this file.
const require = createRequire(path.join(process.env.NODE_MODULES, "index.js"));
const { RP2040, GPIOPinState, LogLevel, ConsoleLogger } = require("rp2040js");

const FLASH = 0x10000000;
const BOOT_SIZE = 256;
const PIN_DATA = 16;
const PIN_SELECT = 17;
const PIN_RESET = 21;
const SILENCE_NS = 60e9; // of emulated time, without text or a byte on the bus
const FAULT = 100;
const BYTES_UNTIL_FAULT = 300; // the window and some pixels
const SLOWNESS = 100;
const DMA_READ_ERROR = 1 << 30;

const [image, stream, bus, frames] = process.argv.slice(2);
let framesLeft = Number(frames ?? Infinity);
const mcu = new RP2040();
const clock = mcu.clock;
mcu.logger = new ConsoleLogger(LogLevel.Error);
mcu.flash.set(fs.readFileSync(image));

// ---- The bus, seen from the panel

const out = stream ? fs.openSync(stream, "w") : null;
let lines = [];
let bytes = [];
let kind = "";
let lastSign = 0;

function flush() {
  if (bytes.length) {
    lines.push(kind + " " + bytes.map((byte) => byte.toString(16).padStart(2, "0")).join(" "));
    bytes = [];
  }
}

function note(line) {
  flush();
  lines.push(line);
  if (out !== null && lines.length > 1000) {
    fs.writeSync(out, lines.join("\n") + "\n");
    lines = [];
  }
}

let lastByteAt = 0;
function passTime() {
  const elapsed = Math.floor((clock.nanos - lastByteAt) / 1000);
  if (elapsed >= 100) { // delays count; the time that bytes take does not
    note("T " + elapsed);
    lastByteAt += elapsed * 1000;
  }
}

const spi = mcu.spi[0];
let clockNoted = 0;
let onBus = 0;
let fault = "mended";
let bytesUntilFault = 0;
let isStopped = false;
let leftBehind = false;
let hasToReset = false;
let wasReset = false;
const done = clock.createAlarm(() => spi.completeTransmit(0));

function breakBus() {
  if (fault === "stopped") {
    isStopped = true;
  } else if (fault === "broken") {
    mcu.dma.channels[0].ctrl |= DMA_READ_ERROR; // and a channel that has failed stands still
    mcu.dma.channels[0].abort();
  } else if (fault === "reset") {
    hasToReset = true;
  }
}

spi.onTransmit = (value) => {
  const hertz = spi.clockFrequency;
  if (hertz !== clockNoted) {
    note("H " + Math.round(hertz));
    clockNoted = hertz;
  }
  if (mcu.gpio[PIN_SELECT].value !== GPIOPinState.Low) {
    if (leftBehind) { // what the driver gave up leaves now, to no panel
      if (!isStopped) {
        done.schedule(0);
      }
      return;
    }
    throw new Error("a byte left while the panel was not selected");
  }
  passTime();
  const now = mcu.gpio[PIN_DATA].value === GPIOPinState.High ? "D" : "C";
  if (now !== kind || now === "C" || bytes.length === 256) {
    flush();
    kind = now;
  }
  bytes.push(value);
  lastSign = clock.nanos;
  leftBehind = fault !== "mended";
  if (fault !== "mended" && bytesUntilFault-- === 0) {
    breakBus();
  }
  const takes = ((8 * 1e9) / hertz) * (fault === "slow" && bytesUntilFault < 0 ? SLOWNESS : 1); // on the wire
  onBus += takes;
  if (!isStopped && !hasToReset) {
    done.schedule(bus === "free" ? 0 : takes);
  }
};
mcu.gpio[PIN_RESET].addListener((state) => {
  passTime();
  note("R " + (state === GPIOPinState.Low ? 1 : 0));
});

// ---- Text, arguments and exit status (Arm, "Semihosting for AArch32 and AArch64")

let text = "";
let status = null;
let instructions = 0;
const operations = {
  0x04: (argument) => {
    for (let at = argument, byte; (byte = mcu.readUint8(at)) !== 0; at++) {
      text += String.fromCharCode(byte);
    }
    for (let end; (end = text.indexOf("\n")) >= 0; text = text.slice(end + 1)) {
      const line = text.slice(0, end);
      console.log(line);
      const told = line.match(/^bus: (\w+)$/);
      if (told) {
        fault = told[1];
        bytesUntilFault = BYTES_UNTIL_FAULT;
        if (isStopped) {
          isStopped = false;
          done.schedule(0);
        }
      }
      const shown = line.match(/^(\S+) (\d+) done$/);
      if (shown) {
        passTime();
        note(`# instructions ${instructions} nanoseconds ${Math.round(clock.nanos)} bus ${Math.round(onBus)}`);
        note(`P ${wasReset ? "reset-" : ""}${shown[1]}-${shown[2]}.ppm`);
        status = wasReset || --framesLeft === 0 ? 0 : status;
      }
    }
    lastSign = clock.nanos;
    return 0;
  },
  0x15: () => -1,
  0x20: (argument) => {
    status = mcu.readUint32(argument + 4);
    return 0;
  },
};

const core = mcu.core;
mcu.onBreak = (code) => {
  const operation = operations[core.registers[0]];
  if (code !== 0xab || !operation) {
    console.log(`stopped at 0x${core.PC.toString(16)}`);
    status = FAULT;
    return;
  }
  core.registers[0] = operation(core.registers[1]);
};

// The boot ROM is not ours to have: start where it would, behind the second boot stage, or in it.
function start() {
  core.VTOR = FLASH + BOOT_SIZE;
  core.SP = mcu.readUint32(FLASH + BOOT_SIZE);
  core.PC = mcu.readUint32(FLASH + BOOT_SIZE + 4) & ~1;
}

// What the RUN pin does to the parts that this firmware uses; the panel is not told.
function reset() {
  done.cancel();
  for (const channel of mcu.dma.channels) {
    channel.abort();
    channel.reset();
  }
  spi.txFIFO.reset();
  spi.rxFIFO.reset();
  spi.busy = false;
  fault = "mended";
  hasToReset = false;
  wasReset = true;
  core.waiting = false;
  start();
}

start();

const cycle = 1e9 / 125e6;
while (status === null) {
  if (core.waiting) {
    clock.tick(clock.nanosToNextAlarm);
  } else {
    clock.tick(core.executeInstruction() * cycle);
    instructions++;
  }
  if (hasToReset) {
    reset();
  }
  if (clock.nanos - lastSign > SILENCE_NS) {
    console.log("no sign of life");
    status = FAULT;
  }
}
note(`# nanoseconds ${Math.round(clock.nanos)} on the bus ${Math.round(onBus)}`);
if (out !== null) {
  fs.writeSync(out, lines.join("\n") + "\n");
}
process.exitCode = status;
