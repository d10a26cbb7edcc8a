/* The timeline of all clips: a row for each clip, labels above motifs. Rows out of sight are not drawn. */
import { clientside, register } from "../shared/dash.mjs";
import { allWithin, around, childrenOf, closest, element, find, need } from "../shared/dom.mjs";
import { drawings } from "../shared/downloads.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { clock } from "../shared/words.mjs";
import { player } from "../stage/player.mjs";
import * as ids from "./ids.mjs";
/** @import { TimelineData, TimelineRow } from "./types.d.ts" */
/** @import { Selection } from "../shared/types.d.ts" */

/** @param {HTMLElement} node @param {number} start @param {number} end @param {number} seconds */
const place = (node, start, end, seconds) => {
  node.style.left = (100 * start) / seconds + "%";
  node.style.width = Math.max((100 * (end - start)) / seconds, 0.15) + "%";
};

/** @param {[start: number, end: number, action: number]} label @param {TimelineData} data @param {number} seconds */
function labelBlock([start, end, action], { actions, colours }, seconds) {
  const block = element("span", "timeline-label", actions[action]);
  block.title = `${actions[action]}, ${clock(start)} to ${clock(end)}`;
  block.style.setProperty("--tone", colours[action]);
  place(block, start, end, seconds);
  return block;
}

/**
 * @param {[start: number, end: number, motif: number, motion: number]} place
 * @param {TimelineData["motifs"]} motifs
 * @param {number} seconds
 */
function motionBlock([start, end, motif, number], motifs, seconds) {
  const { name, colour: tone, motions } = motifs[motif];
  const block = element("button", "timeline-motion");
  block.append(element("span", motif < 100 ? "" : "timeline-hundred", String(motif)));
  block.type = "button";
  block.tabIndex = -1;
  block.title = `${name}, motion ${number + 1} of ${motions}, ${clock(start)} to ${clock(end)}`;
  block.setAttribute("aria-label", block.title);
  block.dataset.store = SELECTION;
  block.dataset.value = JSON.stringify({ motif, motion: number });
  block.dataset.motif = String(motif);
  block.style.setProperty("--tone", tone);
  place(block, start, end, seconds);
  return block;
}

/** @param {TimelineRow} clip @param {TimelineData} data @param {number} longest @param {boolean} fill */
function row(clip, data, longest, fill) {
  const line = element("div", "timeline-row");
  line.setAttribute("role", "listitem");
  const head = element("button", "timeline-clip");
  head.type = "button";
  head.title = `Play ${clip.clip}`;
  head.setAttribute("aria-label", `${head.title}, ${Math.round(100 * clip.share)} % in motifs`);
  head.dataset.store = SELECTION;
  head.dataset.value = JSON.stringify({ clip: clip.clip });
  head.append(element("span", "ellipsis", clip.brief), element("span", "muted number", `${Math.round(100 * clip.share)} %`));
  const track = element("div", "timeline-track");
  const time = element("div", "timeline-time");
  time.style.width = fill ? "100%" : Math.max((100 * clip.seconds) / longest, 0.5) + "%";
  time.dataset.clip = clip.clip;
  time.dataset.seconds = String(clip.seconds);
  time.dataset.fps = String(clip.fps);
  if (data.actions.length) {
    const labels = element("div", "timeline-labels");
    labels.append(...clip.labels.map((label) => labelBlock(label, data, clip.seconds)));
    time.append(labels);
  }
  const motions = element("div", "timeline-motions");
  motions.append(...clip.motions.map((motion) => motionBlock(motion, data.motifs, clip.seconds)));
  if (childrenOf(motions)[0]) childrenOf(motions)[0].tabIndex = 0;
  time.append(motions, element("div", "timeline-now"));
  track.append(time);
  line.append(head, track);
  return line;
}

/** @param {TimelineRow[]} rows @param {string} order @param {number | string | undefined} motif */
function ordered(rows, order, motif) {
  /** @param {TimelineRow} row */
  const has = ({ motions }) => motions.filter((motion) => String(motion[2]) === String(motif)).length;
  if (order === "share") return [...rows].sort((a, b) => a.share - b.share);
  if (order === "chosen") return [...rows].sort((a, b) => has(b) - has(a));
  return rows;
}

/** @param {HTMLElement} box @param {TimelineData} data */
function legend(box, { actions, colours }) {
  box.replaceChildren(...actions.slice(0, 24).map((action, i) => {
    const entry = element("span", "timeline-key", action);
    entry.style.setProperty("--tone", colours[i]);
    return entry;
  }));
  if (actions.length > 24) box.append(element("span", "muted", `and ${actions.length - 24} more`));
}

/** @param {HTMLElement} box @param {Selection | null} selection */
function mark(box, selection) {
  chosen = selection;
  const motif = selection && selection.motif !== undefined ? String(selection.motif) : null;
  box.classList.toggle("one-motif", motif !== null);
  for (const block of allWithin(box, ".timeline-motion")) {
    block.classList.toggle("same", block.dataset.motif === motif);
    const { motion } = JSON.parse(block.dataset.value ?? "{}");
    block.setAttribute("aria-pressed", String(block.dataset.motif === motif && String(selection?.motion) === String(motion)));
  }
  for (const head of allWithin(box, ".timeline-clip")) {
    head.classList.toggle("chosen", Boolean(selection && selection.clip === JSON.parse(head.dataset.value ?? "{}").clip));
  }
}

// Arrow keys go from block to block and from row to row; one block of a row can be reached with Tab.
/** @param {KeyboardEvent} event */
function move(event) {
  const block = closest(event, ".timeline-motion");
  if (!block) return;
  const motions = /** @type {HTMLInputElement} */ (block.parentNode);
  const siblings = childrenOf(motions);
  const lines = allWithin(around(block, ".timeline-rows"), ".timeline-motions:not(:empty)");
  const at = siblings.indexOf(block);
  const line = lines.indexOf(motions);
  /** @type {Record<string, () => HTMLElement | undefined>} */
  const ways = {
    ArrowRight: () => siblings[at + 1],
    ArrowLeft: () => siblings[at - 1],
    ArrowDown: () => lines[line + 1] && childrenOf(lines[line + 1])[0],
    ArrowUp: () => lines[line - 1] && childrenOf(lines[line - 1])[0],
  };
  const next = ways[event.key];
  if (!next) return;
  event.preventDefault();
  event.stopPropagation();
  next()?.focus();
}
document.addEventListener("keydown", move);

// The cursor of what plays, in the row of its clip.
/** @type {HTMLElement[]} */
let shown = [];
function cursor() {
  const box = find(ids.TIMELINE_ROWS);
  if (!box || !box.offsetParent) return;
  const now = new Map();
  for (let i = 0; i < 24; i++) {
    const item = player.frameOf(i);
    if (!item) break;
    if (!String(item.dataset || "").startsWith("~")) now.set(item.clip, item.frame);
  }
  for (const line of shown) if (!now.has(line.parentElement?.dataset.clip ?? "")) line.style.display = "";
  shown = [];
  for (const [clip, frame] of now) {
    const time = allWithin(box, `.timeline-time[data-clip="${CSS.escape(clip)}"]`)[0];
    const line = time && childrenOf(time).at(-1);
    if (!line) continue;
    line.style.display = "block";
    line.style.left = (100 * frame) / Number(time.dataset.fps) / Number(time.dataset.seconds) + "%";
    shown.push(line);
  }
}
setInterval(cursor, 80);

/** @type {{ data: TimelineData, order: string, scale: string, motif: number | string | null | undefined } | null} */
let drawn = null;

/**
 * Where the drawing of what is shown lies: this order, scale, motif and theme.
 * @param {Selection | null} selection
 */
function drawing(selection) {
  if (!drawn) return null;
  const motif = selection && selection.motif !== undefined ? { motif: String(selection.motif) } : null;
  const scheme = document.documentElement.dataset.mantineColorScheme || "light";
  return `${drawn.data.drawing}&${new URLSearchParams({ order: drawn.order, scale: drawn.scale, ...motif, scheme })}`;
}
/** @type {Selection | null} */
let chosen = null;
drawings.timeline = () => drawing(chosen);

/** @param {TimelineData | null} data @param {string} order @param {string} scale @param {Selection | null} selection */
function draw(data, order, scale, selection) {
  const box = find(ids.TIMELINE_ROWS);
  if (!box || !data) return clientside.no_update;
  const wanted = { data, order, scale, motif: order === "chosen" ? (selection || {}).motif : null };
  const same = drawn && box.firstChild && data === drawn.data && order === drawn.order && scale === drawn.scale && wanted.motif === drawn.motif;
  if (!same) {
    drawn = wanted;
    const longest = Math.max(...data.rows.map((clip) => clip.seconds), 1e-3);
    const rows = ordered(data.rows, order, (selection || {}).motif);
    box.classList.toggle("labelled", data.actions.length > 0);
    box.replaceChildren(...rows.map((clip) => row(clip, data, longest, scale === "fill")));
    legend(need(ids.TIMELINE_LEGEND), data);
  }
  mark(box, selection);
  return clientside.no_update;
}

register("timeline", {
  draw,
  /** @param {Selection | null} selection @param {string} order */
  mark(selection, order) {
    if (drawn && order === "chosen") draw(drawn.data, order, drawn.scale, selection);
    const box = find(ids.TIMELINE_ROWS);
    if (box) mark(box, selection);
    return clientside.no_update;
  },
});
