/* A new routine: its keys in the link, the answer of the server, and how it plays. */
import { changeView, clientside, setStore } from "../shared/dash.mjs";
import { allWithin, closest, element, find, need, setLink, within } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { drawSkateMeter } from "../shared/skate_meter.mjs";
import { plural } from "../shared/words.mjs";
import { player } from "../stage/player.mjs";
import { visited } from "./history.mjs";
import * as ids from "./ids.mjs";
import { actionChip, actionOf, downloadQuery, isFresh, redraw, state } from "./state.mjs";
import { lightTree, showTree } from "./tree.mjs";
/** @import { Past } from "./history.mjs" */
/** @import { Composition, RoutineKeys, TreeNode } from "./types.d.ts" */
/** @import { Selection, View, ViewKey } from "../shared/types.d.ts" */
/** @import { StageRequest } from "../stage/types.d.ts" */

/** Keys of the link that say which routine it is, and its chosen part. @type {ViewKey[]} */
const KEYS = ["sentence", "pick", "up"];
const HISTORY = "motionscape-routines";

let on = false;
/** The server's last answer; empty until there is one. @type {Composition} */
let now = /** @type {any} */ ({});
/** @type {View} */
let view = {};
let played = "";
let lit = -1;
/** @type {Past} */
let past = { key: "", list: [], at: -1 }; // routines seen before, for undo and redo

/** @param {RoutineKeys | null} shown */
const keysOf = (shown) => Object.fromEntries(KEYS.filter((key) => shown?.[key]).map((key) => [key, shown?.[key]]));
/** @param {RoutineKeys | undefined} a @param {RoutineKeys | undefined} b */
const same = (a, b) => KEYS.every((key) => (a?.[key] || "") === (b?.[key] || ""));
const ready = () => Boolean(now.name) && same(now.inputs, keysOf(view));
const here = () => on && Boolean(find(ids.COMPOSE_TREE)?.offsetParent); // the page may have gone meanwhile
const onStage = () => String(player.frameOf(0)?.dataset || "").startsWith("~derive~");

/**
 * Go to another routine: it is a step that can be undone.
 * @param {string} sentence
 * @param {View} [more]
 */
export const goTo = (sentence, more = {}) => changeView({ sentence, pick: "", up: "", alt: "", ...more });

/** @param {string} sentence */
function remember(sentence) {
  if (past.key !== state.data.key) {
    past = { key: state.data.key, list: [], at: -1 };
    try {
      const kept = JSON.parse(sessionStorage.getItem(HISTORY) || "{}");
      if (kept.key === past.key) past = kept;
    } catch { /* nothing is remembered */ }
  }
  const next = visited(past, sentence);
  if (next === past) return;
  past = next;
  try { sessionStorage.setItem(HISTORY, JSON.stringify(past)); } catch { /* private mode: then not after a reload */ }
}

/** @param {Composition} data @returns {StageRequest} */
function request(data) {
  return {
    dataset: data.name ?? "", title: `New routine: ${plural(data.actions.length, "action")}`, layout: "overlay", sync: "start",
    items: [{ clip: data.clip, start: 0, end: data.frames, label: "New routine", colours: data.bands }],
  };
}

/** @param {Composition} data @param {number} [from] */
async function play(data, from) {
  played = data.name ?? "";
  await player.show(request(data));
  if (from !== undefined) player.seek({ clip: data.clip, frame: data.spans[from][0] });
  player.play();
}

/** @param {Composition} data */
function string(data) {
  const list = need(ids.COMPOSE_STRING);
  if (!isFresh(list, [data.name, data.actions, state.data.names, now.inputs, now.chosen])) return;
  const chips = data.actions.map((id, at) => {
    const line = element("li", "compose-step");
    const button = actionChip(id);
    delete button.dataset.store;
    button.dataset.pick = String(at);
    button.title = `${actionOf(id).name}: choose it`;
    button.setAttribute("aria-pressed", String(String(at) === now.inputs.pick));
    line.classList.toggle("within", Boolean(now.chosen && at >= now.chosen.first && at < now.chosen.end));
    line.append(button);
    return line;
  });
  redraw(list, chips);
}

function chosenWords() {
  const { chosen } = now;
  if (!chosen) return "Choose an action to change its part.";
  const span = chosen.end - chosen.first === 1 ? `action ${chosen.first + 1}` : `actions ${chosen.first + 1} to ${chosen.end}`;
  const ways = chosen.ways > 1 ? `${chosen.ways} ways` : chosen.varies ? "its parts can differ" : "one way only";
  return `${chosen.name}: ${span}, ${ways}`;
}

function show() {
  const busy = Boolean(view.sentence) && !same(now.inputs, keysOf(view));
  need(ids.COMPOSE_STRING).classList.toggle("busy", busy);
  const error = !busy && now.error;
  need(ids.COMPOSE_ERROR).classList.toggle("hidden", !error);
  need(ids.COMPOSE_ERROR).textContent = error || "";
  const there = ready();
  need(ids.COMPOSE_STRING).dataset.shown = busy ? "" : KEYS.map((key) => now.inputs?.[key] || "").join(" ");
  need(ids.COMPOSE_STATUS).textContent = busy ? "Making the routine …" : there
    ? `${plural(now.actions.length, "action")}, ${now.seconds.toFixed(1)} s. ${now.novel ? "Nobody performed it like this." : "It occurs like this in the recordings."}`
    : error ? "" : "Press New routine: chance makes one that keeps to the rules.";
  for (const name of ["play", "larger", "smaller", "others", "undo", "redo"]) {
    const usable = { play: there, undo: past.at > 0, redo: past.at < past.list.length - 1,
      larger: there && now.chosen?.larger, smaller: there && now.chosen?.smaller, others: there && now.chosen?.varies }[name];
    within(document, `[data-compose="${name}"]`).disabled = !usable;
  }
  if (busy && !now.actions) return;
  need(ids.COMPOSE_CHOSEN).textContent = there ? chosenWords() : "";
  if (!there) {
    if (error) for (const id of [ids.COMPOSE_STRING, ids.COMPOSE_TREE]) { need(id).replaceChildren(); isFresh(need(id), ""); }
  } else {
    string(now);
    showTree(need(ids.COMPOSE_TREE), now.svg, choose);
    drawSkateMeter(need(ids.COMPOSE_METERS), "This routine", now);
  }
  need(ids.COMPOSE_WARNINGS).replaceChildren(...((there && now.warnings) || []).map((text) => element("p", "", text)));
  setLink(ids.COMPOSE_BVH, there && `/api/bvh/${encodeURIComponent(now.name ?? "")}/${encodeURIComponent(now.clip)}`);
  setLink(ids.COMPOSE_JSON, there && `/api/derivation/${now.name?.split("~")[2]}.json`);
  setLink(ids.COMPOSE_SVG, there && `/api/grammar-tree.svg?${downloadQuery(view, { sentence: now.code })}`);
  need(ids.COMPOSE_SAVE).disabled = !there;
  for (const button of allWithin(document, ".compose-recipe")) {
    const text = there && now.recipes?.[button.dataset.recipe ?? ""];
    button.disabled = !text;
    button.title = button.dataset.recipe ?? "";
    button.dataset.copy = text || "";
  }
}

/**
 * A node of the tree: an action is picked, a phrase is the part to change.
 * @param {TreeNode} node
 */
function choose({ path, first, leaf }) {
  if (!ready()) return;
  if (leaf) return pick(first);
  /** @param {string} text */
  const depth = (text) => (text === "" ? 0 : text.split(".").length);
  const inner = now.parents[first]; // path of the smallest phrase around its first action
  changeView({ pick: String(first), up: String(Math.max(0, depth(inner) - depth(path)) || ""), alt: "" });
}

/** @param {number} at */
function pick(at) {
  const again = String(at) === now.inputs.pick && !now.inputs.up;
  changeView({ pick: again ? "" : String(at), up: "", alt: "" });
  if (!again && now.name === played && onStage()) player.seek({ clip: now.clip, frame: now.spans[at][0] });
}

/** @param {string} text @param {number} low @param {number} high */
const whole = (text, low, high) => Math.min(Math.max(Math.round(Number(text) || low), low), high);
/** @type {Record<string, () => void>} */
const actions = {
  new() {
    const most = whole(need(ids.COMPOSE_MOST).value, 1, Number(need(ids.COMPOSE_MOST).max));
    const seed = Number((/^random:(\d+)/.exec(view.sentence || "") || [0, past.list.length])[1]) + 1;
    goTo(`random:${seed}:${most}`);
  },
  undo: () => past.at > 0 && goTo(past.list[past.at - 1]),
  redo: () => past.at < past.list.length - 1 && goTo(past.list[past.at + 1]),
  play: () => ready() && play(now),
  larger: () => changeView({ up: String(Number(now.inputs.up || 0) + 1), alt: "" }),
  smaller: () => changeView({ up: String(Math.max(0, Number(now.inputs.up || 0) - 1) || ""), alt: "" }),
  others: () => changeView({ alt: String(Number(view.alt || 0) + 1) }),
};

document.addEventListener("click", (event) => {
  const button = closest(event, "[data-compose]");
  if (button && !button.disabled && here()) actions[button.dataset.compose ?? ""]();
  const chip = closest(event, "[data-pick]");
  if (chip && here() && ready()) pick(Number(chip.dataset.pick));
});
document.addEventListener("keydown", (event) => {
  if (!here() || !(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
  if (closest(event, "input, textarea")) return;
  event.preventDefault();
  actions[event.shiftKey ? "redo" : "undo"]();
});

window.addEventListener("stage-frame", (event) => {
  const item = event.detail.items[0];
  const ours = here() && now.name && item?.dataset === now.name;
  const at = ours ? now.spans.findIndex(([a, b]) => item.frame >= a && item.frame < b) : -1;
  if (at === lit) return;
  lit = at;
  lightTree(find(ids.COMPOSE_TREE), at);
  allWithin(document, `#${ids.COMPOSE_STRING} .compose-step`).forEach((step, number) => step.classList.toggle("lit", number === at));
});

export const composition = () => ({ on, now, view, ready: ready(), play: () => play(now) });

/** @param {Composition | null} data @param {View | null} shown @param {Selection | null} selection */
export const drawCompose = (data, shown, selection) => {
  view = shown || {};
  const entered = view.show === "compose" && !on;
  on = view.show === "compose" && Boolean(find(ids.COMPOSE_TREE));
  if (!on || !state.data.key) return;
  if (!view.sentence) return actions.new();
  const [, , most] = /^random:(\d+):(\d+)/.exec(view.sentence) || [];
  if (most && document.activeElement?.id !== ids.COMPOSE_MOST) clientside.set_props(ids.COMPOSE_MOST, { value: Number(most) });
  remember(view.sentence);
  if (data) now = data;
  if (data && data.key !== state.data.key && !data.error) now = /** @type {any} */ ({});
  show();
  if (!ready()) return;
  if (entered && selection && Object.keys(selection).length) setStore(SELECTION, {});
  if (!view.alt && (now.name !== played || (entered && !onStage()))) play(now);
};
