// The warp strip: a row for each motion, along the medoid's time; colour tells where it is slower or faster than the medoid.
import { context2d, within } from "../shared/dom.mjs";
import { css, mix } from "./colours.mjs";
/** @import { Figure } from "./figure.mjs" */
/** @import { Theme, Timeline } from "./types.d.ts" */

const [SLOW, FAST] = [[33, 102, 172], [230, 97, 1]];
const LEVELS = 16;
const RANGE = Math.log(2.5); // colours are full where a motion runs 2.5 times as fast or as slow

export class WarpStrip {
  /** @param {HTMLElement} holder */
  constructor(holder) {
    this.holder = holder;
    this.canvas = /** @type {HTMLCanvasElement} */ (/** @type {Element} */ (within(holder, "canvas")));
    this.cursor = within(holder, ".ms-warp-cursor");
    /** @type {Float32Array[]} */
    this.speeds = [];
    /** @type {Figure[]} */
    this.figures = [];
    this.rowHeight = 3;
    this.stale = false;
  }

  /**
   * Smoothed speed of each motion relative to the medoid's, one value a medoid frame; none hides the strip.
   * @param {Figure[]} figures
   * @param {Timeline} timeline
   */
  show(figures, timeline) {
    this.speeds = timeline.warped ? figures.filter((f) => f.warp && f.visible).map((f) => localSpeed(f, figures[timeline.reference])) : [];
    this.holder.hidden = this.speeds.length < 2;
    if (this.holder.hidden) return;
    this.figures = figures.filter((f) => f.warp && f.visible);
    this.rowHeight = Math.max(3, Math.min(9, Math.floor(84 / this.speeds.length)));
    this.canvas.style.height = `${this.speeds.length * (this.rowHeight + 1)}px`;
  }

  /** Paint before the next frame: several changes at once cost one painting. */
  paint() {
    this.stale = true;
  }

  /** @param {Theme} theme */
  refresh(theme) {
    if (!this.stale || this.holder.hidden) return;
    this.stale = false;
    const rows = this.speeds.length;
    const height = this.rowHeight;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    this.canvas.width = width;
    this.canvas.height = Math.round(rows * (height + 1) * ratio);
    const context = context2d(this.canvas);
    const colours = levelColours(theme);
    this.speeds.forEach((speed, row) => {
      const y = Math.round(row * (height + 1) * ratio);
      for (const { from, to, level } of levelRuns(speed, Math.min(width, 400))) {
        context.fillStyle = colours[level + LEVELS];
        context.fillRect(Math.floor(from * width), y, Math.ceil((to - from) * width) + 1, Math.round(height * ratio));
      }
      context.fillStyle = this.figures[row].shades.fill[2][0];
      context.fillRect(0, y, Math.round(4 * ratio), Math.round(height * ratio));
    });
  }

  /** @param {number} share */
  place(share) {
    if (!this.holder.hidden) this.cursor.style.left = `${(100 * share).toFixed(3)}%`;
  }

  /**
   * What the row and column under the pointer mean, in words.
   * @param {PointerEvent} event
   */
  describe(event) {
    const box = this.canvas.getBoundingClientRect();
    const row = Math.floor(((event.clientY - box.top) / box.height) * this.speeds.length);
    const share = (event.clientX - box.left) / box.width;
    const speed = this.speeds[row]?.[Math.floor(share * this.speeds[row].length)];
    if (!(speed > 0)) return "";
    const pace = speed > 1.05 ? `${speed.toFixed(1)}× as fast` : speed < 0.95 ? `${(1 / speed).toFixed(1)}× as slow` : "as fast";
    return `${this.figures[row].label}: ${pace} as the middle motion here. Click to go there.`;
  }
}

/**
 * Colours from slow to fast, as many steps either way.
 * @param {Theme} theme
 */
function levelColours(theme) {
  const neutral = mix(theme.haze, theme.muted, 0.3);
  return Array.from({ length: 2 * LEVELS + 1 }, (_, k) => {
    const share = k / LEVELS - 1;
    return css(mix(neutral, share < 0 ? SLOW : FAST, Math.abs(share)));
  });
}

/**
 * Columns of one colour together: shares of the width and the step of the colour.
 * @param {Float32Array} speed
 * @param {number} columns
 */
function levelRuns(speed, columns) {
  /** @type {{ from: number, to: number, level: number }[]} */
  const runs = [];
  for (let c = 0; c < columns; c++) {
    const share = Math.log(Math.max(speed[Math.floor(((c + 0.5) * speed.length) / columns)], 0.05)) / RANGE;
    const level = Math.round(LEVELS * Math.min(Math.max(share, -1), 1));
    const last = runs.at(-1);
    if (last?.level === level) last.to = (c + 1) / columns;
    else runs.push({ from: c / columns, to: (c + 1) / columns, level });
  }
  return runs;
}

/** @param {Figure} figure @param {Figure} medoid */
function localSpeed(figure, medoid) {
  const warp = figure.warp ?? new Float32Array(2);
  const reach = Math.max(1, Math.round(0.1 * medoid.ownFps));
  return Float32Array.from(warp, (_, k) => {
    const [a, b] = [Math.max(k - reach, 0), Math.min(k + reach, warp.length - 1)];
    return ((warp[b] - warp[a]) / (b - a)) * (medoid.ownFps / figure.ownFps);
  });
}
