// SPDX-License-Identifier: MIT
// The web page in Chromium: run.js MADE COMMITTED FOLDER. MADE is the page as `make figures` writes it, COMMITTED is docs/web,
// FOLDER has the program `errors` and takes what tests leave. Closes with `N passed, N failed`.
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import { createRequire } from "node:module";
import { spawnSync } from "node:child_process";
import { pathToFileURL } from "node:url";

// The packages lie where they were installed, not beside this file.
const require = createRequire(path.join(process.env.NODE_MODULES, "index.js"));
const { chromium } = require("playwright-core");

const [made, committed, folder] = process.argv.slice(2);
const ROOT = path.resolve(".");
const HOST = path.resolve("build/host/glint");
const MOST_BYTES = 352 * 1024;
const MOST_DIFFERENCE = 0.01; // steps: sin, cos and pow of the browser are not those of libm
const SPOT = "examples/models/spot.obj";

let passed = 0, failed = 0;
function check(name, holds, detail = "") {
  if (holds) {
    passed++;
  } else {
    failed++;
    console.log(`FAILED ${name}${detail ? `: ${detail}` : ""}`);
  }
}

function run(command, args, options = {}) {
  return spawnSync(command, args, { maxBuffer: 1 << 28, ...options });
}

// ---- Files

function checkFiles() {
  const names = fs.readdirSync(made).sort();
  check("docs/web has the files of the page", fs.readdirSync(committed).sort().join() === names.join());
  for (const name of names.filter((file) => file !== "data.js")) {
    const file = path.join(committed, name);
    check(`docs/web/${name} is what \`make figures\` writes`, fs.existsSync(file) && fs.readFileSync(file).equals(fs.readFileSync(path.join(made, name))));
  }
  const bytes = names.reduce((sum, name) => sum + fs.statSync(path.join(made, name)).size, 0);
  check("the page is small", bytes < MOST_BYTES, `${bytes} bytes`);
}

// ---- The page

const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox", "--force-color-profile=srgb"] });
const complaints = [];

async function openPage(url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  page.on("console", (message) => message.type() === "error" && complaints.push(`${url}: ${message.text()}`));
  page.on("pageerror", (error) => complaints.push(`${url}: ${error}`));
  page.on("request", (request) => {
    const asked = request.url();
    if (!asked.startsWith("data:") && !asked.startsWith("blob:") && !asked.startsWith(url.split("#")[0].replace(/[^/]*$/, ""))) {
      complaints.push(`${url} asks for ${asked}`);
    }
  });
  await page.goto(url);
  await page.waitForFunction(() => document.body.dataset.drawn, null, { timeout: 60000 });
  return page;
}

// The state that an address has, as the page writes it once it is drawn: changes wait for that.
async function show(page, address) {
  await forget(page);
  await page.evaluate((text) => {
    location.hash = text;
    dispatchEvent(new HashChangeEvent("hashchange")); // also where it was this one before
  }, address);
  await page.waitForFunction(() => document.body.dataset.drawn !== undefined, null, { timeout: 60000 });
}

const forget = (page) => page.evaluate(() => {
  delete document.body.dataset.drawn;
  delete document.body.dataset.settled;
});

// What has come to rest is what was drawn last: under load an earlier state may come to rest after its change.
const settle = (page) => page.waitForFunction(() => document.body.dataset.settled !== undefined &&
  document.body.dataset.settled === document.body.dataset.drawn, null, { timeout: 60000 });

async function after(page, action) {
  await forget(page);
  await action();
  await page.waitForFunction(() => document.body.dataset.drawn !== undefined, null, { timeout: 60000 });
}

// What the canvas shows, in base 64, without the fourth channel, which is 255.
const canvasOf = async (page) => {
  const { width, height, data, solid } = await page.evaluate(() => {
    const canvas = document.getElementById("canvas"), rgba = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    let text = "", solid = true;
    for (let i = 0; i < rgba.length; i += 4) {
      text += String.fromCharCode(rgba[i], rgba[i + 1], rgba[i + 2]);
      solid = solid && rgba[i + 3] === 255;
    }
    return { width: canvas.width, height: canvas.height, data: btoa(text), solid };
  });
  return { width, height, solid, rgb: Buffer.from(data, "base64") };
};

// ---- The host program

// The words of a command line that only quotes what it must.
function wordsOf(line) {
  return [...line.matchAll(/'([^']*)'|(\S+)/g)].map(([, quoted, plain]) => quoted ?? plain);
}

const commandOf = async (page) => wordsOf(await page.locator("#command").textContent());

function readPpm(bytes) {
  const [, width, height] = /^P6\n(\d+) (\d+)\n255\n/.exec(bytes.subarray(0, 32).toString("latin1")) || [];
  return { width: Number(width), height: Number(height), rgb: bytes.subarray(bytes.length - 3 * width * height) };
}

// The pictures of many command lines, at once: Python starts slowly. A line without words takes the picture as it is.
function picturesOf(jobs) {
  const script = `
import json, subprocess, sys
sys.path.insert(0, ${JSON.stringify(path.join(ROOT, "tools"))})
import png
for words, folder, name in json.load(sys.stdin):
    if words:
        subprocess.run(words, cwd=folder, check=True)
    image = png.decode(open(name, "rb").read())
    rows = b"".join(bytes(level for pixel in row for level in (pixel if len(pixel) == 3 else pixel * 3)) for row in image.rows)
    open(name[:-3] + "ppm", "wb").write(b"P6\\n%d %d\\n255\\n" % (image.width, image.height) + rows)
`;
  const result = run("python3", ["-c", script], { input: JSON.stringify(jobs) });
  if (result.status !== 0) {
    console.log(String(result.stderr));
    return jobs.map(() => null);
  }
  return jobs.map(([, , name]) => readPpm(fs.readFileSync(name.replace(/png$/, "ppm"))));
}

function hostPictures(list) {
  return picturesOf(list.map(({ words, cwd }, i) => {
    const name = path.resolve(folder, `host-${i}.png`);
    return [[HOST, ...words.slice(1, -1), name], cwd || ROOT, name];
  }));
}

function differences(a, b) {
  if (!b || a.width !== b.width || a.height !== b.height) {
    return `${a.width}x${a.height} is not ${b && b.width}x${b && b.height}`;
  }
  let count = 0;
  for (let i = 0; i < a.rgb.length; i++) {
    count += a.rgb[i] !== b.rgb[i];
  }
  return count ? `${count} levels differ` : "";
}

const isEmpty = ({ rgb }) => rgb.every((level) => level === rgb[0]);

// ---- Pixels

const THREE = "dir,-40,45,5,ffffff,0.7,20~point,70,-20,3,ff8040,0.8,20~spot,10,60,5,60a0ff,1.2,15,0.05,0.02";

// What each control can be set to.
function settingsToShow() {
  const list = [""];
  for (const at of ["flat", "vertex", "fragment"]) {
    for (const model of ["lambert", "phong", "blinn-phong", "unlit"]) {
      list.push(`at=${at}&model=${model}&p=20`);
    }
    list.push(`at=${at}&lights=${THREE}&m=sphere:12x8&above=25&ground=203040`);
  }
  for (const format of ["rgb565", "rgb444", "rgb888", "grey8", "grey4", "mono"]) {
    list.push(`format=${format}&m=cone-capped:10x2&paint=f0f0e0`, `format=${format}&dither=1&m=box&turn=40&tilt=30`);
  }
  for (const [panel, w, h] of [["st7789", 240, 240], ["st7735", 160, 128], ["gc9a01", 240, 240], ["ssd0323", 128, 64], ["own", 97, 33]]) {
    list.push(`panel=${panel}&w=${w}&h=${h}&zoom=1.3`);
  }
  for (const model of ["teapot", "pumpkin-merry", "pumpkin-grim", "pumpkin", "tree"]) {
    list.push(`m=examples/models/${model}.obj&turn=-30&above=15`);
  }
  list.push("tile=8x64&arena=9000", "local=0&metal=1&paint=d0a040&highlight=1", "lights=", "p=1", "p=1000&m=torus:64x32",
    "p=0.3&model=phong&lights=point,160,10,2,ffffff,1,20", "ungated=1&model=phong&p=2&lights=dir,150,20,5,ffffff,1,20", "larger=1&ambient=0.5",
    "lights=point,-40,45,3,ffffff,1,20,0.25,0", "lights=point,-40,45,3,ffffff,1,20,0,0.25",
    "opacity=0.5&m=sphere:12x8&ground=405060", "opacity=0.4&blend=add&ground=203040", "opacity=0.7&blend=dithered&format=rgb444",
    "fog=linear&ground=405060", "fog=squared&from=5&to=6&at=vertex&ground=800000", "smooth=1", "smooth=1&format=grey4&dither=1&panel=own&w=97&h=33",
    "opacity=0.5&fog=linear&smooth=1&ground=c0d0e0", "m=cylinder-capped:24x4&tilt=-100", "show=errors&show=picture");
  return list;
}

async function checkPixels(page) {
  const scenes = await page.evaluate(() => [...document.querySelectorAll("#model option")].map((option) => option.value).filter((value) => value.startsWith("scene:")));
  check("there are all scenes", scenes.length === 61, String(scenes.length));
  const shown = [];
  for (const address of [...scenes.map((name) => `m=${name}`), "m=scene:halloween:night&frame=24&w=160&h=128", ...settingsToShow()]) {
    await show(page, address);
    shown.push({ address, picture: await canvasOf(page), words: await commandOf(page), problem: await page.locator("#problem").textContent() });
  }
  const pictures = hostPictures(shown);
  shown.forEach(({ address, picture, problem }, i) => {
    const detail = problem || differences(picture, pictures[i]) || (picture.solid ? "" : "not opaque") || (isEmpty(picture) ? "empty" : "");
    check(`pixels of ${address || "the first picture"}`, !detail, detail);
  });
  check("pictures differ from each other", new Set(shown.map(({ picture }) => picture.rgb.toString("base64"))).size > shown.length * 0.85);
}

// ---- Files that are dropped

const PAINTED = `mtllib paint.mtl
v -1 -1 0\nv 1 -1 0\nv 1 1 0.3\nv -1 1 0\nv 0 0 1
usemtl red\nf 1 2 5\nf 2 3 5\nusemtl blue\nf 3 4 5\nf 4 1 5\n`;
const PAINT = "newmtl red\nKd 0.8 0.1 0.1\nKs 0.5 0.5 0.5\nNs 40\nnewmtl blue\nKd 0.1 0.2 0.9\n";

async function dropFiles(page, files) {
  await after(page, () => page.evaluate((list) => {
    const data = new DataTransfer();
    list.forEach(([name, text]) => data.items.add(new File([text], name)));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, files));
}

async function checkDropped(page) {
  const cwd = path.resolve(folder, "dropped");
  fs.mkdirSync(cwd, { recursive: true });
  const files = { "spot.obj": fs.readFileSync(SPOT, "utf8"), "painted.obj": PAINTED, "paint.mtl": PAINT, "my model.obj": PAINTED };
  Object.entries(files).forEach(([name, text]) => fs.writeFileSync(path.join(cwd, name), text));
  const shown = [];
  const take = async (name) => shown.push({ name, cwd, picture: await canvasOf(page), words: await commandOf(page) });
  await show(page, "");
  await dropFiles(page, [["spot.obj", files["spot.obj"]]]);
  await take("spot.obj, dropped");
  await dropFiles(page, [["paint.mtl", PAINT], ["painted.obj", PAINTED]]);
  await take("an OBJ with its MTL, dropped");
  check("materials of the file are taken", !shown[1].words.includes("--diffuse"));
  await after(page, () => page.setInputFiles("#file", path.join(cwd, "my model.obj")));
  await take("an OBJ whose name has a blank, opened");
  hostPictures(shown).forEach((picture, i) => {
    const detail = differences(shown[i].picture, picture) || (isEmpty(picture) ? "empty" : "");
    check(`pixels of ${shown[i].name}`, !detail, detail);
  });
  const problem = () => page.locator("#problem").textContent();
  await dropFiles(page, [["broken.obj", "v 1 2\nf 1 1 1\n"]]);
  check("what is wrong with a file is told, with its line", /broken\.obj:1: /.test(await problem()), await problem());
  const side = 240, grid = [...Array(side * side).keys()];
  await dropFiles(page, [["large.obj", grid.map((i) => `v ${i % side} ${Math.floor(i / side)} 0`).join("\n") + "\n" +
    grid.filter((i) => i % side && i >= side).map((i) => `f ${i - side} ${i - side + 1} ${i + 1} ${i}`).join("\n") + "\n"]]);
  check("a mesh too large for flash is told of", /more than microcontrollers have/.test(await problem()), await problem());
  await show(page, "m=absent.obj");
  check("a link to a file says so", /absent\.obj/.test(await problem()), await problem());
  await show(page, "");
  check("and is forgotten", await page.locator("#problem").isHidden());
}

// ---- Errors

async function checkErrors(page) {
  const cases = ["at=flat&against=exact", "at=vertex&p=200&against=exact", "at=fragment&p=8", "at=fragment&model=phong&against=exact&lights=" + THREE,
    "format=rgb444&dither=1", "format=mono&against=exact", "m=examples/models/teapot.obj&at=vertex&against=exact", "m=scene:shaders:torus-100",
    "m=scene:phong-lighting:near", "at=vertex", "m=scene:halloween:night", "format=mono&dither=1&at=flat"];
  for (const address of cases) {
    await show(page, `${address}&show=errors`);
    const same = !address.includes("against=exact");
    const text = await page.evaluate((isSame) => {
      const picture = draw() && Glint.measure(isSame);
      const bytes = new Uint8Array(picture.errors.buffer, picture.errors.byteOffset, picture.errors.byteLength);
      return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
    }, same);
    const words = (await commandOf(page)).slice(1, -2);
    const { stdout: native, status } = run(path.join(folder, "errors"), [words[0], same ? "1" : "0", ...words.slice(1)]);
    check(`sums of ${address} are the judge's`, status === 0, String(status));
    const bytes = Buffer.from(text, "base64");
    let worst = bytes.length === native.length && bytes.length > 0 ? 0 : Infinity, largest = 0;
    for (let i = 0; i + 4 <= Math.min(bytes.length, native.length); i += 4) {
      worst = Math.max(worst, Math.abs(bytes.readFloatLE(i) - native.readFloatLE(i)));
      largest = Math.max(largest, native.readFloatLE(i));
    }
    check(`errors of ${address}`, worst <= MOST_DIFFERENCE && largest > 0.1, `${worst} steps apart`);
    const map = await canvasOf(page);
    check(`the map of ${address} has colours`, new Set(map.rgb).size > 8);
  }
  // Where a scene is lit for an infinite viewer or per vertex, that is no error of the library's.
  await show(page, "m=scene:shaders:torus-50");
  await settle(page);
  const readout = await page.locator("#readout").textContent();
  check("a scene is judged by its own shading", Number(/worst pixel ([\d.]+) steps/.exec(readout)[1]) < 1, readout);
  await show(page, "");
}

// ---- Costs

// What the page says of boards is what the host program says.
async function checkCosts(page) {
  for (const address of ["", "lights=" + THREE, "at=vertex&format=grey4", "m=scene:teapot:flood-wide", "m=scene:three-spheres:vertex-dense"]) {
    await show(page, address);
    await settle(page);
    const told = String(run(HOST, [...(await commandOf(page)).slice(1, -1), path.join(folder, "cost.png"), "--stats"]).stdout);
    const own = await page.evaluate(() => stats);
    const wanted = [...told.matchAll(/^(passes|tiles|triangles|references|bytes_sent) ([\d.]+)$/gm)];
    const wrong = wanted.filter(([, name, value]) => own[name] !== Number(value)).map(([line, name]) => `${line}, not ${own[name]}`);
    check(`costs of ${address || "the first picture"}`, wanted.length === 5 && wrong.length === 0, wrong.join("; "));
  }
}

// ---- The program that is copied

const MODULES = { ili9341: ["ili9341", "90"], st7789: ["st7789-240x240", "0"], st7735: ["st7735-red", "90"], ssd1351: ["ssd1351", "0"],
  gc9a01: ["gc9a01", "0"], ssd0323: ["ssd0323", "0"], ssd1306: ["ssd1306", "0"] };

// Compiles and runs it, for a machine of 32 bits, as its arena is counted: on a model of its panel or, where there is no
// driver, on a display. Returns the picture.
function runProgram(text, name, { panel, width, height, format }) {
  const source = path.join(folder, `${name}.c`), program = path.join(folder, name);
  fs.writeFileSync(source, text);
  const sources = fs.readdirSync("port/panel").filter((file) => file.endsWith(".c")).map((file) => `port/panel/${file}`);
  const display = panel ? [] : [`-DWIDTH=${width}`, `-DHEIGHT=${height}`, `-DFORMAT=${format}`];
  const flags = "-std=c99 -O1 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Wno-missing-field-initializers -Isrc -Iport -Iexamples -Itests/image";
  const scenes = text.includes("scenes/scenes.h") ? fs.readdirSync("build/i686/examples/scenes").filter((file) => file.endsWith(".o")).map((file) => `build/i686/examples/scenes/${file}`) : [];
  const compiled = run("i686-linux-gnu-gcc", [...flags.split(" "), "-Dmain=scene_main", "-c", source, "-o", `${program}.o`]);
  const linked = compiled.status === 0 && run("i686-linux-gnu-gcc", ["-static", ...flags.split(" "), ...display, `${program}.o`, "tests/web/board.c", "tests/image/picture.c", ...sources, ...scenes,
    "build/i686/libglint.a", "-o", program]);
  if (!linked || linked.status !== 0) {
    return { problem: String((linked || compiled).stderr) };
  }
  const ran = run("qemu-i386", [program]);
  if (ran.status !== 0) {
    return { problem: `ended with ${ran.status}` };
  }
  if (!panel) {
    return readPpm(ran.stdout);
  }
  const [module, turn] = MODULES[panel];
  const glass = run("build/host/panel_stream", ["-r", turn, module, `${program}.ppm`], { input: ran.stdout });
  return glass.status === 0 ? readPpm(fs.readFileSync(`${program}.ppm`)) : { problem: String(glass.stdout) + String(glass.stderr) };
}

// Compiles it for a board with its panel and runs it there, as `make run` does but for its patience. Returns the picture.
const FIRMWARE = { "mps2-an385": "build/mps2-an385/O2/run.elf", lm3s6965evb: "build/lm3s6965evb/release/run.elf" };
function runOnBoard(name, board) {
  const built = run("make", ["--no-print-directory", `BOARD=${board}`, `PROGRAM=${path.join(folder, name)}.c`, FIRMWARE[board]]);
  const ran = run("python3", ["tests/board/run.py", "--stream", "build/host/panel_stream", "--output", path.join(folder, board), "--frames", "1",
    "--patience", "3600", board, FIRMWARE[board]]);
  const picture = String(ran.stdout).trim().split("\n").pop();
  return built.status === 0 && ran.status === 0 && picture.endsWith(".png") ? picturesOf([[[], ".", path.resolve(picture)]])[0] :
    { problem: String(built.stderr) + String(ran.stderr) + String(ran.stdout) };
}

async function checkProgram(page, name, address, display, what = address) {
  if (address !== null) {
    await show(page, address);
  }
  const picture = await canvasOf(page);
  await page.click("#code");
  const text = await page.locator("#dialog-text").inputValue();
  await page.click("#dialog button[value=close]");
  const drawn = runProgram(text, name, display);
  const detail = drawn.problem || differences(picture, drawn);
  check(`the program of ${what || "the first picture"}`, !detail, detail);
  if (display.board) {
    const shown = runOnBoard(name, display.board);
    check(`the program of ${what || "the first picture"} on ${display.board}`, !shown.problem && !differences(picture, shown),
      shown.problem || differences(picture, shown));
  }
}

async function checkPrograms(page) {
  await checkProgram(page, "scene-a", "", { panel: "ili9341", board: "mps2-an385" });
  await after(page, () => page.locator("#arena").fill("0"));
  check("the slider stops at the least arena", await page.evaluate(() => S.arena > 0 && S.arena === stats.need_least) &&
    await page.locator("#problem").isHidden());
  await checkProgram(page, "scene-least", null, { panel: "ili9341", board: "mps2-an385" }, "the least arena");
  await checkProgram(page, "scene-b", `panel=st7789&w=240&h=240&format=rgb444&dither=1&at=flat&lights=${THREE}`, { panel: "st7789" });
  await checkProgram(page, "scene-c", "panel=st7735&w=160&h=128&at=vertex&model=phong&local=0&p=0.5&larger=1&ungated=1", { panel: "st7735" });
  await checkProgram(page, "scene-d", "panel=ssd1306&w=128&h=64&format=mono&dither=1&at=vertex", { panel: "ssd1306" });
  await checkProgram(page, "scene-e", "panel=ssd0323&w=128&h=64&format=grey4&m=examples/models/teapot.obj&arena=40000", { panel: "ssd0323", board: "lm3s6965evb" });
  await checkProgram(page, "scene-f", "panel=ssd1351&w=128&h=128&dither=1&tile=16x8", { panel: "ssd1351" });
  await checkProgram(page, "scene-g", "panel=own&w=75&h=50&format=rgb888&ground=102030", { width: 75, height: 50, format: "glint_format_rgb888" });
  await checkProgram(page, "scene-h", "m=scene:shaders:torus-50&panel=own&w=320&h=180", { width: 320, height: 180, format: "glint_format_rgb565" });
  await checkProgram(page, "scene-round", "panel=gc9a01&w=240&h=240&model=lambert&metal=1", { panel: "gc9a01" });
  await checkProgram(page, "scene-k", "panel=st7789&w=240&h=240&opacity=0.5&fog=linear&smooth=1&ground=405060", { panel: "st7789" });
  await checkProgram(page, "scene-l", "m=scene:still-life:dusk&panel=own&w=160&h=120", { width: 160, height: 120, format: "glint_format_rgb565" });
  await checkProgram(page, "scene-unlit", "panel=st7735&w=160&h=128&model=unlit&m=box", { panel: "st7735" });
  await show(page, "");
  await dropFiles(page, [["painted.obj", PAINTED], ["paint.mtl", PAINT]]);
  await checkProgram(page, "scene-i", null, { panel: "ili9341" }, "a file and its materials");
  await after(page, () => page.uncheck("#own"));
  await checkProgram(page, "scene-j", null, { panel: "ili9341" }, "a file of several meshes");
}

// ---- What people do

async function checkHandling(page, url) {
  const state = (key) => page.evaluate((name) => S[name], key);
  await show(page, "");
  await page.focus("#canvas");
  await after(page, () => page.keyboard.press("ArrowRight"));
  check("an arrow key turns the model", (await state("turn")) === 25, String(await state("turn")));
  await page.focus("#handles button");
  await after(page, () => page.keyboard.press("ArrowUp"));
  check("an arrow key moves a light", (await state("lights")).startsWith("dir,-40,50,"), await state("lights"));
  const heard = [await page.locator("#handles button").getAttribute("aria-label"), await page.locator("#light-yaw").getAttribute("aria-valuetext"),
    await page.locator("#tilt").getAttribute("aria-valuetext")];
  check("directions are heard right", heard.join("; ") === "Light 1, directional: 40° left, 50° up; 40° left; 50° back", heard.join("; "));
  const box = await page.locator("#handles button").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await after(page, () => page.mouse.move(box.x + 150, box.y + 60, { steps: 3 }));
  await page.mouse.up();
  check("a light is dragged", !(await state("lights")).startsWith("dir,-40,50,"), await state("lights"));
  await after(page, () => page.locator('#thumbs input[value="vertex"]').check({ force: true }));
  check("shading is chosen by its picture", (await state("at")) === "vertex");
  await after(page, () => page.locator("#shininess").fill("4"));
  check("a slider sets the exponent", (await state("p")) === 16, String(await state("p")));
  await after(page, () => page.locator("#shininess").fill("-2"));
  check("an exponent may be below 1", (await state("p")) === 0.25, String(await state("p")));
  await after(page, () => page.check("#larger"));
  await after(page, () => page.check("#ungated"));
  const words = (await commandOf(page)).join(" ");
  check("boxes set flags of the material", words.includes("--combine max --ungated"), words);
  await after(page, () => page.locator("#opacity").fill("0.5"));
  await after(page, () => page.selectOption("#blend", "add"));
  await after(page, () => page.selectOption("#fog", "squared"));
  await after(page, () => page.locator("#to").fill("9"));
  await after(page, () => page.check("#smooth"));
  check("controls set opacity, fog and samples", /--samples 2x2/.test(await page.locator("#command").textContent()) &&
    / --opacity 0\.5 --blend add .* --fog 4\.5:9 --fog-type squared /.test(await page.locator("#command").textContent()));
  await settle(page);
  const told = await page.locator("#readout").textContent();
  check("no error is told of what the reference does not draw", /errors are measured of opaque objects/.test(told) && !/dB/.test(told), told);
  await after(page, () => page.locator("#opacity").fill("1"));
  await after(page, () => page.selectOption("#fog", "none"));
  await after(page, () => page.uncheck("#smooth"));
  await after(page, () => page.selectOption("#screen", "ssd1306"));
  check("a panel brings its size and format", (await state("w")) === 128 && (await state("format")) === "mono");
  await after(page, () => page.click('#light-tabs [data-act="add"]'));
  check("a light is added", (await page.locator("#handles button").count()) === 2);
  await after(page, () => page.locator("#light-quadratic").fill("0.1"));
  check("a lamp fades with the distance", /--light point:\S+:0:0\.1 /.test(await page.locator("#command").textContent()));
  await settle(page);
  const hash = new URL(page.url()).hash;
  const before = await canvasOf(page);
  const again = await openPage(url + hash);
  check("the address holds the whole state", differences(await canvasOf(again), before) === "" && hash.length > 40, hash);
  await again.context().close();
  const readout = await page.locator("#readout").textContent();
  check("the line below tells accuracy and memory", /dB PSNR.*working memory/.test(readout), readout);
  await after(page, () => page.click("#reset"));
  await settle(page);
  const marks = await page.locator("#frames-chart svg").getAttribute("aria-label");
  check("the chart marks the setting", /Chosen: fragment Blinn-Phong local, [\d.]+ decibels/.test(marks), marks);
  check("each chart has its rows", (await page.locator("#frames-chart path").count()) >= 15 && (await page.locator("#shading-chart path").count()) >= 20);
  check("sending is told for each part", (await page.locator("#times tbody tr").count()) >= 3);
  check("flash is told", /about/.test(await page.locator("#flash").textContent()));
}

// An address that nobody's page wrote: what it says wrongly is what it was at first.
async function checkForeign(page) {
  await show(page, "");
  const first = await canvasOf(page);
  await show(page, "at=none&model=x&fog=thick&blend=mud&format=rgb565_be&tile=3x3&show=q&core=z80&against=&paint=red&ground=<b>&lights=sun,-40,45,5,white,1,20&nonsense=1");
  check("a wrong address changes nothing", differences(await canvasOf(page), first) === "");
  await show(page, "p=nan&w=1e9&h=-5&panel=none&zoom=0&m=torus:1x1");
  check("what cannot be drawn is said", !(await page.locator("#problem").isHidden()));
  await show(page, "");
}

async function checkNames(page) {
  const nameless = await page.evaluate(() => [...document.querySelectorAll("input, select, button, textarea, canvas")].filter((element) => {
    const labelled = element.getAttribute("aria-label") || element.getAttribute("aria-hidden") || (element.labels && element.labels.length) || element.textContent.trim();
    return !labelled && !element.hidden && element.closest("[aria-hidden]") === null;
  }).map((element) => element.outerHTML));
  check("each control has a name", nameless.length === 0, nameless.join(" "));
  const names = await page.evaluate(() => [...document.querySelectorAll("button, label, summary")].map((one) => (one.firstChild ? one.firstChild.textContent : "").trim()));
  check("one control is called Turn", names.filter((name) => name === "Turn").length === 1);
  const label = await page.locator("#canvas").getAttribute("aria-label");
  check("the picture has a description", /Torus of 192 triangles, Blinn-Phong with exponent 50, lit per fragment/.test(label), label);
}

async function checkPhone(url) {
  for (const colorScheme of ["light", "dark"]) {
    const page = await openPage(url, { viewport: { width: 360, height: 740 }, deviceScaleFactor: 3, isMobile: true, hasTouch: true, colorScheme });
    await settle(page);
    const wide = await page.evaluate(() => document.scrollingElement.scrollWidth) - 360;
    check(`a phone does not scroll sideways, ${colorScheme}`, wide <= 0, `${wide} pixels`);
    const canvas = await page.locator("#canvas").boundingBox();
    check(`the picture is on a phone's first screen and as wide, ${colorScheme}`, canvas.y + canvas.height < 740 && canvas.width === 360, JSON.stringify(canvas));
    await checkInSight(page, `on a phone, ${colorScheme}`);
    await page.context().close();
  }
}

// At the last control, whose change one wants to see, all of the picture is on the screen.
async function checkInSight(page, where) {
  await page.locator("#reset").evaluate((button) => button.scrollIntoView({ block: "end" }));
  const canvas = await page.locator("#canvas").boundingBox(), { width, height } = page.viewportSize();
  check(`the picture stays in sight ${where}`, canvas.x >= 0 && canvas.y >= 0 && canvas.x + canvas.width <= width && canvas.y + canvas.height <= height,
    JSON.stringify(canvas));
}

async function checkDesktop(url) {
  for (const height of [720, 900]) {
    const page = await openPage(url, { viewport: { width: 1280, height } });
    const canvas = await page.locator("#canvas").boundingBox();
    check(`a pixel is a whole number of the screen's, 1280x${height}`, canvas.width % 320 === 0 && canvas.width >= 640, JSON.stringify(canvas));
    await checkInSight(page, `at 1280x${height}`);
    await page.context().close();
  }
}

// The program within the committed page need not be the last one, but draws the same.
async function checkCommitted() {
  const page = await openPage(pathToFileURL(path.resolve(committed, "index.html")).href);
  const shown = [];
  for (const address of ["", `lights=${THREE}&m=sphere:12x8`, "at=vertex&format=rgb444&dither=1", "m=scene:halloween:night&frame=24&w=160&h=128",
    "m=scene:shaders:torus-50", "m=examples/models/teapot.obj&local=0"]) {
    await show(page, address);
    shown.push({ address, picture: await canvasOf(page), words: await commandOf(page) });
  }
  const pictures = hostPictures(shown);
  shown.forEach(({ address, picture }, i) => {
    const detail = differences(picture, pictures[i]);
    check(`docs/web draws ${address || "the first picture"} (make figures)`, !detail, detail);
  });
  await page.context().close();
}

async function checkServer() {
  const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };
  const server = http.createServer((request, response) => {
    const file = path.join(made, path.basename(new URL(request.url, "http://localhost").pathname));
    response.writeHead(fs.existsSync(file) ? 200 : 404, { "Content-Type": types[path.extname(file)] || "application/octet-stream" });
    response.end(fs.existsSync(file) ? fs.readFileSync(file) : "");
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const url = `http://127.0.0.1:${server.address().port}/index.html`;
  const page = await openPage(url);
  check("a server's page draws", !isEmpty(await canvasOf(page)));
  const broken = await page.evaluate(async () => (await Promise.all([...document.links].map(async ({ href }) => [href, (await fetch(href)).ok]))).filter(([, ok]) => !ok));
  check("links of a server's page lead somewhere", broken.length === 0, broken.join(" "));
  await show(page, "m=sphere:24x16&p=9");
  const before = await canvasOf(page);
  await page.click("#link");
  const again = await openPage(page.url());
  check("the link that is copied shows the picture", differences(await canvasOf(again), before) === "" && page.url().includes("#m=sphere"), page.url());
  await again.context().close();
  await page.context().close();
  server.close();
}

checkFiles();
try {
  const url = pathToFileURL(path.resolve(made, "index.html")).href;
  const page = await openPage(url);
  await checkPixels(page);
  await checkDropped(page);
  await checkErrors(page);
  await checkCosts(page);
  await checkPrograms(page);
  await checkHandling(page, url);
  await checkForeign(page);
  await show(page, "");
  await settle(page);
  await checkNames(page);
  await checkDesktop(url);
  await checkPhone(url);
  await checkServer();
  await checkCommitted();
  check("no error on the console, and no request", complaints.length === 0, complaints.join("; "));
} catch (error) {
  check("the tests run to their end", false, error.stack);
}
await browser.close();
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
