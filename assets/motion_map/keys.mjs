/* The side of the map: the posture under the pointer, the key sequence, how far keys reach, and the hits. */
import { element, icon } from "../shared/dom.mjs";
import { clock } from "../shared/words.mjs";
import { figurePicture } from "./figure.mjs";
import { editPosture } from "./posture_editor.mjs";

const MOST_ROWS = 60;
const AT_ONCE = 12; // rows: more cannot be seen without scrolling, so they may come a moment later
const button = (label, symbol, action, className = "map-tool") => {
  const made = element("button", className);
  made.type = "button";
  made.title = label;
  made.setAttribute("aria-label", label);
  made.append(icon(symbol));
  made.addEventListener("click", action);
  return made;
};
const short = (seconds) => (seconds >= 10 ? seconds.toFixed(0) : seconds.toFixed(1)) + " s";

/** The posture large: front, side, top, and what is known of its node. */
export function drawPreview(map, node, facts) {
  const box = document.getElementById("map-preview");
  if (!box) return;
  if (node < 0) {
    box.replaceChildren(element("p", "muted map-hint", "Point at the map to see a posture. Click postures in the order in which they should come."));
    return;
  }
  const posture = map.posture(node);
  const views = ["front", "side", "top"].map((view) => {
    const figure = element("figure", "map-view");
    figure.append(figurePicture(map, posture, view), element("figcaption", "muted", view));
    return figure;
  });
  const row = element("div", "map-views");
  row.append(...views);
  const said = box.querySelector(".map-caption") || element("div", "map-caption number");
  said.textContent = caption(map, node, facts);
  box.replaceChildren(row, said);
}

function caption(map, node, facts) {
  const [x, y] = map.place(node);
  const labels = ((facts && facts.labels) || [])[node] || [];
  const named = labels.filter(([, seconds]) => seconds >= 0.05).slice(0, 3).map(([k, seconds]) => `${facts.names[k]} ${short(seconds)}`).join(", ");
  const time = map.seconds[node] > 0 ? `${short(map.seconds[node])} of motion` : "no motion here";
  return `Node ${x}, ${y} · region ${map.regions[node]} · ${time}${named ? ` · ${named}` : ""}`;
}

/** The numbered strip: drag, or use the arrow buttons or keys, to reorder; remove with the cross or Delete. */
export function drawStrip(map, keys, change) {
  const box = document.getElementById("map-keys");
  if (!box) return;
  const focused = [...box.children].indexOf(document.activeElement?.closest?.(".map-key-card"));
  const move = (from, to) => {
    if (to < 0 || to >= keys.length || from === to) return;
    const next = [...keys];
    next.splice(to, 0, ...next.splice(from, 1));
    change(next, to);
  };
  const remove = (k) => change(keys.filter((_, i) => i !== k), Math.min(k, keys.length - 2));
  box.replaceChildren(...keys.map((node, k) => {
    const card = element("div", "map-key-card");
    card.tabIndex = 0;
    card.draggable = true;
    card.setAttribute("role", "listitem");
    const [x, y] = map.place(node);
    card.setAttribute("aria-label", `Key ${k + 1} of ${keys.length}, node ${x}, ${y}. Left and right move it, Delete removes it.`);
    const tools = element("div", "map-key-tools");
    tools.append(
      button(`Move key ${k + 1} before the one in front`, "left", () => move(k, k - 1)),
      button(`Change the posture of key ${k + 1}`, "edit", () => editPosture(node, k, change)),
      button(`Move key ${k + 1} behind the next`, "right", () => move(k, k + 1)),
      button(`Remove key ${k + 1}`, "close", () => remove(k)),
    );
    tools.children[0].disabled = k === 0;
    tools.children[2].disabled = k === keys.length - 1;
    card.append(element("span", "map-key-number", String(k + 1)), figurePicture(map, map.posture(node), "icon"), tools);
    card.addEventListener("keydown", (event) => {
      if (event.target !== card) return;
      if (event.key === "ArrowLeft") move(k, k - 1);
      else if (event.key === "ArrowRight") move(k, k + 1);
      else if (event.key === "Delete" || event.key === "Backspace") remove(k);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    card.addEventListener("dragstart", (event) => event.dataTransfer.setData("text/plain", String(k)));
    card.addEventListener("dragover", (event) => event.preventDefault());
    card.addEventListener("drop", (event) => {
      event.preventDefault();
      const from = Number.parseInt(event.dataTransfer.getData("text/plain"), 10);
      if (Number.isInteger(from)) move(from, k);
    });
    return card;
  }));
  if (!keys.length) box.append(element("p", "muted map-hint", "No keys yet: click a posture on the map."));
  if (focused >= 0) box.children[Math.min(focused, box.children.length - 1)]?.focus?.({ preventScroll: true });
}

const said = (n, keys) => (!keys.length ? "" : n === 1 ? "1 hit" : `${n} hits`);

export function drawCount(n, keys, files) {
  const box = document.getElementById("map-count");
  if (box) box.textContent = said(n, keys) + (n ? ` in ${files} clip${files === 1 ? "" : "s"}` : "");
}

let later = 0;
/** The hits as rows that play on a click. dataset, version: of the clips. */
export function drawHits(map, hits, keys, { dataset, version, chosen }) {
  const box = document.getElementById("map-hits");
  if (!box) return;
  clearTimeout(later);
  if (!hits.length) {
    const hint = keys.length
      ? "Nothing passes these postures in this order. Let the keys reach farther, or remove one."
      : "Choose one or more postures on the map: every stretch of motion that passes through them in order is listed here.";
    box.replaceChildren(element("p", "muted map-hint", hint));
    return;
  }
  const row = (hit, k) => {
    const segment = map.segment(hit);
    const { fps } = map.clips[hit.clip];
    const made = element("button", "motion-row map-hit");
    made.type = "button";
    made.dataset.store = "selection";
    made.dataset.value = JSON.stringify(segment);
    const on = Boolean(chosen) && chosen.clip === segment.clip && chosen.start === segment.start && chosen.end === segment.end;
    made.classList.toggle("chosen", on);
    made.setAttribute("aria-pressed", String(on));
    const when = `${clock(segment.start / fps)} to ${clock(segment.end / fps)}`;
    made.title = `Play ${segment.clip}, ${when}; postures ${hit.distance.toFixed(2)} m from the keys`;
    const picture = element("img", "motion-strip");
    const asked = new URLSearchParams({ start: segment.start, end: segment.end, n: 5, v: version });
    const address = `/api/filmstrip/${encodeURIComponent(dataset)}/${segment.clip.split("/").map(encodeURIComponent).join("/")}?${asked}`;
    Object.assign(picture, { loading: "lazy", alt: "", draggable: false, src: address });
    made.append(element("span", "map-rank number muted", String(k + 1)), element("span", "ellipsis motion-clip", segment.clip),
      element("span", "muted number motion-time", when), picture);
    return made;
  };
  box.replaceChildren(...hits.slice(0, AT_ONCE).map(row));
  const rest = () => {
    box.append(...hits.slice(AT_ONCE, MOST_ROWS).map((hit, k) => row(hit, AT_ONCE + k)));
    if (hits.length > MOST_ROWS) box.append(element("div", "muted selection-more", `and ${hits.length - MOST_ROWS} more`));
  };
  if (hits.length > AT_ONCE) later = setTimeout(rest, 50);
}

/** Mark the row of what is selected. */
export function markHit(chosen) {
  for (const row of document.querySelectorAll(".map-hit")) {
    const segment = JSON.parse(row.dataset.value);
    const on = Boolean(chosen) && ["clip", "start", "end"].every((key) => segment[key] === chosen[key]);
    row.classList.toggle("chosen", on);
    row.setAttribute("aria-pressed", String(on));
  }
}

