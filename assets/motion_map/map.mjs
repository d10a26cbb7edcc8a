/* The Map page: what is chosen on the map, from the link and back into it; all changes by clicks are made here. */
import { changeView, clientside, notify, register, setStore } from "../shared/dash.mjs";
import { childrenOf, closest, find, need } from "../shared/dom.mjs";
import { STAGE_REQUEST } from "../shared/ids.mjs";
import { player } from "../stage/player.mjs";
import { loadMap } from "./data.mjs";
import * as ids from "./ids.mjs";
import { drawCount, drawHits, drawPreview, drawStrip, markHit } from "./keys.mjs";
import { paceOf, readKeys, readNumber, writeKeys } from "./link.mjs";
import { Overlay } from "./overlay.mjs";
import { Follower } from "./paths.mjs";
import { editPosture } from "./posture_editor.mjs";
import { state } from "./state.mjs";
/** @import { KnownMap, Point } from "./types.d.ts" */
/** @import { Selection, View, ViewKey } from "../shared/types.d.ts" */
/** @import { StageRequest, Standing } from "../stage/types.d.ts" */

/** The choices of the menus that need no words in the link. @type {View} */
const USUAL = { colour: "height", click: "keys", pace: "any", way: "any" };
/** Those keys of the view that the server draws by. @type {ViewKey[]} */
const DRAWN_KEYS = ["colour", "below", "region"];
/** The key of the link that a menu sets: what follows "map-" in its id. @param {string} id */
const keyOf = (id) => /** @type {ViewKey} */ (id.slice("map-".length));
let live = 0;

const page = () => find(ids.MAP_PLOT);

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
  const all = find(ids.MAP_PLAY_ALL);
  if (all) all.disabled = state.hits.length === 0;
  return state.hits;
}
function list() {
  const { dataset, version } = state.known;
  drawHits(state.map, state.hits, state.keys, { dataset, version, chosen: state.selection });
}
/**
 * Everything that follows from keys and reach; the list of hits may wait while a slider is dragged.
 * @param {boolean} [lists]
 */
function refresh(lists = true) {
  if (!state.map || !state.overlay) return;
  drawKeys();
  search();
  clearTimeout(live);
  if (lists) list();
  else live = setTimeout(list, 120);
}

// ---- the server ----
/** What the server answers, or {error} in plain words. @param {string} address */
async function ask(address) {
  const answer = await fetch(address).catch(() => null);
  const body = await answer?.json().catch(() => null);
  return answer?.ok && body ? body : { error: body?.error || "The server does not answer; try again in a moment." };
}

// ---- changes ----
/** Hits of a path drawn by hand ("x-y,x-y"): the server warps it onto every clip. @param {string} path */
async function followPath(path) {
  const { map } = state;
  state.path = path;
  state.overlay.drawPath(path.split(",").map((point) => point.split("-").map(Number)));
  const answer = await ask(`/api/map/${map.key}/drawn?${new URLSearchParams({ path })}`);
  if (state.path !== path || state.map !== map) return;
  if (answer.error) notify("This path was not followed", answer.error);
  state.hits = answer.error ? [] : answer;
  refresh();
}
/** @param {Point[]} points */
function drawn(points) {
  const step = Math.max(1, Math.ceil(points.length / 24));
  const few = points.filter((_, k) => k % step === 0 || k === points.length - 1);
  const path = few.map((point) => point.map((value) => Math.max(value, 0).toFixed(1)).join("-")).join(",");
  state.keys = [];
  drawStrip(state.map, [], setKeys);
  changeView({ drawn: path, keys: "" });
  return followPath(path);
}

/** @param {number[]} keys @param {number} [focus] */
export function setKeys(keys, focus) {
  if (state.path) {
    state.path = "";
    state.overlay.drawPath([]);
  }
  state.keys = keys.slice(0, 20);
  drawStrip(state.map, state.keys, setKeys);
  if (focus !== undefined) childrenOf(need(ids.MAP_KEYS))[focus]?.focus();
  refresh();
  changeView({ keys: writeKeys(state.keys, state.map), drawn: "" });
}
/** @param {number} reach @param {boolean} done */
function setReach(reach, done) {
  state.reach = reach;
  showReach();
  refresh(done);
  if (done) changeView({ within: reach ? reach.toFixed(2) : "" });
}
function showReach() {
  const slider = find(ids.MAP_REACH), label = find(ids.MAP_REACH_VALUE);
  if (!slider || !label || !state.map) return;
  slider.max = String(state.map.reach);
  slider.value = String(state.reach);
  slider.setAttribute("aria-valuetext", `${state.reach.toFixed(2)} metres`);
  label.textContent = `${state.reach.toFixed(2)} m`;
}
/** @param {number} node */
function choose(node) {
  if (state.mode === "regions") {
    const region = state.map.regions[node];
    changeView({ region: String(region), below: "region" });
  } else setKeys([...state.keys, node]);
}

function mount() {
  const box = page();
  if (!box || state.overlay?.box === box) return Boolean(box);
  state.overlay = new Overlay(box, {
    /** @param {number} node */
    hover: (node) => drawPreview(state.map, node, state.facts),
    leave: () => {},
    choose,
    undo: () => state.keys.length && setKeys(state.keys.slice(0, -1)),
    draws: () => state.mode === "draw",
    path: drawn,
  });
  state.follower = new Follower(state.overlay);
  const slider = Object.assign(document.createElement("input"), { type: "range", id: ids.MAP_REACH, className: "map-slider", min: 0, step: 0.01, value: 0 });
  slider.setAttribute("aria-labelledby", ids.MAP_REACH_LABEL);
  need(ids.MAP_REACH_BOX).replaceChildren(slider);
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

/** Take up what a view says; nothing is done where it is shown already. @param {View} view */
function show(view) {
  const { map } = state;
  if (!map || !mount()) return;
  const keys = readKeys(view.keys, map), reach = Math.min(readNumber(view.within, 0), map.reach), pace = paceOf(view);
  state.mode = view.click === "regions" || view.click === "draw" ? view.click : "keys";
  need(ids.MAP_PLOT).dataset.mode = state.mode;
  const region = readNumber(view.region, -1);
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
/** @param {Standing[]} items */
const own = (items) => (items || []).map((item) => ({ ...item, dataset: item.dataset || state.known?.dataset || "" }));

async function keyFromStage() {
  const item = player.frameOf(0);
  if (!item) return notify("Nothing is on the Stage", "Play a clip or a motif first; its current frame then becomes a key.");
  const query = new URLSearchParams({ dataset: item.dataset || state.known.dataset, clip: item.clip, frame: String(item.frame) });
  const answer = await ask(`/api/map/${state.map.key}/node?${query}`);
  if (answer.error) return notify("That posture cannot be a key", answer.error);
  const node = state.map.index(answer.node[0], answer.node[1]);
  state.overlay.move(node);
  setKeys([...state.keys, node]);
  if (answer.distance > 2.5 * answer.usual) notify("Added, but it fits badly", `No posture of the map is like this one: the nearest is ${answer.distance.toFixed(2)} m away, ${answer.usual.toFixed(2)} m is usual.`);
}

function playAll() {
  const items = state.hits.slice(0, 12).map((hit) => {
    const segment = state.map.segment(hit);
    return { ...segment, label: segment.clip };
  });
  if (!items.length) return;
  const { dataset, version } = state.known;
  const title = `${items.length} of ${state.hits.length} hits`;
  /** @type {StageRequest} */
  const request = { dataset, version, items, title, layout: "overlay", sync: "start" };
  setStore(STAGE_REQUEST, request);
  player.show(request);
}

document.addEventListener("click", (event) => {
  const button = closest(event, "[data-map-do]");
  if (!button || !state.map) return;
  /** @type {Record<string, () => void>} */
  const actions = {
    stage: keyFromStage,
    all: playAll,
    clear: () => setKeys([]),
    edit: () => editPosture(state.overlay.cursor >= 0 ? state.overlay.cursor : state.map.index(...state.map.icons[0]), -1, setKeys),
  };
  actions[button.dataset.mapDo ?? ""]?.();
});

register("map", {
  /**
   * A map has come: fetch it, then show what the link says of it.
   * @param {KnownMap | null} known
   * @param {View | null} view
   */
  async load(known, view) {
    if (!known || !known.key) {
      state.map = /** @type {any} */ (null);
      return clientside.no_update;
    }
    const map = await loadMap(known.key).catch(() => null);
    if (!map) return clientside.no_update;
    Object.assign(state, { map, known, facts: known.facts });
    if (!mount()) return clientside.no_update;
    state.overlay.map = map; // the overlay may not be over the heatmap yet
    state.overlay.cursor = -1;
    drawPreview(map, -1);
    state.shownOn = null;
    show(view || {});
    fit();
    state.overlay.squares("lit", state.lit);
    state.follower.take(map, own(player.standing()));
    return map.key;
  },
  /** @param {View | null} view */
  view(view) {
    show(view || {});
    return clientside.no_update;
  },
  /** The heatmap was drawn anew: lie over it again. */
  drawn() {
    requestAnimationFrame(() => requestAnimationFrame(fit));
    return clientside.no_update;
  },
  /** @param {{ nodes?: number[] } | null} lit */
  lit(lit) {
    state.lit = (lit && lit.nodes) || []; // it may come before the map
    if (state.overlay && state.map) state.overlay.squares("lit", state.lit);
    return clientside.no_update;
  },
  /** @param {Selection | null} selection */
  selection(selection) {
    state.selection = selection && selection.clip !== undefined ? selection : null;
    markHit(state.selection);
    return clientside.no_update;
  },
  /**
   * A control was used: its choice goes into the link, the usual one leaves it.
   * @param {string | null} value
   * @param {View | null} view
   */
  chosen(value, view) {
    const key = keyOf(clientside.callback_context.inputs_list[0].id);
    const wanted = value === USUAL[key] ? "" : value ?? "";
    if (value && (view?.[key] || "") !== wanted) changeView({ [key]: wanted });
    return clientside.no_update;
  },
  /** @param {View | null} view @param {string} id */
  choice(view, id) {
    const key = keyOf(id);
    return view?.[key] || USUAL[key];
  },
  /** Those parts of the view that the server draws by. @param {View | null} view @param {View | null} current */
  look(view, current) {
    const next = Object.fromEntries(DRAWN_KEYS.filter((key) => view?.[key]).map((key) => [key, view?.[key]]));
    return current && JSON.stringify(next) === JSON.stringify(current) ? clientside.no_update : next;
  },
});
