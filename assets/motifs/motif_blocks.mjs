// The blocks about motifs: what they have in common, the table of motifs and the big numbers.
import { isMostly, motifsToLight, motionOf } from "../blocks/selection.mjs";
import { tableOf, tableRow } from "../blocks/table.mjs";
import { tipOn } from "../blocks/tip.mjs";
import { element } from "../shared/dom.mjs";
import { plural } from "../shared/words.mjs";
/** @import { Context, Draw, MotifContent, Playing } from "../blocks/types.d.ts" */

/** @param {MotifContent} motif @returns {Playing} */
export const playingOf = (motif) => ({
  title: `${motif.name}, ${motif.count} motions`,
  items: motif.motions.map(([clip, start, end], k) => ({ clip, start, end, label: clip, warp: motif.warps[k] ?? null })),
});

/** @param {Context} context @param {MotifContent} motif */
export const choose = (context, motif) => context.select({ motif: motif.id }, playingOf(motif));

/**
 * Whether most of a motif has a label, and a motion of it is of one of some clips; every motif fits "" and null.
 * @param {MotifContent} motif
 * @param {string} label
 * @param {Set<string> | null} among
 */
export const fits = (motif, label, among) => (!label || isMostly(motif.label, label)) && (!among || motif.motions.some(([clip]) => among.has(clip)));

/** @param {MotifContent} motif */
export const factsOf = (motif) => [
  motif.name,
  `${motif.count} motions of ${motif.seconds.toFixed(1)} s${motif.label ? `, mostly ${motif.label}` : ""}`,
];

/** @type {Draw<{ motifs: MotifContent[], more: number }>} */
export function drawMotifs(place, { motifs, more }, context) {
  const rows = motifs.map((motif) => tableRow(
    [motif.name, String(motif.count), motif.seconds.toFixed(1), String(motif.clips ?? ""), [motif.label, motif.note].filter(Boolean).join(" · ")],
    motif.strip ?? "", `Play ${motif.name}`, () => choose(context, motif),
  ));
  place.append(tableOf(["Motif", "Motions", "Seconds", "Clips", "Mostly", "Motion"], rows, more ? `${plural(more, "more motif")} not listed.` : ""));
  return {
    motion: (selection) => motionOf(selection, motifs),
    light(selection, motion) {
      const chosen = motifsToLight(selection, motion, motifs);
      motifs.forEach(({ id }, k) => rows[k].classList.toggle("chosen", chosen.has(id)));
    },
    narrow: (label, among) => motifs.forEach((motif, k) => rows[k].classList.toggle("faint", !fits(motif, label, among))),
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
