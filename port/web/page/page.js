// SPDX-License-Identifier: MIT
// The page's state, which is the address, and what shows it.
"use strict";

const $ = (id) => document.getElementById(id);
const radians = (degrees) => (degrees * Math.PI) / 180;
const limit = (value, least, most) => Math.min(most, Math.max(least, value));

// A number as the command line and C take it.
function decimal(value, digits = 4) {
  return String(+value.toFixed(digits) + 0);
}

// ---- What there is to choose from

const EVALUATIONS = [["flat", "Flat", "once a triangle"], ["vertex", "Per vertex", "Gouraud"], ["fragment", "Per fragment", "every pixel"]];

const REFLECTIONS = { "blinn-phong": "Blinn-Phong", phong: "Phong", lambert: "Lambert", unlit: "unlit" };

// Divisions from coarse to fine, tilt, and how far from its middle a model reaches.
const SHAPES = {
  torus: { name: "Torus", counts: ["8x6", "12x8", "16x10", "24x12", "32x16", "48x24", "64x32"], tilt: -50, reach: 1.4 },
  sphere: { name: "Sphere", counts: ["6x4", "8x6", "10x6", "12x8", "16x10", "24x16", "32x16", "48x32"], tilt: -60, reach: 1 },
  "cylinder-capped": { name: "Cylinder", counts: ["6x1", "10x2", "16x2", "24x4", "48x16"], tilt: -60, reach: 1.3 },
  "cone-capped": { name: "Cone", counts: ["6x1", "10x2", "16x4", "24x8", "48x16"], tilt: -60, reach: 1.3 },
  box: { name: "Box", counts: [], tilt: 0, reach: 1.6 },
};
const MODELS = [["teapot", "Teapot"], ["pumpkin-merry", "Pumpkin, carved"], ["pumpkin-grim", "Pumpkin, grim"], ["pumpkin", "Pumpkin"], ["tree", "Tree"]]
  .map(([file, name]) => [`examples/models/${file}.obj`, name]);
const MODEL_REACH = 1.1;

const PANELS = {
  ili9341: { name: "ILI9341, 320×240", width: 320, height: 240, format: "rgb565" },
  st7789: { name: "ST7789, 240×240", width: 240, height: 240, format: "rgb565" },
  st7735: { name: "ST7735, 160×128", width: 160, height: 128, format: "rgb565" },
  gc9a01: { name: "GC9A01, 240×240, round", width: 240, height: 240, format: "rgb565" },
  ssd1351: { name: "SSD1351, 128×128 OLED", width: 128, height: 128, format: "rgb565" },
  ssd0323: { name: "SSD0323, 128×64 OLED, 16 greys", width: 128, height: 64, format: "grey4" },
  ssd1306: { name: "SSD1306, 128×64 OLED, 1 bit", width: 128, height: 64, format: "mono", dithered: 1 },
  own: { name: "another size" },
};
const FORMATS = { rgb565: "RGB565", rgb444: "RGB444", rgb888: "RGB888", grey8: "256 greys", grey4: "16 greys", mono: "1 bit" };
const BLENDS = { alpha: "alpha", add: "added", dithered: "dithered" };
const FOGS = ["none", "linear", "squared"];
const CORES = { m0: "Cortex-M0", m3: "Cortex-M3", m4: "Cortex-M4", rv32: "RV32IMC" };
const TILES = [8, 16, 32, 64].flatMap((height) => [8, 16, 32, 64].map((width) => `${width}x${height}`));

// ---- State

const DEFAULTS = {
  m: "torus:12x8", frame: 0, turn: 20, tilt: -50, above: 0, zoom: 1,
  at: "fragment", model: "blinn-phong", p: 50, paint: "2f7fe0", ambient: 0.12, highlight: 0.7, metal: 0, local: 1, larger: 0, ungated: 0, own: 0,
  opacity: 1, blend: "alpha", fog: "none", from: 4.5, to: 7, smooth: 0,
  lights: "dir,-40,45,5,ffffff,1,20",
  panel: "ili9341", w: 320, h: 240, format: "rgb565", dither: 0, ground: "000000",
  tile: "32x32", arena: 0, show: "picture", against: "same", core: "m3",
};
const NEW_LIGHT = "point,60,10,4,ffb060,0.8,20";
let S = { ...DEFAULTS };
let chosenLight = 0;

function readAddress() {
  S = { ...DEFAULTS };
  for (const [key, value] of new URLSearchParams(location.hash.slice(1))) {
    if (key in DEFAULTS) {
      S[key] = typeof DEFAULTS[key] === "number" ? Number(value) || 0 : value;
    }
  }
  S.w = limit(Math.round(S.w), 8, 1024);
  S.h = limit(Math.round(S.h), 8, 1024);
  S.panel = S.panel in PANELS ? S.panel : "own";
  const known = { at: EVALUATIONS.map(([key]) => key), model: Object.keys(REFLECTIONS), format: Object.keys(FORMATS), tile: TILES,
    blend: Object.keys(BLENDS), fog: FOGS,
    show: ["picture", "errors"], against: ["exact", "same"], core: Object.keys(CORES) };
  for (const [key, values] of Object.entries(known)) {
    S[key] = values.includes(S[key]) ? S[key] : DEFAULTS[key];
  }
  for (const key of ["paint", "ground"]) {
    S[key] = /^[0-9a-f]{6}$/.test(S[key]) ? S[key] : DEFAULTS[key];
  }
  chosenLight = 0;
}

function address() {
  const changed = Object.entries(S).filter(([key, value]) => value !== DEFAULTS[key]);
  const text = new URLSearchParams(changed).toString().replace(/%3A/g, ":").replace(/%2C/g, ",").replace(/%2F/g, "/").replace(/%7E/g, "~").replace(/\*/g, "%2A");
  return text ? "#" + text : "#";
}

const lights = () => S.lights.split("~").filter(Boolean).map((text) => {
  const [kind, yaw, pitch, far, colour, power, cone, linear, quadratic] = text.split(",");
  return { kind: ["point", "spot"].includes(kind) ? kind : "dir", yaw: +yaw || 0, pitch: +pitch || 0, far: +far || 5, colour: /^[0-9a-f]{6}$/.test(colour) ? colour : "ffffff", power: +power || 0, cone: +cone || 20,
    linear: +linear || 0, quadratic: +quadratic || 0 };
}).slice(0, 8);

function setLights(list) {
  S.lights = list.map((l) => [l.kind, l.yaw, l.pitch, l.far, l.colour, l.power, l.cone,
    ...(l.linear || l.quadratic ? [l.linear, l.quadratic] : [])].join(",")).join("~");
}

const isScene = () => S.m.startsWith("scene:");
const isFile = () => S.m.endsWith(".obj");
const shapeOf = () => SHAPES[S.m.split(":")[0]];
const isBrought = () => MODELS.some(([path]) => path === S.m);

let scenes = [];
function chosenScene() {
  const [, name, variant] = S.m.split(":");
  const scene = Math.max(0, scenes.findIndex((one) => one.name === name));
  return { scene, variant: Math.max(0, scenes[scene].variants.findIndex((one) => one.name === variant)) };
}

// ---- From the state to the command line

const channels = (hex, factor = 1) => [0, 2, 4].map((at) => decimal((parseInt(hex.slice(at, at + 2), 16) / 255) * factor, 3)).join(",");

// From the camera's axes to the world's: the camera stands above the horizon, turned about x.
function toWorld([x, y, z]) {
  const up = radians(S.above);
  return [x, y * Math.cos(up) + z * Math.sin(up), z * Math.cos(up) - y * Math.sin(up)];
}

function directionOf({ yaw, pitch }) {
  return [Math.cos(radians(pitch)) * Math.sin(radians(yaw)), Math.sin(radians(pitch)), Math.cos(radians(pitch)) * Math.cos(radians(yaw))];
}

const joined = (vector, factor = 1) => vector.map((x) => decimal(x * factor)).join(",");

function lightWord(light) {
  const world = toWorld(directionOf(light)), fades = light.linear || light.quadratic;
  const colour = channels(light.colour, light.power) + (fades && light.kind !== "dir" ? `:${decimal(light.linear)}:${decimal(light.quadratic)}` : "");
  switch (light.kind) {
    case "point": return `point:${joined(world, light.far)}:${colour}`;
    case "spot": return `spot:${joined(world, light.far)}:${joined(world, -1)}:${decimal(light.cone * 0.7)},${decimal(light.cone)}:${colour}`;
    default: return `dir:${joined(world)}:${colour}`;
  }
}

const FIELD_OF_VIEW = 30;

function eye() {
  const reach = shapeOf() ? shapeOf().reach : MODEL_REACH;
  const distance = (reach * 1.08) / Math.tan(radians(FIELD_OF_VIEW / 2)) / Math.min(1, S.w / S.h) / S.zoom;
  return toWorld([0, 0, distance]);
}

let loaded = { key: null, half: 1, problem: "", notes: "" };
let dropped = [];

const modelWords = () => [S.m, ...(isFile() ? ["--centre", "--scale", scaleOf()] : [])];
const scaleOf = () => decimal(Number((1 / loaded.half).toPrecision(4)), 9);

function outputWords(arena = S.arena) {
  return ["--size", `${S.w}x${S.h}`, "--format", S.format, ...(S.dither ? ["--dither"] : []), ...(S.smooth ? ["--samples", "2x2"] : []),
    ...(S.tile !== DEFAULTS.tile ? ["--tile", S.tile] : []), ...(arena ? ["--arena", String(arena)] : [])];
}

const opacityWords = () => (S.opacity < 1 ? ["--opacity", decimal(S.opacity, 2), "--blend", S.blend] : []);
const fogWords = () => (S.fog === "none" ? [] : ["--fog", `${decimal(S.from, 2)}:${decimal(Math.max(S.to, S.from + 0.1), 2)}`, "--fog-type", S.fog]);

function surfaceWords() {
  if (S.own && isFile()) {
    return [];
  }
  return ["--model", S.model, "--ambient", channels(S.paint, S.ambient), "--diffuse", channels(S.paint),
    "--specular", S.metal ? channels(S.paint, S.highlight) : decimal(S.highlight, 3), "--shininess", decimal(S.p, 2),
    ...(S.larger ? ["--combine", "max"] : []), ...(S.ungated ? ["--ungated"] : []), ...opacityWords()];
}

function drawWords(evaluation) {
  return [...modelWords(), "--eye", joined(eye()), "--at", "0,0,0", "--fov", String(FIELD_OF_VIEW), "--rotate-x", decimal(S.tilt),
    "--rotate-y", decimal(S.turn), ...surfaceWords(), "--shading", evaluation, "--viewer", S.local ? "local" : "infinite",
    "--background", channels(S.ground), ...fogWords(), ...(lights().length ? lights() : [{ ...lightOff }]).flatMap((light) => ["--light", lightWord(light)]),
    ...outputWords(evaluation === S.at ? S.arena : 0)];
}

// Without lights the program would add one of its own.
const lightOff = { kind: "dir", yaw: 0, pitch: 0, far: 5, colour: "000000", power: 0, cone: 20, linear: 0, quadratic: 0 };

const sceneWords = () => [S.m.slice("scene:".length), "--frame", String(S.frame), ...outputWords()];

const quoted = (word) => (/^[\w.,:/=+-]+$/.test(word) ? word : `'${word.replace(/'/g, "'\\''")}'`);

function commandLine() {
  const words = isScene() ? ["scene", ...sceneWords()] : ["render", ...drawWords(S.at)];
  return ["build/host/glint", ...words, "-o", "picture.png"].map(quoted).join(" ");
}

// ---- Drawing

// Loads the model unless it is there: once to measure a file, then at its scale.
function ensureLoaded() {
  if (isScene() || loaded.key === S.m) {
    return;
  }
  loaded = { key: S.m, half: 1, problem: "", notes: "" };
  if (isFile() && !isBrought() && !dropped.some((file) => file.name === S.m)) {
    loaded.problem = `A link does not hold ${S.m}: open the file once more.`;
    return;
  }
  if (isFile()) {
    const first = Glint.load([S.m, "--centre"], dropped);
    loaded.half = first.half || 1;
    loaded.problem = first.problem || "";
  }
  if (!loaded.problem) {
    const result = Glint.load(modelWords(), dropped);
    loaded.problem = result.problem || "";
    loaded.notes = result.notes || "";
  }
}

function drawOnce(evaluation) {
  ensureLoaded();
  if (!isScene() && loaded.problem) {
    return { problem: loaded.problem, stats: {} };
  }
  if (isScene()) {
    const { scene, variant } = chosenScene();
    return Glint.drawScene(scene, variant, [...sceneWords(), "--stats"]);
  }
  return Glint.draw([...drawWords(evaluation), "--stats"]);
}

// An arena that has become too small grows to the least that will do. Ways of shading that are not chosen take what they need.
function draw(evaluation = S.at) {
  let picture = drawOnce(evaluation);
  if (!picture.pixels && S.arena && picture.stats.need_least > S.arena) {
    S.arena = picture.stats.need_least;
    picture = drawOnce(evaluation);
  }
  return picture;
}

// Errors in steps as colours: black, violet, red, yellow, white, by their logarithm.
const RAMP = [[0, 0, 0], [70, 20, 110], [190, 40, 70], [250, 160, 30], [255, 255, 220]];
const MOST_STEPS = 32;
const heatPlace = (steps) => limit(Math.log(1 + 2 * steps) / Math.log(1 + 2 * MOST_STEPS), 0, 1);
function heat(steps) {
  const place = heatPlace(steps) * (RAMP.length - 1);
  const low = Math.min(Math.floor(place), RAMP.length - 2), part = place - low;
  return RAMP[low].map((value, i) => value + (RAMP[low + 1][i] - value) * part);
}

function heatPixels(errors) {
  const pixels = new Uint8ClampedArray(4 * errors.length).fill(255);
  errors.forEach((steps, i) => pixels.set(heat(steps), 4 * i));
  return pixels;
}

function makeRamp() {
  const ramp = $("ramp").getContext("2d"), image = ramp.createImageData(256, 1);
  for (let i = 0; i < 256; i++) {
    image.data.set([...heat(((1 + 2 * MOST_STEPS) ** (i / 255) - 1) / 2), 255], 4 * i);
  }
  ramp.putImageData(image, 0, 0);
  $("ramp-marks").replaceChildren(...[0, 0.5, 2, 8, MOST_STEPS].map((steps) =>
    Object.assign(document.createElement("span"), { textContent: steps, style: `left:${100 * heatPlace(steps)}%` })));
}

function paint(canvas, picture, pixels) {
  if (canvas.width !== picture.width || canvas.height !== picture.height) {
    canvas.width = picture.width;
    canvas.height = picture.height;
  }
  canvas.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(pixels), picture.width, picture.height), 0, 0);
}

function show(canvas, picture) {
  paint(canvas, picture, S.show === "errors" && picture.errors ? heatPixels(picture.errors) : picture.pixels);
}

// Pixels of the panel are whole numbers of the screen's, but where the picture is as wide as a phone.
function fitCanvas() {
  const style = getComputedStyle($("panel")), frame = 2 * parseFloat(getComputedStyle($("glass")).borderLeftWidth);
  const room = $("panel").clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - frame;
  const tall = Math.max(160, innerWidth < 960 ? innerHeight * 0.5 : innerHeight - 200); // what stands below is seen too
  const dots = devicePixelRatio || 1, most = Math.min((room * dots) / S.w, (tall * dots) / S.h);
  const times = matchMedia("(max-width: 30rem)").matches ? most : Math.max(1, Math.floor(most));
  $("canvas").style.width = `${(S.w * times) / dots}px`;
  $("canvas").style.height = "auto";
}

let stats = {};
let generation = 0;
let isQueued = false;
let slowTimer = 0;

// Draws soon: the picture in the next frame of the screen, the rest once the state has come to rest.
function update() {
  generation++;
  if (!isQueued) {
    isQueued = true;
    requestAnimationFrame(() => {
      isQueued = false;
      drawPicture();
    });
  }
  clearTimeout(slowTimer);
  if (!spinning) {
    slowTimer = setTimeout(compare, 120);
  }
}

function drawPicture() {
  let picture = draw();
  if (picture.pixels && S.show === "errors") {
    picture = Glint.measure(S.against === "same");
  }
  tellProblem(picture.problem || (isScene() ? "" : loaded.notes));
  if (picture.pixels) {
    stats = picture.stats;
    fitCanvas();
    show($("canvas"), picture);
  }
  $("command").textContent = commandLine();
  showControls();
  document.body.dataset.drawn = address(); // for tests
}

function tellProblem(text) {
  $("problem").hidden = !text;
  $("problem").textContent = (text || "").replace(/^glint: /gm, "");
}

const pause = () => new Promise((resolve) => setTimeout(resolve, 0));

// Draws the scene in each way of shading, and holds it against the reference.
async function compare() {
  const mine = generation;
  const list = isScene() ? [S.at] : EVALUATIONS.map(([key]) => key).sort((a, b) => (b === S.at) - (a === S.at));
  for (const evaluation of list) {
    let picture = draw(evaluation);
    if (picture.pixels && !isScene()) { // all against the same picture
      picture = Glint.measure(false);
      showThumb(evaluation, picture);
    }
    if (isScene() || evaluation === S.at) {
      stats = (picture.pixels ? Glint.measure(S.against === "same") : picture).stats;
      showStats();
    }
    await pause();
    if (mine !== generation) {
      return;
    }
  }
  try {
    history.replaceState(null, "", address());
  } catch {
    // Some browsers allow no more than so many a second: the next one will do.
  }
  document.body.dataset.settled = address(); // for tests
}

// ---- Words for numbers

const bytes = (count) => (count >= 10240 ? `${(count / 1024).toFixed(1)} KB` : `${count} B`);
const milliseconds = (value) => `${value >= 100 ? Math.round(value) : value.toPrecision(3)} ms`;
const steps = (value) => (value < 10 ? value.toFixed(2) : value.toFixed(0));

function showStats() {
  const parts = [];
  if (stats.psnr !== undefined) {
    parts.push(`${stats.psnr.toFixed(1)} dB PSNR, worst pixel ${steps(stats.worst_steps)} steps off`);
  }
  if (stats.passes && stats.psnr === undefined) {
    parts.push("errors are measured of opaque objects, without fog and smooth edges");
  }
  if (stats.passes) {
    parts.push(`${bytes(S.arena || stats.need_one_pass)} of working memory, ${stats.passes === 1 ? "one pass" : stats.passes + " passes"}`);
  }
  $("readout").textContent = parts.join(" · ");
  $("canvas").setAttribute("aria-label", describe());
  showTimes();
  showRam();
  showFlash();
  Charts.frames($("frames-chart"), DATA, chartState());
  Charts.shading($("shading-chart"), DATA, chartState());
}

function describe() {
  const format = FORMATS[S.format] + (S.dither ? " dithered" : "");
  if (isScene()) {
    const { scene, variant } = chosenScene();
    return `Example scene ${scenes[scene].name}, ${scenes[scene].variants[variant].name}. ${scenes[scene].variants[variant].lookFor} ${format}.`;
  }
  const name = shapeOf() ? shapeOf().name : S.m.split("/").pop();
  const shading = EVALUATIONS.find(([key]) => key === S.at);
  return `${name} of ${stats.scene_triangles} triangles, ${REFLECTIONS[S.model]} with exponent ${decimal(S.p, 2)}, lit ${shading[1].toLowerCase()}, ` +
    `${["no light", "one light"][lights().length] || `${lights().length} lights`}, ${S.w} by ${S.h} pixels, ${format}${S.show === "errors" ? "; shown as an error map" : ""}.`;
}

function chartState() {
  const viewer = S.local ? "local" : "infinite";
  const place = { flat: "facet" }[S.at] || S.at;
  const choices = S.model === "lambert" ? [`${place} Lambert`] : [`${place} ${REFLECTIONS[S.model]} ${viewer}`];
  return { core: S.core, choices: isScene() ? [] : choices, triangles: isScene() ? 0 : stats.scene_triangles, evaluation: place };
}

// ---- Tables

function table(head, rows) {
  const made = document.createElement("table");
  const line = (cells, tag, parent, className) => {
    const row = parent.appendChild(document.createElement("tr"));
    row.className = className || "";
    cells.forEach((text, i) => {
      const cell = row.appendChild(document.createElement(i === 0 ? "th" : tag));
      cell.scope = tag === "th" ? "col" : i === 0 ? "row" : "";
      cell.textContent = text;
    });
  };
  if (head) {
    line(head, "th", made.appendChild(document.createElement("thead")));
  }
  const body = made.appendChild(document.createElement("tbody"));
  rows.forEach(({ cells, total }) => line(cells, "td", body, total ? "total" : ""));
  return made;
}

function showTimes() {
  $("times").replaceChildren(table(["part", "bus, MHz", "sending"], DATA.parts.map(([part, , , , mhz]) => (
    { cells: [part, mhz, milliseconds((stats.bytes_sent * 8) / (mhz * 1000))] }))));
}

function showRam() {
  const need = (name) => (stats[name] ? bytes(stats[name]) : "");
  $("ram").replaceChildren(table(null, [
    { cells: ["the least that draws it", need("need_least")] },
    { cells: ["each vertex once a frame", need("need_resident")] },
    { cells: ["one pass", need("need_one_pass")] },
    { cells: ["chosen", bytes(S.arena || stats.need_one_pass || 0)], total: true },
  ]));
}

// Rows of docs/features.md that the scene has, against the base: RGB565, Blinn-Phong, per fragment, a directional light.
function flashRows(of) {
  const format = { rgb565: "the base", rgb444: "RGB444", rgb888: "RGB888", grey8: "8-bit grey", grey4: "4-bit grey", mono: "1 bit" }[S.format] +
    (S.dither ? ", dithered" : "");
  const start = format === "the base, dithered" ? "RGB565, dithered" : format;
  const plain = start === "the base";
  const rows = [[plain ? "RGB565, Blinn-Phong, per fragment" : start, of[start]]];
  const less = (a, b) => of[a].map((value, i) => value - of[b][i]);
  if (S.at !== "fragment") {
    const name = { flat: "per facet", vertex: "per vertex" }[S.at];
    rows.push([name, plain ? less(name, "the base") : less(`${name}, RGB888`, "RGB888")]);
  }
  if (S.model !== "blinn-phong") {
    const name = { phong: "Phong", lambert: "Lambert", unlit: "unlit" }[S.model];
    rows.push([`${name} in place of Blinn-Phong`, less(name, "the base")]);
  }
  for (const kind of ["point", "spot"]) {
    if (lights().some((light) => light.kind === kind)) {
      rows.push([`${kind} light`, less(kind, "the base")]);
    }
  }
  for (const [name, isOn] of [["opacity", S.opacity < 1], ["fog", S.fog !== "none"], ["2x2 samples", S.smooth]]) {
    if (isOn && of[name]) {
      rows.push([name, less(name, "the base")]);
    }
  }
  return rows;
}

function showFlash() {
  if (isScene()) {
    $("flash").textContent = "Choose a model: scenes name several features at once.";
    return;
  }
  const small = flashRows(DATA.flash.size), fast = flashRows(DATA.flash.speed);
  const column = S.core === "m0" || S.core === "rv32" ? 1 : 0;
  const sum = (rows) => rows.reduce((total, [, values]) => total + values[column], 0);
  const text = (value, i) => (i && value >= 0 ? "+" : "") + value;
  $("flash").replaceChildren(table([column ? "ARMv6-M" : "Cortex-M3", "-Os", "-O2"], [
    ...small.map(([name, values], i) => ({ cells: [name, text(values[column], i), text(fast[i][1][column], i)] })),
    { cells: ["about", bytes(sum(small)), bytes(sum(fast))], total: true },
  ]));
}

// ---- Thumbnails

function makeThumbs() {
  $("thumbs").replaceChildren(...EVALUATIONS.map(([key, name, what]) => {
    const label = document.createElement("label");
    label.innerHTML = `<input type="radio" name="at" value="${key}"><canvas aria-hidden="true"></canvas><b></b><small></small>`;
    label.querySelector("b").textContent = name;
    label.querySelector("small").textContent = what;
    label.querySelector("input").addEventListener("change", () => set({ at: key }));
    return label;
  }));
}

function showThumb(evaluation, picture) {
  const label = document.querySelector(`#thumbs input[value="${evaluation}"]`).parentElement;
  show(label.querySelector("canvas"), picture);
  label.querySelector("small").textContent = picture.stats.psnr === undefined ? "" : `${picture.stats.psnr.toFixed(1)} dB`;
}

// ---- Controls

function set(changes) {
  Object.assign(S, changes);
  update();
}

function exponentOf(place) {
  const p = 2 ** place;
  return p < 10 ? +p.toFixed(p < 1 ? 2 : 1) : Math.round(p);
}

// An angle in words, as a minus sign is not always read out.
const side = (degrees, less, more) => `${Math.abs(degrees)}°${degrees < 0 ? ` ${less}` : degrees > 0 ? ` ${more}` : ""}`;
const sideways = (degrees) => side(degrees, "left", "right");

// A slider: how it shows a state, and what it changes.
const SLIDERS = {
  turn: { get: () => S.turn, set: (v) => ({ turn: v }), text: sideways },
  tilt: { get: () => S.tilt, set: (v) => ({ tilt: v }), text: (v) => side(v, "back", "forward") },
  above: { get: () => S.above, set: (v) => ({ above: v }), text: (v) => side(v, "below", "above") },
  zoom: { get: () => S.zoom, set: (v) => ({ zoom: v }), text: (v) => `× ${v}` },
  frame: { get: () => S.frame, set: (v) => ({ frame: v }), text: (v) => String(v) },
  detail: { get: () => (shapeOf() ? shapeOf().counts.indexOf(S.m.split(":")[1]) : 0),
    set: (v) => ({ m: `${S.m.split(":")[0]}:${shapeOf().counts[v]}` }), text: () => String(stats.scene_triangles || "") },
  shininess: { get: () => Math.log2(Math.max(1 / 16, S.p)), set: (v) => ({ p: exponentOf(v) }), text: () => decimal(S.p, 2) },
  ambient: { get: () => S.ambient, set: (v) => ({ ambient: v }), text: (v) => `${Math.round(v * 100)} %` },
  opacity: { get: () => S.opacity, set: (v) => ({ opacity: v }), text: (v) => `${Math.round(v * 100)} %` },
  from: { get: () => S.from, set: (v) => ({ from: v }), text: String },
  to: { get: () => S.to, set: (v) => ({ to: v }), text: String },
  highlight: { get: () => S.highlight, set: (v) => ({ highlight: v }), text: (v) => `${Math.round(v * 100)} %` },
  arena: { get: () => (S.arena && stats.need_one_pass > stats.need_least ? Math.min(99, Math.round((100 * (S.arena - stats.need_least)) / (stats.need_one_pass - stats.need_least))) : 100),
    set: (v) => ({ arena: v >= 100 || !stats.need_least ? 0 : Math.round(stats.need_least + ((stats.need_one_pass - stats.need_least) * v) / 100) }),
    text: () => bytes(S.arena || stats.need_one_pass || 0) },
};
for (const [key, text] of [["yaw", sideways], ["pitch", (v) => side(v, "down", "up")], ["far", String], ["linear", String], ["quadratic", String],
  ["cone", (v) => `${v}°`], ["power", (v) => `${Math.round(v * 100)} %`]]) {
  SLIDERS[`light-${key}`] = { get: () => (lights()[chosenLight] || lightOff)[key], set: (v) => changeLight({ [key]: v }), text };
}

function changeLight(change, index = chosenLight) {
  const list = lights();
  Object.assign(list[index], change);
  setLights(list);
  return {};
}

const BOXES = { metal: "metal", local: "local", larger: "larger", ungated: "ungated", own: "own", dither: "dither", smooth: "smooth" };
const COLOURS = { paint: "paint", background: "ground" };
const CHOICES = { reflection: "model", blend: "blend", fog: "fog", format: "format", tile: "tile", core: "core", against: "against" };

function fillSelects() {
  const option = (value, text) => new Option(text, value);
  const group = (name, options) => {
    const made = document.createElement("optgroup");
    made.label = name;
    made.append(...options);
    return made;
  };
  $("model").replaceChildren(
    group("Shapes", Object.entries(SHAPES).map(([key, { name }]) => option(key, name))),
    group("Models", MODELS.map(([path, name]) => option(path, name))),
    ...scenes.map((scene) => group(`Scene: ${scene.name}`, scene.variants.map(({ name }) => option(`scene:${scene.name}:${name}`, `${scene.name}: ${name}`)))));
  $("screen").replaceChildren(...Object.entries(PANELS).map(([key, { name }]) => option(key, name)));
  $("tile").replaceChildren(...TILES.map((size) => option(size, size.replace("x", "×"))));
}

function connect() {
  for (const [id, slider] of Object.entries(SLIDERS)) {
    $(id).addEventListener("input", () => set(slider.set(Number($(id).value))));
  }
  for (const [id, key] of Object.entries(BOXES)) {
    $(id).addEventListener("change", () => set({ [key]: $(id).checked ? 1 : 0 }));
  }
  for (const [id, key] of Object.entries(COLOURS)) {
    $(id).addEventListener("input", () => set({ [key]: $(id).value.slice(1) }));
  }
  for (const [id, key] of Object.entries(CHOICES)) {
    $(id).addEventListener("change", () => set({ [key]: $(id).value }));
  }
  $("model").addEventListener("change", () => chooseModel($("model").value));
  $("screen").addEventListener("change", () => choosePanel($("screen").value));
  for (const [id, key] of [["width", "w"], ["height", "h"]]) {
    $(id).addEventListener("change", () => set({ [key]: limit(Math.round(Number($(id).value)) || 8, 8, 1024), panel: "own" }));
  }
  $("light-kind").addEventListener("change", () => set(changeLight({ kind: $("light-kind").value })));
  $("light-colour").addEventListener("input", () => set(changeLight({ colour: $("light-colour").value.slice(1) })));
  document.querySelectorAll('input[name="show"]').forEach((radio) => radio.addEventListener("change", () => set({ show: radio.value })));
  $("spin").addEventListener("click", spin);
  $("reset").addEventListener("click", () => {
    S = { ...DEFAULTS };
    chosenLight = 0;
    update();
  });
  $("link").addEventListener("click", async () => {
    history.replaceState(null, "", address());
    const done = await copyText(location.href);
    $("link").textContent = done ? "Copied" : "It is in the address bar";
    setTimeout(() => ($("link").textContent = "Copy link"), 1500);
  });
  $("controls").addEventListener("submit", (event) => event.preventDefault());
  addEventListener("hashchange", () => {
    readAddress();
    update();
  });
  addEventListener("resize", update);
}

function chooseModel(value) {
  const shape = SHAPES[value];
  if (value.startsWith("scene:")) {
    const scene = scenes.find((one) => one.name === value.split(":")[1]);
    set({ m: value, frame: 0, w: scene.width, h: scene.height, panel: panelOf(scene.width, scene.height), arena: 0 });
  } else if (shape) {
    const middle = shape.counts[Math.min(1, shape.counts.length - 1)];
    set({ m: middle ? `${value}:${middle}` : value, tilt: shape.tilt, zoom: 1, arena: 0, ...backFromScene() });
  } else {
    set({ m: value, tilt: 0, zoom: 1, arena: 0, ...backFromScene() });
  }
}

const panelOf = (width, height) => Object.keys(PANELS).find((key) => PANELS[key].width === width && PANELS[key].height === height) || "own";
const backFromScene = () => (isScene() ? { w: DEFAULTS.w, h: DEFAULTS.h, panel: DEFAULTS.panel } : {});

function choosePanel(key) {
  const { width, height, format, dithered } = PANELS[key];
  set(key === "own" ? { panel: key } : { panel: key, w: width, h: height, format, dither: dithered || 0, arena: 0 });
}

// Shows the state in every control.
function showControls() {
  const scene = isScene() ? chosenScene() : null;
  document.querySelectorAll(".model-only").forEach((part) => (part.hidden = Boolean(scene)));
  $("scene-note").hidden = !scene;
  $("scene-note").textContent = scene ? `${scenes[scene.scene].variants[scene.variant].lookFor} A scene brings its own lights and surfaces.` : "";
  $("frame-field").hidden = !scene || scenes[scene.scene].frames === 1;
  $("spin").hidden = Boolean(scene) && scenes[scene.scene].frames === 1;
  $("frame").max = scene ? scenes[scene.scene].frames - 1 : 0;
  $("detail-field").hidden = !shapeOf() || !shapeOf().counts.length;
  $("detail").max = shapeOf() ? shapeOf().counts.length - 1 : 0;
  $("own-field").hidden = !isFile() || isBrought();
  $("blend-field").hidden = S.opacity >= 1;
  $("fog-fields").hidden = S.fog === "none";
  $("size-field").hidden = S.panel !== "own";
  $("legend").hidden = S.show !== "errors";
  $("glass").classList.toggle("round", S.panel === "gc9a01");
  $("canvas-help").textContent = scene ? "This scene is as it was composed; panel and memory can be changed." :
    "Drag the picture to turn the model, the numbered suns to move the lights; or use the arrow keys.";
  showModelName();
  $("screen").value = S.panel;
  $("width").value = S.w;
  $("height").value = S.h;
  for (const [id, slider] of Object.entries(SLIDERS)) {
    const value = slider.get();
    $(id).value = value;
    $(id).nextElementSibling.textContent = slider.text(+Number(value).toFixed(2));
    $(id).setAttribute("aria-valuetext", $(id).nextElementSibling.textContent);
  }
  Object.entries(BOXES).forEach(([id, key]) => ($(id).checked = Boolean(S[key])));
  Object.entries(COLOURS).forEach(([id, key]) => ($(id).value = "#" + S[key]));
  Object.entries(CHOICES).forEach(([id, key]) => ($(id).value = S[key]));
  document.querySelectorAll('input[name="show"]').forEach((radio) => (radio.checked = radio.value === S.show));
  document.querySelectorAll('input[name="at"]').forEach((radio) => (radio.checked = radio.value === S.at));
  showLights();
}

function showModelName() {
  const value = shapeOf() ? S.m.split(":")[0] : S.m;
  const known = [...$("model").options].some((option) => option.value === value);
  if (!known && isFile()) {
    $("model").prepend(new Option(S.m, S.m));
  }
  $("model").value = value;
}

// ---- Lights

function showLights() {
  const list = lights();
  chosenLight = limit(chosenLight, 0, Math.max(0, list.length - 1));
  const light = list[chosenLight];
  const key = list.map((one, i) => `${one.colour}${i === chosenLight}`).join();
  if ($("light-tabs").dataset.key !== key) { // or a button would lose the keyboard's focus
    $("light-tabs").dataset.key = key;
    const had = document.activeElement && document.activeElement.parentElement === $("light-tabs") ? document.activeElement.dataset.act : null;
    $("light-tabs").replaceChildren(
      ...list.map((one, i) => lightButton(`${i + 1}`, `choose${i}`, () => { chosenLight = i; update(); }, one.colour, i === chosenLight)),
      ...(list.length < 8 ? [lightButton("Add", "add", addLight)] : []),
      ...(list.length ? [lightButton("Remove", "remove", removeLight)] : []));
    const again = had && $("light-tabs").querySelector(`[data-act="${had}"]`);
    if (again) {
      again.focus();
    }
  }
  $("light-fields").hidden = !light;
  if (light) {
    $("light-kind").value = light.kind;
    $("light-colour").value = "#" + light.colour;
    $("light-far-field").hidden = $("light-fading-fields").hidden = light.kind === "dir";
    $("light-cone-field").hidden = light.kind !== "spot";
  }
  showHandles(isScene() ? [] : list);
}

function lightButton(text, act, action, colour, isChosen) {
  const button = document.createElement("button");
  button.type = "button";
  button.dataset.act = act;
  if (colour) {
    button.setAttribute("aria-pressed", String(isChosen));
    button.setAttribute("aria-label", `Light ${text}`);
    button.append(Object.assign(document.createElement("span"), { className: "dot", style: `background:#${colour}` }));
  }
  button.append(text);
  button.addEventListener("click", action);
  return button;
}

function addLight() {
  S.lights = [S.lights, NEW_LIGHT].filter(Boolean).join("~");
  chosenLight = lights().length - 1;
  update();
}

function removeLight() {
  setLights(lights().filter((_, i) => i !== chosenLight));
  update();
}

// A sun for each light, where its direction meets a sphere round the model.
function showHandles(list) {
  const box = $("handles");
  while (box.children.length > list.length) {
    box.lastChild.remove();
  }
  while (box.children.length < list.length) {
    box.append(makeHandle(box.children.length));
  }
  const radius = handleRadius();
  list.forEach((light, i) => {
    const [x, y, z] = directionOf(light), handle = box.children[i];
    handle.style.left = `calc(50% + ${(x * radius).toFixed(1)}px)`;
    handle.style.top = `calc(50% - ${(y * radius).toFixed(1)}px)`;
    handle.style.background = "#" + light.colour;
    handle.classList.toggle("behind", z < 0);
    handle.setAttribute("aria-label", `Light ${i + 1}, ${light.kind === "dir" ? "directional" : light.kind}: ${sideways(light.yaw)}, ${side(light.pitch, "down", "up")}${z < 0 ? ", behind the model" : ""}`);
  });
}

const handleRadius = () => Math.min($("canvas").clientWidth, $("canvas").clientHeight) * 0.45;

function makeHandle(index) {
  const handle = document.createElement("button");
  handle.type = "button";
  handle.textContent = index + 1;
  const move = (event) => {
    const box = $("canvas").getBoundingClientRect(), radius = handleRadius();
    let x = (event.clientX - box.left - box.width / 2) / radius, y = (box.top + box.height / 2 - event.clientY) / radius;
    const length = Math.hypot(x, y), isBehind = handle.classList.contains("behind");
    if (length > 1) {
      x /= length, y /= length;
    }
    const z = Math.sqrt(Math.max(0, 1 - x * x - y * y));
    set(changeLight({ yaw: Math.round((Math.atan2(x, isBehind ? -z : z) * 180) / Math.PI), pitch: Math.round((Math.asin(y) * 180) / Math.PI) }, index));
  };
  onDrag(handle, move);
  handle.addEventListener("focus", () => { chosenLight = index; update(); });
  onArrows(handle, (across, up) => {
    const light = lights()[index];
    set(changeLight({ yaw: wrap(light.yaw + 5 * across), pitch: limit(light.pitch + 5 * up, -90, 90) }, index));
  });
  return handle;
}

const wrap = (degrees) => ((((degrees + 180) % 360) + 360) % 360) - 180;

function onDrag(element, move) {
  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    element.addEventListener("pointermove", move);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    element.addEventListener(end, () => element.removeEventListener("pointermove", move));
  }
}

function onArrows(element, move) {
  const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  element.addEventListener("keydown", (event) => {
    if (ways[event.key]) {
      event.preventDefault();
      move(...ways[event.key]);
    }
  });
}

// ---- Turning

let spinning = false;

function turnBy(across, up) {
  if (!isScene()) {
    set({ turn: wrap(Math.round(S.turn + across)), above: limit(Math.round(S.above - up), -85, 85) });
  }
}

function connectCanvas() {
  onDrag($("canvas"), (event) => turnBy(event.movementX * 0.6, -event.movementY * 0.6));
  onArrows($("canvas"), (across, up) => turnBy(5 * across, 5 * up));
  $("canvas").addEventListener("wheel", (event) => {
    if (event.ctrlKey && !isScene()) { // else the page scrolls
      event.preventDefault();
      set({ zoom: limit(+(S.zoom * (event.deltaY < 0 ? 1.1 : 1 / 1.1)).toFixed(2), 0.3, 3) });
    }
  }, { passive: false });
}

function spin() {
  spinning = !spinning;
  $("spin").setAttribute("aria-pressed", String(spinning));
  $("spin").textContent = spinning ? "Stop" : "Animate";
  if (spinning) {
    requestAnimationFrame(step);
  } else {
    update();
  }
}

function step() {
  if (spinning) {
    set(isScene() ? { frame: (S.frame + 1) % scenes[chosenScene().scene].frames } : { turn: wrap(S.turn + 2) });
    requestAnimationFrame(step);
  }
}

// ---- Files and the clipboard

async function openFiles(list) {
  const files = await Promise.all([...list].map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })));
  const model = files.find(({ name }) => /\.obj$/i.test(name));
  if (!model) {
    tellProblem("None of these files is an OBJ file.");
    return;
  }
  model.name = model.name.replace(/\.obj$/i, ".obj");
  dropped = files;
  loaded.key = null;
  set({ m: model.name, tilt: 0, zoom: 1, arena: 0, own: files.length > 1 ? 1 : 0, ...backFromScene() });
}

function connectFiles() {
  $("open").addEventListener("click", () => $("file").click());
  $("file").addEventListener("change", () => openFiles($("file").files));
  addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
  });
  addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) {
      document.body.classList.remove("dropping");
    }
  });
  addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    openFiles(event.dataTransfer.files);
  });
}

async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

function connectCode() {
  $("code").addEventListener("click", () => {
    const { text, note } = sceneAsC();
    $("dialog-text").value = text;
    $("dialog-note").textContent = note;
    $("dialog-done").textContent = "";
    $("dialog").showModal();
    $("dialog-text").scrollTop = 0;
  });
  $("dialog-copy").addEventListener("click", async () => {
    const done = await copyText($("dialog-text").value);
    if (!done) {
      $("dialog-text").select();
    }
    $("dialog-done").textContent = done ? "Copied." : "Selected: copy it with the keyboard.";
  });
  $("dialog-save").addEventListener("click", () => {
    const link = Object.assign(document.createElement("a"), { download: "scene.c", href: URL.createObjectURL(new Blob([$("dialog-text").value], { type: "text/x-c" })) });
    link.click();
    URL.revokeObjectURL(link.href);
  });
}

// ---- Start

async function begin() {
  readAddress();
  $("version").textContent = DATA.version;
  await Glint.start(DATA);
  scenes = Glint.scenes();
  fillSelects();
  makeThumbs();
  makeRamp();
  connect();
  connectCanvas();
  connectFiles();
  connectCode();
  update();
}

begin().catch((error) => {
  tellProblem(`The program could not start: ${error.message}`);
  throw error;
});
