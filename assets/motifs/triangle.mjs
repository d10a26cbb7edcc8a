// A mixture of three motions as a point of a triangle.

export const CORNERS = [[150, 26], [28, 214], [272, 214]];
const CORNER = 0.03; // of a weight: how near a corner holds the point

/** Where a mixture lies between the corners. @param {number[]} weights */
export const placeOf = (weights) => [0, 1].map((axis) => weights.reduce((total, w, k) => total + w * CORNERS[k][axis], 0));

/**
 * Weights of the corners at a point; outside the triangle those of the nearest side.
 * @param {number} x
 * @param {number} y
 */
export function weightsAt(x, y) {
  const [[ax, ay], [bx, by], [cx, cy]] = CORNERS;
  const area = (by - cy) * (ax - cx) + (cx - bx) * (ay - cy);
  const a = ((by - cy) * (x - cx) + (cx - bx) * (y - cy)) / area;
  const b = ((cy - ay) * (x - cx) + (ax - cx) * (y - cy)) / area;
  return insideWeights([a, b, 1 - a - b]);
}

/** Shares of sum 1, none negative; near a corner all of it. @param {number[]} weights */
export function insideWeights(weights) {
  const kept = weights.map((w) => Math.max(w, 0));
  const total = kept.reduce((sum, w) => sum + w, 0) || 1;
  const shares = kept.map((w) => w / total);
  const corner = shares.findIndex((w) => w > 1 - CORNER);
  return shares.map((w, k) => (corner < 0 ? w : Number(k === corner)));
}

/**
 * From a corner that holds the point, in the direction of a key: along the side that leads most that way.
 * @param {number} corner
 * @param {[number, number]} way
 */
export function awayFromCorner(corner, [dx, dy]) {
  const [x, y] = CORNERS[corner];
  const gains = CORNERS.map(([cx, cy], k) => (k === corner ? 0 : (cx - x) * dx + (cy - y) * dy));
  const best = gains.indexOf(Math.max(...gains));
  if (gains[best] <= 0) return [0, 1, 2].map((k) => Number(k === corner));
  return [0, 1, 2].map((k) => (k === corner ? 1 - 2 * CORNER : k === best ? 2 * CORNER : 0));
}
