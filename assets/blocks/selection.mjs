// What a selection names, and which other things are the same motion: so it lights in every block.
/** @import { Drawn, MotifContent, Segment, Selection } from "./types.d.ts" */

/**
 * The motifs that a selection names: one, several, or both ends of an edge.
 * @param {Selection} selection
 */
export function motifsIn(selection) {
  const text = selection.motifs ?? selection.edge ?? (selection.motif === undefined ? "" : String(selection.motif));
  return new Set(text ? text.split("-").map(Number) : []);
}

/**
 * Whether two stretches are mostly the same motion: they share at least half of the shorter one.
 * @param {Segment} one
 * @param {Segment} other
 */
export const meets = ([clip, start, end], [name, from, to]) =>
  clip === name && 2 * (Math.min(end, to) - Math.max(start, from)) >= Math.min(end - start, to - from);

/** Whether most of something has a label, from words such as "walk (80 %)". @param {string | undefined} words @param {string} label */
export const isMostly = (words, label) => Boolean(words?.startsWith(`${label} (`));

/** @param {Segment} stretch @param {Segment[]} motion */
export const isIn = (stretch, motion) => motion.some((one) => meets(stretch, one));

/**
 * The motions of the motifs that a selection names; undefined where it names none of these.
 * @param {Selection} selection
 * @param {MotifContent[]} motifs
 */
export function motionOf(selection, motifs) {
  const chosen = motifsIn(selection);
  const found = motifs.filter(({ id }) => chosen.has(id));
  return found.length ? found.flatMap(({ motions }) => motions) : undefined;
}

/**
 * The motifs to light: those that a selection names, else those with a motion in it.
 * @param {Selection} selection
 * @param {Segment[]} motion
 * @param {MotifContent[]} motifs
 */
export function motifsToLight(selection, motion, motifs) {
  const chosen = motifsIn(selection);
  if (chosen.size || !motion.length) return chosen;
  return new Set(motifs.filter(({ motions }) => motions.some((one) => isIn(one, motion))).map(({ id }) => id));
}

/**
 * Light a selection in blocks of one dataset. The numbers of motifs and actions mean the same in blocks with the
 * settings of the selection alone; in the others what is the same motion lights.
 * @param {{ drawn: Drawn, same: boolean }[]} blocks
 * @param {Selection} selection
 */
export function lightBlocks(blocks, selection) {
  const { clip, start, end } = selection;
  /** @type {Segment[]} */
  let motion = [];
  if (clip !== undefined) motion = [[clip, start ?? 0, end ?? Infinity]];
  else {
    for (const { drawn, same } of blocks) {
      const known = same ? drawn.motion?.(selection) : undefined;
      if (known) {
        motion = known;
        break;
      }
    }
  }
  const stretch = clip === undefined ? {} : { clip, start, end };
  for (const { drawn, same } of blocks) drawn.light?.(same ? selection : stretch, motion);
}
