/* The cursor of the Clip page: it follows the Stage frame by frame, shows the values under it, and moves the Stage. */
import { changeView, clientside, register, setStore } from "../shared/dash.mjs";
import { allWithin, find, need } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { nearest } from "../shared/numbers.mjs";
import { player } from "../stage/player.mjs";
import * as ids from "./ids.mjs";
/** @import { ClipState, Plot, Range, ShownClip } from "./types.d.ts" */
/** @import { Selection, View, ViewKey } from "../shared/types.d.ts" */
/** @import { Standing } from "../stage/types.d.ts" */

/**
 * What the page shows now: the clip, the cursor's frame, the pointer's, the figures of the Stage, the chosen frames.
 * @type {ClipState}
 */
export const at = { shown: null, frame: null, hover: null, items: [], pending: null, values: null, from: "", range: null, dragged: null };

/** @param {string} name */
const part = (name) => allWithin(document, `#${ids.CLIP_BOX} .clip-${name}`)[0];

/** @type {Plot | null} */
let measured = null; // cached, because reading positions makes the browser lay out the page
const forget = () => { measured = null; };

/** Where the chart's axes lie within the box, in pixels; null while nothing is drawn. */
export function chartPlot() {
  if (measured && measured.graph.isConnected && at.shown && measured.meta.clip === at.shown.clip) return measured;
  measured = measure();
  return measured;
}

/** @returns {Plot | null} */
function measure() {
  const graph = /** @type {any} */ (document.querySelector(`#${ids.CLIP_GRAPH} .js-plotly-plot`));
  const full = graph && graph._fullLayout;
  if (!full || !full.xaxis || !full.meta || !at.shown || full.meta.clip !== at.shown.clip) return null;
  const box = need(ids.CLIP_BOX).getBoundingClientRect();
  const own = graph.getBoundingClientRect();
  const { xaxis, yaxis, meta } = full;
  const dx = own.left - box.left + xaxis._offset;
  const dy = own.top - box.top;
  return {
    graph, meta, full,
    lines: graph.data.filter((/** @type {any} */ trace) => trace.mode === "lines"),
    chips: allWithin(document, `#${ids.CLIP_LEGEND} .clip-value`),
    left: dx, width: xaxis._length,
    top: dy + full._size.t, height: full._size.h,
    /** @param {number} value */
    x: (value) => dx + xaxis.l2p(value),
    /** @param {number} value */
    y: (value) => dy + yaxis._offset + yaxis.l2p(value),
    /** @param {number} pixel */
    time: (pixel) => xaxis.p2l(pixel - dx),
    range: xaxis.range.map(Number),
  };
}

/** Lay cursor, pointer and selected range over the chart. */
export function placeMarks() {
  const plot = chartPlot();
  const cursor = part("cursor");
  if (!cursor) return;
  const time = plot && plot.meta.kind === "time";
  upright(cursor, time && at.frame !== null ? at.frame / plot.meta.fps : null, plot);
  upright(part("pointer"), time && at.hover !== null ? at.hover / plot.meta.fps : null, plot);
  band(part("band"), time ? chosenRange() : null, plot);
  dot(part("dot"), plot && plot.meta.kind === "path" ? at.frame : null, plot);
  if (time) tell(plot);
}

/** @param {HTMLElement} line @param {number | null} seconds @param {Plot | null} plot */
function upright(line, seconds, plot) {
  const x = seconds === null || !plot ? null : plot.x(seconds);
  line.hidden = !plot || x === null || x < plot.left - 1 || x > plot.left + plot.width + 1;
  if (line.hidden || !plot || x === null) return;
  line.style.height = `${plot.height}px`;
  line.style.transform = `translate(${x.toFixed(1)}px, ${plot.top}px)`;
}

/** @param {HTMLElement} area @param {Range | null} range @param {Plot | null} plot */
function band(area, range, plot) {
  area.hidden = !range;
  if (!range || !plot) return;
  /** @param {number} x */
  const clamp = (x) => Math.min(Math.max(x, plot.left), plot.left + plot.width);
  const [a, b] = range.map((frame) => clamp(plot.x(frame / plot.meta.fps)));
  Object.assign(area.style, { height: `${plot.height}px`, width: `${Math.max(b - a, 1)}px`, transform: `translate(${a}px, ${plot.top}px)` });
}

/** @param {HTMLElement} mark @param {number | null} frame @param {Plot | null} plot */
function dot(mark, frame, plot) {
  const path = plot && plot.graph.data[0];
  const k = frame === null || !path || !path.customdata ? -1 : nearest(path.customdata, frame);
  mark.hidden = k < 0;
  if (plot && k >= 0) mark.style.transform = `translate(${plot.x(path.x[k])}px, ${plot.y(path.y[k])}px)`;
}

/** The selected frames, or those being dragged over. */
export const chosenRange = () => at.dragged || at.range || null;

let toldAt = 0;
let later = 0;
/** Digits after the point, by unit. @type {Record<string, number>} */
const DIGITS = { "°": 1, " m/s": 2 };

/**
 * Values of all lines at the pointer, else at the cursor; at most twenty times a second.
 * @param {Plot} plot
 */
function tell(plot) {
  const now = performance.now();
  if (now - toldAt < 48) {
    clearTimeout(later);
    later = window.setTimeout(placeMarks, 50);
    return;
  }
  toldAt = now;
  const frame = at.hover ?? at.frame;
  plot.chips.forEach((chip, k) => {
    const value = frame === null || !plot.lines[k] ? null : valueAt(plot, plot.lines[k], k, frame);
    const digits = DIGITS[chip.dataset.unit ?? ""] ?? 3;
    const text = value === null ? "" : value.toFixed(digits).replace("-", "\u2212") + chip.dataset.unit;
    if (chip.textContent !== text) chip.textContent = text;
  });
}

/** @param {Plot} plot @param {any} line @param {number} k @param {number} frame */
function valueAt(plot, line, k, frame) {
  const { fps, frames, thinned } = plot.meta;
  const whole = at.values && at.values.length >= (k + 1) * frames ? at.values[k * frames + Math.min(Math.round(frame), frames - 1)] : null;
  if (thinned) return whole;
  const i = nearest(line.x, frame / fps);
  return i < 0 || Math.abs(line.x[i] - frame / fps) > 1 / fps ? whole : line.y[i];
}

/** Keys of the link that say what the chart shows. @type {ViewKey[]} */
const CHART_KEYS = ["chart", "angles", "joints", "rig", "channels"];

/**
 * Fetches the values of lines that were thinned for the chart.
 * @param {View | null} view
 */
async function fetchValues(view) {
  if (!at.shown) return;
  const { dataset, clip, version } = at.shown;
  const query = new URLSearchParams({ v: version });
  for (const key of CHART_KEYS) if (view?.[key]) query.set(key, view[key]);
  const where = clip.split("/").map(encodeURIComponent).join("/");
  const address = `/api/clip-values/${encodeURIComponent(dataset)}/${where}?${query}`;
  if (address === at.from) return;
  at.from = address;
  at.values = null;
  const answer = await fetch(address).catch(() => null);
  if (!answer?.ok || at.from !== address) return;
  const bytes = await answer.arrayBuffer();
  if (at.from !== address) return;
  at.values = new Float32Array(bytes);
  placeMarks();
}

/**
 * Go to a frame of the clip that is shown, on the Stage; the Stage is made to play the clip first where it plays something else.
 * @param {number} frame
 */
export function seekFrame(frame) {
  const { shown } = at;
  if (!shown) return;
  const wanted = Math.min(Math.max(Math.round(frame), 0), shown.frames - 1);
  const there = at.items.some((item) => isShown(item) && wanted >= item.start && wanted < item.end);
  if (there && player.seek({ clip: shown.clip, frame: wanted })) return;
  at.pending = { clip: shown.clip, frame: wanted };
  setStore(SELECTION, { clip: shown.clip });
}

/** Where every figure of the Stage stands at this moment. */
function standing() {
  const items = [];
  for (let k = 0, item; k < 48 && (item = player.frameOf(k)); k++) items.push(item);
  return items;
}

/** The frame of the clip on the Stage at this moment: a painted frame ahead of the cursor, where one has just moved. */
export const frameNow = () => standing().find(isShown)?.frame ?? at.frame;

/** @param {Standing} item */
const isShown = (item) => at.shown && item.clip === at.shown.clip && (!item.dataset || item.dataset === at.shown.dataset);

/** @param {Standing[]} items */
function follow(items) {
  at.items = items || [];
  const item = at.items.find(isShown);
  if (item && at.pending && at.pending.clip === item.clip && at.pending.frame >= item.start && at.pending.frame < item.end) {
    const { frame } = at.pending;
    at.pending = null;
    player.seek({ clip: item.clip, frame });
  }
  at.frame = item ? item.frame : null;
  placeMarks();
}

for (const kind of /** @type {const} */ (["stage-frame", "stage-state"])) {
  window.addEventListener(kind, (event) => { if (find(ids.CLIP_BOX)) follow(event.detail.items); });
}

register("clip", {
  // A chart was drawn: lay everything over it again, now and after every redrawing.
  /** @param {any} figure @param {unknown} legend @param {ShownClip | null} shown @param {View | null} view */
  drawn(figure, legend, shown, view) {
    at.shown = shown;
    const graph = /** @type {any} */ (document.querySelector(`#${ids.CLIP_GRAPH} .js-plotly-plot`));
    if (graph && graph.on && !graph.dataset.clipWatched) {
      graph.dataset.clipWatched = "yes";
      const again = () => { forget(); placeMarks(); };
      graph.on("plotly_afterplot", again);
      new ResizeObserver(again).observe(need(ids.CLIP_BOX));
    }
    forget();
    if (figure && figure.layout && figure.layout.meta && figure.layout.meta.thinned) fetchValues(view);
    requestAnimationFrame(() => requestAnimationFrame(() => { forget(); placeMarks(); })); // Plotly draws after this
    return figure?.layout?.meta?.kind ?? null;
  },
  /** @param {Selection | null} selection @param {ShownClip | null} shown */
  mark(selection, shown) {
    at.shown = shown;
    const { clip, start = 0, end = 0 } = selection ?? {};
    at.range = shown && clip === shown.clip && end > start ? [start, Math.min(end, shown.frames)] : null;
    follow(standing());
    return clientside.no_update;
  },
  /**
   * @param {string} value
   * @param {unknown} _back
   * @param {unknown} _next
   * @param {string[]} names
   * @param {ShownClip | null} shown
   */
  pick(value, _back, _next, names, shown) {
    const trigger = (clientside.callback_context.triggered[0] || {}).prop_id || "";
    const step = trigger.startsWith(ids.CLIP_PREVIOUS) ? -1 : trigger.startsWith(ids.CLIP_NEXT) ? 1 : 0;
    const clip = step ? names[names.indexOf(shown ? shown.clip : value) + step] : value;
    if (clip && (!shown || clip !== shown.clip)) {
      changeView({ span: "" });
      setStore(SELECTION, { clip });
    }
    return clientside.no_update;
  },
  // Puts what was chosen above the chart into the view; what the server preselects is no choice.
  /**
   * @param {string} chart
   * @param {string} kind
   * @param {string[] | null} joints
   * @param {string[] | null} channels
   * @param {View | null} view
   * @param {{ joints?: string[], channels?: string[] } | null} choice
   */
  control(chart, kind, joints, channels, view, choice) {
    const now = view || {};
    /** @param {string[] | null | undefined} a @param {string[] | null | undefined} b */
    const same = (a, b) => JSON.stringify(a || []) === JSON.stringify(b || []);
    const trigger = (clientside.callback_context.triggered[0] || {}).prop_id || "";
    /** @type {View} */
    const change = {};
    if (trigger.startsWith(ids.CLIP_CHART)) Object.assign(change, { chart: chart === "angles" ? "" : chart, joints: "" });
    if (trigger.startsWith(ids.CLIP_KIND)) change.angles = kind === "body" ? "" : kind;
    if (trigger.startsWith(ids.CLIP_JOINTS)) change[kind === "file" && chart === "angles" ? "rig" : "joints"] = (joints || []).join(",");
    if (trigger.startsWith(ids.CLIP_CHANNELS)) change.channels = (channels || []).join(",");
    if (trigger.startsWith(ids.CLIP_JOINTS) && same(joints, choice && choice.joints)) return clientside.no_update;
    if (trigger.startsWith(ids.CLIP_CHANNELS) && same(channels, choice && choice.channels)) return clientside.no_update;
    if (trigger.startsWith(ids.CLIP_CHART) && (now.chart || "angles") === chart) return clientside.no_update;
    if (trigger.startsWith(ids.CLIP_KIND) && (now.angles || "body") === kind) return clientside.no_update;
    changeView(change);
    return clientside.no_update;
  },
  /** @param {{ clip: string, frame: number } | null} to */
  seek(to) {
    if (to && at.shown && to.clip === at.shown.clip) seekFrame(to.frame);
    return clientside.no_update;
  },
  /** @param {object | null} edit */
  editAtFrame(edit) {
    return edit ? { ...edit, frame: frameNow() ?? 0 } : clientside.no_update;
  },
});
