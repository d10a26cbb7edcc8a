// A posture of the motion map as a small drawing: joints in millimetres around the pelvis, on a body that faces +z.
import { svgElement } from "../shared/dom.mjs";
/** @import { MapContent } from "../blocks/types.d.ts" */

const [YAW, PITCH] = [(35 * Math.PI) / 180, (8 * Math.PI) / 180];

/** The numbers of all postures. @param {string} text */
export function readPostures(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Int16Array(bytes.buffer);
}

/**
 * @param {MapContent} map
 * @param {Int16Array} postures
 * @param {number} node
 * @param {number} size
 */
export function drawPosture({ parents, sides, roles }, postures, node, size = 120) {
  const n = parents.length;
  /** @param {number} joint */
  const seen = (joint) => {
    const at = 3 * (node * n + joint);
    const [x, y, z] = joint < 0 ? [0, 0, 0] : [postures[at], postures[at + 1], postures[at + 2]];
    const away = Math.cos(YAW) * z - Math.sin(YAW) * x;
    return [Math.cos(YAW) * x + Math.sin(YAW) * z, -(y * Math.cos(PITCH) - away * Math.sin(PITCH)), away];
  };
  const points = parents.map((_, joint) => seen(joint));
  const lows = [0, 1].map((k) => Math.min(0, ...points.map((point) => point[k])) - 160);
  const highs = [0, 1].map((k) => Math.max(0, ...points.map((point) => point[k])) + 90);
  const svg = svgElement("svg", { class: "block-posture", viewBox: `${lows[0]} ${lows[1]} ${highs[0] - lows[0]} ${highs[1] - lows[1]}`, width: size, height: size });
  const bones = parents.map((parent, joint) => ({ joint, side: trunk(roles[joint]) ? "centre" : sides[joint], from: seen(parent), to: points[joint] }));
  for (const { from, to, side } of bones.sort((a, b) => a.from[2] + a.to[2] - b.from[2] - b.to[2])) {
    svg.append(svgElement("path", { d: `M${from[0]} ${from[1]}L${to[0]} ${to[1]}`, class: `block-bone block-${side}` }));
  }
  const head = roles.indexOf("head");
  if (head >= 0) svg.append(svgElement("circle", { cx: points[head][0], cy: points[head][1] - 85, r: 100, class: "block-skull" }));
  return svg;
}

/** @param {string} role */
const trunk = (role) => /_(clavicle|shoulder|hip)$/.test(role);
