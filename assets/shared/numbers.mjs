// Sums that several rooms do.

/** A value, or the nearer of two limits where it lies beyond. @param {number} value @param {number} low @param {number} high */
export const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/**
 * Index of the entry of a rising list that is nearest to a value; -1 in an empty list.
 * @param {ArrayLike<number>} list
 * @param {number} value
 */
export function nearest(list, value) {
  let low = 0;
  let high = list.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle] <= value) low = middle;
    else high = middle;
  }
  return high < 0 ? -1 : Math.abs(list[low] - value) <= Math.abs(list[high] - value) ? low : high;
}
