// Joints dragged by hand: chains that bend while bones keep their lengths.
import { jointOf } from "./figure.mjs";
/** @import { MapData } from "./data.mjs" */
/** @import { Point, Posture } from "./types.d.ts" */

/**
 * Joints from the end of a limb (or the trunk) up to where it is fixed: the dragged one first.
 * @param {MapData} map
 * @param {number} joint
 */
function chainOf(map, joint) {
  const chain = [joint];
  /** @param {number} j */
  const trunk = (j) => j < 0 || /^(chest|spine|neck|head)$|_(clavicle|shoulder|hip)$/.test(map.roles[j]);
  const inTrunk = trunk(joint);
  for (let j = map.parents[joint]; ; j = map.parents[j]) {
    chain.push(j);
    if (j < 0 || (!inTrunk && trunk(j))) return chain;
  }
}

/**
 * Move a joint towards a place: the chain bends (FABRIK), its end stays; what hangs on a bone turns with it.
 * @param {MapData} map
 * @param {Posture} posture
 * @param {number} joint
 * @param {Point} goal
 */
export function dragJoint(map, posture, joint, goal) {
  const chain = chainOf(map, joint);
  const at = chain.map((j) => [...jointOf(posture, j)]);
  const bones = chain.slice(0, -1).map((j) => map.lengths[j]);
  const fixed = [...at[at.length - 1]];
  /** @param {Point} from @param {Point} to @param {number} length @param {Point} otherwise */
  const toward = (from, to, length, otherwise) => {
    let way = to.map((v, k) => v - from[k]), size = Math.hypot(...way);
    if (size < 1e-9) [way, size] = [otherwise, Math.hypot(...otherwise) || 1];
    return from.map((v, k) => v + (length * way[k]) / size);
  };
  const before = at.map((point) => [...point]);
  for (let round = 0; round < 12; round++) {
    at[0] = [...goal];
    for (let k = 1; k < at.length; k++) at[k] = toward(at[k - 1], at[k], bones[k - 1], [0, 1, 0]);
    at[at.length - 1] = [...fixed];
    for (let k = at.length - 2; k >= 0; k--) at[k] = toward(at[k + 1], at[k], bones[k], [0, 1, 0]);
  }
  const moved = Float64Array.from(posture);
  /** @type {Map<number, (vector: Point) => Point>} */
  const turns = new Map(); // joint -> how its bone has turned
  chain.slice(0, -1).forEach((j, k) => {
    at[k].forEach((v, d) => (moved[3 * j + d] = v));
    turns.set(j, turn(before[k].map((v, d) => v - before[k + 1][d]), at[k].map((v, d) => v - at[k + 1][d])));
  });
  map.parents.forEach((parent, j) => { // parents come first: a joint off the chain hangs on a moved one
    if (turns.has(j) || !turns.has(parent)) return;
    const rotate = /** @type {(vector: Point) => Point} */ (turns.get(parent));
    turns.set(j, rotate);
    const bone = rotate([0, 1, 2].map((d) => posture[3 * j + d] - posture[3 * parent + d]));
    bone.forEach((v, d) => (moved[3 * j + d] = moved[3 * parent + d] + v));
  });
  return map.withBones(moved);
}

/**
 * The smallest rotation that takes one direction to another, as a function of vectors (Rodrigues).
 * @param {Point} from
 * @param {Point} to
 */
function turn(from, to) {
  /** @param {Point} v */
  const unit = (v) => v.map((x) => x / (Math.hypot(...v) || 1));
  const [a, b] = [unit(from), unit(to)];
  const axis = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const scale = 1 / Math.max(1 + cosine, 1e-6);
  return (/** @type {Point} */ v) => {
    /** @param {Point} p @param {Point} q */
    const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    const once = cross(axis, v), twice = cross(axis, once);
    return v.map((x, k) => x + once[k] + scale * twice[k]);
  };
}
