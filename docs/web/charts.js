// SPDX-License-Identifier: MIT
// Charts of docs/*.csv with the page's setting marked.
"use strict";

const Charts = (() => {
  let WIDTH = 560; // that of the box, so that letters keep their size
  const HEIGHT = 360, LEFT = 46, RIGHT = 14, TOP = 12, BOTTOM = 42;
  const COLOURS = { facet: "var(--facet)", vertex: "var(--vertex)", fragment: "var(--fragment)" };
  const NAMES = { facet: "flat", vertex: "per vertex", fragment: "per fragment" };

  function element(name, attributes, text) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    if (text !== undefined) {
      made.textContent = text;
    }
    return made;
  }

  // A square, a triangle, a diamond or a disc: shapes, not colours alone, tell evaluations apart.
  function mark(evaluation, x, y, size) {
    const paths = {
      facet: `M${x - size},${y - size}h${2 * size}v${2 * size}h${-2 * size}z`,
      vertex: `M${x},${y - size * 1.2}l${size * 1.2},${size * 2.1}h${-size * 2.4}z`,
      fragment: `M${x - size},${y}a${size},${size} 0 1 0 ${2 * size},0a${size},${size} 0 1 0 ${-2 * size},0z`,
    };
    return element("path", { d: paths[evaluation], fill: COLOURS[evaluation] });
  }

  function axis([least, most], from, to, log) {
    const f = log ? Math.log : (x) => x;
    const place = (value) => from + ((f(Math.min(most, Math.max(least, value))) - f(least)) / (f(most) - f(least))) * (to - from);
    return { place, least, most };
  }

  function frame(title, x, y, xTicks, yTicks, xName, yName) {
    const svg = element("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": title });
    for (const tick of yTicks) {
      svg.append(element("line", { class: "grid", x1: LEFT, x2: WIDTH - RIGHT, y1: y.place(tick), y2: y.place(tick) }),
        element("text", { x: LEFT - 6, y: y.place(tick) + 4, "text-anchor": "end", class: "soft" }, tick));
    }
    for (const tick of xTicks.filter((tick) => tick >= x.least && tick <= x.most)) {
      svg.append(element("line", { class: "grid", x1: x.place(tick), x2: x.place(tick), y1: TOP, y2: HEIGHT - BOTTOM }),
        element("text", { x: x.place(tick), y: HEIGHT - BOTTOM + 16, "text-anchor": "middle", class: "soft" }, tick));
    }
    svg.append(element("text", { x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 6, "text-anchor": "middle" }, xName),
      element("text", { x: 12, y: (TOP + HEIGHT - BOTTOM) / 2, "text-anchor": "middle", transform: `rotate(-90 12 ${(TOP + HEIGHT - BOTTOM) / 2})` }, yName));
    return svg;
  }

  function legend(svg, kinds, x, y) {
    kinds.forEach((kind, i) => svg.append(mark(kind, x, y + 18 * i - 4, 4.5), element("text", { x: x + 12, y: y + 18 * i, class: "halo" }, NAMES[kind])));
  }

  function titled(node, text) {
    node.append(element("title", {}, text));
    return node;
  }

  function frames(box, { frames: choices, others }, state) {
    WIDTH = Math.max(300, box.clientWidth);
    const cpu = state.core;
    const rivals = others.filter(([, , core]) => core === cpu || (cpu === "m4" && core === "m4f"));
    const costs = [...choices.map(([, , cost]) => cost[cpu]), ...rivals.map(([, , , cost]) => cost)];
    const x = axis([Math.min(...costs) * 0.8, Math.max(...costs) * 1.25], LEFT, WIDTH - RIGHT, true);
    const y = axis([18, 46], HEIGHT - BOTTOM, TOP, false);
    const ticks = [10, 20, 30, 40, 50, 60].filter((tick) => tick >= y.least && tick <= y.most);
    const chosen = choices.find(([choice]) => choice === state.choices.find((one) => choices.some(([name]) => name === one)));
    const svg = frame(`Accuracy over instructions on ${CORES[cpu]}.${chosen ? ` Chosen: ${chosen[0]}, ${chosen[1]} decibels, ${chosen[2][cpu]} million instructions.` : ""}`,
      x, y, [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200], ticks, `million instructions a frame, ${CORES[cpu]}`, "PSNR, dB");
    for (const [name, psnr, core, cost] of rivals) {
      svg.append(titled(element("circle", { cx: x.place(cost), cy: y.place(psnr), r: 4.5, fill: "none", stroke: "var(--soft)", "stroke-width": 1.5 }),
        `${name}: ${psnr} dB, ${cost} M${core === "m4f" ? ", with FPU" : ""}`));
    }
    for (const [choice, psnr, cost] of choices) {
      svg.append(titled(mark(choice.split(" ")[0], x.place(cost[cpu]), y.place(psnr), 5), `${choice}: ${psnr} dB, ${cost[cpu]} M`));
    }
    if (chosen) {
      svg.append(element("circle", { cx: x.place(chosen[2][cpu]), cy: y.place(chosen[1]), r: 11, fill: "none", stroke: "var(--ink)", "stroke-width": 2.5 }));
    }
    legend(svg, ["facet", "vertex", "fragment"], WIDTH - 110, HEIGHT - BOTTOM - 48);
    box.replaceChildren(svg);
  }

  function shading(box, { shading: rows }, state) {
    WIDTH = Math.max(300, box.clientWidth);
    const counts = rows.map(([, triangles]) => triangles), errors = rows.map(([, , rms]) => rms);
    const x = axis([Math.min(...counts) * 0.8, Math.max(...counts) * 1.2], LEFT, WIDTH - RIGHT, true);
    const y = axis([1.5, Math.max(...errors) * 1.2], HEIGHT - BOTTOM, TOP, true);
    const svg = frame("Error over triangles of a torus: flat, per vertex and per fragment", x, y, [200, 500, 1000, 2000, 5000, 10000], [2, 5, 10, 20, 40], "triangles", "error, levels of 255");
    for (const kind of ["facet", "vertex", "fragment"]) {
      const line = rows.filter(([evaluation]) => evaluation === kind);
      svg.append(element("polyline", { points: line.map(([, triangles, rms]) => `${x.place(triangles)},${y.place(rms)}`).join(" "), fill: "none",
        stroke: COLOURS[kind], "stroke-width": kind === state.evaluation ? 3 : 1.5 }));
      line.forEach(([, triangles, rms, cost]) => svg.append(titled(mark(kind, x.place(triangles), y.place(rms), 4.5), `${NAMES[kind]}, ${triangles} triangles: ${rms} levels, ${cost} M on Cortex-M3`)));
    }
    if (state.triangles) {
      const at = x.place(state.triangles);
      svg.append(element("line", { x1: at, x2: at, y1: TOP, y2: HEIGHT - BOTTOM, stroke: "var(--ink)", "stroke-dasharray": "4 3", "stroke-width": 1.5 }),
        element("text", { x: at + (at > WIDTH / 2 ? -6 : 6), y: HEIGHT - BOTTOM - 8, "text-anchor": at > WIDTH / 2 ? "end" : "start", class: "halo" }, `yours: ${state.triangles}`));
    }
    legend(svg, ["facet", "vertex", "fragment"], WIDTH - 110, TOP + 16);
    box.replaceChildren(svg);
  }

  return { frames, shading };
})();
