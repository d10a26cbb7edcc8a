/* Where the query comes from: changes of its pieces, and ranges that are dragged on their pictures. */
import { notify, setStore } from "../shared/dash.mjs";
import { allWithin, around, childrenOf, closest, element, find, hasClass, need, targetOf } from "../shared/dom.mjs";
import { player } from "../stage/player.mjs";
import { drawBody } from "./body.mjs";
import { seekPiece } from "./hits.mjs";
import * as ids from "./ids.mjs";
import { emptyRow, pieceName, placeRange, shownOf, shownWindows, sourceRow } from "./pieces.mjs";
import { canGoBack, changeSearch, copyPieces, goBack, now, remember, searchFor } from "./state.mjs";
import { chooseRecording } from "./upload.mjs";
/** @import { ClipList, Drag, QueryPiece, ShownPiece } from "./types.d.ts" */

/** @param {string} name */
const clipCalled = (name) => now.clips && now.clips.clips.find((clip) => clip[0] === name);

let drawn = "";
/** @type {Drag | null} */
let dragged = null; // {index, start, end, mode, at}: while one drags
export const drawSources = () => {
  const box = need(ids.SEARCH_SOURCES);
  const pieces = (now.found && now.found.pieces) || [];
  const mark = JSON.stringify([now.clips && [now.clips.dataset, now.clips.version, Boolean(now.clips.clips.length)], pieces.map((p) =>
    [p.dataset, p.clip, p.version, p.gives, p.labels.length, shownOf(p)])]);
  if (mark !== drawn || !box.firstChild) {
    const focus = document.activeElement && box.contains(document.activeElement)
      ? [closest({ target: document.activeElement }, ".search-source")?.dataset.index, document.activeElement.className] : null;
    drawn = mark;
    now.active = Math.min(now.active, Math.max(pieces.length - 1, 0));
    box.replaceChildren(...(pieces.length ? pieces.map((piece, k) => sourceRow(piece, k, pieces.length > 1)) : [emptyRow()]));
    const again = focus && focus[1] && allWithin(box, `[data-index="${focus[0]}"] *`).find((one) => one.className === focus[1]);
    if (again) again.focus();
    names();
  }
  pieces.forEach((piece, k) => { if (!dragged || dragged.index !== k) placeRange(childrenOf(box)[k], piece); });
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
  if (width >= piece.frames) shownWindows.delete(pieceName(piece));
  else shownWindows.set(pieceName(piece), [start, Math.round(start + width)]);
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
  if (hasClass(event, "search-clip")) setStore(ids.SEARCH_TYPED, targetOf(event).value); // of thousands of clips some are offered
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
    shownWindows.delete(pieceName(piece));
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
  placeRange(around(track, ".search-source"), { ...piece, start, end: dragged.end });
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
