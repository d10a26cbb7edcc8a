// What the blocks about motifs have in common.
/** @import { Context, MotifContent, Playing, Selection } from "./types.d.ts" */

/** @param {MotifContent} motif @returns {Playing} */
export const playingOf = (motif) => ({
  title: `${motif.name}, ${motif.count} motions`,
  items: motif.motions.map(([clip, start, end], k) => ({ clip, start, end, label: clip, warp: motif.warps[k] ?? null })),
});

/** @param {Context} context @param {MotifContent} motif */
export const choose = (context, motif) => context.select({ motif: motif.id }, playingOf(motif));

/**
 * The motifs that a selection names: one, several, or both ends of an edge.
 * @param {Selection} selection
 */
export function motifsIn(selection) {
  const text = selection.motifs ?? selection.edge ?? (selection.motif === undefined ? "" : String(selection.motif));
  return new Set(text ? text.split("-").map(Number) : []);
}

/** @param {MotifContent} motif */
export const factsOf = (motif) => [
  motif.name,
  `${motif.count} motions of ${motif.seconds.toFixed(1)} s${motif.label ? `, mostly ${motif.label}` : ""}`,
];
