/* The path of a walk as chips: click to go there, drag or Alt and arrow keys to move, Delete or × to take away. */
import { allWithin, closest, element } from "../shared/dom.mjs";
/** @import { PathActions, Walk } from "./types.d.ts" */

/** The path that is drawn, what its chips may do, and which of them takes the focus next. */
const path = {
  ids: /** @type {number[]} */ ([]),
  actions: /** @type {PathActions} */ (/** @type {any} */ (null)),
  focus: /** @type {number | undefined} */ (undefined),
};
/** @type {Record<string, string>} */
const LINKS = { further: "A further transition point, inside the motions", bridge: "Bridged by a blend: not in the recordings" };

/** @param {number[]} ids @param {number} from @param {number} to */
function moved(ids, from, to) {
  const next = [...ids];
  next.splice(to, 0, ...next.splice(from, 1));
  return next;
}

/** @param {number[]} ids @param {number} at */
const without = (ids, at) => ids.filter((_, i) => i !== at);

/** @param {number} motif @param {number} at @param {Walk} data @param {PathActions} actions */
function chip(motif, at, data, actions) {
  const name = data.motifs?.find((one) => one.id === motif)?.name || "";
  const item = element("li", "walk-step");
  const kind = data.kinds?.[at - 1];
  if (at && kind && kind !== "seen") {
    const mark = element("span", "walk-link", "⇢");
    mark.title = LINKS[kind];
    item.append(mark);
  }
  const box = element("span", "walk-chip");
  box.draggable = true;
  box.dataset.at = String(at);
  if (data.gap && at && data.path[at - 1] === data.gap[0] && motif === data.gap[1]) box.classList.add("gap");
  if (data.dead?.includes(motif) && at === data.path.length - 1) box.classList.add("dead");
  const go = element("button", "walk-go");
  go.type = "button";
  go.append(element("b", "", String(motif)));
  if (name) go.append(element("span", "walk-name", name));
  go.title = `Motif ${motif}${name ? `, ${name}` : ""}: play from here. Alt and arrow keys move it, Delete takes it away.`;
  go.addEventListener("click", () => actions.jump(at));
  go.addEventListener("keydown", (event) => {
    const ids = data.path;
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.altKey && step && at + step >= 0 && at + step < ids.length) {
      path.focus = at + step;
      actions.write(moved(ids, at, at + step));
    } else if (event.key === "Delete" || event.key === "Backspace") {
      path.focus = Math.max(0, at - 1);
      actions.write(without(ids, at));
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });
  const away = element("button", "walk-away", "×");
  away.type = "button";
  away.title = "Take away";
  away.setAttribute("aria-label", `Take motif ${motif} away`);
  away.addEventListener("click", () => actions.write(without(data.path, at)));
  box.append(go, away);
  item.append(box);
  return item;
}

/**
 * Dragging: a chip is moved to where it is dropped.
 * @param {HTMLElement} list
 */
function watch(list) {
  if (list.dataset.watched) return;
  list.dataset.watched = "yes";
  /** @type {number | null} */
  let held = null;
  /** @param {DragEvent} event */
  const place = (event) => closest(event, ".walk-chip");
  list.addEventListener("dragstart", (event) => {
    held = Number(place(event)?.dataset.at);
    if (!event.dataTransfer) return;
    event.dataTransfer.effectAllowed = "move";
    event.dataTransfer.setData("text/plain", String(held));
  });
  list.addEventListener("dragover", (event) => {
    if (held === null || !place(event)) return;
    event.preventDefault();
    for (const box of allWithin(list, ".walk-chip")) box.classList.toggle("over", box === place(event));
  });
  list.addEventListener("drop", (event) => {
    const to = place(event);
    if (held === null || !to) return;
    event.preventDefault();
    if (Number(to.dataset.at) !== held) path.actions.write(moved(path.ids, held, Number(to.dataset.at)));
  });
  list.addEventListener("dragend", () => {
    held = null;
    for (const box of allWithin(list, ".over")) box.classList.remove("over");
  });
}

/** @param {HTMLElement} list @param {Walk} data @param {PathActions} actions */
export function drawPath(list, data, actions) {
  watch(list);
  path.ids = data.path || [];
  path.actions = actions;
  const stamp = JSON.stringify([data.path, data.kinds, data.gap, data.dead, data.motifs]);
  if (list.dataset.stamp === stamp) return;
  list.dataset.stamp = stamp;
  list.replaceChildren(...path.ids.map((motif, at) => chip(motif, at, data, actions)));
  const focused = path.focus === undefined ? null : allWithin(list, ".walk-go")[path.focus];
  path.focus = undefined;
  if (focused) focused.focus();
}

/**
 * The motif that plays now; none where `visit` is -1.
 * @param {HTMLElement | null} list
 * @param {number} visit
 */
export function lightVisit(list, visit) {
  if (!list) return;
  allWithin(list, ".walk-chip").forEach((box, at) => {
    const here = at === visit;
    box.classList.toggle("lit", here);
    if (here) box.setAttribute("aria-current", "true");
    else box.removeAttribute("aria-current");
    // only the list scrolls, not the page
    if (here) {
      const [outer, inner] = [list.getBoundingClientRect(), box.getBoundingClientRect()];
      if (inner.top < outer.top || inner.bottom > outer.bottom) list.scrollTop += inner.top - outer.top - 4;
    }
  });
}
