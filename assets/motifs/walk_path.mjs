/* The path of a walk as chips: click to go there, drag or Alt and arrow keys to move, Delete or × to take away. */
import { element } from "../shared/dom.mjs";

const path = { ids: [], hands: null, focus: undefined };
const LINKS = { further: "A further transition point, inside the motions", bridge: "Bridged by a blend: not in the recordings" };

function moved(ids, from, to) {
  const next = [...ids];
  next.splice(to, 0, ...next.splice(from, 1));
  return next;
}

const without = (ids, at) => ids.filter((_, i) => i !== at);

function chip(motif, at, data, hands) {
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
  box.dataset.at = at;
  if (data.gap && at && data.path[at - 1] === data.gap[0] && motif === data.gap[1]) box.classList.add("gap");
  if (data.dead?.includes(motif) && at === data.path.length - 1) box.classList.add("dead");
  const go = element("button", "walk-go");
  go.type = "button";
  go.append(element("b", "", String(motif)));
  if (name) go.append(element("span", "walk-name", name));
  go.title = `Motif ${motif}${name ? `, ${name}` : ""}: play from here. Alt and arrow keys move it, Delete takes it away.`;
  go.addEventListener("click", () => hands.jump(at));
  go.addEventListener("keydown", (event) => {
    const ids = data.path;
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.altKey && step && at + step >= 0 && at + step < ids.length) {
      path.focus = at + step;
      hands.write(moved(ids, at, at + step));
    } else if (event.key === "Delete" || event.key === "Backspace") {
      path.focus = Math.max(0, at - 1);
      hands.write(without(ids, at));
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });
  const away = element("button", "walk-away", "×");
  away.type = "button";
  away.title = "Take away";
  away.setAttribute("aria-label", `Take motif ${motif} away`);
  away.addEventListener("click", () => hands.write(without(data.path, at)));
  box.append(go, away);
  item.append(box);
  return item;
}

/** Dragging: the chip that is held goes where it is let go. */
function watch(list) {
  if (list.dataset.watched) return;
  list.dataset.watched = "yes";
  let held = null;
  const place = (event) => event.target.closest?.(".walk-chip");
  list.addEventListener("dragstart", (event) => {
    held = Number(place(event)?.dataset.at);
    event.dataTransfer.effectAllowed = "move";
    event.dataTransfer.setData("text/plain", String(held));
  });
  list.addEventListener("dragover", (event) => {
    if (held === null || !place(event)) return;
    event.preventDefault();
    for (const box of list.querySelectorAll(".walk-chip")) box.classList.toggle("over", box === place(event));
  });
  list.addEventListener("drop", (event) => {
    const to = place(event);
    if (held === null || !to) return;
    event.preventDefault();
    if (Number(to.dataset.at) !== held) path.hands.write(moved(path.ids, held, Number(to.dataset.at)));
  });
  list.addEventListener("dragend", () => {
    held = null;
    for (const box of list.querySelectorAll(".over")) box.classList.remove("over");
  });
}

export function drawPath(list, data, hands) {
  watch(list);
  path.ids = data.path || [];
  path.hands = hands;
  const stamp = JSON.stringify([data.path, data.kinds, data.gap, data.dead, data.motifs]);
  if (list.dataset.stamp === stamp) return;
  list.dataset.stamp = stamp;
  list.replaceChildren(...path.ids.map((motif, at) => chip(motif, at, data, hands)));
  const focused = path.focus === undefined ? null : list.querySelectorAll(".walk-go")[path.focus];
  path.focus = undefined;
  if (focused) focused.focus();
}

/** The motif that plays now; none where `visit` is -1. */
export function lightVisit(list, visit) {
  if (!list) return;
  list.querySelectorAll(".walk-chip").forEach((box, at) => {
    const here = at === visit;
    box.classList.toggle("lit", here);
    if (here) box.setAttribute("aria-current", "true");
    else box.removeAttribute("aria-current");
    // the list scrolls by itself, never the page
    if (here) {
      const [outer, inner] = [list.getBoundingClientRect(), box.getBoundingClientRect()];
      if (inner.top < outer.top || inner.bottom > outer.bottom) list.scrollTop += inner.top - outer.top - 4;
    }
  });
}
