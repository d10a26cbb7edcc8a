// The span of seconds that the chart of a clip shows.
import { clamp } from "../shared/numbers.mjs";

const LEAST = 4; // frames

/**
 * The span nearest to [low, high] that lies within the clip and holds a few frames; `whole` where it is all of the clip.
 * @param {number} low
 * @param {number} high
 * @param {{ frames: number, fps: number }} clip
 * @returns {{ span: [number, number], whole: boolean }}
 */
export function spanWithin(low, high, { frames, fps }) {
  const seconds = Math.max((frames - 1) / fps, 1 / fps);
  const width = clamp(high - low, Math.min(LEAST / fps, seconds), seconds);
  const from = clamp((low + high - width) / 2, 0, seconds - width);
  return { span: [from, from + width], whole: width >= seconds - 1e-6 };
}
