/* Every recording as a string of actions along time, a row for each clip, with a cursor at what plays. */
import { allWithin, around, childrenOf, closest, element, find } from "../shared/dom.mjs";
import { clock } from "../shared/words.mjs";
import { player } from "../stage/player.mjs";
import * as ids from "./ids.mjs";
import { actionOf, isFresh, paintAction, playsSelection } from "./state.mjs";
/** @import { GrammarData, Piece, StringRow } from "./types.d.ts" */
/** @import { Selection } from "../shared/types.d.ts" */

const MOST_FIGURES = 24;

/** @param {HTMLElement} node @param {number} start @param {number} end @param {number} seconds */
const place = (node, start, end, seconds) => {
  node.style.left = `${(100 * start) / seconds}%`;
  node.style.width = `${Math.max((100 * (end - start)) / seconds, 0.15)}%`;
};

/** @param {Piece} piece @param {number} seconds */
function block([start, end, id, number], seconds) {
  const action = actionOf(id);
  const made = playsSelection(element("button", "string-block"), { action: id, segment: number });
  made.type = "button";
  made.append(element("span", "", action.short));
  made.tabIndex = -1;
  made.title = `${action.name}, ${number + 1} of ${action.count}, ${clock(start)} to ${clock(end)}`;
  made.setAttribute("aria-label", made.title);
  made.dataset.action = String(id);
  made.dataset.segment = String(number);
  paintAction(made, action);
  place(made, start, end, seconds);
  return made;
}

/** @param {StringRow} clip @param {number} longest */
function row(clip, longest) {
  const line = element("div", "string-row");
  line.setAttribute("role", "listitem");
  const head = playsSelection(element("button", "string-clip ellipsis", clip.brief), { clip: clip.clip, as: "actions" });
  head.type = "button";
  head.dataset.clip = clip.clip;
  head.title = `Play ${clip.clip} with its actions`;
  const time = element("div", "string-time");
  time.style.width = `${Math.max((100 * clip.seconds) / longest, 0.5)}%`;
  Object.assign(time.dataset, { clip: clip.clip, seconds: clip.seconds, fps: clip.fps });
  if (clip.labels.length) {
    const labels = element("div", "string-labels");
    labels.append(...clip.labels.map(([start, end, name]) => {
      const made = element("span", "string-label", name);
      made.title = `${name}, ${clock(start)} to ${clock(end)}`;
      place(made, start, end, clip.seconds);
      return made;
    }));
    time.append(labels);
  }
  const blocks = element("div", "string-blocks");
  blocks.append(...clip.pieces.map((piece) => block(piece, clip.seconds)));
  if (childrenOf(blocks)[0]) childrenOf(blocks)[0].tabIndex = 0;
  for (const cut of clip.cuts) {
    const mark = element("span", "string-cut");
    mark.style.left = `${(100 * cut) / clip.seconds}%`;
    blocks.append(mark);
  }
  time.append(blocks, element("div", "string-now"));
  const track = element("div", "string-track");
  track.append(time);
  line.append(head, track);
  return line;
}

/** @param {GrammarData} data */
export const drawString = (data) => {
  const box = find(ids.GRAMMAR_STRING);
  if (!box || !isFresh(box, [data.key, data.names])) return;
  const longest = Math.max(...data.rows.map((clip) => clip.seconds), 1e-3);
  box.replaceChildren(...data.rows.map((clip) => row(clip, longest)));
};

/**
 * The chosen action stands out, in the string and wherever else it is drawn.
 * @param {Selection | null} selection
 */
export const markChosen = (selection) => {
  const chosen = selection?.action === undefined ? null : String(selection.action);
  const box = find(ids.GRAMMAR_STRING);
  if (!box) return;
  box.classList.toggle("one-action", chosen !== null);
  for (const made of allWithin(box, ".string-block")) {
    const same = made.dataset.action === chosen;
    made.classList.toggle("same", same);
    made.setAttribute("aria-pressed", String(same && made.dataset.segment === String(selection?.segment)));
  }
  for (const head of allWithin(box, ".string-clip")) head.classList.toggle("chosen", selection?.clip === head.dataset.clip);
};

document.addEventListener("keydown", (event) => {
  const at = closest(event, ".string-block");
  if (!at) return;
  const lines = allWithin(around(at, `#${ids.GRAMMAR_STRING}`), ".string-blocks");
  const siblings = /** @type {any} */ (at.parentNode);
  const line = lines.indexOf(siblings);
  const blocks = allWithin(siblings, ".string-block");
  const number = blocks.indexOf(at);
  /** @type {Record<string, () => HTMLElement | null | undefined>} */
  const ways = {
    ArrowRight: () => blocks[number + 1],
    ArrowLeft: () => blocks[number - 1],
    ArrowDown: () => lines[line + 1]?.querySelector(".string-block"),
    ArrowUp: () => lines[line - 1]?.querySelector(".string-block"),
  };
  const next = ways[event.key];
  if (!next) return;
  event.preventDefault();
  event.stopPropagation();
  next()?.focus();
});

// Zoom: the rows get wider, and what was in the middle stays there.
const LARGEST = 32;
document.addEventListener("click", (event) => {
  const button = closest(event, ".string-zoom");
  const box = button && find(ids.GRAMMAR_STRING);
  if (!box) return;
  const before = Number(box.dataset.zoom || 1);
  const zoom = Math.min(Math.max(before * (button.dataset.zoom === "in" ? 2 : 0.5), 1), LARGEST);
  const middle = box.scrollLeft + box.clientWidth / 2;
  box.dataset.zoom = String(zoom);
  box.style.setProperty("--zoom", String(zoom));
  box.scrollLeft = (middle * zoom) / before - box.clientWidth / 2;
});

/**
 * Scrolls on when the cursor of a single motion leaves the visible part.
 * @param {HTMLElement} box
 * @param {HTMLElement} line
 */
function follow(box, line) {
  if (Number(box.dataset.zoom || 1) === 1 || !player.playing) return;
  const [outer, at] = [box.getBoundingClientRect(), line.getBoundingClientRect().left];
  if (at < outer.left + 140 || at > outer.right) box.scrollLeft += at - outer.left - 160;
}

/** @type {HTMLElement[]} */
let lit = [];
function cursor() {
  const box = find(ids.GRAMMAR_STRING);
  if (!box || !box.offsetParent) return;
  for (const line of lit) line.style.display = "";
  lit = [];
  for (let i = 0; i < MOST_FIGURES; i++) {
    const item = player.frameOf(i);
    if (!item) break;
    if (String(item.dataset || "").startsWith("~")) continue;
    const time = allWithin(box, `.string-time[data-clip="${CSS.escape(item.clip)}"]`)[0];
    const line = time && childrenOf(time).at(-1);
    if (!line || lit.includes(line)) continue;
    line.style.display = "block";
    line.style.left = `${(100 * item.frame) / Number(time.dataset.fps) / Number(time.dataset.seconds)}%`;
    lit.push(line);
  }
  if (lit.length === 1) follow(box, lit[0]);
}
setInterval(cursor, 80);
