// Motions for the tests of the stage: a body with two joints that walks along +Z and rises.
import { Figure } from "../../../assets/stage/figure.mjs";

/** A motion as the server sends it; the root moves `speed` metres a frame. */
export function madeMotion({ clip = "walk", start = 0, frames = 61, fps = 30, step = 1, speed = 0.02, floor = 0 } = {}) {
  const positions = new Float32Array(frames * 2 * 3);
  for (let f = 0; f < frames; f++) positions.set([0, 1, speed * f, 0, 1.5, speed * f], 6 * f);
  const header = {
    clip, start, end: start + (frames - 1) * step + 1, frames, fps: fps / step, step, floor,
    joints: ["hips", "head"], parents: [-1, 0], roles: ["pelvis", "head"], sides: ["centre", "centre"],
    root: 0, head: 1, nose: -1, head_radius: 0.1, height: 1.75, hands: [], feet: [],
  };
  return { header, positions, bytes: positions.byteLength };
}

/** A figure of such a motion. */
export const madeFigure = (motion = {}, item = {}, index = 0) => {
  const made = madeMotion(motion);
  return new Figure({ clip: made.header.clip, ...item }, made, index);
};
