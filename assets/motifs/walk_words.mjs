// Sentences about the ways of a graph, and paths whose gap is filled.
/** @import { Walk } from "./types.d.ts" */

const MOST_NAMED = 12; // dead ends that are listed by number

/**
 * Dead ends, parts and further links of the graph, in words.
 * @param {Walk} data
 */
export function waysText(data) {
  if (!data.parts) return "";
  const total = data.motifs.length;
  const words = [];
  if (data.parts.length > 1) words.push(`From ${data.parts[0]} of ${total} motifs one can come back to each other; ${data.parts.length - 1} more such part${data.parts.length > 2 ? "s" : ""}.`);
  const dead = data.dead.length > MOST_NAMED ? `${data.dead.length} motifs` : data.dead.join(", ");
  if (data.dead.length) words.push(`Dead ends, where nothing leads on: ${dead} (marked in the graph).`);
  if (data.inputs.extra) words.push(data.further.length ? `${data.further.length} further transitions (dashed).` : "No further transition points are good enough.");
  return words.join(" ");
}

/**
 * A path with the way round put into its gap, wherever it occurs.
 * @param {number[]} path
 * @param {[number, number]} gap
 * @param {number[]} detour
 */
export const filled = (path, [a, b], detour) => path.flatMap((motif, i) => (i && path[i - 1] === a && motif === b ? detour.slice(1) : [motif]));

/** A path without the motif after its gap. @param {number[]} path @param {[number, number]} gap */
export const withoutGap = (path, [a, b]) => path.filter((motif, i) => !(i && path[i - 1] === a && motif === b));
