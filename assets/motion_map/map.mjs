/* The Map page: what is chosen on the map, from the link and back into it; everything a click changes is changed here. */
import { changeView, clientside, notify, register, setStore } from "../shared/dash.mjs";
import { player } from "../stage/player.mjs";
import { loadMap } from "./data.mjs";
import { drawCount, drawHits, drawPreview, drawStrip, markHit } from "./keys.mjs";
import { Overlay } from "./overlay.mjs";
import { Follower } from "./paths.mjs";
import { editPosture } from "./posture_editor.mjs";
import { state } from "./state.mjs";

const USUAL = { colour: "height", click: "keys", pace: "any", way: "any" };
let live = 0;

const put = (change) => changeView({ ...change, at: Date.now() });
const page = () => document.getElementById("map-plot");

/** Keys as they stand in a link: 3-4,5-6. */
const write = (keys) => keys.map((node) => state.map.place(node).join("-")).join(",");
function read(text, map) {
  const found = [];
  for (const word of String(text || "").split(",")) {
    const match = /^(\d+)-(\d+)$/.exec(word);
    if (match && Number(match[1]) < map.nx && Number(match[2]) < map.ny) found.push(map.index(Number(match[1]), Number(match[2])));
  }
  return found.slice(0, 20);
}
const number = (text, otherwise) => (/^\d+(\.\d+)?$/.test(text ?? "") ? Number(text) : otherwise);

function paceOf(view) {
  const [low, high] = String(view.pace || "").split("-").map((word) => number(word, NaN));
  const way = ["forward", "backward", "left", "right"].includes(view.way) ? view.way : "any";
  const limits = Number.isFinite(low) && Number.isFinite(high) && low <= high ? [low, high] : [0, Infinity];
  return way === "any" && limits[0] === 0 && limits[1] === Infinity ? null : { slowest: limits[0], fastest: limits[1], way };
}

// ---- drawing ----
function drawKeys() {
  const { map, keys, reach } = state;
  state.overlay.drawKeys(keys.map((node) => {
    const apart = map.distances(node), nodes = [];
    for (let k = 0; k < map.n; k++) if (k === node || apart[k] < reach) nodes.push(k);
    return { node, nodes };
  }));
}
function search() {
  const { map, keys, reach, pace, path } = state;
  if (!path) state.hits = map.search(keys, reach, pace);
  drawCount(state.hits.length, path ? [path] : keys, new Set(state.hits.map((hit) => hit.clip)).size);
  const all = document.getElementById("map-play-all");
  if (all) all.disabled = state.hits.length === 0;
  return state.hits;
}
function list() {
  const { dataset, version } = state.known;
  drawHits(state.map, state.hits, state.keys, { dataset, version, chosen: state.selection });
}
/** Everything that follows from keys and reach; the list of hits may wait while a slider is dragged. */
function refresh(lists = true) {
  if (!state.map || !state.overlay) return;
  drawKeys();
  search();
  clearTimeout(live);
  if (lists) list();
  else live = setTimeout(list, 120);
}

// ---- the server ----
/** What the server answers, or {error} in plain words. */
async function ask(address) {
  const answer = await fetch(address).catch(() => null);
  const body = await answer?.json().catch(() => null);
  return answer?.ok && body ? body : { error: body?.error || "The server does not answer; try again in a moment." };
}

// ---- changes ----
/** Hits of a path drawn by hand ("x-y,x-y"): the server warps it onto every clip. */
async function followPath(path) {
  const { map } = state;
  state.path = path;
  state.overlay.drawPath(path.split(",").map((point) => point.split("-").map(Number)));
  const found = await ask(`/api/map/${map.key}/drawn?${new URLSearchParams({ path })}`);
  if (state.path !== path || state.map !== map) return;
  if (found.error) notify("This path was not followed", found.error);
  state.hits = found.error ? [] : found;
  refresh();
}
function drawn(points) {
  const step = Math.max(1, Math.ceil(points.length / 24));
  const few = points.filter((_, k) => k % step === 0 || k === points.length - 1);
  const path = few.map((point) => point.map((value) => Math.max(value, 0).toFixed(1)).join("-")).join(",");
  state.keys = [];
  drawStrip(state.map, [], setKeys);
  put({ drawn: path, keys: "" });
  return followPath(path);
}

export function setKeys(keys, focus) {
  if (state.path) {
    state.path = "";
    state.overlay.drawPath([]);
  }
  state.keys = keys.slice(0, 20);
  drawStrip(state.map, state.keys, setKeys);
  if (focus !== undefined) document.getElementById("map-keys").children[focus]?.focus?.();
  refresh();
  put({ keys: write(state.keys), drawn: "" });
}
function setReach(reach, done) {
  state.reach = reach;
  showReach();
  refresh(done);
  if (done) put({ within: reach ? reach.toFixed(2) : "" });
}
function showReach() {
  const slider = document.getElementById("map-reach"), label = document.getElementById("map-reach-value");
  if (!slider || !state.map) return;
  slider.max = state.map.reach;
  slider.value = state.reach;
  slider.setAttribute("aria-valuetext", `${state.reach.toFixed(2)} metres`);
  label.textContent = `${state.reach.toFixed(2)} m`;
}
function choose(node) {
  if (state.mode === "regions") {
    const region = state.map.regions[node];
    put({ region: String(region), below: "region" });
  } else setKeys([...state.keys, node]);
}

function mount() {
  const box = page();
  if (!box || state.overlay?.box === box) return Boolean(box);
  state.overlay = new Overlay(box, {
    hover: (node) => drawPreview(state.map, node, state.facts),
    leave: () => {},
    choose,
    undo: () => state.keys.length && setKeys(state.keys.slice(0, -1)),
    draws: () => state.mode === "draw",
    path: drawn,
  });
  state.follower = new Follower(state.overlay);
  const slider = Object.assign(document.createElement("input"), { type: "range", id: "map-reach", className: "map-slider", min: 0, step: 0.01, value: 0 });
  slider.setAttribute("aria-labelledby", "map-reach-label");
  document.getElementById("map-reach-box").replaceChildren(slider);
  slider.addEventListener("input", () => state.map && setReach(Number(slider.value), false));
  slider.addEventListener("change", () => state.map && setReach(Number(slider.value), true));
  new ResizeObserver(() => requestAnimationFrame(fit)).observe(box);
  return true;
}
function fit() {
  if (!state.overlay || !state.map) return;
  state.overlay.fit(state.map);
  drawKeys();
}

/** Take up what a view says; nothing is done where it is shown already. */
function show(view) {
  const { map } = state;
  if (!map || !mount()) return;
  const keys = read(view.keys, map), reach = Math.min(number(view.within, 0), map.reach), pace = paceOf(view);
  state.mode = ["regions", "draw"].includes(view.click) ? view.click : "keys";
  page().dataset.mode = state.mode;
  const region = number(view.region, -1);
  state.overlay.squares("region", region < 0 ? [] : [...map.regions.keys()].filter((node) => map.regions[node] === region));
  const path = view.drawn || "";
  const shown = JSON.stringify([keys, reach, pace, path]);
  if (shown === JSON.stringify([state.keys, state.reach, state.pace, state.path]) && state.shownOn === map.key) return;
  const stays = path && path === state.path && state.shownOn === map.key;
  Object.assign(state, { keys, reach, pace, shownOn: map.key });
  showReach();
  drawStrip(map, keys, setKeys);
  if (path && !stays) followPath(path);
  else {
    state.path = path;
    if (!path) state.overlay.drawPath([]);
    refresh();
  }
}

// ---- the Stage ----
window.addEventListener("stage-state", (event) => {
  if (state.map && state.follower && page()) state.follower.take(state.map, own(event.detail.items));
});
window.addEventListener("stage-frame", (event) => {
  if (state.map && state.follower && page() && event.detail.items) state.follower.step(own(event.detail.items));
});
const own = (items) => (items || []).map((item) => ({ ...item, dataset: item.dataset || state.known?.dataset }));

async function keyFromStage() {
  const item = player.frameOf(0);
  if (!item) return notify("Nothing is on the Stage", "Play a clip or a motif first; its current frame then becomes a key.");
  const asked = new URLSearchParams({ dataset: item.dataset || state.known.dataset, clip: item.clip, frame: item.frame });
  const found = await ask(`/api/map/${state.map.key}/node?${asked}`);
  if (found.error) return notify("That posture cannot be a key", found.error);
  const node = state.map.index(...found.node);
  state.overlay.move(node);
  setKeys([...state.keys, node]);
  if (found.distance > 2.5 * found.usual) notify("Added, but it fits badly", `No posture of the map is like this one: the nearest is ${found.distance.toFixed(2)} m away, ${found.usual.toFixed(2)} m is usual.`);
}

function playAll() {
  const items = state.hits.slice(0, 12).map((hit) => {
    const segment = state.map.segment(hit);
    return { ...segment, label: segment.clip };
  });
  if (!items.length) return;
  const { dataset, version } = state.known;
  const title = `${items.length} of ${state.hits.length} hits`;
  const request = { dataset, version, items, title, layout: "overlay", sync: "start" };
  setStore("stage-request", request);
  player.show(request);
}

document.addEventListener("click", (event) => {
  const button = event.target.closest?.("[data-map-do]");
  if (!button || !state.map) return;
  const actions = {
    stage: keyFromStage,
    all: playAll,
    clear: () => setKeys([]),
    edit: () => editPosture(state.overlay.cursor >= 0 ? state.overlay.cursor : state.map.index(...state.map.icons[0]), -1, setKeys),
  };
  actions[button.dataset.mapDo]?.();
});

register("map", {
  /** A map has come: fetch it, then show what the link says of it. */
  async load(known, view) {
    if (!known || !known.key) {
      state.map = null;
      return clientside.no_update;
    }
    const map = await loadMap(known.key).catch(() => null);
    if (!map) return clientside.no_update;
    Object.assign(state, { map, known, facts: known.facts });
    if (!mount()) return clientside.no_update;
    state.overlay.map = map; // it may not lie over the heatmap yet
    state.overlay.cursor = -1;
    drawPreview(map, -1);
    state.shownOn = null;
    show(view || {});
    fit();
    state.overlay.squares("lit", state.lit);
    const items = [];
    for (let k = 0; player.frameOf(k); k++) items.push(player.frameOf(k));
    state.follower.take(map, own(items));
    return map.key;
  },
  view(view) {
    show(view || {});
    return clientside.no_update;
  },
  /** The heatmap was drawn anew: lie over it again. */
  drawn() {
    requestAnimationFrame(() => requestAnimationFrame(fit));
    return clientside.no_update;
  },
  lit(lit) {
    state.lit = (lit && lit.nodes) || []; // it may come before the map
    if (state.overlay && state.map) state.overlay.squares("lit", state.lit);
    return clientside.no_update;
  },
  selection(selection) {
    state.selection = selection && selection.clip !== undefined ? selection : null;
    markHit(state.selection);
    return clientside.no_update;
  },
  /** A control was used: its choice goes into the link, the usual one leaves it. */
  chosen(value, view) {
    const key = clientside.callback_context.inputs_list[0].id.slice("map-".length);
    const wanted = value === USUAL[key] ? "" : value;
    if (value && ((view || {})[key] || "") !== wanted) put({ [key]: wanted });
    return clientside.no_update;
  },
  choice(view, id) {
    const key = id.slice("map-".length);
    return (view || {})[key] || USUAL[key];
  },
  /** Those parts of the view that the server draws by. */
  look(view, current) {
    const keys = ["colour", "below", "region", "icons"];
    const next = Object.fromEntries(keys.filter((key) => (view || {})[key]).map((key) => [key, view[key]]));
    return current && JSON.stringify(next) === JSON.stringify(current) ? clientside.no_update : next;
  },
});
