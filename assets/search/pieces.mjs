// The rows of a query: each a piece of a clip, with pictures, labels and the range that is looked for.
import { element, icon, within } from "../shared/dom.mjs";
import { clock } from "../shared/words.mjs";
import * as ids from "./ids.mjs";
import { now } from "./state.mjs";
/** @import { ShownPiece } from "./types.d.ts" */

const PICTURES = 12;
const LABELS = ["#4e79a7", "#f28e2b", "#59a14f", "#e15759", "#b07aa1", "#9c755f", "#76b7b2", "#d4a720", "#ff9da7", "#79706e"];

/** Frames that a row shows, where it is not all of its clip, by the piece's name. @type {Map<string, [number, number]>} */
export const shownWindows = new Map();

/** @param {ShownPiece} piece */
export const pieceName = (piece) => `${piece.dataset} ${piece.clip}`;

/** The frames that a piece's row shows. @param {ShownPiece} piece @returns {[number, number]} */
export const shownOf = (piece) => shownWindows.get(pieceName(piece)) || [0, piece.frames];

/** @param {ShownPiece} piece @param {[number, number]} range */
function pictures(piece, [from, to]) {
  const box = element("div", "search-pictures");
  const step = (to - from) / PICTURES;
  for (let k = 0; k < PICTURES; k++) {
    const start = Math.round(from + k * step);
    const end = Math.max(Math.round(from + (k + 1) * step), start + 1);
    const picture = element("img");
    const pairs = new URLSearchParams({ start: String(start), end: String(Math.min(end, piece.frames)), n: "1", v: piece.version.slice(0, 8) });
    picture.src = `/api/filmstrip/${encodeURIComponent(piece.source)}/${encodeURIComponent(piece.clip)}?${pairs}`;
    picture.alt = "";
    picture.draggable = false;
    box.append(picture);
  }
  return box;
}

/** @param {ShownPiece} piece @param {[number, number]} range */
function labels(piece, [from, to]) {
  const box = element("div", "search-labels");
  const actions = now.clips ? now.clips.actions : [];
  for (const [start, end, action] of piece.labels) {
    if (end <= from || start >= to) continue;
    const block = element("span", "search-label-block", action);
    block.title = `${action}, ${clock(start / piece.fps)} to ${clock(end / piece.fps)}. Click to look for it.`;
    block.dataset.range = `${start}-${end}`;
    block.style.setProperty("--tone", LABELS[Math.max(actions.indexOf(action), 0) % LABELS.length]);
    place(block, Math.max(start, from), Math.min(end, to), [from, to]);
    box.append(block);
  }
  return box;
}

/** @param {HTMLElement} node @param {number} start @param {number} end @param {[number, number]} range */
const place = (node, start, end, [from, to]) => {
  node.style.left = (100 * (start - from)) / (to - from) + "%";
  node.style.width = Math.max((100 * (end - start)) / (to - from), 0.3) + "%";
};

/** @param {string} which @param {ShownPiece} piece */
function handle(which, piece) {
  const made = element("div", "search-handle search-handle-" + which);
  made.tabIndex = 0;
  made.setAttribute("role", "slider");
  made.setAttribute("aria-label", which === "start" ? "First frame of the query" : "End of the query");
  made.setAttribute("aria-valuemin", String(0));
  made.setAttribute("aria-valuemax", String(piece.frames));
  made.dataset.end = which;
  return made;
}

/** @param {string} symbol @param {string} label @param {string} action */
function tool(symbol, label, action) {
  const made = element("button", "search-tool", icon(symbol, 14));
  made.type = "button";
  made.title = label;
  made.setAttribute("aria-label", label);
  made.dataset.piece = action;
  return made;
}

/** @param {ShownPiece} piece @param {number} index @param {boolean} several */
export function sourceRow(piece, index, several) {
  const made = element("div", "search-source");
  made.dataset.index = String(index);
  made.style.setProperty("--own", piece.colour);
  const badge = element("button", "search-badge", "ABCDEF"[index]);
  badge.type = "button";
  badge.dataset.piece = "active";
  badge.title = `Parts one clicks in the figure come from ${"ABCDEF"[index]}`;
  const name = element("input", "search-clip");
  name.setAttribute("list", ids.SEARCH_CLIP_NAMES);
  name.setAttribute("aria-label", "Clip that is looked for");
  name.placeholder = "Choose a clip";
  name.value = piece.dataset ? piece.clip : piece.clip;
  name.title = piece.dataset.startsWith("~upload~") ? "An uploaded recording" : piece.dataset ? `From ${piece.source}` : piece.clip;
  const gives = element("span", "search-gives muted", several ? piece.gives : piece.dataset.startsWith("~upload~") ? "uploaded" : "");
  const head = element("div", "search-source-head", several ? badge : null, name, gives,
    element("span", "search-span number"), element("span", "spacer"),
    tool("minus", "Show more of the clip", "out"), tool("plus", "Zoom in on the range", "in"),
    tool("fit", "Take the whole clip", "whole"), several ? tool("close", "Leave this piece out", "remove") : null);
  const track = element("div", "search-track");
  const range = shownOf(piece);
  const box = element("div", "search-selection", handle("start", piece), handle("end", piece));
  track.append(pictures(piece, range), labels(piece, range), element("div", "search-shade search-shade-left"),
    element("div", "search-shade search-shade-right"), box, element("div", "search-cursor"));
  made.append(head, track);
  return made;
}

/** Bring a row in line with its piece: the range, and what it says. @param {HTMLElement} node @param {ShownPiece} piece */
export function placeRange(node, piece) {
  const range = shownOf(piece);
  const { start, end, fps, frames } = piece;
  place(within(node, ".search-selection"), Math.max(start, range[0]), Math.min(end, range[1]), range);
  place(within(node, ".search-shade-left"), range[0], Math.max(start, range[0]), range);
  place(within(node, ".search-shade-right"), Math.min(end, range[1]), range[1], range);
  within(node, ".search-shade-left").style.minWidth = "0";
  for (const [which, value] of /** @type {[string, number][]} */ ([["start", start], ["end", end]])) {
    const one = within(node, ".search-handle-" + which);
    one.setAttribute("aria-valuenow", String(value));
    one.setAttribute("aria-valuetext", clock(value / fps));
  }
  const whole = start === 0 && end === frames;
  within(node, ".search-span").textContent = whole ? `whole clip, ${(frames / fps).toFixed(1)} s`
    : `${clock(start / fps)} to ${clock(end / fps)}, ${((end - start) / fps).toFixed(1)} s`;
}

export function emptyRow() {
  const name = element("input", "search-clip");
  name.setAttribute("list", ids.SEARCH_CLIP_NAMES);
  name.setAttribute("aria-label", "Clip that is looked for");
  name.placeholder = now.clips ? "Choose a clip" : "No dataset yet";
  const hint = element("span", "muted search-hint", "What motion do you look for? Choose a clip, then drag over the part that matters.");
  const made = element("div", "search-source search-source-empty", element("div", "search-source-head", name, hint));
  made.dataset.index = String(0);
  return made;
}
