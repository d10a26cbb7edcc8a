/* The cursor of the Clip page: it follows the Stage frame by frame, shows the values under it, and moves the Stage. */
import { clientside, register, setStore } from "../shared/dash.mjs";
import { find } from "../shared/dom.mjs";
import { player } from "../stage/player.mjs";

/** What the page shows now: the clip, the cursor's frame, the pointer's, the figures of the Stage, the chosen frames. */
export const at = { shown: null, frame: null, hover: null, items: [], pending: null, values: null, from: "", range: null, dragged: null };

const part = (name) => document.querySelector(`#clip-box .clip-${name}`);

let measured = null; // asking the browser for places sixty times a second would make it lay out the page as often
const forget = () => { measured = null; };

/** Where the chart's axes lie within the box, in pixels; null while nothing is drawn. */
export function chartPlot() {
  if (measured && measured.graph.isConnected && at.shown && measured.meta.clip === at.shown.clip) return measured;
  measured = measure();
  return measured;
}

function measure() {
  const graph = document.querySelector("#clip-graph .js-plotly-plot");
  const full = graph && graph._fullLayout;
  if (!full || !full.xaxis || !full.meta || !at.shown || full.meta.clip !== at.shown.clip) return null;
  const box = find("clip-box").getBoundingClientRect();
  const own = graph.getBoundingClientRect();
  const { xaxis, yaxis, meta } = full;
  const dx = own.left - box.left + xaxis._offset;
  const dy = own.top - box.top;
  return {
    graph, meta, full,
    lines: graph.data.filter((trace) => trace.mode === "lines"),
    chips: document.querySelectorAll("#clip-legend .clip-value"),
    left: dx, width: xaxis._length,
    top: dy + full._size.t, height: full._size.h,
    x: (value) => dx + xaxis.l2p(value),
    y: (value) => dy + yaxis._offset + yaxis.l2p(value),
    time: (pixel) => xaxis.p2l(pixel - dx),
    range: xaxis.range.map(Number),
  };
}

/** Index of the entry of a rising list that is nearest to a value. */
function nearest(list, value) {
  let low = 0;
  let high = list.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle] <= value) low = middle;
    else high = middle;
  }
  return high < 0 ? -1 : Math.abs(list[low] - value) <= Math.abs(list[high] - value) ? low : high;
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

function upright(line, seconds, plot) {
  const x = seconds === null ? null : plot.x(seconds);
  line.hidden = x === null || x < plot.left - 1 || x > plot.left + plot.width + 1;
  if (line.hidden) return;
  line.style.height = `${plot.height}px`;
  line.style.transform = `translate(${x.toFixed(1)}px, ${plot.top}px)`;
}

function band(area, range, plot) {
  area.hidden = !range;
  if (!range) return;
  const clamp = (x) => Math.min(Math.max(x, plot.left), plot.left + plot.width);
  const [a, b] = range.map((frame) => clamp(plot.x(frame / plot.meta.fps)));
  Object.assign(area.style, { height: `${plot.height}px`, width: `${Math.max(b - a, 1)}px`, transform: `translate(${a}px, ${plot.top}px)` });
}

function dot(mark, frame, plot) {
  const path = plot && plot.graph.data[0];
  const k = frame === null || !path || !path.customdata ? -1 : nearest(path.customdata, frame);
  mark.hidden = k < 0;
  if (k >= 0) mark.style.transform = `translate(${plot.x(path.x[k])}px, ${plot.y(path.y[k])}px)`;
}

/** The selected frames, or those being dragged over. */
export const chosenRange = () => at.dragged || at.range || null;

let toldAt = 0;

/** Values of all lines at the pointer, else at the cursor; twenty times a second are plenty to read. */
function tell(plot) {
  const now = performance.now();
  if (now - toldAt < 48) {
    clearTimeout(tell.later);
    tell.later = setTimeout(placeMarks, 50);
    return;
  }
  toldAt = now;
  const frame = at.hover ?? at.frame;
  plot.chips.forEach((chip, k) => {
    const value = frame === null || !plot.lines[k] ? null : valueAt(plot, plot.lines[k], k, frame);
    const digits = { "°": 1, " m/s": 2 }[chip.dataset.unit] ?? 3;
    const text = value === null ? "" : value.toFixed(digits).replace("-", "\u2212") + chip.dataset.unit;
    if (chip.textContent !== text) chip.textContent = text;
  });
}

function valueAt(plot, line, k, frame) {
  const { fps, frames, thinned } = plot.meta;
  const whole = at.values && at.values.length >= (k + 1) * frames ? at.values[k * frames + Math.min(Math.round(frame), frames - 1)] : null;
  if (thinned) return whole;
  const i = nearest(line.x, frame / fps);
  return i < 0 || Math.abs(line.x[i] - frame / fps) > 1 / fps ? whole : line.y[i];
}

/** Lines thinned for the chart lack values: those come once as plain numbers. */
async function fetchValues(view) {
  const { dataset, clip, version } = at.shown;
  const query = new URLSearchParams({ v: version });
  for (const key of ["chart", "angles", "joints", "rig", "channels"]) if ((view || {})[key]) query.set(key, view[key]);
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

/** Go to a frame of the clip that is shown, on the Stage; what plays something else is made to play the clip first. */
export function seekFrame(frame) {
  const { shown } = at;
  if (!shown) return;
  const wanted = Math.min(Math.max(Math.round(frame), 0), shown.frames - 1);
  const there = at.items.some((item) => isShown(item) && wanted >= item.start && wanted < item.end);
  if (there && player.seek({ clip: shown.clip, frame: wanted })) return;
  at.pending = { clip: shown.clip, frame: wanted };
  setStore("selection", { clip: shown.clip });
}

/** Where every figure of the Stage stands at this moment. */
function standing() {
  const items = [];
  for (let k = 0, item; k < 48 && (item = player.frameOf(k)); k++) items.push(item);
  return items;
}

/** The frame of the clip on the Stage at this moment: a painted frame ahead of the cursor, where one has just moved. */
export const frameNow = () => standing().find(isShown)?.frame ?? at.frame;

const isShown = (item) => at.shown && item.clip === at.shown.clip && (!item.dataset || item.dataset === at.shown.dataset);

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

for (const kind of ["stage-frame", "stage-state"]) {
  window.addEventListener(kind, (event) => { if (find("clip-box")) follow(event.detail.items); });
}

register("clip", {
  // A chart was drawn: lay everything over it again, now and after every redrawing.
  drawn(figure, legend, shown, view) {
    at.shown = shown;
    const graph = document.querySelector("#clip-graph .js-plotly-plot");
    if (graph && graph.on && !graph.dataset.clipWatched) {
      graph.dataset.clipWatched = "yes";
      const again = () => { forget(); placeMarks(); };
      graph.on("plotly_afterplot", again);
      new ResizeObserver(again).observe(find("clip-box"));
    }
    forget();
    if (figure && figure.layout && figure.layout.meta && figure.layout.meta.thinned) fetchValues(view);
    requestAnimationFrame(() => requestAnimationFrame(() => { forget(); placeMarks(); })); // Plotly draws after this
    return figure?.layout?.meta?.kind ?? null;
  },
  mark(selection, shown) {
    at.shown = shown;
    const own = selection && shown && selection.clip === shown.clip && selection.end > selection.start;
    at.range = own ? [selection.start, Math.min(selection.end, shown.frames)] : null;
    follow(standing());
    return clientside.no_update;
  },
  pick(value, _back, _next, names, shown) {
    const trigger = (clientside.callback_context.triggered[0] || {}).prop_id || "";
    const step = trigger.startsWith("clip-previous") ? -1 : trigger.startsWith("clip-next") ? 1 : 0;
    const clip = step ? names[names.indexOf(shown ? shown.clip : value) + step] : value;
    if (clip && (!shown || clip !== shown.clip)) {
      setStore("view-change", { span: "" });
      setStore("selection", { clip });
    }
    return clientside.no_update;
  },
  // What was chosen above the chart, into the view; what a clip offers of itself is no choice.
  control(chart, kind, joints, channels, view, choice) {
    const now = view || {};
    const same = (a, b) => JSON.stringify(a || []) === JSON.stringify(b || []);
    const trigger = (clientside.callback_context.triggered[0] || {}).prop_id || "";
    const change = {};
    if (trigger.startsWith("clip-chart")) Object.assign(change, { chart: chart === "angles" ? "" : chart, joints: "" });
    if (trigger.startsWith("clip-kind")) change.angles = kind === "body" ? "" : kind;
    if (trigger.startsWith("clip-joints")) change[kind === "file" && chart === "angles" ? "rig" : "joints"] = (joints || []).join(",");
    if (trigger.startsWith("clip-channels")) change.channels = (channels || []).join(",");
    if (trigger.startsWith("clip-joints") && same(joints, choice && choice.joints)) return clientside.no_update;
    if (trigger.startsWith("clip-channels") && same(channels, choice && choice.channels)) return clientside.no_update;
    if (trigger.startsWith("clip-chart") && (now.chart || "angles") === chart) return clientside.no_update;
    if (trigger.startsWith("clip-kind") && (now.angles || "body") === kind) return clientside.no_update;
    setStore("view-change", change);
    return clientside.no_update;
  },
  seek(to) {
    if (to && at.shown && to.clip === at.shown.clip) seekFrame(to.frame);
    return clientside.no_update;
  },
  asked(edit) {
    return edit ? { ...edit, frame: frameNow() ?? 0 } : clientside.no_update;
  },
});
