// Weights over the motions of a motif, and how their times run together.
/** @import { BlendMotion } from "./types.d.ts" */

/** @param {number[]} values */
export const sum = (values) => values.reduce((total, value) => total + value, 0);

/** A weight as links have it. @param {number} value */
export const rounded = (value) => String(Math.round(value * 100) / 100);

/** Motions with their weights for a link: "0:0.5,3:1". @param {number[]} motions @param {number[]} values */
export const writePairs = (motions, values) => motions.map((motion, i) => `${motion}:${rounded(values[i])}`).join(",");

/** What each of `n` motions weighs at first. @param {number} n */
export const evenWeight = (n) => (n > 3 ? 0.5 : 1 / n);

/**
 * Value at `x` of a curve through rising xs; straight between them.
 * @param {number} x
 * @param {number[]} xs
 * @param {number[]} ys
 */
export function interpolate(x, xs, ys) {
  let k = 1;
  while (k < xs.length - 1 && xs[k] < x) k++;
  const part = (x - xs[k - 1]) / Math.max(xs[k] - xs[k - 1], 1e-9);
  return ys[k - 1] + (ys[k] - ys[k - 1]) * Math.min(Math.max(part, 0), 1);
}

/**
 * For each frame of the mixture the frames of its sources beside it, so that they move in step.
 * @param {{ share: number, one: BlendMotion }[]} used
 */
export function inStep(used) {
  const knots = used[0].one.seconds.map((_, i) => i);
  const times = knots.map((i) => sum(used.map(({ one, share }) => share * one.seconds[i])));
  const last = times.at(-1) ?? 0;
  const fps = Math.max(...used.map(({ one }) => one.fps));
  const n = Math.round(last * fps) + 1;
  const at = Array.from({ length: n }, (_, j) => interpolate((j / Math.max(n - 1, 1)) * last, times, knots));
  /** @param {{ one: BlendMotion }} source */
  const own = ({ one }) => at.map((u) => Math.min(Math.round(interpolate(u, knots, one.seconds) * one.fps * 100) / 100, one.end - one.start - 1));
  return { mixture: at.map((_, j) => j), sources: used.map(own) };
}

/** Shares of sum 1; all alike where none has any weight. @param {number[]} values */
export function sharesOf(values) {
  const total = sum(values);
  return values.map((value) => (total > 0 ? value / total : 1 / values.length));
}

/** Motions and weights of a link, each at most 1. @param {string | undefined} text */
export const readPairs = (text) =>
  [...(text || "").matchAll(/(\d+):([\d.]+)/g)].map(([, motion, value]) => [Number(motion), Math.min(Number(value) || 0, 1)]);
