/* A walk through the motif graph: its keys in the link, the answer of the server, and how it plays.
   walk_path.mjs draws the path, walk_graph.mjs marks the graph. */
import { changeView, clientside, register, setStore } from "../shared/dash.mjs";
import { allWithin, closest, find, need, setLink, targetOf } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { drawSkateMeter } from "../shared/skate_meter.mjs";
import { ahead } from "../stage/ahead.mjs";
import { player } from "../stage/player.mjs";
import * as ids from "./ids.mjs";
import { lightMotif, markWalk } from "./walk_graph.mjs";
import { drawPath, lightVisit } from "./walk_path.mjs";
import { walking } from "./walk_state.mjs";
import { filled, waysText, withoutGap } from "./walk_words.mjs";
/** @import { Walk, WalkKeys } from "./types.d.ts" */
/** @import { Selection, View, ViewKey } from "../shared/types.d.ts" */
/** @import { StageRequest } from "../stage/types.d.ts" */

/** Keys of the link that say which walk it is. @type {ViewKey[]} */
const KEYS = ["walk", "extra", "gaps", "ends", "feet"];
const OURS = "~walk~";
const LONGEST = 300; // letters of a path that a link can hold
const BEFORE = 0.5; // seconds played before a motif that was just added

/** The server's last answer; empty until there is one. @type {Walk} */
let now = /** @type {any} */ ({});
/** @type {View} */
let view = {};
let played = ""; // name of the walk that was last given to the Stage
let added = false; // the path was just made longer: play its end
let lit = -1;

/** @param {View | null} shown */
const keysOf = (shown) => Object.fromEntries(KEYS.filter((key) => shown?.[key]).map((key) => [key, shown?.[key]]));
/** @param {WalkKeys | null | undefined} a @param {WalkKeys | null | undefined} b */
const same = (a, b) => KEYS.every((key) => (a?.[key] || "") === (b?.[key] || ""));
const onStage = () => Boolean(player.frameOf(0)?.dataset?.startsWith(OURS));

/** The motifs that are shown: of the walk, or of a path that cannot be walked. */
const motifs = () => now.path || [];

/** @param {number[]} path @param {View} [more] */
function write(path, more = {}) {
  const text = path.join("-");
  if (text.length > LONGEST) return problem({ error: "This path is too long for a link; about a hundred motifs fit." });
  changeView({ walk: text, ...more });
}

/**
 * The next motif of the path: a click on a box, or the list of all motifs.
 * @param {number} motif
 */
function add(motif) {
  added = true;
  write([...motifs(), motif]);
}

/** @param {Walk} data @returns {StageRequest} */
function request(data) {
  const shown = data.path.slice(0, 8).join(" → ") + (data.path.length > 8 ? " …" : "");
  return {
    dataset: data.name ?? "", title: `Walk: ${shown}`, layout: "overlay", sync: "start",
    items: [{ clip: "walk", start: 0, end: data.frames, label: "Walk", colours: data.bands }],
  };
}

/** @param {Walk} data @param {boolean} [fromEnd] */
async function play(data, fromEnd) {
  played = data.name ?? "";
  await player.show(request(data));
  if (!fromEnd || data.path.length < 2) return;
  const back = Math.round((BEFORE * data.frames) / data.seconds);
  player.seek({ clip: "walk", frame: Math.max(0, (data.visits.at(-1) ?? [0])[0] - back) });
}

/**
 * Another walk of the same length in time: with feet kept or sliding, shown at the same moment.
 * @param {Walk} data
 */
const swap = (data) => {
  played = data.name ?? "";
  player.replace(request(data));
};

/** @param {Partial<Walk>} walk */
function problem({ error, gap, detour }) {
  const box = need(ids.WALK_ERROR);
  box.replaceChildren();
  box.classList.toggle("hidden", !error);
  if (!error) return;
  const text = document.createElement("p");
  text.textContent = error;
  box.append(text);
  /** @param {string} label @param {() => void} act */
  const offer = (label, act) => {
    const button = Object.assign(document.createElement("button"), { type: "button", className: "walk-button", textContent: label });
    button.addEventListener("click", act);
    box.append(button);
  };
  if (gap && detour?.length) offer(`Go by way of ${detour.slice(1, -1).join(", ")}`, () => write(filled(motifs(), gap, detour)));
  if (gap) offer("Bridge the gap by a blend", () => changeView({ gaps: "bridge" }));
  if (gap && motifs().length) offer(`Take ${gap[1]} away`, () => write(withoutGap(motifs(), gap)));
}

function show() {
  const busy = !same(now.inputs, keysOf(view));
  need(ids.WALK_PATH).classList.toggle("busy", busy);
  if (busy) {
    need(ids.WALK_HINT).textContent = view.walk ? "Making the walk …" : "";
    return;
  }
  const walks = Boolean(now.name);
  need(ids.WALK_PATH).dataset.shown = now.inputs.walk || "";
  need(ids.WALK_LENGTH).textContent = walks ? `${now.path.length} motif${now.path.length > 1 ? "s" : ""}, ${now.seconds.toFixed(1)} s` : "";
  need(ids.WALK_HINT).textContent = walks || now.error ? "" : "Click motifs in the graph one after the other, or let chance choose.";
  need(ids.WALK_NOTES).replaceChildren(...(now.warnings || []).map((text) => Object.assign(document.createElement("p"), { textContent: text })));
  need(ids.WALK_WAYS).textContent = waysText(now);
  drawPath(need(ids.WALK_PATH), now, { write, jump: seekTo });
  problem(now);
  drawSkateMeter(need(ids.WALK_METERS), "This walk", now.name ? now : null, now.blends > 0);
  for (const button of allWithin(document, "[data-walk='play']")) button.disabled = !walks;
  for (const button of allWithin(document, "[data-walk='clear']")) button.disabled = !view.walk;
  setLink(ids.WALK_BVH, walks && `/api/bvh/${encodeURIComponent(now.name ?? "")}/walk`);
  const recipes = Object.values((walks && now.recipes) || {});
  allWithin(document, ".walk-recipe").forEach((button, i) => {
    button.disabled = !recipes[i];
    button.title = `Copy the walk as ${i ? "a Python script" : "commands"}`;
    button.dataset.copy = recipes[i] || "";
  });
  setLink(ids.WALK_JSON, walks && `/api/walk/${now.name?.slice(OURS.length)}.json`);
  lists();
  markWalk(now, walking.on, steps);
}

/** The lists of all motifs, filled once for each graph. */
function lists() {
  for (const [id, first] of [[ids.WALK_ADD, "a motif …"], [ids.WALK_FROM, "motif"], [ids.WALK_TO, "motif"]]) {
    const list = need(id);
    const stamp = `${now.key} ${JSON.stringify(now.motifs)}`;
    if (list.dataset.stamp === stamp) continue;
    list.dataset.stamp = stamp;
    const chosen = list.value;
    list.replaceChildren(new Option(first, ""), ...now.motifs.map(({ id: motif, name }) => new Option(name ? `${motif} ${name}` : String(motif), String(motif))));
    list.value = chosen;
  }
}

/**
 * From the path to the Stage: the moment at which a motif begins.
 * @param {number} visit
 */
function seekTo(visit) {
  if (!now.name) return;
  const frame = now.visits[visit][0];
  if (!onStage() || played !== now.name) play(now).then(() => player.seek({ clip: "walk", frame }));
  else player.seek({ clip: "walk", frame });
}

// the motif that plays is lit in the graph and on the path
window.addEventListener("stage-frame", (event) => {
  const item = event.detail.items[0];
  const ours = walking.on && now.name && item?.dataset === now.name;
  const visit = ours ? now.visits.findIndex(([a, b]) => item.frame >= a && item.frame < b) : -1;
  if (visit === lit) return;
  lit = visit;
  lightVisit(find(ids.WALK_PATH), visit);
  lightMotif(visit < 0 ? null : now.path[visit]);
});

/** @type {Record<string, () => void>} */
const actions = {
  play: () => now.name && play(now),
  clear: () => changeView({ walk: "" }),
  fewest: () => between("fewest"),
  used: () => between("used"),
  random() {
    /** @param {string} id @param {number} low @param {number} high */
    const whole = (id, low, high) => Math.min(Math.max(Math.round(Number(need(id).value) || low), low), high);
    const seconds = whole(ids.WALK_SECONDS, 1, Number(need(ids.WALK_SECONDS).max));
    let seed = whole(ids.WALK_SEED, 0, 999999999);
    if (view.walk === `random:${seconds}:${seed}`) seed += 1;
    changeView({ walk: `random:${seconds}:${seed}` });
  },
};

/** @param {string} by */
function between(by) {
  const [from, to] = [ids.WALK_FROM, ids.WALK_TO].map((id) => need(id).value);
  const missing = [ids.WALK_FROM, ids.WALK_TO].find((id) => !need(id).value);
  if (missing) return need(missing).focus();
  changeView({ walk: `${by}:${from}:${to}` });
}

document.addEventListener("click", (event) => {
  const button = closest(event, "[data-walk]");
  if (button && !button.disabled && walking.on) actions[button.dataset.walk ?? ""]();
});
document.addEventListener("change", (event) => {
  if (targetOf(event).id !== ids.WALK_ADD || !targetOf(event).value) return;
  add(Number(targetOf(event).value));
  targetOf(event).value = "";
});

/** @param {Selection | null} selection */
function leave(selection) {
  if (!walking.on) return;
  walking.on = false;
  lit = -1;
  markWalk({}, false, steps);
  if (onStage() && selection && Object.keys(selection).length) setStore(SELECTION, { ...selection });
}

/** What clicks in the graph do. */
const steps = {
  add,
  /**
   * A click on an edge: on to its target, if the path has come to its source.
   * @param {number} source
   * @param {number} target
   */
  follow(source, target) {
    const last = motifs().at(-1);
    if (last === source) add(target);
    else if (last === undefined) {
      added = true;
      write([source, target]);
    }
  },
};

// boxes and arrows are then steps of the walk, not selections to be played
ahead.unless((selection) => walking.on && (selection.edge !== undefined || (selection.motif !== undefined && selection.motion === undefined)));

/** The switches: key of the link, and the control. @type {[ViewKey, string][]} */
const OPTIONS = [["extra", ids.WALK_EXTRA], ["gaps", ids.WALK_BRIDGE], ["ends", ids.WALK_STOP], ["feet", ids.WALK_FEET]];
/** Whether a switch is on for a value of the link. @type {Record<string, (value: string | undefined) => boolean>} */
const checkedFor = { /** @param {string | undefined} v */
extra: (v) => v === "1", /** @param {string | undefined} v */
gaps: (v) => v === "bridge", /** @param {string | undefined} v */
ends: (v) => v === "stop", /** @param {string | undefined} v */
feet: (v) => v !== "0" };

register("walk", {
  /**
   * @param {Walk | null} data
   * @param {View | null} shown
   * @param {unknown} _id
   * @param {unknown} _elements
   * @param {Selection | null} selection
   */
  draw(data, shown, _id, _elements, selection) {
    view = shown || {};
    if (view.side !== "walk") return leave(selection), clientside.no_update;
    if (!find(ids.WALK_PATH)) return clientside.no_update;
    const entered = !walking.on;
    walking.on = true;
    for (const [key, id] of OPTIONS) clientside.set_props(id, { checked: checkedFor[key](view[key]) });
    const [, seconds, seed] = /^random:([\d.]+):(\d+)/.exec(view.walk || "") || [];
    if (seed) {
      clientside.set_props(ids.WALK_SECONDS, { value: Number(seconds) });
      clientside.set_props(ids.WALK_SEED, { value: Number(seed) });
    }
    if (!data) return clientside.no_update;
    const before = now;
    now = data;
    show();
    if (!now.name || !same(now.inputs, keysOf(view))) return clientside.no_update;
    const chosen = selection && Object.keys(selection).length > 0;
    if (entered && chosen && !before.key) return clientside.no_update; // the link is of the selection
    if (entered && chosen) setStore(SELECTION, {});
    if (now.name !== played || (entered && !onStage())) {
      const feet = before.name && before.frames === now.frames && String(before.path) === String(now.path) && onStage();
      if (feet) swap(now);
      else play(now, added && !entered);
    }
    added = false;
    return clientside.no_update;
  },
  // One of the switches: it goes into the link, where it differs.
  /**
   * @param {boolean} extra
   * @param {boolean} bridge
   * @param {boolean} stop
   * @param {boolean} feet
   * @param {View | null} shown
   */
  option(extra, bridge, stop, feet, shown) {
    if (!walking.on) return clientside.no_update;
    /** @type {View} */
    const wanted = { extra: extra ? "1" : "", gaps: bridge ? "bridge" : "", ends: stop ? "stop" : "", feet: feet ? "" : "0" };
    if (OPTIONS.some(([key]) => (shown?.[key] || "") !== wanted[key])) changeView(wanted);
    return clientside.no_update;
  },
});
