/* The ranked hits: a row each with its pictures and score, and the strip that shows which parts match when. */
import { changeView, notify, setStore } from "../shared/dash.mjs";
import { allWithin, around, closest, element, find, hasClass, icon, need, targetOf, within } from "../shared/dom.mjs";
import { SELECTION, STAGE_REQUEST } from "../shared/ids.mjs";
import { player } from "../stage/player.mjs";
import { lightPart } from "./body.mjs";
import * as ids from "./ids.mjs";
import { now, searchAddress } from "./state.mjs";
import { canvasOf, paintStrip } from "./strip.mjs";
import { scoreWords } from "./words.mjs";
/** @import { Found, Hit, HitRow, Reason } from "./types.d.ts" */
/** @import { StageRequest } from "../stage/types.d.ts" */

const MORE = 30;
/** @type {Map<string, Promise<Reason>>} */
const reasons = new Map(); // address -> promise of why a hit is one
/** @type {Map<string, Reason>} */
const known = new Map(); // the same, once it is there

/**
 * Why a hit is one, and what the Stage plays of it; fetched once.
 * @param {string} name
 */
export const reasonOf = (name) => {
  const address = `/api/search/explain?${searchAddress(name)}`;
  if (!reasons.has(address)) {
    const answer = fetch(address).then(async (response) => {
      const body = await response.json().catch(() => ({}));
      if (!response.ok) throw new Error(body.error || "The server does not answer.");
      known.set(address, body);
      return body;
    });
    answer.catch(() => reasons.delete(address));
    reasons.set(address, answer);
    if (reasons.size > 400) for (const old of [...reasons.keys()].slice(0, 100)) { reasons.delete(old); known.delete(old); }
  }
  return /** @type {Promise<Reason>} */ (reasons.get(address));
};
/** @param {string} name */
const reasonNow = (name) => known.get(`/api/search/explain?${searchAddress(name)}`);

// ---- the strip ----

/** @param {HitRow} row */
function drawStrip(row) {
  const canvas = canvasOf(row);
  const name = row.dataset.hit ?? "";
  reasonOf(name).then(({ strip }) => {
    if (!canvas.isConnected) return;
    paintStrip(canvas, strip);
    row.strip = strip;
    row.classList.add("explained");
    const best = now.body.leaves.map((leaf, k) => /** @type {[number, string]} */ ([strip.means[k] ?? -1, now.body.words[leaf].toLowerCase()])).filter(([mean]) => mean >= 0)
      .sort((a, b) => b[0] - a[0]);
    if (best.length) canvas.setAttribute("aria-label", `Most alike: ${best.slice(0, 3).map(([mean, words]) => `${words} ${Math.round(100 * mean)} %`).join(", ")}`);
  }, (error) => { if (canvas.isConnected) canvas.title = error.message; });
}

const seen = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    seen.unobserve(target);
    drawStrip(/** @type {HitRow} */ (target));
  }
}, { rootMargin: "120px" });

/**
 * What the cell under the pointer means, in words.
 * @param {PointerEvent} event
 */
function describe(event) {
  const row = /** @type {HitRow | null} */ (closest(event, ".search-hit"));
  if (!row || !row.strip) return;
  const box = targetOf(event).getBoundingClientRect();
  const leaf = Math.min(Math.floor(((event.clientY - box.top) / box.height) * 10), 9);
  const cells = row.strip.rows[leaf];
  const share = Math.min(Math.max((event.clientX - box.left) / box.width, 0), 0.9999);
  const value = cells[Math.floor(share * cells.length)];
  const lead = now.found.pieces[0];
  const when = `${((share * (lead.end - lead.start)) / lead.fps).toFixed(1)} s`;
  targetOf(event).title = `${now.body.words[now.body.leaves[leaf]]}, ${when} into the query: ${value < 0 ? "not compared" : `${value} % alike`}`;
  lightPart(now.body.leaves[leaf]);
}

// ---- rows ----
/** @param {string} symbol @param {string} words @param {string} href */
function link(symbol, words, href) {
  const made = element("a", "search-tool", icon(symbol));
  Object.assign(made, { href, title: words });
  made.setAttribute("aria-label", words);
  return made;
}

/** @param {Hit} hit @param {boolean} chances */
function hitRow(hit, chances) {
  const made = element("div", "search-hit");
  made.setAttribute("role", "listitem");
  made.dataset.hit = hit.name;
  const picture = element("img", "search-strip");
  Object.assign(picture, { src: hit.strip, alt: "", loading: "lazy", draggable: false });
  const bar = element("span", "search-score-bar");
  bar.style.setProperty("--share", String(Math.min(Math.max(hit.score, 0), 1)));
  const score = element("span", "search-score", bar, element("b", "number", scoreWords(hit.score, chances)));
  if (chances) score.title = "The chance that people would call this the same action";
  const facts = element("span", "search-facts muted", [hit.when, hit.label].filter(Boolean).join(" · "));
  const words = element("span", "search-words", element("span", "search-name ellipsis", hit.clip), facts, score);
  const open = element("button", "search-open", element("span", "search-rank number", String(hit.rank)), picture, words);
  open.type = "button";
  open.title = `Compare with the query on the Stage: ${hit.clip}, frames ${hit.start} to ${hit.end}`;
  const canvas = element("canvas", "search-why");
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", "Which parts match when");
  const similar = element("button", "search-tool", icon("search"));
  similar.type = "button";
  similar.title = "More like this";
  similar.setAttribute("aria-label", `More like ${hit.clip}`);
  similar.dataset.similar = JSON.stringify({ clip: hit.clip, start: hit.start, end: hit.end });
  const bvh = link("download", "Save as BVH",
    `/api/bvh/${encodeURIComponent(now.clips.dataset)}/${encodeURIComponent(hit.clip)}?start=${hit.start}&end=${hit.end}`);
  const why = element("div", "search-why-box", element("div", "search-why-names"), canvas, element("div", "search-why-cursor"));
  made.append(open, why, element("div", "search-hit-tools", similar, bvh));
  return made;
}

/** @param {number} ms */
const took = (ms) => (ms < 10 ? `${ms.toFixed(1)} ms` : ms < 2000 ? `${Math.round(ms)} ms` : `${(ms / 1000).toFixed(1)} s`);

/** @param {HTMLElement} box @param {Found} found */
function head(box, found) {
  const { total, hits, milliseconds } = found;
  const count = hits.length < total ? `${hits.length} of ${total}` : `${total}`;
  const noun = found.level === "clip" ? "clip" : "moment";
  const others = found.unlike ? `; ${found.unlike} more are unlike it` : "";
  box.replaceChildren(element("h2", "", "Hits"),
    element("span", "muted number", `${count} ${noun}${total === 1 ? "" : "s"}, found in ${took(milliseconds)}${others}`),
    element("span", "spacer"), element("span", "search-key muted", "which parts match when: ", element("i", "search-key-none"), " not at all", element("i", "search-key-full"), " alike"));
}

let drawn = "";
export const drawHits = () => {
  const box = find(ids.SEARCH_HITS);
  if (!box) return;
  const title = need(ids.SEARCH_HITS_HEAD), error = need(ids.SEARCH_ERROR);
  const found = now.found || {};
  error.textContent = found.error || "";
  error.classList.toggle("hidden", !found.error);
  const ready = Boolean(found.hits);
  box.classList.toggle("hidden", !ready);
  title.classList.toggle("hidden", !ready);
  if (!ready) {
    drawn = "";
    box.replaceChildren();
    return;
  }
  const mark = JSON.stringify([found.inputs, now.scheme]);
  if (mark !== drawn || !box.firstChild) {
    drawn = mark;
    head(title, found);
    const rows = found.hits.map((hit) => hitRow(hit, Boolean(found.chances)));
    box.replaceChildren(...rows);
    if (!rows.length) box.append(element("p", "muted search-nothing", nothing(found)));
    for (const one of rows) seen.observe(one);
    if (found.hits.length < found.total && found.hits.length < 300) box.append(more(found));
  }
  choose();
};

/** @param {Found} found */
const nothing = (found) => (found.unlike
  ? `No ${found.level === "clip" ? "clip" : "other moment"} is like this query: the chance that any shows the same action is below 1 %.`
  : found.inputs.label || found.inputs.named || found.inputs.lasting
  ? "Nothing passes these filters. Widen them, or look for moments instead of whole clips."
  : "Nothing else is there to compare with. Add recordings, or choose another query.");

/** @param {Found} found */
function more(found) {
  const made = element("button", "search-button search-more", `Show more (${found.total - found.hits.length} left)`);
  made.type = "button";
  made.addEventListener("click", () => changeView({ top: String(Math.min(found.hits.length + MORE, 300)) }));
  return made;
}

function choose() {
  for (const one of allWithin(document, ".search-hit")) {
    const chosen = one.dataset.hit === now.view.hit;
    if (chosen !== one.classList.contains("chosen")) {
      one.classList.toggle("chosen", chosen);
      const names = within(one, ".search-why-names");
      names.replaceChildren(...(chosen ? now.body.leaves.map((leaf) => {
        const name = element("span", "", now.body.words[leaf]);
        name.dataset.part = leaf;
        return name;
      }) : []));
      const { strip } = /** @type {HitRow} */ (one);
      if (strip) paintStrip(canvasOf(one), strip);
    }
    within(one, ".search-open").setAttribute("aria-pressed", String(chosen));
  }
}

// ---- the Stage ----
let playing = "";
/** Plays the query, or the query and the chosen hit in step. */
export const playHits = async () => {
  const { found, view } = now;
  if (!found || !found.request || (view.look && view.look !== "search")) return;
  const wanted = JSON.stringify([found.request, view.hit || "", view.parts || ""]);
  if (wanted === playing && player.status !== "empty") return;
  const first = playing === "";
  playing = wanted;
  if (!view.hit) return put(found.request, first);
  try {
    const { request } = reasonNow(view.hit) || (await reasonOf(view.hit));
    if (playing === wanted) put(request, first);
  } catch (error) {
    notify("This hit cannot be shown", error instanceof Error ? error.message : "");
    changeView({ hit: "" });
  }
};

/** @param {StageRequest} request @param {boolean} first */
function put(request, first) {
  const stage = player;
  const paired = (stage.layout === "side" || stage.layout === "overlay") && !first && last > 1;
  const layout = request.items.length > 1 && paired ? stage.layout : request.layout;
  last = request.items.length;
  if (Object.keys(now.selection).length) setStore(SELECTION, {});
  setStore(STAGE_REQUEST, { ...request, layout });
}
let last = 0; // figures that were shown before

/** @param {number} index @param {number} frame */
export const seekPiece = (index, frame) => {
  const piece = now.found.pieces[index];
  const inside = player.seek({ clip: piece.clip, frame, dataset: piece.source });
  if (!inside) setStore(STAGE_REQUEST, { ...now.found.request, at: undefined });
};

window.addEventListener("stage-frame", (event) => {
  if (!find(ids.SEARCH_HITS) || !now.found || !now.found.pieces) return;
  const { items, time, duration } = event.detail;
  const share = duration ? time / duration : 0;
  allWithin(document, ".search-hit .search-why-cursor").forEach((line) => {
    const on = around(line, ".search-hit").classList.contains("chosen") && items.length > 1;
    line.style.display = on ? "block" : "none";
    if (on) line.style.setProperty("--at", String(share));
  });
  now.found.pieces.forEach((piece, k) => {
    const node = allWithin(document, `.search-source[data-index="${k}"] .search-cursor`)[0];
    const item = items.find((one) => one.clip === piece.clip && one.index === (now.found.pieces.length > 1 ? k : 0));
    if (!node) return;
    const shade = within(around(node, ".search-track"), ".search-selection");
    node.style.display = item ? "block" : "none";
    if (!item) return;
    const inside = (item.frame - piece.start) / Math.max(piece.end - piece.start, 1);
    node.style.left = `calc(${shade.style.left} + (${shade.style.width}) * ${inside.toFixed(4)})`;
  });
});

// ---- pointer and keys ----
document.addEventListener("click", (event) => {
  const open = closest(event, ".search-open");
  if (open) {
    const { hit = "" } = around(open, ".search-hit").dataset;
    changeView({ hit: hit === now.view.hit ? "" : hit });
  }
  const why = closest(event, ".search-why");
  if (!why) return;
  const hit = around(why, ".search-hit");
  const box = why.getBoundingClientRect();
  const share = (event.clientX - box.left) / box.width;
  if (!hit.classList.contains("chosen")) changeView({ hit: hit.dataset.hit ?? "" });
  else player.seek(share * player.duration);
});
document.addEventListener("pointermove", (event) => {
  if (hasClass(event, "search-why")) describe(event);
});
let resting = 0;
document.addEventListener("pointerover", (event) => {
  clearTimeout(resting);
  const hit = closest(event, ".search-hit");
  if (hit) resting = setTimeout(() => reasonOf(hit.dataset.hit ?? "").then(({ request }) => player.prefetch(request)).catch(() => {}), 90);
});
document.addEventListener("keydown", (event) => {
  const open = hasClass(event, "search-open");
  if (!open || (event.key !== "ArrowDown" && event.key !== "ArrowUp")) return;
  const hit = around(targetOf(event), ".search-hit");
  const next = /** @type {HTMLElement | null} */ (event.key === "ArrowDown" ? hit.nextElementSibling : hit.previousElementSibling);
  event.preventDefault();
  event.stopPropagation();
  if (next) (allWithin(next, ".search-open")[0] ?? next).focus();
});
