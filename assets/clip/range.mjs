/* Pointer and keys on the chart of the Clip page: moments, ranges, zoom. */
import { changeView, setStore } from "../shared/dash.mjs";
import { closest, find, targetOf } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { clamp } from "../shared/numbers.mjs";
import { player } from "../stage/player.mjs";
import { at, chartPlot, chosenRange, frameNow, placeMarks, seekFrame } from "./cursor.mjs";
import * as ids from "./ids.mjs";
import { spanWithin } from "./zoom.mjs";
/** @import { Plot, Range, Spot } from "./types.d.ts" */

const CLOSE = 4; // pixels that the pointer may move during a click
/** The chart's box around the target of an event. @param {EventTarget | null} target */
const box = (target) => closest({ target }, `#${ids.CLIP_BOX}`);
/** What is pressed now. @type {Spot & { id: number, grip: boolean, moved: boolean } | null} */
let press = null;

/** @param {Plot} plot @param {number} pixel */
const frameAt = (plot, pixel) => clamp(Math.round(plot.time(pixel) * plot.meta.fps), 0, plot.meta.frames - 1);
/** @param {Plot} plot @param {number} x @param {number} y */
const inside = (plot, x, y) => x >= plot.left - 6 && x <= plot.left + plot.width + 6 && y >= plot.top && y <= plot.top + plot.height;

/** @param {PointerEvent | WheelEvent} event */
function locate(event) {
  const plot = chartPlot();
  const area = find(ids.CLIP_BOX);
  if (!plot || !area) return null;
  const { left, top } = area.getBoundingClientRect();
  return { plot, x: event.clientX - left, y: event.clientY - top };
}

document.addEventListener("pointerdown", (event) => {
  if (event.button || !box(targetOf(event))) return;
  const spot = locate(event);
  if (!spot) return;
  const grip = Boolean(closest(event, ".clip-grip"));
  if (!grip && !inside(spot.plot, spot.x, spot.y)) return;
  press = { ...spot, id: event.pointerId, grip, moved: false };
  if (spot.plot.meta.kind === "time") box(targetOf(event))?.setPointerCapture(event.pointerId);
});

document.addEventListener("pointermove", (event) => {
  const over = box(targetOf(event));
  if (!press) {
    const spot = over && locate(event);
    const hover = spot && spot.plot.meta.kind === "time" && inside(spot.plot, spot.x, spot.y) ? frameAt(spot.plot, spot.x) : null;
    if (hover !== at.hover) {
      at.hover = hover;
      placeMarks();
    }
    return;
  }
  const spot = locate(event);
  if (!spot || event.pointerId !== press.id) return;
  if (Math.abs(spot.x - press.x) > CLOSE) press.moved = true;
  if (press.plot.meta.kind !== "time") return;
  if (press.grip) return seekFrame(frameAt(spot.plot, spot.x));
  if (!press.moved) return;
  const ends = [frameAt(spot.plot, press.x), frameAt(spot.plot, spot.x)].sort((a, b) => a - b);
  at.dragged = [ends[0], ends[1] + 1];
  at.hover = null;
  placeMarks();
});

document.addEventListener("pointerup", (event) => {
  if (!press || event.pointerId !== press.id) return;
  const { plot, moved, grip } = press;
  press = null;
  const dragged = at.dragged;
  at.dragged = null;
  if (grip) return;
  if (dragged) return select(dragged);
  if (moved) return;
  const spot = locate(event);
  if (!spot) return;
  if (plot.meta.kind === "path") return clickPath(spot);
  const picked = blockAt(spot);
  if (picked) select(picked);
  else seekFrame(frameAt(spot.plot, spot.x));
});

document.addEventListener("pointercancel", () => {
  press = null;
  at.dragged = null;
  placeMarks();
});

document.addEventListener("pointerout", (event) => {
  if (at.hover === null || box(event.relatedTarget)) return;
  at.hover = null;
  placeMarks();
});

/** @param {Range} range */
function select(range) {
  const [start, end] = range;
  if (at.shown && end - start >= 2) setStore(SELECTION, { clip: at.shown.clip, start, end });
  else placeMarks();
}

/**
 * The frames of the block of a band under the pointer.
 * @param {Spot} spot
 */
function blockAt({ plot, x, y }) {
  const seconds = plot.time(x);
  for (const trace of plot.graph.data) {
    if (!trace.meta || !trace.meta.picks) continue;
    const axis = plot.full["yaxis" + trace.yaxis.slice(1)];
    const row = axis.p2l(y - plot.top + plot.full._size.t - axis._offset);
    if (Math.abs(row - trace.meta.row) > 0.5) continue;
    const frame = seconds * plot.meta.fps;
    const hits = trace.meta.picks.filter((/** @type {Range} */ [start, end]) => frame >= start && frame < end);
    /** @param {Range} range */
    const away = ([start, end]) => Math.abs(frame - (start + end) / 2);
    const hit = hits.sort((/** @type {Range} */ a, /** @type {Range} */ b) => away(a) - away(b))[0];
    if (hit) return hit;
  }
  return null;
}

/**
 * Go to the moment at which the pelvis was nearest to a point of the path.
 * @param {Spot} spot
 */
function clickPath({ plot, x, y }) {
  const path = plot.graph.data[0];
  let best = -1;
  let least = 30;
  for (let k = 0; k < path.x.length; k++) {
    const away = Math.hypot(plot.x(path.x[k]) - x, plot.y(path.y[k]) - y);
    if (away < least) [best, least] = [k, away];
  }
  if (best >= 0) seekFrame(path.customdata[best]);
}

// ---- zoom: the span of seconds is part of the link ----
let settling = 0;
let moving = 0;
/** @type {[number, number] | null} */
let wanted = null; // the chart is drawn at most once a frame

async function move() {
  const plot = chartPlot();
  const range = wanted;
  if (plot && range) await window.Plotly.relayout(plot.graph, { "xaxis.range": range });
  moving = 0;
  if (range !== wanted) moving = requestAnimationFrame(move);
  else wanted = null;
}

/** @param {number} low @param {number} high */
function show(low, high) {
  const plot = chartPlot();
  if (!plot || plot.meta.kind !== "time") return;
  const { span, whole } = spanWithin(low, high, plot.meta);
  wanted = span;
  if (!moving) moving = requestAnimationFrame(move);
  clearTimeout(settling);
  settling = setTimeout(() => changeView({ span: whole ? "" : span.map((second) => second.toFixed(3)).join("_") }), 160);
}

/** @param {string | undefined} what */
function zoom(what) {
  const plot = chartPlot();
  if (!plot) return;
  const [low, high] = plot.range;
  if (what === "whole") return show(0, Infinity === high ? 1 : plot.meta.frames / plot.meta.fps);
  const range = chosenRange();
  if (what === "range") {
    if (!range) return;
    const [a, b] = range.map((frame) => frame / plot.meta.fps);
    return show(a - 0.05 * (b - a), b + 0.05 * (b - a));
  }
  const cursor = at.frame === null ? NaN : at.frame / plot.meta.fps;
  scale(what === "in" ? 0.6 : 1 / 0.6, cursor >= low && cursor <= high ? cursor : (low + high) / 2);
}

/** @param {number} factor @param {number} about */
function scale(factor, about) {
  const [low, high] = wanted || chartPlot()?.range || [0, 1];
  show(about + (low - about) * factor, about + (high - about) * factor);
}

document.addEventListener("wheel", (event) => {
  const spot = box(targetOf(event)) && locate(event);
  if (!spot || spot.plot.meta.kind !== "time") return;
  const [low, high] = wanted || spot.plot.range;
  if (event.ctrlKey || event.metaKey) {
    event.preventDefault();
    scale(Math.exp(clamp(event.deltaY, -80, 80) / 200), spot.plot.time(spot.x));
  } else if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
    event.preventDefault();
    const way = ((event.deltaX || event.deltaY) / spot.plot.width) * (high - low);
    show(low + way, high + way);
  }
}, { passive: false });

document.addEventListener("click", (event) => {
  const button = closest(event, "[data-clip-zoom]");
  if (button) zoom(button.dataset.clipZoom);
});

// ---- keys ----
/** @param {string} which */
function setEnd(which) {
  const frame = frameNow();
  if (frame === null || !at.shown) return;
  const [start, end] = chosenRange() || [0, at.shown.frames];
  select(which === "start" ? [frame, end > frame ? end : at.shown.frames] : [start < frame ? start : 0, frame + 1]);
}

/** @param {number} by */
const step = (by) => {
  player.pause();
  seekFrame((frameNow() ?? 0) + by);
};
/** @type {Record<string, (far: boolean) => void>} */
const KEYS = {
  ArrowLeft: (far) => step(far ? -10 : -1),
  ArrowRight: (far) => step(far ? 10 : 1),
  Home: () => seekFrame(0),
  End: () => at.shown && seekFrame(at.shown.frames - 1),
  "[": () => setEnd("start"),
  "]": () => setEnd("end"),
  Escape: () => at.shown && setStore(SELECTION, { clip: at.shown.clip }),
  "+": () => zoom("in"),
  "=": () => zoom("in"),
  "-": () => zoom("out"),
  0: () => zoom("whole"),
  " ": () => player[player.playing ? "pause" : "play"](),
};
document.addEventListener("keydown", (event) => {
  if (targetOf(event).id !== ids.CLIP_BOX || event.ctrlKey || event.metaKey || event.altKey || !KEYS[event.key]) return;
  event.preventDefault();
  KEYS[event.key](event.shiftKey);
});
