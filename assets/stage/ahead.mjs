// What is selected plays at once: the Stage's request is fetched here, its motions already when the pointer rests on
// them, while the app's own callbacks take their round trips. They end in the same request, which the Stage then knows.
import { closest, find, need } from "../shared/dom.mjs";
import * as ids from "./ids.mjs";
import { player } from "./player.mjs";
/** @import { Selection } from "../shared/types.d.ts" */

const REST = 90; // milliseconds the pointer stays before anything is fetched
const PATIENCE = 400; // milliseconds
const KEPT = 15000; // milliseconds: a name that is given meanwhile is soon seen
const OTHER = ["motifs", "motif", "motion", "edge", "transition", "action", "segment", "clip", "start", "end", "as", "time", "speed", "layout", "camera"];
const requests = new Map(); // address -> promise of a request, null where there is nothing to play
let current = Promise.resolve();
let timer = 0;
let turn = 0;

/**
 * The address of what this page would play for a selection.
 * @param {Selection} selection
 */
function address(selection) {
  const pairs = new URLSearchParams(location.search);
  for (const key of OTHER) pairs.delete(key);
  for (const [key, value] of Object.entries(selection)) pairs.set(key, String(value));
  const page = location.pathname.split("/").filter(Boolean).pop() || "library";
  return `${need(ids.STAGE).dataset.api || "/api"}/stage/${page}?${pairs}`;
}

/** @param {Selection} selection */
function ask(selection) {
  const where = address(selection);
  if (!requests.has(where)) {
    const answer = fetch(where).then((response) => (response.ok ? response.json() : null), () => null);
    requests.set(where, answer);
    answer.then((request) => request || requests.delete(where)); // it may be there the next time
    setTimeout(() => requests.delete(where), KEPT);
  }
  return requests.get(where);
}

/** @type {((selection: Selection) => boolean)[]} */
const exceptions = []; // tests of selections that are not played
/** @param {Selection} selection */
const usable = (selection) =>
  selection && Object.keys(selection).length > 0 && !selection.motifs && find(ids.STAGE) && !exceptions.some((test) => test(selection));

export const ahead = {
  /**
   * Fetch what a selection plays: at once, or when the pointer has rested (`later`) until `leave`.
   * @param {Selection} selection
   * @param {boolean} [later]
   */
  prepare(selection, later = false) {
    clearTimeout(timer);
    if (!usable(selection)) return;
    const fetchIt = async () => player.prefetch(await ask(selection));
    if (later) timer = setTimeout(fetchIt, REST);
    else fetchIt();
  },
  leave: () => clearTimeout(timer),
  /**
   * Never play a selection for which `test(selection)` is true.
   * @param {(selection: Selection) => boolean} test
   */
  unless: (test) => exceptions.push(test),
  /** @param {Selection} selection */
  play(selection) {
    if (usable(selection)) current = play(selection);
  },
  /** Until what was played last is on the Stage, but not for long: work that can wait leaves the browser free. */
  settled: () => Promise.race([current, new Promise((done) => setTimeout(done, PATIENCE))]),
};

/**
 * Play a selection, unless something else was to be shown meanwhile.
 * @param {Selection} selection
 */
async function play(selection) {
  const mine = ++turn;
  const before = player.requestCount;
  const request = await ask(selection);
  if (!request || mine !== turn || before !== player.requestCount) return;
  await player.show(request);
  for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
}

/** @param {Event} event */
const target = (event) => closest(event, '[data-store="selection"]');
document.addEventListener("pointerover", (event) => {
  const button = target(event);
  if (button) ahead.prepare(JSON.parse(button.dataset.value ?? "{}"), true);
});
document.addEventListener("pointerout", (event) => target(event) && ahead.leave());
