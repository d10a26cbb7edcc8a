/* The controls of a blend space: a triangle for three motions, a slider each for two or more than three. */
import { element, find, svgElement, withAttributes } from "../shared/dom.mjs";
import { percent } from "../shared/words.mjs";

const html = (name, attributes, text) => withAttributes(element(name, "", text), attributes);
const CORNERS = [[150, 26], [28, 214], [272, 214]];
const LABELS = [[150, 14], [18, 232], [282, 232]];
const STEP = 0.02, CORNER = 0.03; // of a weight: one press of a key; how near a corner holds the point

const place = (weights) => [0, 1].map((axis) => weights.reduce((total, w, k) => total + w * CORNERS[k][axis], 0));

/** Weights of the corners at a point; outside the triangle those of the nearest side. */
function weightsAt(x, y) {
  const [[ax, ay], [bx, by], [cx, cy]] = CORNERS;
  const area = (by - cy) * (ax - cx) + (cx - bx) * (ay - cy);
  const a = ((by - cy) * (x - cx) + (cx - bx) * (y - cy)) / area;
  const b = ((cy - ay) * (x - cx) + (ax - cx) * (y - cy)) / area;
  return inside([a, b, 1 - a - b]);
}

function inside(weights) {
  const kept = weights.map((w) => Math.max(w, 0));
  const total = kept.reduce((sum, w) => sum + w, 0) || 1;
  const shares = kept.map((w) => w / total);
  const corner = shares.findIndex((w) => w > 1 - CORNER);
  return shares.map((w, k) => (corner < 0 ? w : Number(k === corner)));
}

function triangle(state, hands) {
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
  const at = (event) => {
    const spot = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    hands.set(weightsAt(spot.x, spot.y));
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
  point.addEventListener("keydown", (event) => press(event, state, hands));
  return svg;
}

/** Arrows move the point, 1 2 3 put it on a corner, 0 in the middle. */
function press(event, state, hands) {
  const ways = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };
  if (ways[event.key]) {
    const [x, y] = place(inside(state.values));
    const far = (event.shiftKey ? 5 : 1) * STEP * 244;
    let weights = weightsAt(x + ways[event.key][0] * far, y + ways[event.key][1] * far);
    const corner = state.values.findIndex((w) => w === 1);
    if (corner >= 0 && weights[corner] === 1) weights = away(corner, ways[event.key]);
    hands.set(weights);
  } else if ("0123".includes(event.key)) {
    hands.set(event.key === "0" ? [1, 1, 1].map((w) => w / 3) : [0, 1, 2].map((k) => Number(k === Number(event.key) - 1)));
  } else return;
  event.preventDefault();
  event.stopPropagation();
}

/** From a corner that holds the point, in the direction of a key: along the side that leads most that way. */
function away(corner, [dx, dy]) {
  const [x, y] = CORNERS[corner];
  const gains = CORNERS.map(([cx, cy], k) => (k === corner ? 0 : (cx - x) * dx + (cy - y) * dy));
  const best = gains.indexOf(Math.max(...gains));
  if (gains[best] <= 0) return [0, 1, 2].map((k) => Number(k === corner));
  return [0, 1, 2].map((k) => (k === corner ? 1 - 2 * CORNER : k === best ? 2 * CORNER : 0));
}

function row(state, i, hands) {
  const { motion, clip, brief, when } = state.data.bodies[state.body].motions.find((one) => one.motion === state.chosen[i]);
  const made = html("div", { class: "blend-row" });
  const name = `Motion ${motion + 1}: ${clip}, ${when}`;
  const only = html("button", { type: "button", class: "blend-badge number", title: `Only motion ${motion + 1}`, "aria-label": `Only motion ${motion + 1}` }, String(motion + 1));
  only.addEventListener("click", () => hands.set(state.values.map((_, k) => Number(k === i))));
  const middle = html("div", { class: "blend-middle" });
  middle.append(html("span", { class: "ellipsis blend-name", title: name }, `${brief} · ${when.split(" ")[0]}`));
  if (state.chosen.length !== 3) {
    const range = html("input", { type: "range", min: 0, max: 1, step: 0.01, "aria-label": `Weight of ${name}` });
    range.addEventListener("input", () => hands.set(state.values.map((value, k) => (k === i ? Number(range.value) : value))));
    middle.append(range);
  }
  made.append(only, middle, html("span", { class: "number muted blend-share" }));
  if (state.chosen.length > 2) {
    const remove = html("button", { type: "button", class: "blend-remove", title: "Leave this motion out", "aria-label": `Leave motion ${motion + 1} out` }, "×");
    remove.addEventListener("click", () => hands.remove(motion));
    made.append(remove);
  }
  return made;
}

function choice(label, options, act) {
  const select = html("select", { class: "blend-choice", "aria-label": label });
  for (const [value, text] of options) select.append(html("option", { value }, text));
  select.addEventListener("change", () => act(select.value));
  return select;
}

export function drawControls(box, state, shares, hands) {
  const { bodies, most } = state.data;
  const controls = [];
  if (bodies.length > 1) {
    const bodyChoice = choice("Body", bodies.map(({ motions }, k) => [k, `Body ${k + 1}: ${motions.length} motions`]), (value) => hands.body(Number(value)));
    bodyChoice.value = String(state.body);
    controls.push(bodyChoice);
  }
  if (state.chosen.length === 3) controls.push(triangle(state, hands));
  const rows = html("div", { class: "blend-rows" });
  rows.append(...state.chosen.map((_, i) => row(state, i, hands)));
  controls.push(rows);
  const others = bodies[state.body].motions.filter(({ motion }) => !state.chosen.includes(motion));
  if (others.length && state.chosen.length < most) {
    const options = [["", "Add a motion …"], ...others.map(({ motion, brief, when }) => [motion, `${motion + 1}  ${brief} · ${when.split(" ")[0]}`])];
    controls.push(choice("Add a motion", options, (value) => value && hands.add(Number(value))));
  }
  box.replaceChildren(...controls);
  updateControls(state, shares);
}

/** Numbers, sliders and the point follow the weights. */
export function updateControls(state, shares) {
  const box = find("blend-controls");
  if (!box) return;
  box.querySelectorAll(".blend-row").forEach((made, i) => {
    made.querySelector(".blend-share").textContent = percent(shares[i]);
    made.style.setProperty("--share", shares[i]);
    const range = made.querySelector("input");
    if (range && Number(range.value) !== state.values[i]) range.value = state.values[i];
    if (range) range.setAttribute("aria-valuetext", percent(shares[i]));
  });
  const point = box.querySelector(".blend-point");
  if (!point) return;
  const [x, y] = place(shares);
  point.setAttribute("cx", x.toFixed(1));
  point.setAttribute("cy", y.toFixed(1));
  point.setAttribute("aria-valuenow", Math.round(100 * shares[0]));
  point.setAttribute("aria-valuetext", shares.map((share, k) => `motion ${state.chosen[k] + 1} ${percent(share)}`).join(", "));
}

