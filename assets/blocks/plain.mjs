// Blocks without a drawing of their own: facts and clips, the table of motifs, big numbers, text.
import { element } from "../shared/dom.mjs";
import { clock, plural } from "../shared/words.mjs";
import { choose, motifsIn } from "./motifs.mjs";
import { asButton, tipOn } from "./tip.mjs";
/** @import { Draw, MotifContent, OverviewContent } from "./types.d.ts" */

/** @type {Draw<OverviewContent>} */
export function drawOverview(place, { facts, clips, more }, context) {
  place.append(element("dl", "block-facts", ...facts.map(([name, value]) =>
    element("div", "", element("dt", "", name), element("dd", "number", value)))));
  const rows = clips.map((clip) => row(
    [clip.name, clock(clip.seconds), `${clip.frames.toLocaleString("en")}`, `${clip.fps}`, clip.labels + (clip.verdict === "ok" ? "" : ` (${clip.verdict})`)],
    clip.strip, `Play ${clip.name}`,
    () => context.select({ clip: clip.name }, { title: clip.name, items: [{ clip: clip.name, start: 0, end: clip.frames, label: clip.name }] }),
  ));
  place.append(table(["Clip", "Duration", "Frames", "Rate", "Labels", "Motion"], rows, more ? `${plural(more, "more clip")} not listed.` : ""));
  return { light: (selection) => clips.forEach(({ name }, k) => rows[k].classList.toggle("chosen", name === selection.clip)) };
}

/** @type {Draw<{ motifs: MotifContent[], more: number }>} */
export function drawMotifs(place, { motifs, more }, context) {
  const rows = motifs.map((motif) => row(
    [motif.name, String(motif.count), motif.seconds.toFixed(1), String(motif.clips ?? ""), [motif.label, motif.note].filter(Boolean).join(" · ")],
    motif.strip ?? "", `Play ${motif.name}`, () => choose(context, motif),
  ));
  place.append(table(["Motif", "Motions", "Seconds", "Clips", "Mostly", "Motion"], rows, more ? `${plural(more, "more motif")} not listed.` : ""));
  return {
    light(selection) {
      const chosen = motifsIn(selection);
      motifs.forEach(({ id }, k) => rows[k].classList.toggle("chosen", chosen.has(id)));
    },
  };
}

/** @type {Draw<{ figures: [string, string, string, string][] }>} */
export function drawNumbers(place, { figures }) {
  place.append(element("div", "block-numbers", ...figures.map(([name, value, unit, words]) => {
    const tile = element("div", "block-number", element("span", "block-number-value number", value, unit && element("small", "", ` ${unit}`)), element("span", "muted", name));
    tile.tabIndex = 0;
    return tipOn(tile, () => [words]);
  })));
  return {};
}

/** @type {Draw<{ html: string }>} */
export function drawText(place, { html }) {
  const text = element("div", "block-text");
  text.innerHTML = html; // made from Markdown by the server, which lets no HTML through
  place.append(text);
  return {};
}

/** @param {string[]} cells @param {string} strip @param {string} name @param {() => void} act */
function row(cells, strip, name, act) {
  const picture = element("td", "block-strip");
  picture.innerHTML = strip; // drawn by our own server, its title escaped
  return asButton(element("tr", "", ...cells.map((cell, k) => element("td", k && k < 4 ? "number" : "", cell || " ")), picture), name, act);
}

/** @param {string[]} heads @param {HTMLTableRowElement[]} rows @param {string} note */
function table(heads, rows, note) {
  return element("div", "block-table", element("table", "", element("thead", "", element("tr", "", ...heads.map((head, k) => element("th", k && k < 4 ? "number" : "", head)))), element("tbody", "", ...rows)), note && element("p", "muted", note));
}
