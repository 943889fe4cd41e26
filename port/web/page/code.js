// SPDX-License-Identifier: MIT
// The scene as a program for firmware: what `glint convert` writes of its model, and a main that draws it on the panel.
"use strict";

const sceneAsC = (() => {
  // Drivers in port/panel, how the panel is turned, and the formats that it takes beside its own.
  const DRIVERS = {
    ili9341: { type: "ili9341", rotation: 90, formats: ["rgb565"] },
    st7789: { type: "st7789_240x240", formats: ["rgb565", "rgb444"] },
    st7735: { type: "st7735_red", rotation: 90, formats: ["rgb565", "rgb444"] },
    gc9a01: { type: "gc9a01", formats: ["rgb565", "rgb444"] },
    ssd1351: { type: "ssd1351", formats: ["rgb565"] },
    ssd0323: { type: "ssd0323", formats: ["grey4"] },
    ssd1306: { type: "ssd1306", formats: ["mono"] },
  };
  const TYPES = { dir: "directional", point: "point", spot: "spot" };
  const MODELS = { "blinn-phong": "blinn_phong" };
  const EVALUATION = { flat: "facet" };

  const driver = () => (DRIVERS[S.panel] && DRIVERS[S.panel].formats.includes(S.format) ? DRIVERS[S.panel] : null);
  const q16 = (text) => (text === "0" ? "0" : `GLINT_Q16(${text})`);
  const braced = (text) => `{${text.split(",").map(q16).join(", ")}}`;
  const negated = (text) => text.split(",").map((one) => (one === "0" ? one : one.startsWith("-") ? one.slice(1) : `-${one}`)).join(",");
  const three = (text) => (text.includes(",") ? text : `${text},${text},${text}`);

  // Options of the command line are what the program was drawn by: the same numbers.
  function option(words, name) {
    return words[words.indexOf(name) + 1];
  }

  function material(words) {
    const flags = [...(S.larger ? ["GLINT_MATERIAL_MAX_WITH_AMBIENT"] : []), ...(S.ungated ? ["GLINT_MATERIAL_SPECULAR_UNGATED"] : [])];
    return `static const glint_material material = {
    .model = &glint_model_${MODELS[S.model] || S.model},
    .ambient = ${braced(three(option(words, "--ambient")))},
    .diffuse = ${braced(three(option(words, "--diffuse")))},
    .specular = ${braced(three(option(words, "--specular")))},
    .shininess = ${q16(option(words, "--shininess"))},${flags.length ? `\n    .flags = ${flags.join(" | ")},` : ""}${blending()}
};
`;
  }

  const BLEND = { alpha: "ALPHA", add: "ADD", dithered: "DITHERED" };
  const blending = () => (S.opacity < 1 ? `\n    .blend = GLINT_BLEND_${BLEND[S.blend]},\n    .opacity = ${q16(option(opacityWords(), "--opacity"))},` : "");

  function fog() {
    const [from, to] = option(fogWords(), "--fog").split(":");
    return `\nstatic const glint_fog fog = {.type = &glint_fog_${S.fog}, .start = ${q16(from)}, .end = ${q16(to)}, .to_background = 1};\n`;
  }

  function light(word) {
    const [kind, place, ...rest] = word.split(":");
    const [axis, angles] = kind === "spot" ? rest.splice(0, 2) : ["", ""];
    const [inner, outer] = angles.split(",");
    const [colour, linear, quadratic] = [braced(rest[0]), ...rest.slice(1)];
    const cone = kind === "spot" ? `\n     .direction = ${braced(axis)}, .inner = ${q16(inner)}, .outer = ${q16(outer)},` : "";
    const fading = linear ? `\n     .linear = ${q16(linear)}, .quadratic = ${q16(quadratic)},` : "";
    const at = kind === "dir" ? `.direction = ${braced(negated(place))}` : `.position = ${braced(place)}`;
    return `    {.type = &glint_light_${TYPES[kind]}, ${at},${cone}${fading}
     .diffuse = ${colour}, .specular = ${colour}},
`;
  }

  function allLights() {
    const list = lights();
    return list.length ? `\nstatic const glint_light lights[${list.length}] = {\n${list.map((one) => light(lightWord(one))).join("")}};\n` : "";
  }

  // The converter's header without what only a header needs.
  function meshes() {
    const header = Glint.convert([...modelWords(), "--name", "model", "-o", "model.h"]);
    const materials = header.indexOf("\n/* Materials:");
    const wanted = materials >= 0 && !S.own ? header.slice(0, materials) : header;
    return wanted.replace(/^#(ifndef|define|endif|include).*\n/gm, "").replace(/\n{3,}/g, "\n\n").trim() + "\n";
  }

  // The names of the model's meshes, and how many there are.
  function pieces(text) {
    const array = text.match(/static const glint_mesh model_meshes\[(\d+)\]/);
    if (array) {
      return [...Array(Number(array[1])).keys()].map((i) => `&model_meshes[${i}]`);
    }
    return [...text.matchAll(/static const glint_mesh (model_mesh\w*) =/g)].map(([, name]) => `&${name}`);
  }

  function objects(text) {
    const own = S.own && /model_objects\[(\d+)\]/.exec(text);
    const at = `&glint_per_${EVALUATION[S.at] || S.at}`;
    if (own) {
      return { count: Number(own[1]), code: `    glint_object objects[${own[1]}];
    for (int i = 0; i < ${own[1]}; i++) {
        objects[i] = model_objects[i];
        objects[i].pose = pose;
        objects[i].evaluation = ${at};
    }
` };
    }
    const list = pieces(text);
    return { count: list.length, code: `    const glint_object objects[${list.length}] = {
${list.map((mesh) => `        {.mesh = ${mesh}, .material = &material, .pose = pose, .evaluation = ${at}},\n`).join("")}    };
` };
  }

  function panelCode(layers, samples) {
    const panel = driver();
    const [tileWidth, tileHeight] = S.tile.split("x");
    const name = S.format + (S.dither ? "_dithered" : "");
    const own = { rgb565_dithered: "rgb565_be_dithered", mono: "mono_pages", rgb444: name, rgb444_dithered: name, grey4_dithered: name }[name];
    const output = panel ? `.width = glint_panel_width(&panel),
        .height = glint_panel_height(&panel),
        .format = glint_panel_format(&panel),
        .flush = glint_panel_flush(&panel),` : `.width = ${S.w},
        .height = ${S.h},
        .format = &glint_format_${name},
        .flush = display_flush,`;
    const tile = S.tile === "32x32" ? "" : `
        .tile_width = ${tileWidth},
        .tile_height = ${tileHeight},`;
    const start = panel ? `    const glint_panel panel = {
        .type = &glint_panel_${panel.type},
        .bus = board_panel_bus(),${panel.rotation ? `\n        .rotation = GLINT_PANEL_${panel.rotation},` : ""}${own ? `\n        .format = &glint_format_${own},` : ""}
    };
` : "";
    return `${start}    const glint_config config = {
        ${output}${tile}
        .arena = arena,
        .arena_size = sizeof arena,
        .keeps_arena = 1,${layers ? `\n        .layers = ${layers},` : ""}${samples ? `\n        .samples = ${samples},` : ""}
    };
`;
  }

  const samples = () => (S.smooth ? "&glint_samples_2x2" : "");

  // What is not in glint.h is in glint_extras.h.
  const complete = (text) => (/&glint_(layers|fog|samples)/.test(text) ? text.replace(/#include "(glint|board)\.h"\n/, '$&#include "glint_extras.h"\n') : text);

  function head() {
    const panel = driver();
    const include = panel ? `#include "board.h"\n#include "panel/${panel.type.split("_")[0]}.h"\n` :
      `#include "glint.h"\n\n/* Sends finished tiles to your display; see glint_flush in glint.h. */\nextern const glint_flush display_flush;\n`;
    return `/* Made by glint's web page, glint ${DATA.version}: ${address()} */\n${include}`;
  }

  function arena() {
    const size = S.arena || stats.need_one_pass;
    return `static uint32_t arena[${Math.ceil(size / 4)}]; /* ${S.arena ? "more of it takes fewer passes" : "one pass of this picture"} */\n`;
  }

  const run = (scene, before) => `    glint_renderer renderer;
    int failed = ${driver() ? "glint_panel_start(&panel) || " : ""}glint_init(&renderer, &config)${before};
    failed = failed || glint_render(&renderer, ${scene});
    return failed;
}
`;

  function modelProgram() {
    const text = meshes(), own = S.own && isFile() && text.includes("model_objects"), list = objects(text);
    const count = lights().length, blends = own ? text.includes("GLINT_BLEND_ALPHA") : S.opacity < 1;
    return `${head()}
${text}
${own ? "" : material(surfaceWords())}${allLights()}${S.fog === "none" ? "" : fog()}
${arena()}
int main(void) {
${panelCode(blends ? "&glint_layers" : "", samples())}    const glint_pose tilt = glint_pose_rotate_x(${q16(decimal(S.tilt))}), turn = glint_pose_rotate_y(${q16(decimal(S.turn))});
    const glint_pose pose = glint_pose_then(&tilt, &turn);
${list.code}    const glint_vector eye = ${braced(joined(eye()))}, at = {0, 0, 0}, up = {0, GLINT_ONE, 0};
    glint_scene scene = {
        .camera = {.field_of_view = ${q16(String(FIELD_OF_VIEW))}, .near_plane = GLINT_Q16(0.1)},
        .viewer = GLINT_VIEWER_${S.local ? "LOCAL" : "INFINITE"},
        .background = ${braced(channels(S.ground))},
        .ambient = {GLINT_ONE, GLINT_ONE, GLINT_ONE},${count ? `\n        .lights = lights,\n        .light_count = ${count},` : ""}${S.fog === "none" ? "" : "\n        .fog = &fog,"}
        .objects = objects,
        .object_count = ${list.count},
    };
${run("&scene", " || glint_camera_look_at(&scene.camera, eye, at, up)")}`;
  }

  function sceneProgram() {
    const { scene, variant } = chosenScene(), smooth = samples();
    return `${head()}#include "scenes/scenes.h"

static example_stage stage;
${arena()}
int main(void) {
    example_${scenes[scene].name.replace(/-/g, "_")}.build(&stage, ${variant}, ${S.frame}); /* ${scenes[scene].variants[variant].name} */
${panelCode("stage.layers", smooth || "stage.samples")}${run("&stage.scene", "")}`;
  }

  return () => {
    const parts = ["src/*/*.c", ...(driver() ? ["port/panel/*.c", "your board's files (port/template is an empty one)"] : []),
      ...(isScene() ? ["examples/scenes/*.c"] : [])];
    const paths = ["src/", ...(driver() ? ["port/"] : []), ...(isScene() ? ["examples/"] : [])];
    return {
      text: complete(isScene() ? sceneProgram() : modelProgram()),
      note: `The whole program. Add ${parts.join(", ")} to the build; include paths: ${paths.join(", ")}. Link with --gc-sections. ` +
        (driver() ? "" : "No driver here takes these pixels at this size: display_flush is yours to write."),
    };
  };
})();
