// Routines seen before, for undo and redo.

const MOST = 100;

/**
 * The routines of one result, by their sentences, and which of them is shown.
 * @typedef {{ key: string, list: string[], at: number }} Past
 */

/**
 * The past after a routine was shown: a step back, a step forward, or a new one, after which nothing can be redone. The same
 * past where it is shown already.
 * @param {Past} past
 * @param {string} sentence
 * @returns {Past}
 */
export function visited(past, sentence) {
  const { key, list, at } = past;
  if (list[at] === sentence) return past;
  if (list[at - 1] === sentence) return { key, list, at: at - 1 };
  if (list[at + 1] === sentence) return { key, list, at: at + 1 };
  const kept = [...list.slice(Math.max(0, at + 2 - MOST), at + 1), sentence];
  return { key, list: kept, at: kept.length - 1 };
}
