/* The body diagram: parts are clicked and weighted; of a query in pieces, given to the piece that is active. */
import { allWithin, closest, element, find, need, svgElement, targetOf, within } from "../shared/dom.mjs";
import * as ids from "./ids.mjs";
import { changeSearch, copyPieces, now, searchFor } from "./state.mjs";
import { EVEN, evenWeights, readWeights, sameWeights, writeWeights } from "./weights.mjs";
/** @import { Weights } from "./types.d.ts" */

const MOST = 50; // of a slider; only ratios count

// A person who faces us: their left is on our right. Lines are limbs, thick enough to hit.
/** @type {Record<string, string[]>} */
const SHAPES = {
  torso: ["M48 44 Q60 39 72 44 L69 74 L71 92 Q60 97 49 92 L51 74 Z"],
  head: ["M60 8 a12.5 13.500 0 1 1 -.01 0 Z"],
  left_arm: ["M80 49 L91 76"], left_hand: ["M93.500 84 L97.500 104"],
  right_arm: ["M40 49 L29 76"], right_hand: ["M26.500 84 L22.500 104"],
  left_leg: ["M67.500 103 L70.500 144"], left_foot: ["M71.500 154 L72 170 L79 174"],
  right_leg: ["M52.500 103 L49.500 144"], right_foot: ["M48.500 154 L48 170 L41 174"],
};
/** @type {Record<string, number>} */
const THICK = { left_arm: 11, right_arm: 11, left_hand: 9, right_hand: 9, left_leg: 14, right_leg: 14, left_foot: 10, right_foot: 10 };

const assigning = () => Boolean(now.found && now.found.pieces && now.found.pieces.length > 1) && mode === "pieces";
let mode = "weights";
/** @type {Weights} */
let raw = /** @type {any} */ (null); // leaf -> weight, as the sliders stand
let drawn = "";
let waiting = 0;

const total = () => Object.values(raw).reduce((sum, value) => sum + value, 0);
/** @param {string} leaf */
const share = (leaf) => raw[leaf] / Math.max(total(), 1e-9);
/** @param {number} value */
const percent = (value) => (value === 0 ? "0 %" : `${(100 * value).toFixed(100 * value < 9.95 ? 1 : 0)} %`.replace(".0 ", " "));

function send() {
  clearTimeout(waiting);
  waiting = setTimeout(() => {
    waiting = 0;
    if (total() > 0) changeSearch({ parts: writeWeights(raw, now.body) });
  }, 140);
}

/** @param {string} leaf @param {number} value */
function put(leaf, value) {
  raw[leaf] = Math.min(Math.max(value, 0), MOST);
  paint();
  need(ids.SEARCH_BODY).classList.toggle("search-none", total() === 0);
  send();
}

// ---- drawing ----
/** @param {string} leaf */
function shape(leaf) {
  const group = svgElement("g");
  group.setAttribute("class", "search-part");
  group.setAttribute("tabindex", "0");
  group.dataset.part = leaf;
  for (const d of SHAPES[leaf]) {
    const path = svgElement("path");
    path.setAttribute("d", d);
    if (THICK[leaf]) {
      path.setAttribute("fill", "none");
      path.setAttribute("stroke-width", String(THICK[leaf]));
      path.setAttribute("class", "search-limb");
    }
    group.append(path);
  }
  const title = svgElement("title");
  group.append(title);
  return group;
}

function figure() {
  const svg = svgElement("svg");
  svg.setAttribute("viewBox", "10 4 100 178");
  svg.setAttribute("class", "search-figure");
  svg.setAttribute("role", "group");
  svg.setAttribute("aria-label", "Parts of the body, seen from the front");
  const order = ["torso", ...now.body.leaves.filter((leaf) => leaf !== "torso")];
  svg.append(...order.map(shape));
  for (const [letter, x] of /** @type {[string, number][]} */ ([["R", 17], ["L", 103]])) {
    const text = svgElement("text");
    text.setAttribute("x", String(x));
    text.setAttribute("y", String(40));
    text.setAttribute("class", "search-side");
    text.textContent = letter;
    text.append(svgElement("title", {}, letter === "L" ? "Their left" : "Their right"));
    svg.append(text);
  }
  return svg;
}

/** @param {string} leaf */
function slider(leaf) {
  const input = element("input", "search-weight");
  Object.assign(input, { type: "range", min: 0, max: MOST, step: 0.5 });
  input.dataset.weight = leaf;
  input.setAttribute("aria-label", `Weight of the ${now.body.words[leaf].toLowerCase()}`);
  const label = element("span", "search-weight-name", now.body.words[leaf]);
  const line = element("label", "search-weight-row", label, input, element("span", "search-weight-share number"));
  line.dataset.part = leaf;
  return line;
}

/** @param {HTMLElement} box */
function build(box) {
  const presets = element("select", "search-select");
  presets.id = ids.SEARCH_PRESET;
  presets.setAttribute("aria-label", "Ready-made weights");
  const names = Object.keys(now.presets);
  presets.append(...names.map((name) => {
    const option = element("option", "", name[0].toUpperCase() + name.slice(1));
    option.value = name;
    return option;
  }), Object.assign(element("option", "", "Weights of your own"), { value: "", hidden: true }));
  const modes = element("div", "search-modes hidden");
  modes.setAttribute("role", "radiogroup");
  modes.setAttribute("aria-label", "What a click in the figure does");
  for (const [value, words] of [["weights", "Weigh"], ["pieces", "Assign"]]) {
    const one = element("button", "search-mode", words);
    one.type = "button";
    one.dataset.mode = value;
    one.setAttribute("role", "radio");
    modes.append(one);
  }
  const hint = element("p", "muted search-body-hint");
  const left = element("div", "search-body-left", figure(), modes);
  const right = element("div", "search-body-right", presets, element("div", "search-weights", ...now.body.leaves.map(slider)), hint);
  box.replaceChildren(left, right);
}

function paint() {
  const box = need(ids.SEARCH_BODY);
  const pieces = (now.found && now.found.pieces) || [];
  /** @param {string} leaf */
  const owner = (leaf) => pieces.findIndex((piece) => piece.leaves.includes(leaf));
  const several = pieces.length > 1;
  const most = Math.max(...Object.values(raw), 1e-9);
  within(box, ".search-modes").classList.toggle("hidden", !several);
  for (const one of allWithin(box, "[data-mode]")) one.setAttribute("aria-checked", String(one.dataset.mode === mode));
  for (const group of allWithin(box, ".search-part")) {
    const leaf = group.dataset.part ?? "";
    const own = owner(leaf);
    const colour = several ? (own >= 0 ? pieces[own].colour : "var(--muted)") : "var(--accent)";
    const strength = assigning() ? (own >= 0 ? 0.85 : 0.1) : raw[leaf] > 0 ? 0.25 + 0.75 * Math.sqrt(raw[leaf] / most) : 0;
    group.style.setProperty("--tone", colour);
    group.style.setProperty("--strength", `${Math.round(100 * strength)}%`);
    group.classList.toggle("off", strength === 0);
    const says = assigning() ? (own >= 0 ? `from ${"ABCDEF"[own]}` : "from none") : percent(share(leaf));
    group.setAttribute("aria-label", now.body.words[leaf]);
    group.setAttribute("role", assigning() ? "button" : "slider");
    if (assigning()) {
      for (const name of ["aria-valuenow", "aria-valuemin", "aria-valuemax", "aria-valuetext"]) group.removeAttribute(name);
      group.setAttribute("aria-label", `${now.body.words[leaf]}: ${says}`);
    } else {
      group.setAttribute("aria-valuemin", String(0));
      group.setAttribute("aria-valuemax", String(100));
      group.setAttribute("aria-valuenow", String(Math.round(100 * share(leaf))));
      group.setAttribute("aria-valuetext", says);
    }
    within(group, "title").textContent = `${now.body.words[leaf]}: ${says}`;
  }
  for (const row of allWithin(box, ".search-weight-row")) {
    const leaf = row.dataset.part ?? "";
    const input = within(row, "input");
    if (Number(input.value) !== raw[leaf]) input.value = String(raw[leaf]);
    input.style.setProperty("--share", `${(100 * raw[leaf]) / MOST}%`);
    input.setAttribute("aria-valuetext", percent(share(leaf)));
    within(row, ".search-weight-share").textContent = percent(share(leaf));
    row.classList.toggle("off", raw[leaf] === 0);
    const own = owner(leaf);
    row.style.setProperty("--tone", several && own >= 0 ? pieces[own].colour : "var(--accent)");
  }
  const named = Object.entries(now.presets).find(([, weights]) => sameWeights(weights, raw, now.body));
  within(box, `#${ids.SEARCH_PRESET}`).value = named ? named[0] : "";
  within(box, ".search-body-hint").textContent = total() === 0 ? "All parts are off: switch on at least one."
    : assigning() ? `Click parts to take them from ${"ABCDEF"[now.active]}. Shift + click: the whole limb.`
    : "Click a part to switch it on or off, Shift + click for this one alone; arrow keys change its weight.";
}

export const drawBody = () => {
  const box = find(ids.SEARCH_BODY);
  if (!box) return;
  if (!box.firstChild) {
    build(box);
    drawn = "";
  }
  const pieces = (now.found && now.found.pieces) || [];
  if (pieces.length < 2) mode = "weights";
  else if (pieces.length !== Number(box.dataset.pieces || 0)) mode = "pieces"; // a new piece needs its parts
  box.dataset.pieces = String(pieces.length);
  const text = now.view.parts || "";
  if (!raw || (text !== drawn && !waiting)) {
    raw = readWeights(text, now.body);
    drawn = text;
  }
  paint();
};

/**
 * Whether a part counts in what is shown: it has a weight, and a piece gives it.
 * @param {string} leaf
 */
export const counts = (leaf) => {
  const weights = readWeights(now.view.parts, now.body);
  return weights[leaf] > 0 && now.found.pieces.some((piece) => piece.leaves.includes(leaf));
};

/**
 * Lights a part up, here and in the hits.
 * @param {string | null | undefined} leaf
 */
export const lightPart = (leaf) => {
  for (const one of allWithin(document, ".search-page [data-part]")) one.classList.toggle("lit", one.dataset.part === leaf);
};

// ---- clicks and keys ----
const LIMBS = ["head_torso", "left_arm_hand", "right_arm_hand", "left_leg_foot", "right_leg_foot"];
/** @param {string} leaf */
const limbOf = (leaf) => now.body.nodes[LIMBS.find((node) => now.body.nodes[node].includes(leaf)) ?? ""];

/** @param {string[]} leaves */
function assign(leaves) {
  const pieces = copyPieces();
  const taker = pieces[now.active];
  if (!taker) return;
  const has = leaves.every((leaf) => taker.leaves.includes(leaf));
  for (const piece of pieces) piece.leaves = piece.leaves.filter((leaf) => !leaves.includes(leaf));
  if (!has) taker.leaves = now.body.leaves.filter((leaf) => taker.leaves.includes(leaf) || leaves.includes(leaf));
  if (pieces.every((piece) => !piece.leaves.length)) return; // at least one part must be left
  if (pieces.some((piece) => !piece.leaves.length)) now.active = 0;
  searchFor(pieces);
}

/** @param {string} leaf @param {boolean} shift */
function press(leaf, shift) {
  if (assigning()) return assign(shift ? limbOf(leaf) : [leaf]);
  if (shift) {
    raw = Object.fromEntries(now.body.leaves.map((one) => [one, one === leaf ? EVEN : 0]));
    return put(leaf, EVEN);
  }
  return put(leaf, raw[leaf] > 0 ? 0 : Math.max(...Object.values(raw)) || EVEN);
}

document.addEventListener("click", (event) => {
  const part = closest(event, ".search-part");
  if (part) press(part.dataset.part ?? "", event.shiftKey);
  const chosen = closest(event, "[data-mode]");
  if (chosen && chosen.closest(`#${ids.SEARCH_BODY}`)) {
    mode = chosen.dataset.mode ?? "weights";
    paint();
  }
});

document.addEventListener("keydown", (event) => {
  const part = closest(event, ".search-part");
  if (!part) return;
  const leaf = part.dataset.part ?? "";
  const step = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
  if (event.key === "Enter" || event.key === " ") press(leaf, event.shiftKey);
  else if (step && !assigning()) put(leaf, raw[leaf] + step);
  else if (event.key === "Home" && !assigning()) put(leaf, 0);
  else if (event.key === "End" && !assigning()) put(leaf, MOST);
  else return;
  event.preventDefault();
  event.stopPropagation();
});

document.addEventListener("input", (event) => {
  const { dataset, value } = targetOf(event);
  if (dataset?.weight) put(dataset.weight, Number(value));
});

document.addEventListener("change", (event) => {
  if (targetOf(event).id !== ids.SEARCH_PRESET || !targetOf(event).value) return;
  const weights = now.presets[targetOf(event).value];
  const scale = targetOf(event).value === "whole body" ? 100 : Math.min(100, MOST / Math.max(...Object.values(weights)));
  raw = Object.fromEntries(now.body.leaves.map((leaf) => [leaf, scale * (weights[leaf] || 0)]));
  if (targetOf(event).value === "whole body") raw = evenWeights(now.body);
  paint();
  send();
});

for (const kind of ["pointerover", "focusin"]) {
  document.addEventListener(kind, (event) => {
    const page = closest(event, ".search-page");
    if (!page) return;
    const part = closest(event, "[data-part]");
    lightPart(part ? part.dataset.part : null);
  });
}
