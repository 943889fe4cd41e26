// SPDX-License-Identifier: MIT
// The program: port/web/web.c and all that it links, in WebAssembly. Options are those of the host's command line.
"use strict";

const Glint = (() => {
  let wasm, memory;

  // Base 91, as page.py writes it, and then deflated.
  async function inflate(text) {
    const digits = Array.from({ length: 94 }, (_, i) => String.fromCharCode(33 + i)).filter((digit) => !"\"'\\".includes(digit));
    const values = Object.fromEntries(digits.map((digit, value) => [digit, value]));
    const bytes = [];
    let bits = 0, count = 0;
    for (let i = 0; i < text.length; i += 2) {
      const isPair = i + 1 < text.length, number = values[text[i]] + (isPair ? 91 * values[text[i + 1]] : 0);
      bits |= number << count;
      count = !isPair ? 8 : count + ((number & 0x1fff) < 91 * 91 - 0x2000 ? 14 : 13); // a last one ends a byte
      for (; count > 7; count -= 8, bits >>>= 8) {
        bytes.push(bits & 255);
      }
    }
    const stream = new Blob([new Uint8Array(bytes)]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  // ---- Models: port/web/page.py packs them

  function unpackModels({ heads, sizes }, bytes) {
    const streams = [];
    let at = 0;
    for (const size of sizes) {
      let next = at;
      streams.push(() => {
        const number = bytes[next] + 256 * bytes[next + size] + 65536 * bytes[next++ + 2 * size];
        return number % 2 ? -(number + 1) / 2 : number / 2;
      });
      at += 3 * size;
    }
    const [x, y, z, nx, ny, nz, corners, vertex, normal] = streams;
    return heads.map(([name, digits, normalDigits, points, normals, faces]) => {
      const lines = [];
      let [a, b, c] = [0, 0, 0];
      const text = (number, digits) => (number / 10 ** digits).toFixed(digits);
      for (let i = 0; i < points; i++) {
        a += x(), b += y(), c += z();
        lines.push(`v ${text(a, digits)} ${text(b, digits)} ${text(c, digits)}`);
      }
      a = b = 0;
      for (let i = 0; i < normals; i++) {
        a += nx(), b += ny();
        const left = Math.floor(Math.sqrt(Math.max(0, 10 ** (2 * normalDigits) - a * a - b * b)));
        const third = nz(), size = left + Math.floor(third / 2);
        c = third % 2 ? -size : size;
        lines.push(`vn ${text(a, normalDigits)} ${text(b, normalDigits)} ${text(c, normalDigits)}`);
      }
      for (let i = 0, fresh = 1; i < faces; i++) {
        let line = "f";
        for (let count = corners(); count > 0; count--) {
          const index = fresh - vertex();
          fresh = Math.max(fresh, index + 1);
          line += ` ${index}//${index + normal()}`;
        }
        lines.push(line);
      }
      return { name, bytes: new TextEncoder().encode(lines.join("\n") + "\n") };
    });
  }

  // ---- Memory

  // Bytes and their place in the program's memory.
  function give(bytes) {
    const at = wasm.web_room(bytes.length || 1);
    new Uint8Array(memory.buffer).set(bytes, at);
    return [at, bytes.length];
  }

  function giveText(text) {
    return give(new TextEncoder().encode(text + "\0"));
  }

  function giveWords(words) {
    return giveText(words.join("\0"));
  }

  function text(at) {
    const bytes = new Uint8Array(memory.buffer);
    return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
  }

  function handOver({ name, bytes }) {
    const [nameAt] = giveText(name);
    return wasm.web_hand(nameAt, ...give(bytes));
  }

  // What printf does with a double; an exponent has two digits at least there.
  function printReal(value, letter, digits, at) {
    let out;
    if (letter === 0x66) {
      out = value.toFixed(digits);
    } else {
      out = letter === 0x65 ? value.toExponential(digits) : String(Number(value.toPrecision(digits || 1)));
      out = out.replace(/e([+-])(\d)$/, "e$10$2");
    }
    const bytes = new TextEncoder().encode(out.slice(0, 64));
    new Uint8Array(memory.buffer).set(bytes, at);
    return bytes.length;
  }

  async function start(data) {
    const mathematics = Object.getOwnPropertyNames(Math).map((name) => [name, Math[name]]);
    const env = { ...Object.fromEntries(mathematics), web_print_real: printReal };
    const [program, packed] = await Promise.all([inflate(data.program), inflate(data.models.data)]);
    const { instance } = await WebAssembly.instantiate(program, { env });
    wasm = instance.exports;
    memory = wasm.memory;
    unpackModels(data.models, packed).forEach(handOver);
    if (!wasm.web_start()) {
      throw new Error(shown().problem);
    }
  }

  // ---- Calls

  // What was printed, "name value" a line, as an object of numbers.
  function numbers(told) {
    return Object.fromEntries(told.split("\n").filter(Boolean).map((line) => {
      const end = line.indexOf(" ");
      return [line.slice(0, end), Number(line.slice(end + 1))];
    }));
  }

  function shown() {
    const [width, height, pixels, errors, told, problem] = new Uint32Array(memory.buffer, wasm.web_shown(), 6);
    return {
      width, height,
      pixels: pixels && new Uint8ClampedArray(memory.buffer, pixels, 4 * width * height),
      errors: errors && new Float32Array(memory.buffer, errors, width * height),
      stats: numbers(text(told)), problem: text(problem).trim(),
    };
  }

  return {
    start,
    // Loads a model, with files that it may come from. Returns its half side, or what is wrong.
    load(words, files) {
      wasm.web_begin();
      files.forEach(handOver);
      return wasm.web_load(...giveWords(words)) ? { half: wasm.web_half_side(), notes: shown().problem } : { problem: shown().problem };
    },
    // Draws what was loaded, or a scene; what is returned holds until the next call.
    draw(words) {
      wasm.web_draw(...giveWords(words));
      return shown();
    },
    drawScene(scene, variant, words) {
      wasm.web_draw_scene(scene, variant, ...giveWords(words));
      return shown();
    },
    // Holds what was drawn against the reference.
    measure(same) {
      wasm.web_measure(same ? 1 : 0);
      return shown();
    },
    convert(words) {
      const at = wasm.web_convert(...giveWords(words));
      return at ? text(at) : null;
    },
    scenes() {
      wasm.web_list();
      const list = [];
      for (const line of text(new Uint32Array(memory.buffer, wasm.web_shown(), 6)[4]).split("\n").filter(Boolean)) {
        const [kind, name, ...rest] = line.split("\t");
        if (kind === "scene") {
          list.push({ name, width: +rest[0], height: +rest[1], frames: +rest[2], summary: rest[3], variants: [] });
        } else {
          list[list.length - 1].variants.push({ name, lookFor: rest[0] });
        }
      }
      return list;
    },
  };
})();
