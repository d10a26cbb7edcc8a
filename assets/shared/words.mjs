// Numbers as people read them.

/**
 * Seconds as minutes and seconds: 75.25 is "1:15.3".
 * @param {number} seconds
 */
export function clock(seconds) {
  const tenths = Math.round(seconds * 10);
  return `${Math.floor(tenths / 600)}:${((tenths % 600) / 10).toFixed(1).padStart(4, "0")}`;
}

/**
 * A count with its noun: "1 clip", "3 clips".
 * @param {number} n
 * @param {string} one
 * @param {string} [more]
 */
export const plural = (n, one, more = `${one}s`) => `${n} ${n === 1 ? one : more}`;

/**
 * A share from 0 to 1 as whole percent.
 * @param {number} share
 */
export const percent = (share) => `${Math.round(100 * share)} %`;
