/* The actions as cards with their posture strips; the occurrences of the chosen one beside them. */
import { allWithin, element, find, icon, need } from "../shared/dom.mjs";
import { clock, plural } from "../shared/words.mjs";
import * as ids from "./ids.mjs";
import { isFresh, playsSelection, redraw, state } from "./state.mjs";
/** @import { Action, GrammarData, StringRow } from "./types.d.ts" */
/** @import { Selection } from "../shared/types.d.ts" */

const ROWS = 60;

/** @param {Action} action */
function card(action) {
  const button = playsSelection(element("button", "action-card"), { action: action.id });
  button.type = "button";
  button.dataset.action = String(action.id);
  button.style.setProperty("--tone", action.colour);
  button.title = `Play all occurrences of ${action.name}`;
  const head = element("span", "action-head");
  head.append(element("b", "ellipsis", action.name), element("span", "muted number", action.named ? String(action.id) : ""));
  const strip = element("img", "action-strip");
  Object.assign(strip, { src: action.strip, alt: "", loading: "lazy", draggable: false });
  const facts = element("span", "muted number action-facts");
  facts.append(element("span", "", `${plural(action.count, "time")}, ${action.seconds.toFixed(1)} s`));
  if (action.label) facts.append(element("span", "ellipsis action-label", action.label));
  button.append(head, strip, facts);
  return button;
}

/** @param {[StringRow, number, number, number]} piece @param {number} id @param {boolean} chosen */
function occurrence([clip, start, end, number], id, chosen) {
  const button = playsSelection(element("button", "occurrence" + (chosen ? " chosen" : "")), { action: id, segment: number });
  button.type = "button";
  button.title = `Play ${clip.clip}, ${clock(start)} to ${clock(end)}`;
  button.setAttribute("aria-pressed", String(chosen));
  const strip = element("img", "occurrence-strip");
  const frames = new URLSearchParams({ start: String(Math.round(start * clip.fps)), end: String(Math.round(end * clip.fps)), n: "4", v: state.data.version });
  strip.src = `/api/filmstrip/${encodeURIComponent(state.data.dataset)}/${encodeURIComponent(clip.clip)}?${frames}`;
  Object.assign(strip, { alt: "", loading: "lazy", draggable: false });
  button.append(icon("play"), element("span", "ellipsis", clip.brief), element("span", "muted number", `${clock(start)} to ${clock(end)}`), strip);
  return button;
}

/**
 * Where an action occurs: clip, seconds from and to, number.
 * @param {GrammarData} data
 * @param {number} id
 * @returns {[StringRow, number, number, number][]}
 */
const occurrences = (data, id) =>
  data.rows
    .flatMap((clip) => clip.pieces.filter((piece) => piece[2] === id).map((piece) => /** @type {[StringRow, number, number, number]} */ ([clip, piece[0], piece[1], piece[3]])))
    .sort((a, b) => a[3] - b[3]);

/** @param {GrammarData} data @param {string | null} order */
export const drawActions = (data, order) => {
  const box = find(ids.ACTION_CARDS);
  if (!box || !isFresh(box, [data.key, data.names, order])) return;
  const sorted = [...data.actions];
  if (order === "count") sorted.sort((a, b) => b.count - a.count);
  if (order === "seconds") sorted.sort((a, b) => b.seconds - a.seconds);
  if (order === "name") sorted.sort((a, b) => Number(b.named) - Number(a.named) || a.name.localeCompare(b.name, undefined, { numeric: true }));
  redraw(box, sorted.map(card));
};

/** @param {GrammarData} data @param {Selection | null} selection */
export const drawOccurrences = (data, selection) => {
  const box = find(ids.OCCURRENCES);
  if (!box) return;
  const id = selection?.action === undefined ? null : Number(selection.action);
  const known = id === null ? undefined : data.actions?.[id];
  for (const one of allWithin(document, ".action-card")) one.classList.toggle("chosen", known !== undefined && Number(one.dataset.action) === id);
  need(ids.ACTION_HINT).classList.toggle("hidden", Boolean(known));
  need(ids.ACTION_DETAIL).classList.toggle("hidden", !known);
  if (!known || id === null || !isFresh(box, [data.key, data.names, id, selection?.segment])) return;
  const all = occurrences(data, id);
  need(ids.ACTION_TITLE).textContent = `Action ${id}`;
  need(ids.ACTION_COUNT).textContent = `${plural(all.length, "time")} in ${plural(known.clips ?? 0, "recording")}`;
  const shown = all.slice(0, ROWS).map((one) => occurrence(one, id, String(one[3]) === String(selection?.segment)));
  redraw(box, shown);
  if (all.length > ROWS) box.append(element("div", "muted selection-more", `and ${all.length - ROWS} more, all of them in the recordings above`));
  playsSelection(need(ids.ACTION_ALL), { action: id });
};
