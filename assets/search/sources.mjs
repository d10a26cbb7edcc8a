/* Where the query comes from: one row a piece, each a clip with a range dragged on its pictures. */
import { notify } from "../shared/dash.mjs";
import { allWithin, around, childrenOf, closest, element, find, hasClass, icon, need, targetOf, within } from "../shared/dom.mjs";
import { clock } from "../shared/words.mjs";
import { player } from "../stage/player.mjs";
import { drawBody } from "./body.mjs";
import { seekPiece } from "./hits.mjs";
import * as ids from "./ids.mjs";
import { canGoBack, changeSearch, copyPieces, goBack, now, remember, searchFor } from "./state.mjs";
import { chooseRecording } from "./upload.mjs";
/** @import { ClipList, Drag, QueryPiece, ShownPiece } from "./types.d.ts" */

const PICTURES = 12;
const LABELS = ["#4e79a7", "#f28e2b", "#59a14f", "#e15759", "#b07aa1", "#9c755f", "#76b7b2", "#d4a720", "#ff9da7", "#79706e"];
/** @type {Map<string, [number, number]>} */
const windows = new Map(); // "dataset clip" -> [from, to] frames that its row shows

/** @param {ShownPiece} piece */
const nameOf = (piece) => `${piece.dataset} ${piece.clip}`;
/** @param {ShownPiece} piece */
const shownOf = (piece) => windows.get(nameOf(piece)) || [0, piece.frames];
/** @param {string} name */
const clipCalled = (name) => now.clips && now.clips.clips.find((clip) => clip[0] === name);

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
function row(piece, index, several) {
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

/** @param {HTMLElement} node @param {ShownPiece} piece */
function settle(node, piece) {
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

function empty() {
  const name = element("input", "search-clip");
  name.setAttribute("list", ids.SEARCH_CLIP_NAMES);
  name.setAttribute("aria-label", "Clip that is looked for");
  name.placeholder = now.clips ? "Choose a clip" : "No dataset yet";
  const hint = element("span", "muted search-hint", "What motion do you look for? Choose a clip, then drag over the part that matters.");
  const made = element("div", "search-source search-source-empty", element("div", "search-source-head", name, hint));
  made.dataset.index = String(0);
  return made;
}

let drawn = "";
/** @type {Drag | null} */
let dragged = null; // {index, start, end, mode, at}: while one drags
export const drawSources = () => {
  const box = need(ids.SEARCH_SOURCES);
  const pieces = (now.found && now.found.pieces) || [];
  const mark = JSON.stringify([now.clips && [now.clips.dataset, now.clips.version, now.clips.clips.length], pieces.map((p) =>
    [p.dataset, p.clip, p.version, p.gives, p.labels.length, shownOf(p)])]);
  if (mark !== drawn || !box.firstChild) {
    const focus = document.activeElement && box.contains(document.activeElement)
      ? [closest({ target: document.activeElement }, ".search-source")?.dataset.index, document.activeElement.className] : null;
    drawn = mark;
    now.active = Math.min(now.active, Math.max(pieces.length - 1, 0));
    box.replaceChildren(...(pieces.length ? pieces.map((piece, k) => row(piece, k, pieces.length > 1)) : [empty()]));
    const again = focus && focus[1] && allWithin(box, `[data-index="${focus[0]}"] *`).find((one) => one.className === focus[1]);
    if (again) again.focus();
    names();
  }
  pieces.forEach((piece, k) => { if (!dragged || dragged.index !== k) settle(childrenOf(box)[k], piece); });
  allWithin(box, ".search-source").forEach((one, k) => one.classList.toggle("active", k === now.active && pieces.length > 1));
  drawMotifs();
  const back = document.querySelector("[data-search='back']");
  if (back) back.classList.toggle("hidden", !canGoBack());
  const combineButton = allWithin(document, "[data-search='combine']")[0];
  if (combineButton) combineButton.disabled = !pieces.length || pieces.length >= 6;
  const warning = need(ids.SEARCH_WARNING);
  const doubt = (now.found && now.found.doubt) || "";
  warning.classList.toggle("hidden", !doubt);
  warning.textContent = doubt;
};

/** @type {ClipList | null} */
let named = null;
function names() {
  const list = find(ids.SEARCH_CLIP_NAMES);
  if (!list || named === now.clips && list.firstChild) return;
  named = now.clips;
  list.replaceChildren(...(now.clips ? now.clips.clips : []).slice(0, 5000).map(([name]) => {
    const option = element("option");
    option.value = name;
    return option;
  }));
}

function drawMotifs() {
  const select = find(ids.SEARCH_MOTIF);
  const mark = JSON.stringify(now.motifs);
  if (!select || select.dataset.mark === mark) return;
  select.dataset.mark = mark;
  const first = element("option", "", "From a motif …");
  first.value = "";
  select.replaceChildren(first, ...now.motifs.map(({ name, motions, query }) => {
    const option = element("option", "", `${name} (${motions} motions)`);
    option.value = query;
    return option;
  }));
  select.classList.toggle("hidden", !now.motifs.length);
}

// ---- the pieces are changed ----
/** @param {number} index @param {string} name */
function takeClip(index, name) {
  const clip = clipCalled(name);
  if (!clip) return false;
  /** @type {QueryPiece[]} */
  const pieces = copyPieces();
  const leaves = pieces[index] ? pieces[index].leaves : [...now.body.leaves];
  pieces[index] = { clip: name, dataset: "", start: 0, end: clip[1], leaves };
  searchFor(pieces);
  return true;
}

/** @param {number} index @param {number} start @param {number} end */
function setRange(index, start, end) {
  const pieces = copyPieces();
  const piece = pieces[index];
  if (!piece) return;
  piece.start = Math.max(0, Math.min(start, piece.frames - 1));
  piece.end = Math.max(piece.start + 1, Math.min(end, piece.frames));
  now.found.pieces[index] = { ...now.found.pieces[index], start: piece.start, end: piece.end };
  drawSources();
  searchFor(pieces);
}

/** @param {number} index @param {string} action */
function zoom(index, action) {
  const piece = now.found.pieces[index];
  const [from, to] = shownOf(piece);
  const wanted = action === "in" ? Math.max((piece.end - piece.start) * 1.6, (to - from) / 3, 16) : (to - from) * 2;
  const middle = (piece.start + piece.end) / 2;
  const width = Math.min(wanted, piece.frames);
  const start = Math.round(Math.min(Math.max(middle - width / 2, 0), piece.frames - width));
  if (width >= piece.frames) windows.delete(nameOf(piece));
  else windows.set(nameOf(piece), [start, Math.round(start + width)]);
  drawSources();
}

function combine() {
  const pieces = copyPieces();
  const most = pieces.reduce((a, b) => (b.leaves.length > a.leaves.length ? b : a));
  const limbs = ["lower_body", "left_arm_hand", "right_arm_hand", "left_leg_foot", "right_leg_foot", "head_torso", ...now.body.leaves];
  const node = limbs.find((one) => now.body.nodes[one].every((leaf) => most.leaves.includes(leaf)) && now.body.nodes[one].length < most.leaves.length);
  if (!node) return;
  const given = now.body.nodes[node];
  most.leaves = most.leaves.filter((leaf) => !given.includes(leaf));
  pieces.push({ ...most, leaves: [...given] });
  now.active = pieces.length - 1;
  searchFor(pieces);
}

function fromStage() {
  const item = player.frameOf(0);
  if (!item) return notify("Nothing is on the Stage", "Play a clip, a motif or a walk first; what the Stage shows can then be looked for.");
  const here = !item.dataset || item.dataset === now.clips.dataset;
  const piece = { clip: item.clip, start: item.start, end: item.end, dataset: here ? "" : item.dataset ?? "", leaves: [...now.body.leaves] };
  return searchFor([piece]);
}

document.addEventListener("change", (event) => {
  if (targetOf(event).id === ids.SEARCH_MOTIF && targetOf(event).value) {
    remember();
    changeSearch({ query: targetOf(event).value });
    targetOf(event).value = "";
  } else if (hasClass(event, "search-clip")) {
    const index = Number(around(targetOf(event), ".search-source").dataset.index);
    const piece = now.found && now.found.pieces && now.found.pieces[index];
    if (!takeClip(index, targetOf(event).value) && targetOf(event).value) {
      notify("No clip of this name", `“${targetOf(event).value}” is not in this dataset.`);
      targetOf(event).value = piece ? piece.clip : "";
    }
  }
});

document.addEventListener("input", (event) => { // a choice from the list needs no Enter
  if (hasClass(event, "search-clip") && /** @type {InputEvent} */ (event).inputType === undefined && clipCalled(targetOf(event).value)) {
    takeClip(Number(around(targetOf(event), ".search-source").dataset.index), targetOf(event).value);
  }
});

document.addEventListener("click", (event) => {
  const button = closest(event, "[data-search]");
  if (button) {
    /** @type {Record<string, () => void>} */
    const acts = { stage: fromStage, combine, back: goBack, upload: chooseRecording };
    acts[button.dataset.search ?? ""]?.();
    return;
  }
  const on = closest(event, "[data-piece]");
  if (!on) return;
  const index = Number(around(on, ".search-source").dataset.index);
  const piece = now.found.pieces[index];
  if (on.dataset.piece === "active") {
    now.active = index;
    drawSources();
    drawBody();
  } else if (on.dataset.piece === "whole") {
    windows.delete(nameOf(piece));
    setRange(index, 0, piece.frames);
  } else if (on.dataset.piece === "remove") {
    const pieces = copyPieces();
    const [gone] = pieces.splice(index, 1);
    pieces[0].leaves = now.body.leaves.filter((leaf) => pieces[0].leaves.includes(leaf) || gone.leaves.includes(leaf));
    now.active = 0;
    searchFor(pieces);
  } else zoom(index, on.dataset.piece ?? "");
});

// ---- dragging a range ----
/** @param {HTMLElement} track @param {ShownPiece} piece @param {number} x */
const frameAt = (track, piece, x) => {
  const box = track.getBoundingClientRect();
  const [from, to] = shownOf(piece);
  return Math.round(from + Math.min(Math.max((x - box.left) / box.width, 0), 1) * (to - from));
};

document.addEventListener("pointerdown", (event) => {
  const track = closest(event, ".search-track");
  if (!track || event.button) return;
  const index = Number(around(track, ".search-source").dataset.index);
  const piece = now.found.pieces[index];
  const at = frameAt(track, piece, event.clientX);
  const end = targetOf(event).dataset.end;
  dragged = { index, track, at, piece: { ...piece }, mode: end || "new", moved: false, start: 0, end: 0, id: event.pointerId, label: targetOf(event).dataset.range };
  track.setPointerCapture(event.pointerId);
  event.preventDefault();
  if (end) targetOf(event).focus();
});

document.addEventListener("pointermove", (event) => {
  if (!dragged || event.pointerId !== dragged.id) return;
  const { piece, track, mode } = dragged;
  const frame = frameAt(track, piece, event.clientX);
  if (Math.abs(frame - dragged.at) > 0) dragged.moved = true;
  if (!dragged.moved) return;
  let [start, end] = [piece.start, piece.end];
  if (mode === "start") start = Math.min(frame, end - 1);
  else if (mode === "end") end = Math.max(frame, start + 1);
  else [start, end] = [Math.min(frame, dragged.at), Math.max(frame, dragged.at)];
  dragged.start = start;
  dragged.end = Math.max(end, start + 1);
  settle(around(track, ".search-source"), { ...piece, start, end: dragged.end });
});

/** @param {PointerEvent} event */
const release = (event) => {
  if (!dragged || event.pointerId !== dragged.id) return;
  const { index, moved, start, end, label, piece, track } = dragged;
  const least = Math.max(2, Math.round(0.1 * piece.fps));
  dragged = null;
  if (event.type === "pointercancel") return drawSources();
  if (label && !moved) return setRange(index, Number(label.split("-")[0]), Number(label.split("-")[1]));
  if (!moved) return seekPiece(index, frameAt(track, piece, event.clientX));
  if (end - start < least) return drawSources();
  return setRange(index, start, end);
};
document.addEventListener("pointerup", release);
document.addEventListener("pointercancel", release);

document.addEventListener("keydown", (event) => {
  if (!hasClass(event, "search-handle")) return;
  const index = Number(around(targetOf(event), ".search-source").dataset.index);
  const piece = now.found.pieces[index];
  const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
  const by = event.shiftKey ? 10 * (step || 0) : step;
  const home = event.key === "Home" ? -piece.frames : event.key === "End" ? piece.frames : by;
  if (!home) return;
  event.preventDefault();
  event.stopPropagation();
  if (targetOf(event).dataset.end === "start") setRange(index, Math.min(piece.start + home, piece.end - 1), piece.end);
  else setRange(index, piece.start, Math.max(piece.end + home, piece.start + 1));
});
