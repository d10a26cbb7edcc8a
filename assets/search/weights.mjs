// How much each part of the body counts, as a link has it: "head:9,left_arm:10".
/** @import { Body, Weights } from "./types.d.ts" */

export const EVEN = 10; // of each part of the whole body; only ratios count

/** The whole body alike. @param {Body} body @returns {Weights} */
export const evenWeights = (body) => Object.fromEntries(body.leaves.map((leaf) => [leaf, EVEN]));

/**
 * Weights of a link, part by part; those of a larger part go to all of it. Without any that can be read the whole body.
 * @param {string | undefined} text
 * @param {Body} body
 * @returns {Weights}
 */
export function readWeights(text, body) {
  const weights = Object.fromEntries(body.leaves.map((leaf) => [leaf, 0]));
  let total = 0;
  for (const word of (text || "").split(",")) {
    const [node, weight] = word.split(":");
    const leaves = body.nodes[node];
    if (!leaves || !(Number(weight) > 0)) continue;
    for (const leaf of leaves) weights[leaf] += Number(weight) / leaves.length;
    total += Number(weight);
  }
  return total ? weights : evenWeights(body);
}

/**
 * Weights for a link; nothing for the whole body alike.
 * @param {Weights} weights
 * @param {Body} body
 */
export function writeWeights(weights, body) {
  const values = Object.values(weights);
  if (values.every((value) => value === values[0])) return "";
  return body.leaves.filter((leaf) => weights[leaf] > 0).map((leaf) => `${leaf}:${Number(weights[leaf].toFixed(2))}`).join(",");
}

/** @param {Weights} weights */
const total = (weights) => Object.values(weights).reduce((sum, value) => sum + value, 0) || 1;

/**
 * Whether two have the same ratios.
 * @param {Weights} a
 * @param {Weights} b
 * @param {Body} body
 */
export function sameWeights(a, b, body) {
  const [sumA, sumB] = [total(a), total(b)];
  return body.leaves.every((leaf) => Math.abs((a[leaf] || 0) / sumA - (b[leaf] || 0) / sumB) < 2e-3);
}
