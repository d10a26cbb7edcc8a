// What the Grammar page shows now, and the pieces that all its parts draw with.
import { allWithin, element } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { plural } from "../shared/words.mjs";
/** @import { Action, DrawnBox, GrammarData } from "./types.d.ts" */
/** @import { Selection, View } from "../shared/types.d.ts" */

/** `data`: what the server says of the result that is shown; empty until it has. */
export const state = { data: /** @type {GrammarData} */ ({}) };

/** @param {number} id */
export const actionOf = (id) => (state.data.actions || [])[id] || { id, name: `Action ${id}`, short: String(id), colour: "#8793a3", count: 0, seconds: 0, named: 0 };

/**
 * A button that puts a selection into the store.
 * @template {HTMLElement} Kind
 * @param {Kind} button
 * @param {Selection | null} selection
 */
export const playsSelection = (button, selection) => {
  button.dataset.store = SELECTION;
  button.dataset.value = JSON.stringify(selection);
  return button;
};

/** @param {HTMLElement} node @param {Action} action */
export const paintAction = (node, action) => {
  node.style.setProperty("--tone", action.colour);
  node.style.setProperty("--ink", action.ink || "#ffffff");
};

/**
 * A coloured box with an action's name; a click plays all its occurrences.
 * @param {number} id
 */
export const actionChip = (id) => {
  const action = actionOf(id);
  const button = playsSelection(element("button", "action-chip", action.short), { action: id });
  button.type = "button";
  if (action.hint) button.append(element("span", "action-hint-word", action.hint));
  paintAction(button, action);
  button.title = `${action.name}: ${plural(action.count, "time")}`;
  button.dataset.action = String(id);
  return button;
};

/**
 * Keep what has the focus when a list is drawn anew.
 * @param {HTMLElement} box
 * @param {Node[]} children
 */
export const redraw = (box, children) => {
  const focused = allWithin(box, "button, input, [tabindex]").indexOf(/** @type {any} */ (document.activeElement));
  const top = box.scrollTop;
  box.replaceChildren(...children);
  box.scrollTop = top;
  if (focused >= 0) allWithin(box, "button, input, [tabindex]")[focused]?.focus({ preventScroll: true });
};

/**
 * Draw only where the data differ from what is there.
 * @param {DrawnBox} box
 * @param {unknown} stamp
 */
export const isFresh = (box, stamp) => {
  const text = typeof stamp === "string" ? stamp : JSON.stringify(stamp);
  if (box.drawnFrom === text) return false;
  box.drawnFrom = text;
  return true;
};

/**
 * The query of a download: the result that is shown, and what of it.
 * @param {View | null} view
 * @param {Record<string, string | number | undefined>} [more]
 */
export const downloadQuery = (view, more = {}) => {
  const pairs = new URLSearchParams({ dataset: state.data.dataset || "" });
  for (const [key, value] of Object.entries(view || {})) if (value && key.startsWith("grammar-")) pairs.set(key, value);
  for (const [key, value] of Object.entries(more)) pairs.set(key, String(value));
  return pairs.toString();
};
