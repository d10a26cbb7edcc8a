/* The side of the map: the posture under the pointer, the key sequence, how far keys reach, and the hits. */
import { allWithin, childrenOf, element, find, icon, targetOf, withAttributes } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { clock } from "../shared/words.mjs";
import { figurePicture } from "./figure.mjs";
import * as ids from "./ids.mjs";
import { editPosture } from "./posture_editor.mjs";
/** @import { MapData } from "./data.mjs" */
/** @import { Facts, Hit } from "./types.d.ts" */
/** @import { Selection } from "../shared/types.d.ts" */

const MOST_ROWS = 60;
const AT_ONCE = 12; // rows: the others cannot be seen without scrolling and are drawn a moment later
/** @param {string} label @param {string} symbol @param {() => void} action @param {string} [className] */
const button = (label, symbol, action, className = "map-tool") => {
  const made = element("button", className);
  made.type = "button";
  made.title = label;
  made.setAttribute("aria-label", label);
  made.append(icon(symbol));
  made.addEventListener("click", action);
  return made;
};
/** @param {number} seconds */
const short = (seconds) => (seconds >= 10 ? seconds.toFixed(0) : seconds.toFixed(1)) + " s";

/**
 * The posture large: front, side, top, and what is known of its node.
 * @param {MapData} map
 * @param {number} node
 * @param {Facts | null} [facts]
 */
export function drawPreview(map, node, facts) {
  const box = find(ids.MAP_PREVIEW);
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
  const words = box.querySelector(".map-caption") || element("div", "map-caption number");
  words.textContent = caption(map, node, facts ?? null);
  box.replaceChildren(row, words);
}

/** @param {MapData} map @param {number} node @param {Facts | null} facts */
function caption(map, node, facts) {
  const [x, y] = map.place(node);
  const labels = ((facts && facts.labels) || [])[node] || [];
  const named = labels.filter(([, seconds]) => seconds >= 0.05).slice(0, 3).map(([k, seconds]) => `${facts?.names[k]} ${short(seconds)}`).join(", ");
  const time = map.seconds[node] > 0 ? `${short(map.seconds[node])} of motion` : "no motion here";
  return `Node ${x}, ${y} · region ${map.regions[node]} · ${time}${named ? ` · ${named}` : ""}`;
}

/**
 * The numbered strip: drag, or use the arrow buttons or keys, to reorder; remove with the cross or Delete.
 * @param {MapData} map
 * @param {number[]} keys
 * @param {(keys: number[], focus?: number) => void} change
 */
export function drawStrip(map, keys, change) {
  const box = find(ids.MAP_KEYS);
  if (!box) return;
  const focused = childrenOf(box).indexOf(/** @type {any} */ (document.activeElement?.closest(".map-key-card")));
  /** @param {number} from @param {number} to */
  const move = (from, to) => {
    if (to < 0 || to >= keys.length || from === to) return;
    const next = [...keys];
    next.splice(to, 0, ...next.splice(from, 1));
    change(next, to);
  };
  /** @param {number} k */
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
    childrenOf(tools)[0].disabled = k === 0;
    childrenOf(tools)[2].disabled = k === keys.length - 1;
    card.append(element("span", "map-key-number", String(k + 1)), figurePicture(map, map.posture(node), "icon"), tools);
    card.addEventListener("keydown", (event) => {
      if (targetOf(event) !== card) return;
      if (event.key === "ArrowLeft") move(k, k - 1);
      else if (event.key === "ArrowRight") move(k, k + 1);
      else if (event.key === "Delete" || event.key === "Backspace") remove(k);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    card.addEventListener("dragstart", (event) => event.dataTransfer?.setData("text/plain", String(k)));
    card.addEventListener("dragover", (event) => event.preventDefault());
    card.addEventListener("drop", (event) => {
      event.preventDefault();
      const from = Number.parseInt(event.dataTransfer?.getData("text/plain") ?? "", 10);
      if (Number.isInteger(from)) move(from, k);
    });
    return card;
  }));
  if (!keys.length) box.append(withAttributes(element("p", "muted map-hint", "No keys yet: click a posture on the map."), { role: "listitem" }));
  if (focused >= 0) childrenOf(box)[Math.min(focused, box.children.length - 1)]?.focus?.({ preventScroll: true });
}

/** @param {number} n @param {unknown[]} keys */
const hitsInWords = (n, keys) => (!keys.length ? "" : n === 1 ? "1 hit" : `${n} hits`);

/** @param {number} n @param {unknown[]} keys @param {number} files */
export function drawCount(n, keys, files) {
  const box = find(ids.MAP_COUNT);
  if (box) box.textContent = hitsInWords(n, keys) + (n ? ` in ${files} clip${files === 1 ? "" : "s"}` : "");
}

let later = 0;
/**
 * The hits as rows that play on a click. dataset, version: of the clips.
 * @param {MapData} map
 * @param {Hit[]} hits
 * @param {number[]} keys
 * @param {{ dataset: string, version: string, chosen: Selection | null }} shown
 */
export function drawHits(map, hits, keys, { dataset, version, chosen }) {
  const box = find(ids.MAP_HITS);
  if (!box) return;
  clearTimeout(later);
  if (!hits.length) {
    const hint = keys.length
      ? "Nothing passes these postures in this order. Let the keys reach farther, or remove one."
      : "Choose one or more postures on the map: every stretch of motion that passes through them in order is listed here.";
    box.replaceChildren(withAttributes(element("p", "muted map-hint", hint), { role: "listitem" }));
    return;
  }
  /** @param {Hit} hit @param {number} k */
  const row = (hit, k) => {
    const segment = map.segment(hit);
    const { fps } = map.clips[hit.clip];
    const made = element("button", "motion-row map-hit");
    made.type = "button";
    made.dataset.store = SELECTION;
    made.dataset.value = JSON.stringify(segment);
    const on = chosen !== null && chosen.clip === segment.clip && chosen.start === segment.start && chosen.end === segment.end;
    made.classList.toggle("chosen", on);
    made.setAttribute("aria-pressed", String(on));
    const when = `${clock(segment.start / fps)} to ${clock(segment.end / fps)}`;
    made.title = `Play ${segment.clip}, ${when}; postures ${hit.distance.toFixed(2)} m from the keys`;
    const picture = element("img", "motion-strip");
    const query = new URLSearchParams({ start: String(segment.start), end: String(segment.end), n: "5", v: version });
    const address = `/api/filmstrip/${encodeURIComponent(dataset)}/${segment.clip.split("/").map(encodeURIComponent).join("/")}?${query}`;
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

/**
 * Mark the row of what is selected.
 * @param {Selection | null} chosen
 */
export function markHit(chosen) {
  for (const row of allWithin(document, ".map-hit")) {
    const segment = JSON.parse(row.dataset.value ?? "{}");
    const on = chosen !== null && chosen.clip === segment.clip && chosen.start === segment.start && chosen.end === segment.end;
    row.classList.toggle("chosen", on);
    row.setAttribute("aria-pressed", String(on));
  }
}

