// What the Grammar page shows now, and the pieces that all its parts draw with.
import { element } from "../shared/dom.mjs";
import { plural } from "../shared/words.mjs";

/** `data`: what the server says of the result that is shown. */
export const state = { data: {} };

export const actionOf = (id) => (state.data.actions || [])[id] || { id, name: `Action ${id}`, short: String(id), colour: "#8793a3", count: 0, seconds: 0 };

/** A button that puts a selection into the store. */
export const playsSelection = (button, selection) => {
  button.dataset.store = "selection";
  button.dataset.value = JSON.stringify(selection);
  return button;
};

export const paintAction = (node, action) => {
  node.style.setProperty("--tone", action.colour);
  node.style.setProperty("--ink", action.ink || "#ffffff");
};

/** A coloured box with an action's name; a click plays all its occurrences. */
export const actionChip = (id) => {
  const action = actionOf(id);
  const button = playsSelection(element("button", "action-chip", action.short), { action: id });
  button.type = "button";
  if (action.hint) button.append(element("span", "action-hint-word", action.hint));
  paintAction(button, action);
  button.title = `${action.name}: ${plural(action.count, "time")}`;
  button.dataset.action = id;
  return button;
};

/** Keep what has the focus when a list is drawn anew. */
export const redraw = (box, children) => {
  const focused = [...box.querySelectorAll("button, input, [tabindex]")].indexOf(document.activeElement);
  const top = box.scrollTop;
  box.replaceChildren(...children);
  box.scrollTop = top;
  if (focused >= 0) [...box.querySelectorAll("button, input, [tabindex]")][focused]?.focus({ preventScroll: true });
};

/** Draw only where the data differ from what is there. */
export const isFresh = (box, stamp) => {
  const text = typeof stamp === "string" ? stamp : JSON.stringify(stamp);
  if (box.drawnFrom === text) return false;
  box.drawnFrom = text;
  return true;
};

/** One thing of a row has the keyboard's focus at a time; arrows move it. */
export const arrows = (box, selector) => {
  box.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    const at = event.target.closest?.(selector);
    if (!step || !at) return;
    const all = [...box.querySelectorAll(selector)];
    const next = all[all.indexOf(at) + step];
    event.preventDefault();
    event.stopPropagation();
    next?.focus();
  });
};

/** The query of a download: the result that is shown, and what of it. */
export const downloadQuery = (view, more = {}) => {
  const pairs = new URLSearchParams({ dataset: state.data.dataset || "" });
  for (const [key, value] of Object.entries(view || {})) if (key.startsWith("grammar-")) pairs.set(key, value);
  for (const [key, value] of Object.entries(more)) pairs.set(key, value);
  return pairs.toString();
};
