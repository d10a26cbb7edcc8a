// Coloured spans of a motion (nodes of a walk, labels, words of a sentence): bands above the time bar, and the root's
// path on the floor in their colours.
import { within } from "../shared/dom.mjs";
import { NEAR } from "./camera.mjs";
import { css, parseColour } from "./colours.mjs";
/** @import { Camera } from "./camera.mjs" */
/** @import { Figure } from "./figure.mjs" */
/** @import { PaintedSpan, Path, Span } from "./types.d.ts" */

const PATH_STEPS = 30; // points a second
const MOST_POINTS = 1200;
const MOST_ROWS = 8;

/**
 * An item's spans, cut to its segment, in order: [{start, end, rgb, colour, label}] in frames of the clip's own rate.
 * @param {Span[] | undefined} colours
 * @param {{ start: number, end: number }} segment
 * @returns {PaintedSpan[]}
 */
export function readSpans(colours, { start, end }) {
  if (!Array.isArray(colours)) return [];
  return colours
    .filter((span) => Number.isFinite(span?.start) && Number.isFinite(span?.end))
    .map((span) => {
      const rgb = parseColour(String(span.colour ?? ""));
      return { start: Math.max(span.start, start), end: Math.min(span.end, end), rgb, colour: css(rgb), label: String(span.label ?? "") };
    })
    .filter((span) => span.end > span.start)
    .sort((a, b) => a.start - b.start);
}

export class SpanBands {
  /** @param {HTMLElement} holder */
  constructor(holder) {
    this.holder = holder;
    this.rows = within(holder, ".ms-band-rows");
    this.cursor = within(holder, ".ms-band-cursor");
  }

  /**
   * A row for each visible figure that has spans, along the Stage's time.
   * @param {Figure[]} figures
   * @param {number} duration
   */
  show(figures, duration) {
    const shown = figures.filter((figure) => figure.visible && figure.spans.length).slice(0, MOST_ROWS);
    this.holder.hidden = !shown.length || !(duration > 0);
    this.rows.classList.toggle("ms-band-thin", shown.length > 3);
    this.rows.replaceChildren(...(this.holder.hidden ? [] : shown.map((figure) => row(figure, duration))));
  }

  /** @param {number} share */
  place(share) {
    if (!this.holder.hidden) this.cursor.style.left = `${(100 * share).toFixed(3)}%`;
  }
}

/** @param {Figure} figure @param {number} duration */
function row(figure, duration) {
  const made = document.createElement("div");
  made.className = "ms-band";
  for (const span of figure.spans) {
    const block = document.createElement("span");
    const [from, to] = [figure.timeAt(span.start), Math.min(figure.timeAt(span.end), duration)];
    block.style.left = `${(100 * from) / duration}%`;
    block.style.width = `${(100 * Math.max(to - from, 0)) / duration}%`;
    block.style.background = span.colour;
    block.style.color = 0.3 * span.rgb[0] + 0.59 * span.rgb[1] + 0.11 * span.rgb[2] > 140 ? "#10151d" : "#ffffff";
    block.textContent = span.label;
    block.title = `${span.label || "no name"}, frames ${Math.round(span.start)} to ${Math.round(span.end)} of ${figure.label}`;
    made.append(block);
  }
  return made;
}

/**
 * The root's way over the floor, and where each colour begins: {points (n, 3), runs: [{from, to, colour}]}.
 * @param {Figure} figure
 * @param {number} duration
 * @param {string} plain
 */
function makePath(figure, duration, plain) {
  const n = Math.min(Math.max(Math.ceil(duration * PATH_STEPS), 2), MOST_POINTS);
  const points = new Float32Array(3 * n);
  /** @type {Path["runs"]} */
  const runs = [];
  const root = 3 * figure.header.root;
  for (let s = 0; s < n; s++) {
    const time = (duration * s) / (n - 1);
    figure.pose(time, figure.spare);
    points[3 * s] = figure.spare[root];
    points[3 * s + 2] = figure.spare[root + 2];
    const colour = figure.spanAt(figure.recordedFrame(time))?.colour ?? plain;
    const last = runs.at(-1);
    if (last?.colour === colour) last.to = s;
    else runs.push({ from: Math.max(s - 1, 0), to: s, colour });
  }
  return { points, runs, n };
}

/** Paint the paths of all visible figures that have spans and really go somewhere. */
export class PathPainter {
  constructor() {
    this.x = new Float32Array(MOST_POINTS);
    this.y = new Float32Array(MOST_POINTS);
    this.scale = new Float32Array(MOST_POINTS);
    this.depth = new Float32Array(MOST_POINTS);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {Figure[]} figures
   * @param {number} duration
   */
  paint(context, camera, figures, duration) {
    context.lineCap = context.lineJoin = "round";
    for (const figure of figures) {
      if (!figure.visible || !figure.spans.length || figure.walksInPlace) continue;
      const { points, runs, n } = (figure.path ??= makePath(figure, duration, figure.shades.fill[2][4]));
      camera.project(points, n, this.x, this.y, this.scale, this.depth);
      for (const { from, to, colour } of runs) {
        context.strokeStyle = colour;
        context.lineWidth = Math.min(Math.max(0.035 * this.scale[from], 2), 7);
        context.beginPath();
        for (let s = from; s <= to; s++) if (this.depth[s] > NEAR) context.lineTo(this.x[s], this.y[s]);
        context.stroke();
      }
    }
  }
}
