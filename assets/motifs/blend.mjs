/* The blend space of a motif: the chosen motions and their weights, in the link and on the Stage. blend_controls.mjs draws the controls. */
import { changeView, clientside, register, setStore } from "../shared/dash.mjs";
import { closest, find, need, within } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { player } from "../stage/player.mjs";
import { drawControls, updateControls } from "./blend_controls.mjs";
import * as ids from "./ids.mjs";
import { evenWeight, inStep, readPairs, rounded, sharesOf, sum, writePairs } from "./mixture.mjs";
/** @import { BlendData, BlendMotion, Mixture } from "./types.d.ts" */
/** @import { Selection, View } from "../shared/types.d.ts" */
/** @import { StageRequest } from "../stage/types.d.ts" */

const OURS = "~blend~";
const WAIT = 300; // milliseconds without a change before the weights go into the link
/** @type {Record<string, string>} */
const SOURCE = { light: "#9aa5b4", dark: "#7c8797" };

/** The mixture that is shown; null where there is none. @type {Mixture} */
let now = /** @type {any} */ (null);
/** @type {string | undefined} */
let seen; // what was shown last; the link's weights belong to the motif that is shown first
let writing = 0;

/** @param {number} motion */
const motionOf = (motion) => /** @type {BlendMotion} */ (now.data.bodies[now.body].motions.find((one) => one.motion === motion));

/** Shares of the chosen motions. */
const shares = () => sharesOf(now.values);

/** Weights as the link has them; empty for the initial ones. */
function linkText() {
  const { data, body, chosen, values } = now;
  const first = body === 0 && chosen.join() === data.bodies[0].chosen.join() && values.every((v) => v === values[0]);
  return first ? "" : writePairs(chosen, values);
}

/** @param {string | undefined} text */
function read(text) {
  const pairs = readPairs(text);
  const body = now.data.bodies.findIndex(({ motions }) => pairs.length > 1 && pairs.every(([k]) => motions.some((one) => one.motion === k)));
  if (body < 0) return false;
  const kept = pairs.slice(0, now.data.most);
  Object.assign(now, { body, chosen: kept.map(([k]) => k), values: kept.map(([, v]) => v), written: text ?? "" });
  return true;
}

/** @param {number} body */
function start(body) {
  const chosen = [...now.data.bodies[body].chosen];
  Object.assign(now, { body, chosen, values: chosen.map(() => evenWeight(chosen.length)) });
}

function mixtureName() {
  const used = shares().map((share, i) => /** @type {[number, number]} */ ([now.chosen[i], share])).filter(([, share]) => rounded(share) !== "0");
  used.sort(([a], [b]) => a - b);
  return `${OURS}${now.data.key}~${now.data.motif}~${writePairs(used.map(([k]) => k), used.map(([, share]) => share))}`;
}

/** @returns {StageRequest} */
function request() {
  const { data } = now;
  const made = { dataset: mixtureName(), clip: "blend", label: "Mixture" };
  const title = `${data.title}: mixture of ${shares().filter((share) => rounded(share) !== "0").length}`;
  if (!now.sources) return { dataset: data.dataset, items: [made], layout: "overlay", sync: "warp", title };
  const used = shares().map((share, i) => ({ share, one: motionOf(now.chosen[i]) })).filter(({ share }) => rounded(share) !== "0");
  const warps = inStep(used);
  const colour = SOURCE[document.documentElement.dataset.mantineColorScheme ?? ""] || SOURCE.light;
  const items = used.map(({ one }, i) => ({
    clip: one.clip, start: one.start, end: one.end, label: `Motion ${one.motion + 1}`, version: data.version, colour, warp: warps.sources[i],
  }));
  return { dataset: data.dataset, items: [{ ...made, warp: warps.mixture }, ...items], layout: "overlay", sync: "warp", title };
}

const onStage = () => Boolean(player.frameOf(0)?.dataset?.startsWith(OURS));

/** Play the mixture: from its start where something else was shown, else in place of the one before. */
function play() {
  const mixture = request();
  if (onStage()) player.replace(mixture);
  else player.show(mixture);
  const link = find(ids.BLEND_BVH);
  if (link) link.setAttribute("href", `/api/bvh/${encodeURIComponent(mixtureName())}/blend`);
}

function write() {
  clearTimeout(writing);
  writing = setTimeout(() => {
    if (!now) return;
    now.written = linkText();
    changeView({ weights: now.written });
  }, WAIT);
}

/** Weights were changed by hand: numbers follow immediately, the Stage as fast as it can, the link after a pause. */
function changed() {
  updateControls(now, shares());
  play();
  write();
}

/**
 * Another choice of motions: the controls are drawn anew.
 * @param {number} body
 * @param {number[]} chosen
 * @param {number[]} values
 */
function chooseAgain(body, chosen, values) {
  Object.assign(now, { body, chosen, values });
  show();
  write();
}

/** @type {Record<string, () => void>} */
const actions = {
  mean: () => now.values.fill(evenWeight(now.values.length)),
  random() {
    const drawn = now.values.map(() => -Math.log(Math.max(Math.random(), 1e-9)));
    const scale = now.values.length > 3 ? Math.max(...drawn) : sum(drawn);
    now.values = drawn.map((value) => Math.round((value / scale) * 100) / 100);
  },
  sources() {
    now.sources = !now.sources;
  },
};

/** What the controls may do. */
const controlActions = {
  /** @param {number[]} values */
  set(values) {
    now.values = values;
    changed();
  },
  /** @param {number} number */
  body(number) {
    start(number);
    chooseAgain(now.body, now.chosen, now.values);
  },
  /** @param {number} motion */
  add(motion) {
    const chosen = [...now.chosen, motion];
    chooseAgain(now.body, chosen, chosen.map(() => evenWeight(chosen.length)));
  },
  /** @param {number} motion */
  remove(motion) {
    const chosen = now.chosen.filter((one) => one !== motion);
    chooseAgain(now.body, chosen, chosen.map(() => evenWeight(chosen.length)));
  },
};

document.addEventListener("click", (event) => {
  const button = closest(event, "[data-blend]");
  if (!button || !now) return;
  const action = button.dataset.blend;
  if (action === "middles") return player.show(now.data.middles);
  actions[action ?? ""]();
  if (action === "sources") button.setAttribute("aria-pressed", String(now.sources));
  changed();
});

/** @param {boolean | null} [quiet] */
function show(quiet) {
  const { data } = now;
  need(ids.BLEND_TITLE).textContent = data.title;
  const body = data.bodies[now.body];
  need(ids.BLEND_COUNT).textContent = `${now.chosen.length} of ${data.total} motions`;
  const others = data.total - body.motions.length;
  need(ids.BLEND_NOTE).textContent = others
    ? `${others} of its ${data.total} motions are of other bodies; only motions of one body can be mixed.` : "";
  drawControls(need(ids.BLEND_CONTROLS), now, shares(), controlActions);
  if (!quiet) play();
}

/** @param {string} text */
function message(text) {
  need(ids.BLEND_HINT).textContent = text;
  need(ids.BLEND_HINT).classList.toggle("hidden", !text);
  need(ids.BLEND_PANEL).classList.toggle("hidden", Boolean(text));
}

/**
 * On the way out the motif plays as it is elsewhere.
 * @param {Selection | null} selection
 */
function leave(selection) {
  if (now && onStage() && selection) setStore(SELECTION, { ...selection });
  now = /** @type {any} */ (null);
}

/**
 * The mixture of a motif that has just come; `linked`: the link's weights may be its own.
 * @param {BlendData} data
 * @param {View} view
 * @param {Selection | null} selection
 * @param {boolean} linked
 */
function begin(data, view, selection, linked) {
  now = { data, body: 0, chosen: [], values: [], sources: false, written: "" };
  start(0);
  if (linked && view.weights) read(view.weights);
  else if (view.weights) changeView({ weights: "" });
  const stills = !seen && new URLSearchParams(location.search).get("layout") === "pose"; // as in the link
  show(stills || (selection && selection.motion !== undefined));
  if (stills) player.show(data.middles);
  within(document, "[data-blend='sources']").setAttribute("aria-pressed", "false");
}

/**
 * What is there to mix, or why there is nothing.
 * @param {BlendData} data
 * @param {View} view
 * @param {Selection | null} selection
 */
function take(data, view, selection) {
  const name = `${data.key} ${data.motif}`;
  const linked = !seen || seen === name;
  if (data.motif === undefined || data.motif === null) {
    now = /** @type {any} */ (null);
    message("Choose a motif to mix its motions.");
  } else if (!data.bodies || !data.bodies.length) {
    now = /** @type {any} */ (null);
    message("No two motions of this motif are of one body, so there is nothing to mix.");
    if (data.together && seen !== name) player.show(data.together);
  } else {
    message("");
    if (!now || `${now.data.key} ${now.data.motif}` !== name) begin(data, view, selection, linked);
    else if (!need(ids.BLEND_CONTROLS).childElementCount) show(true); // the page came anew
    else if ((view.weights || "") !== now.written && read(view.weights)) show();
  }
  seen = name;
}

register("blend", {
  /**
   * @param {BlendData | null} data
   * @param {View | null} view
   * @param {unknown} _id
   * @param {Selection | null} selection
   */
  draw(data, view, _id, selection) {
    if (!view || view.side !== "blend") {
      leave(selection);
      return clientside.no_update;
    }
    if (!data || !find(ids.BLEND_PANEL)) return clientside.no_update;
    take(data, view, selection);
    return clientside.no_update;
  },
});
