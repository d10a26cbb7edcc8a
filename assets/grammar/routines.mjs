/* The routines of the recordings as strings of coloured squares, and the tree of the chosen one. */
import { changeView, setStore } from "../shared/dash.mjs";
import { allWithin, closest, element, find, need, setLink } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { clock, plural } from "../shared/words.mjs";
import { ahead } from "../stage/ahead.mjs";
import * as ids from "./ids.mjs";
import { actionOf, downloadQuery, isFresh, redraw, state } from "./state.mjs";
import { lightTree, showTree } from "./tree.mjs";
/** @import { GrammarData, Routine, ShownRoutine } from "./types.d.ts" */
/** @import { View } from "../shared/types.d.ts" */

/** The routine whose tree is shown. @type {{ routine?: Routine, number?: number }} */
let now = {};

/** @param {Routine} routine @param {number} first @param {number} end */
const selectionOf = (routine, first, end) => ({
  clip: routine.clip, start: routine.leaves[first][0], end: routine.leaves[end - 1][1], as: "actions",
});

/** @param {Routine} routine @param {number} number @param {string | undefined} brief */
function row(routine, number, brief) {
  const line = element("li");
  const button = element("button", "routine-row");
  button.type = "button";
  button.dataset.routine = String(number);
  const name = `${routine.clip}, ${clock(routine.seconds[0])} to ${clock(routine.seconds[1])}`;
  button.setAttribute("aria-label", `Routine ${number + 1}: ${name}, ${plural(routine.actions.length, "action")}`);
  button.title = `${name}: ${routine.actions.map((id) => actionOf(id).name).join(", ")}`;
  const squares = element("span", "routine-squares");
  squares.append(...routine.actions.map((id) => {
    const square = element("span", "routine-square");
    square.style.setProperty("--tone", actionOf(id).colour);
    return square;
  }));
  button.append(element("span", "number routine-number", String(number + 1)), element("span", "ellipsis routine-clip", brief),
    element("span", "muted number", clock(routine.seconds[0])), squares);
  line.append(button);
  return line;
}

/** @param {Routine} routine @param {number} [first] @param {number} [end] */
function play(routine, first = 0, end = routine.leaves.length) {
  const selection = selectionOf(routine, first, end);
  ahead.play(selection);
  setStore(SELECTION, selection);
}

/** @param {ShownRoutine | null} shown @param {GrammarData | null} data @param {View | null} view */
export const drawRoutines = (shown, data, view) => {
  const list = find(ids.ROUTINE_LIST);
  if (!list || !data?.routines) return;
  if (isFresh(list, [data.key, data.names])) {
    const brief = new Map(data.rows.map((clip) => [clip.clip, clip.brief]));
    redraw(list, data.routines.map((routine, number) => row(routine, number, brief.get(routine.clip))));
  }
  if (!shown || shown.key !== data.key) return;
  const routine = data.routines[shown.number];
  now = { routine, number: shown.number };
  for (const button of allWithin(list, ".routine-row")) {
    const here = Number(button.dataset.routine) === shown.number;
    button.classList.toggle("chosen", here);
    button.setAttribute("aria-pressed", String(here));
  }
  need(ids.ROUTINE_TITLE).textContent = `Routine ${shown.number + 1}`;
  need(ids.ROUTINE_COUNT).textContent = `${routine.clip}, ${plural(routine.actions.length, "action")}`;
  showTree(need(ids.ROUTINE_TREE), shown.svg, ({ first, end }) => play(routine, first, end));
  setLink(ids.ROUTINE_SVG, `/api/grammar-tree.svg?${downloadQuery(view, { routine: shown.number })}`);
};

document.addEventListener("click", (event) => {
  if (closest(event, `#${ids.ROUTINE_PLAY}`) && now.routine) play(now.routine);
  const button = closest(event, ".routine-row");
  if (!button) return;
  const number = Number(button.dataset.routine);
  changeView({ routine: number ? String(number) : "" });
  play(state.data.routines[number]);
});

window.addEventListener("stage-frame", (event) => {
  const box = find(ids.ROUTINE_TREE);
  if (!box?.offsetParent || !now.routine) return;
  const item = event.detail.items[0];
  const here = item && item.clip === now.routine.clip && item.dataset === state.data.dataset;
  lightTree(box, here ? now.routine.leaves.findIndex(([start, end]) => item.frame >= start && item.frame < end) : -1);
});
