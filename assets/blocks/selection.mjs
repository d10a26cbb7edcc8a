// What a selection names.
/** @import { Selection } from "./types.d.ts" */

/**
 * The motifs that a selection names: one, several, or both ends of an edge.
 * @param {Selection} selection
 */
export function motifsIn(selection) {
  const text = selection.motifs ?? selection.edge ?? (selection.motif === undefined ? "" : String(selection.motif));
  return new Set(text ? text.split("-").map(Number) : []);
}
