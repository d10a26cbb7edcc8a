// The motion map: ridges as shades, postures on its regions; a node shows its posture, and plays what passes it.
import { element, svgElement } from "../shared/dom.mjs";
import { clamp } from "../shared/numbers.mjs";
import { panZoom } from "../blocks/pan_zoom.mjs";
import { drawPosture, readPostures } from "./posture_block.mjs";
import { isIn } from "../blocks/selection.mjs";
import { hideTip, showTip } from "../blocks/tip.mjs";
/** @import { Draw, MapContent, Segment } from "../blocks/types.d.ts" */

/** @type {Draw<MapContent>} */
export function drawMap(place, content, context) {
  const [nx, ny] = content.grid;
  const postures = readPostures(content.postures);
  const highest = Math.max(...content.heights, 1e-9);
  const svg = svgElement("svg", { class: "block-map", tabindex: 0, role: "application", "aria-label": "Motion map: arrow keys move over it, Enter plays what passes" });
  const ground = svgElement("g", { class: "block-nodes" });
  const squares = content.heights.map((height, node) => svgElement("rect", { x: Math.floor(node / ny) - 0.5, y: (node % ny) - 0.5, width: 1.02, height: 1.02, "fill-opacity": (height / highest).toFixed(3) }));
  ground.append(...squares);
  const stays = staysOf(content);
  const icons = svgElement("g", { class: "block-icons" });
  const mark = svgElement("rect", { class: "block-mark", width: 1, height: 1, x: -9, y: -9 });
  svg.append(ground, icons, mark);
  const zoom = panZoom(svg, [-0.5, -0.5, nx, ny]);
  place.append(svg, zoom);

  const paint = () => {
    icons.innerHTML = content.icons[context.dark() ? "dark" : "light"]; // drawn by our own server
    const picture = icons.firstElementChild;
    for (const [name, value] of Object.entries({ x: -0.5, y: -0.5, width: nx, height: ny })) picture?.setAttribute(name, String(value));
  };
  paint();

  let current = -1;
  /** @param {number} x @param {number} y */
  const point = (x, y) => {
    current = clamp(x, 0, nx - 1) * ny + clamp(y, 0, ny - 1);
    mark.setAttribute("x", String(Math.floor(current / ny) - 0.5));
    mark.setAttribute("y", String((current % ny) - 0.5));
  };
  /** @param {{ clientX: number, clientY: number }} at */
  const tell = (at) => showTip(at, drawPosture(content, postures, current),
    `${content.seconds[current].toFixed(1)} s of motion here${content.passes[current].length ? ", click to play" : ""}`);
  const play = () => {
    const passes = current < 0 ? [] : content.passes[current];
    if (!passes.length) return;
    const [clip, start, end] = passes[0];
    context.select({ clip, start, end }, {
      title: `Motion through node ${Math.floor(current / ny)}, ${current % ny}`,
      items: passes.map(([name, from, to]) => ({ clip: name, start: from, end: to, label: name })),
    });
  };
  svg.addEventListener("pointermove", (event) => {
    const matrix = svg.getScreenCTM()?.inverse();
    if (!matrix || event.buttons) return;
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
    if (x < -0.5 || y < -0.5 || x > nx - 0.5 || y > ny - 0.5) return hideTip();
    point(Math.round(x), Math.round(y));
    tell(event);
  });
  svg.addEventListener("pointerleave", hideTip);
  svg.addEventListener("blur", hideTip);
  svg.addEventListener("click", play);
  svg.addEventListener("keydown", (event) => {
    /** @type {Record<string, number[]>} */
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    if (event.key === "Enter") play();
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    point(Math.floor(Math.max(current, 0) / ny) + step[0], (Math.max(current, 0) % ny) + step[1]);
    const box = mark.getBoundingClientRect();
    tell({ clientX: box.right, clientY: box.bottom });
  }, { capture: true });
  if (!content.heights.length) place.append(element("p", "muted", "This map has no nodes."));
  return {
    recolour: paint,
    light(selection, motion) {
      const passed = new Set(motion.length ? stays.filter(({ at }) => isIn(at, motion)).map(({ node }) => node) : []);
      squares.forEach((square, k) => square.classList.toggle("lit", passed.has(k)));
      const { clip, start, end } = selection;
      const node = clip === undefined ? -1 : content.passes.findIndex((passes) => passes.some(([name, from, to]) => name === clip && from === start && to === end));
      if (node >= 0) point(Math.floor(node / ny), node % ny);
    },
    narrow(label, among) {
      const fit = stays.filter((stay) => (!label || stay.label === label) && (!among || among.has(stay.at[0])));
      const nodes = new Set(fit.map(({ node }) => node));
      const all = !stays.length || (!label && !among);
      squares.forEach((square, k) => square.classList.toggle("faint", !all && !nodes.has(k)));
    },
  };
}

/**
 * Where clips stay; none for contents that an earlier version kept.
 * @param {MapContent} content
 * @returns {{ node: number, at: Segment, label: string }[]}
 */
function staysOf({ stays = [], clips = [], labels = [] }) {
  return Array.from({ length: stays.length / 5 }, (_, k) => {
    const [clip, node, start, end, label] = stays.slice(5 * k, 5 * k + 5);
    return { node, at: [clips[clip], start, end], label: labels[label] ?? "" };
  });
}
