/* The gait of a clip: its bouts as folding tables, and the list of its events. Drawn here, because a long walk has
   thousands of cells; those of a folded table are made when it opens. */
import { clientside, register } from "../shared/dash.mjs";
import { element, find } from "../shared/dom.mjs";
import * as ids from "./ids.mjs";
/** @import { Bout, Gait } from "./types.d.ts" */

const MOST_EVENTS = 600;

/** @param {HTMLButtonElement} button @param {string} store @param {object} value */
function sends(button, store, value) {
  button.type = "button";
  button.dataset.store = store;
  button.dataset.value = JSON.stringify(value);
  button.dataset.stamp = store === "selection" ? "" : "yes";
  return button;
}

/** @param {string[]} head @param {string[][]} rows */
function table(head, rows) {
  const made = element("table", "gait-table number");
  const top = made.createTHead().insertRow();
  for (const text of head) {
    const cell = element("th", "", text);
    cell.scope = "col";
    top.append(cell);
  }
  const body = made.createTBody();
  for (const [name, unit, ...values] of rows) {
    const row = body.insertRow();
    const first = element("th", "", name + " ");
    first.scope = "row";
    first.append(element("span", "muted", unit));
    row.append(first, ...values.map((value) => element("td", "", value)));
  }
  return made;
}

/**
 * A part that folds; `fill` gives what is in it, once.
 * @param {string} className
 * @param {HTMLElement} head
 * @param {boolean} open
 * @param {() => Node} fill
 */
function folding(className, head, open, fill) {
  const part = element("details", className);
  part.append(head);
  part.addEventListener("toggle", () => { if (part.open && part.children.length === 1) part.append(fill()); });
  part.open = open;
  return part;
}

/** @param {Gait} data @param {Bout} one @param {boolean} open */
function bout(data, one, open) {
  const head = element("summary", "gait-head");
  const select = sends(element("button", "gait-select", "Select"), "selection", { clip: data.clip, start: one.start, end: one.end });
  select.setAttribute("aria-label", `Select the frames of ${one.title}`);
  head.append(element("b", "", one.title), element("span", "muted number", one.facts));
  return element("div", "gait-row", folding("gait-bout", head, open, () => table(data.head, one.rows)), select);
}

/** @param {Gait} data */
function events(data) {
  const list = element("div", "gait-events");
  for (const [frame, seconds, side, name] of data.events.slice(0, MOST_EVENTS)) {
    const row = sends(element("button", "gait-event"), ids.CLIP_SEEK, { clip: data.clip, frame });
    row.append(element("span", "number", seconds), element("span", "muted number", `frame ${frame}`),
      element("span", `side-${side}`, side[0].toUpperCase() + side.slice(1)), element("span", "", name));
    list.append(row);
  }
  const more = data.events.length - MOST_EVENTS;
  if (more > 0) list.append(element("div", "muted", `and ${more} more: a table of the clip has them all`));
  return list;
}

register("gait", {
  /** @param {Gait | null} data */
  draw(data) {
    const place = find(ids.CLIP_GAIT);
    if (!place) return clientside.no_update;
    if (!data) place.replaceChildren();
    else if (data.why) place.replaceChildren(element("div", "muted", data.why));
    else {
      const all = folding("gait-details", element("summary", "", `${data.events.length} heel strikes and toe-offs`), false, () => events(data));
      place.replaceChildren(...data.bouts.map((one, k) => bout(data, one, k === 0)), all);
    }
    return clientside.no_update;
  },
});
