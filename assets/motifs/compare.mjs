/* Two results side by side: bars and ribbons, as wide as the page; table cells for changes and shares. */
import { changeView, clientside, register, setStore } from "../shared/dash.mjs";
import { allWithin, find, svgElement } from "../shared/dom.mjs";
import { cellRenderers, reactElement } from "../shared/grid.mjs";
import { SELECTION, STAGE_REQUEST } from "../shared/ids.mjs";
import * as ids from "./ids.mjs";
/** @import { Bar, Flow, Ribbon } from "./types.d.ts" */
/** @import { Selection, View } from "../shared/types.d.ts" */

const BAR = 12, LABEL = 40, LEAST_LABEL = 9;
/** What is drawn, kept so that a new width can redraw it. @type {{ data: Flow, selection: Selection | null, gained: string | undefined } | null} */
let shown = null;

/**
 * An SVG element with a title.
 * @template {keyof SVGElementTagNameMap} Name
 * @param {Name} name
 * @param {Record<string, string | number>} attributes
 * @param {string} [title]
 */
const drawing = (name, attributes, title) => svgElement(name, attributes, ...(title ? [svgElement("title", {}, title)] : []));

/**
 * A click: this result's motif is selected everywhere; a motif that only the other has plays alone.
 * @param {number | null} a
 * @param {number | null} b
 */
function choose(a, b) {
  if (a !== null && a !== undefined) return setStore(SELECTION, { motif: a });
  if (b === null || b === undefined) return;
  changeView({ gained: String(b) });
  setStore(SELECTION, {});
}

/**
 * The motif of this result that a bar stands for: its own, or the one that shares most with it.
 * @param {Bar} bar
 */
function here(bar) {
  if (bar.side === "a") return bar.motif;
  const links = (shown?.data.ribbons ?? []).filter((r) => r.b === bar.motif && r.a !== null && r.kind !== "rest");
  return links.length ? links.reduce((best, r) => (r.h > best.h ? r : best)).a : null;
}

/** @param {SVGElement} node @param {string} label @param {() => void} act */
function pressable(node, label, act) {
  node.setAttribute("tabindex", "0");
  node.setAttribute("role", "button");
  node.setAttribute("aria-label", label);
  node.addEventListener("click", act);
  node.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    act();
  });
}

/** @param {SVGSVGElement} svg @param {Bar} bar @param {number} width */
function drawBar(svg, bar, width) {
  const left = bar.side === "a";
  const x = left ? LABEL : width - LABEL - BAR;
  const group = drawing("g", { class: `flow-bar change-${bar.change || "none"}`, "data-side": bar.side, "data-motif": bar.motif ?? "" }, bar.title);
  group.appendChild(drawing("rect", { x, y: bar.y, width: BAR, height: Math.max(bar.h, 1), rx: 2 }));
  if (bar.h >= LEAST_LABEL) {
    const at = { x: left ? x - 6 : x + BAR + 6, y: bar.y + bar.h / 2, "text-anchor": left ? "end" : "start" };
    group.appendChild(drawing("text", { ...at, "dominant-baseline": "central" })).textContent = bar.label;
  }
  if (bar.motif !== null) pressable(group, bar.title, () => choose(here(bar), bar.motif));
  svg.appendChild(group);
}

/**
 * @param {SVGSVGElement} svg
 * @param {Ribbon} ribbon
 * @param {number} width
 * @param {(ribbon: Ribbon) => string | null | undefined} changes
 */
function drawRibbon(svg, ribbon, width, changes) {
  const [x0, x1] = [LABEL + BAR + 1, width - LABEL - BAR - 1];
  const bend = (x0 + x1) / 2, { ya, yb, h } = ribbon;
  const path = `M${x0},${ya} C${bend},${ya} ${bend},${yb} ${x1},${yb} L${x1},${yb + h} C${bend},${yb + h} ${bend},${ya + h} ${x0},${ya + h} Z`;
  const change = ribbon.kind === "kept" ? "kept" : ribbon.kind === "linked" ? changes(ribbon) : "none";
  const one = drawing("path", { d: path, class: `flow-ribbon change-${change}`, "data-a": ribbon.a ?? "", "data-b": ribbon.b ?? "" }, ribbon.title);
  one.addEventListener("click", () => choose(ribbon.a, ribbon.b));
  svg.appendChild(one);
}

function draw() {
  const box = find(ids.COMPARE_FLOW);
  if (!box || !shown || !shown.data || !box.clientWidth) return;
  const width = box.clientWidth, { height, bars, ribbons } = shown.data;
  const svg = drawing("svg", { width, height, viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": "Motion that motifs of both results share" });
  const change = new Map(bars.map((bar) => [bar.side + bar.motif, bar.change]));
  /** @param {Ribbon} ribbon */
  const changes = (ribbon) => (change.get("a" + ribbon.a) === "kept" ? change.get("b" + ribbon.b) : change.get("a" + ribbon.a));
  /** @type {Record<string, number>} */
  const rank = { rest: 0, linked: 1, kept: 2 };
  [...ribbons].sort((r, s) => rank[r.kind] - rank[s.kind]).forEach((ribbon) => drawRibbon(svg, ribbon, width, changes));
  bars.forEach((bar) => drawBar(svg, bar, width));
  box.replaceChildren(svg);
  mark();
}

function mark() {
  const box = find(ids.COMPARE_FLOW);
  if (!box || !shown) return;
  const a = String(shown.selection?.motif ?? ""), b = a ? "" : String(shown.gained ?? "");
  /** @param {HTMLElement} node */
  const touches = (node) => (a && node.dataset.a === a) || (b && node.dataset.b === b)
    || (node.dataset.side === "a" && a && node.dataset.motif === a) || (node.dataset.side === "b" && b && node.dataset.motif === b);
  box.classList.toggle("some-chosen", Boolean(a || b));
  for (const node of allWithin(box, ".flow-bar, .flow-ribbon")) node.classList.toggle("chosen", Boolean(touches(node)));
}

const watched = new WeakSet();
/** @param {HTMLElement} box */
function watch(box) {
  if (watched.has(box)) return;
  watched.add(box);
  let width = 0;
  new ResizeObserver(() => {
    if (box.clientWidth && box.clientWidth !== width) draw();
    width = box.clientWidth;
  }).observe(box);
}

register("compare", {
  /** @param {Flow | null} data @param {Selection | null} selection @param {View | null} view */
  draw(data, selection, view) {
    shown = data && { data, selection, gained: (view || {}).gained };
    const box = find(ids.COMPARE_FLOW);
    if (!data || !box) return clientside.no_update;
    watch(box);
    draw();
    return clientside.no_update;
  },
  /** @param {any} request */
  play(request) {
    if (request) setStore(STAGE_REQUEST, request);
    return clientside.no_update;
  },
  /** @param {Selection | null} selection @param {View | null} view */
  mark(selection, view) {
    if (shown) Object.assign(shown, { selection, gained: (view || {}).gained });
    mark();
    return clientside.no_update;
  },
});

/** @type {Record<string, string>} */
const WORDS = { kept: "Kept", split: "Split", merged: "Merged", lost: "Gone", gained: "New" };
cellRenderers.Change = (props) =>
  props.value ? reactElement("span", { className: "change-mark change-" + props.value }, WORDS[props.value] || props.value) : null;
cellRenderers.Share = (props) =>
  typeof props.value === "number"
    ? reactElement("span", { className: "share-bar number", title: Math.round(100 * props.value) + " %" },
        reactElement("span", { className: "share-track" }, reactElement("span", { className: "share-fill", style: { width: 100 * props.value + "%" } })),
        reactElement("span", { className: "share-number" }, Math.round(100 * props.value) + " %"))
    : null;
