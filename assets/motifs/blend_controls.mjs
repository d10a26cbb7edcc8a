/* The controls of a blend space: a triangle for three motions, otherwise a slider for each. */
import { allWithin, element, find, within, svgElement, withAttributes } from "../shared/dom.mjs";
import { percent } from "../shared/words.mjs";
import * as ids from "./ids.mjs";
import { awayFromCorner, CORNERS, insideWeights, placeOf, weightsAt } from "./triangle.mjs";
/** @import { Mixture, MixtureActions } from "./types.d.ts" */

/**
 * An element with attributes and a text.
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {Record<string, string | number>} attributes
 * @param {string} [text]
 */
const html = (name, attributes, text) => withAttributes(element(name, "", text), attributes);
const LABELS = [[150, 14], [18, 232], [282, 232]];
const STEP = 0.02; // of a weight: one press of a key

/** @param {Mixture} state @param {MixtureActions} actions */
function triangle(state, actions) {
  const svg = svgElement("svg", { viewBox: "0 0 300 240", class: "blend-triangle" });
  svg.append(svgElement("polygon", { points: CORNERS.map((c) => c.join()).join(" "), class: "blend-field" }));
  CORNERS.forEach((corner, k) => {
    const [x, y] = LABELS[k];
    svg.append(svgElement("line", { x1: corner[0], y1: corner[1], x2: (CORNERS[(k + 1) % 3][0] + CORNERS[(k + 2) % 3][0]) / 2, y2: (CORNERS[(k + 1) % 3][1] + CORNERS[(k + 2) % 3][1]) / 2, class: "blend-median" }));
    svg.append(svgElement("circle", { cx: corner[0], cy: corner[1], r: 4, class: "blend-corner" }));
    svg.append(svgElement("text", { x, y, "text-anchor": "middle", class: "blend-corner-label" }, String(state.chosen[k] + 1)));
  });
  const point = svgElement("circle", { r: 10, class: "blend-point", tabindex: 0, role: "slider", "aria-label": "Mixture of three motions",
    "aria-valuemin": 0, "aria-valuemax": 100 });
  svg.append(point);
  /** @param {PointerEvent} event */
  const at = (event) => {
    const spot = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()?.inverse());
    actions.set(weightsAt(spot.x, spot.y));
  };
  svg.addEventListener("pointerdown", (event) => {
    svg.setPointerCapture(event.pointerId);
    point.focus();
    at(event);
    event.preventDefault();
  });
  svg.addEventListener("pointermove", (event) => {
    if (svg.hasPointerCapture(event.pointerId)) at(event);
  });
  point.addEventListener("keydown", (event) => press(event, state, actions));
  return svg;
}

/**
 * Arrows move the point, 1 2 3 put it on a corner, 0 in the middle.
 * @param {KeyboardEvent} event
 * @param {Mixture} state
 * @param {MixtureActions} actions
 */
function press(event, state, actions) {
  /** @type {Record<string, [number, number]>} */
  const ways = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };
  if (ways[event.key]) {
    const [x, y] = placeOf(insideWeights(state.values));
    const far = (event.shiftKey ? 5 : 1) * STEP * 244;
    let weights = weightsAt(x + ways[event.key][0] * far, y + ways[event.key][1] * far);
    const corner = state.values.findIndex((w) => w === 1);
    if (corner >= 0 && weights[corner] === 1) weights = awayFromCorner(corner, ways[event.key]);
    actions.set(weights);
  } else if ("0123".includes(event.key)) {
    actions.set(event.key === "0" ? [1, 1, 1].map((w) => w / 3) : [0, 1, 2].map((k) => Number(k === Number(event.key) - 1)));
  } else return;
  event.preventDefault();
  event.stopPropagation();
}

/** @param {Mixture} state @param {number} i @param {MixtureActions} actions */
function row(state, i, actions) {
  const { motion, clip, brief, when } = state.data.bodies[state.body].motions.find((one) => one.motion === state.chosen[i]) ?? state.data.bodies[state.body].motions[0];
  const made = html("div", { class: "blend-row" });
  const name = `Motion ${motion + 1}: ${clip}, ${when}`;
  const only = html("button", { type: "button", class: "blend-badge number", title: `Only motion ${motion + 1}`, "aria-label": `Only motion ${motion + 1}` }, String(motion + 1));
  only.addEventListener("click", () => actions.set(state.values.map((_, k) => Number(k === i))));
  const middle = html("div", { class: "blend-middle" });
  middle.append(html("span", { class: "ellipsis blend-name", title: name }, `${brief} · ${when.split(" ")[0]}`));
  if (state.chosen.length !== 3) {
    const range = html("input", { type: "range", min: 0, max: 1, step: 0.01, "aria-label": `Weight of ${name}` });
    range.addEventListener("input", () => actions.set(state.values.map((value, k) => (k === i ? Number(range.value) : value))));
    middle.append(range);
  }
  made.append(only, middle, html("span", { class: "number muted blend-share" }));
  if (state.chosen.length > 2) {
    const remove = html("button", { type: "button", class: "blend-remove", title: "Leave this motion out", "aria-label": `Leave motion ${motion + 1} out` }, "×");
    remove.addEventListener("click", () => actions.remove(motion));
    made.append(remove);
  }
  return made;
}

/** @param {string} label @param {[string | number, string][]} options @param {(value: string) => void} act */
function choice(label, options, act) {
  const select = html("select", { class: "blend-choice", "aria-label": label });
  for (const [value, text] of options) select.append(html("option", { value }, text));
  select.addEventListener("change", () => act(select.value));
  return select;
}

/** @param {HTMLElement} box @param {Mixture} state @param {number[]} shares @param {MixtureActions} actions */
export function drawControls(box, state, shares, actions) {
  const { bodies, most } = state.data;
  const controls = [];
  if (bodies.length > 1) {
    const bodyChoice = choice("Body", bodies.map(({ motions }, k) => /** @type {[number, string]} */ ([k, `Body ${k + 1}: ${motions.length} motions`])), (value) => actions.body(Number(value)));
    bodyChoice.value = String(state.body);
    controls.push(bodyChoice);
  }
  if (state.chosen.length === 3) controls.push(triangle(state, actions));
  const rows = html("div", { class: "blend-rows" });
  rows.append(...state.chosen.map((_, i) => row(state, i, actions)));
  controls.push(rows);
  const others = bodies[state.body].motions.filter(({ motion }) => !state.chosen.includes(motion));
  if (others.length && state.chosen.length < most) {
    /** @type {[string | number, string][]} */
    const options = [["", "Add a motion …"], ...others.map(({ motion, brief, when }) => /** @type {[number, string]} */ ([motion, `${motion + 1}  ${brief} · ${when.split(" ")[0]}`]))];
    controls.push(choice("Add a motion", options, (value) => value && actions.add(Number(value))));
  }
  box.replaceChildren(...controls);
  updateControls(state, shares);
}

/**
 * Numbers, sliders and the point follow the weights.
 * @param {Mixture} state
 * @param {number[]} shares
 */
export function updateControls(state, shares) {
  const box = find(ids.BLEND_CONTROLS);
  if (!box) return;
  allWithin(box, ".blend-row").forEach((made, i) => {
    within(made, ".blend-share").textContent = percent(shares[i]);
    made.style.setProperty("--share", String(shares[i]));
    const range = made.querySelector("input");
    if (range && Number(range.value) !== state.values[i]) range.value = String(state.values[i]);
    if (range) range.setAttribute("aria-valuetext", percent(shares[i]));
  });
  const point = box.querySelector(".blend-point");
  if (!point) return;
  const [x, y] = placeOf(shares);
  point.setAttribute("cx", x.toFixed(1));
  point.setAttribute("cy", y.toFixed(1));
  point.setAttribute("aria-valuenow", String(Math.round(100 * shares[0])));
  point.setAttribute("aria-valuetext", shares.map((share, k) => `motion ${state.chosen[k] + 1} ${percent(share)}`).join(", "));
}

