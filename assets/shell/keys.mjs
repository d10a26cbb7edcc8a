// Keys that are the same on every page: "?" lists all of them, Ctrl+Z takes back what a notice offers to undo.
import { openWindow } from "../shared/dialogs.mjs";
import { allWithin, closest, element } from "../shared/dom.mjs";

/** @type {[string, [string, string][]][]} */
const KEYS = [
  ["Everywhere", [["Ctrl K", "go to a page, a clip, a motif, a setting, a board"], ["?", "these keys"], ["Ctrl Z", "undo the last change"], ["Tab", "to the next control"], ["Esc", "close a window"]]],
  ["Tables", [["↑ ↓", "from row to row"], ["Enter", "play the row, or open its link"], ["Space", "choose the row"]]],
  ["Motif graph", [["arrows", "move"], ["+ −", "closer, further away"], ["0", "show all"]]],
];

/** Whether someone writes there. @param {Event} event */
const writing = (event) => closest(event, "input:not([type=checkbox], [type=radio], [type=range]), textarea, select, [contenteditable=true]") !== null;

/** @param {string} title @param {Element[]} entries */
const section = (title, entries) => element("section", "", element("h3", "", title), element("dl", "keys-list", ...entries));

/** The window with all keys; those of the Stage as the Stage lists them. */
export function showKeys() {
  const stage = allWithin(document, ".ms-help dt, .ms-help dd").map((node) => /** @type {Element} */ (node.cloneNode(true)));
  openWindow("Keyboard shortcuts", element("div", "keys",
    ...KEYS.map(([title, keys]) => section(title, keys.flatMap(([key, what]) => [element("dt", "", key), element("dd", "", what)]))),
    section("Stage, when it has the focus", stage)));
}

document.addEventListener("keydown", (event) => {
  if (event.defaultPrevented || event.altKey || writing(event) || document.querySelector("dialog[open]")) return;
  const control = event.ctrlKey || event.metaKey;
  if (event.key === "?" && !control) showKeys();
  else if (event.key.toLowerCase() === "z" && control && !event.shiftKey && lastUndo()) lastUndo()?.click();
  else return;
  event.preventDefault();
});

/** The newest button that is shown and offers to undo. */
function lastUndo() {
  const buttons = allWithin(document, '[data-store="undo"], .boards-toast button').filter((button) => button.getClientRects().length && button.textContent === "Undo");
  return buttons.at(-1);
}
