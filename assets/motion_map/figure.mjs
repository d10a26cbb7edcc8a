/* Postures of a map as stick figures in SVG: from the front, the side, the top, or as icons from the front left. */
import { svgElement } from "../shared/dom.mjs";
/** @import { MapData } from "./data.mjs" */
/** @import { Point, Posture } from "./types.d.ts" */

const HEAD = 0.105; // metres, on a body of 1.7 m
/** @type {Record<string, number>} */
const PENS = { left: 0.06, right: 0.06, centre: 0.075 };
const [YAW, PITCH] = [(35 * Math.PI) / 180, (8 * Math.PI) / 180];

/**
 * Per view: a point to [right, down, towards the viewer]. The body faces +z, its left is +x.
 * @type {Record<string, (point: Point) => Point>}
 */
export const VIEWS = {
  front: ([x, y, z]) => [x, -y, z],
  side: ([x, y, z]) => [z, -y, -x],
  top: ([x, y, z]) => [x, z, y],
  icon: ([x, y, z]) => {
    const [a, c] = [Math.cos(YAW) * x + Math.sin(YAW) * z, Math.cos(YAW) * z - Math.sin(YAW) * x];
    return [a, c * Math.sin(PITCH) - y * Math.cos(PITCH), c];
  },
};

/** @param {Posture} posture @param {number} j */
export const jointOf = (posture, j) => (j < 0 ? [0, 0, 0] : [posture[3 * j], posture[3 * j + 1], posture[3 * j + 2]]);
/** @param {Point} a @param {Point} b */
const minus = (a, b) => a.map((part, k) => part - b[k]);
/** @param {Point} a @param {Point} b @param {number} [scale] */
const plus = (a, b, scale = 1) => a.map((part, k) => part + scale * b[k]);
/** @param {Point} a @param {Point} b */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @param {Point} a */
const unit = (a) => {
  const size = Math.hypot(...a);
  return size > 1e-6 ? a.map((part) => part / size) : null;
};

/**
 * Where the trunk faces: square to the shoulders and to the line from the hips to the chest.
 * @param {MapData} map
 * @param {Posture} posture
 */
function forward(map, posture) {
  const [left, right] = ["left_shoulder", "right_shoulder"].map((role) => map.roles.indexOf(role));
  if (left < 0 || right < 0) return [0, 0, 1];
  const [a, b] = [jointOf(posture, left), jointOf(posture, right)];
  return unit(cross(minus(a, b), plus(a, b))) || [0, 0, 1];
}

/** @param {MapData} map @param {number} j */
const sideOf = (map, j) => (/_(clavicle|shoulder|hip)$/.test(map.roles[j]) ? "centre" : map.sides[j]);

/**
 * A <g> with the posture (3 n_joints) in metres, the pelvis at the origin, as seen in a view.
 * @param {MapData} map
 * @param {Posture} posture
 * @param {string} view
 */
export function drawFigure(map, posture, view) {
  const see = VIEWS[view];
  /** @param {Point} point */
  const text = (point) => { const [a, b] = see(point); return `${a.toFixed(3)} ${b.toFixed(3)}`; };
  const layers = ["left", "right", "centre"].map((side) => {
    const bones = map.parents.map((parent, j) => [parent, j]).filter(([, j]) => sideOf(map, j) === side);
    const d = bones.map(([parent, j]) => `M${text(jointOf(posture, parent))}L${text(jointOf(posture, j))}`).join("");
    const depth = bones.reduce((sum, [, j]) => sum + see(jointOf(posture, j))[2], 0) / Math.max(bones.length, 1);
    const group = svgElement("g", { class: `map-limb-${side}` }, svgElement("path", { d, "stroke-width": PENS[side], fill: "none" }));
    if (side === "centre") group.append(...head(map, posture, see));
    return { group, depth };
  });
  layers.sort((a, b) => a.depth - b.depth);
  return svgElement("g", { class: "map-figure" }, ...layers.map((layer) => layer.group));
}

/** @param {MapData} map @param {Posture} posture @param {(point: Point) => Point} see */
function head(map, posture, see) {
  const at = map.roles.indexOf("head");
  if (at < 0) return [];
  const up = unit(minus(jointOf(posture, at), jointOf(posture, map.parents[at]))) || [0, 1, 0];
  const centre = plus(jointOf(posture, at), up, HEAD);
  const [middle, tip] = [see(centre), see(plus(centre, forward(map, posture), 1.5 * HEAD))];
  const ball = svgElement("circle", { cx: middle[0], cy: middle[1], r: HEAD, class: "map-head" });
  if (tip[2] < middle[2] - 1e-6) return [ball];
  return [ball, svgElement("path", { d: `M${middle[0]} ${middle[1]}L${tip[0]} ${tip[1]}`, "stroke-width": 0.045, class: "map-nose" })];
}

/**
 * An <svg> of the posture in a view; the box holds every posture at the same scale.
 * @param {MapData} map
 * @param {Posture} posture
 * @param {string} view
 * @param {string} [className]
 */
export function figurePicture(map, posture, view, className = "map-picture") {
  const fit = view === "icon";
  let box = [-1, -1.05, 2, 2.1];
  if (fit) {
    const seen = [[0, 0, 0], ...map.parents.map((_, j) => jointOf(posture, j))].map(VIEWS.icon);
    const [xs, ys] = [seen.map((p) => p[0]), seen.map((p) => p[1])];
    const side = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys), 1.2) + 0.34;
    box = [(Math.max(...xs) + Math.min(...xs) - side) / 2, (Math.max(...ys) + Math.min(...ys) - side) / 2 - 0.08, side, side];
  }
  const svg = svgElement("svg", { viewBox: box.map((part) => part.toFixed(3)).join(" "), class: className, "aria-hidden": "true" });
  svg.append(drawFigure(map, posture, view));
  return svg;
}

