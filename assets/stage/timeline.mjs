// Time: one clock, and how each figure's own frames follow it.
/** @import { Figure } from "./figure.mjs" */

export const SPEEDS = [0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4];
const LOOPS = ["loop", "bounce", "once"];

export class Clock {
  constructor() {
    this.time = 0;
    this.duration = 0;
    this.speed = 1;
    this.loop = "loop";
    this.playing = false;
    this.direction = 1;
    this.jumped = false; // the last change of time was no smooth step
  }

  /** @param {number} time */
  seek(time) {
    this.time = Math.min(Math.max(time, 0), this.duration);
    this.jumped = true;
  }

  play() {
    if (this.loop === "once" && this.time >= this.duration) this.seek(0);
    this.direction = 1;
    this.playing = this.duration > 0;
  }

  /** @param {number} by */
  changeSpeed(by) {
    const nearest = SPEEDS.reduce((best, s, k) =>
      Math.abs(s - this.speed) < Math.abs(SPEEDS[best] - this.speed) ? k : best, 0);
    this.speed = SPEEDS[Math.min(Math.max(nearest + by, 0), SPEEDS.length - 1)];
  }

  nextLoop() {
    this.loop = LOOPS[(LOOPS.indexOf(this.loop) + 1) % LOOPS.length];
    this.direction = 1;
  }

  /** @param {number} seconds */
  advance(seconds) {
    if (!this.playing) return;
    let time = this.time + seconds * this.speed * this.direction;
    if (time >= 0 && time <= this.duration) {
      this.time = time;
      return;
    }
    if (this.loop === "loop") {
      this.seek(time % this.duration);
    } else if (this.loop === "bounce") {
      time = time < 0 ? -time : 2 * this.duration - time;
      this.time = Math.min(Math.max(time, 0), this.duration);
      this.direction *= -1;
    } else {
      this.time = this.duration;
      this.playing = false;
    }
  }
}

/**
 * Index of the figure whose warp runs straight: the medoid, whose frames count the time of all.
 * @param {Figure[]} figures
 */
function findMedoid(figures) {
  let best = -1;
  let least = Infinity;
  figures.forEach((figure, k) => {
    if (!figure.warp) return;
    const bend = figure.warp.reduce((sum, frame, i) => sum + Math.abs(frame - i), 0) / figure.warp.length;
    if (bend < least) [best, least] = [k, bend];
  });
  return best;
}

/**
 * How long the figures play and at what rate frames are stepped. In step ("warp"), time is the medoid's and every
 * figure stands at the frame that matches; otherwise each runs at its own pace from its start. Poses side by side all
 * move by the same share of their motion, whatever its length.
 * @param {Figure[]} figures
 * @param {string} sync
 * @param {string} layout
 */
export function makeTimeline(figures, sync, layout) {
  const medoid = sync === "warp" ? findMedoid(figures) : -1;
  const reference = medoid < 0 ? longest(figures) : medoid;
  const warped = medoid >= 0;
  figures.forEach((figure) => figure.follow(warped && figure.warp ? figures[medoid].ownFps : 0));
  const chosen = figures[reference];
  const spread = layout === "pose" && figures.length > 0;
  const duration = spread ? chosen.duration : figures.reduce((most, figure) => Math.max(most, figure.duration), 0);
  if (spread) figures.forEach((figure) => spreadOver(figure, duration));
  return { reference, warped, fps: chosen ? chosen.fps : 30, duration };
}

/**
 * All of a motion within the time of the others; half-way it stands at the item's `frame`, or at its middle.
 * @param {Figure} figure
 * @param {number} duration
 */
function spreadOver(figure, duration) {
  figure.follow(figure.warpFps, duration);
  const middle = figure.item.frame;
  if (middle === undefined || !Number.isFinite(middle)) return;
  const { start, step } = figure.header;
  figure.offset = (middle - start) / step - figure.frameAt(duration / 2);
}

/** @param {Figure[]} figures */
function longest(figures) {
  return figures.reduce((best, f, k) => (f.ownDuration > figures[best].ownDuration ? k : best), 0);
}
