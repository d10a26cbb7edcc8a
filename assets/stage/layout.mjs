// Where figures stand, and how much of the stage they need.
/** @import { Figure } from "./figure.mjs" */
/** @import { Shelf } from "./types.d.ts" */

const LANE = { least: 1.0, most: 2.4, gap: 0.3 };
const ROW = { least: 1.5, most: 3.2 };
const SHELF = { least: 0.75, most: 2.2, gap: 0.22, above: 0.5 }; // above the tallest: room for the labels
const TURN = 0.5; // radians: side by side, the camera looks straight and the figures stand askew

/**
 * "overlay": all start at the origin. "side": each in a lane of its own, in rows that suit the view's shape. "pose":
 * stills on shelves. Gives the shelves.
 * @param {Figure[]} figures
 * @param {string} layout
 * @param {number} aspect
 * @param {number} duration
 */
export function placeFigures(figures, layout, aspect, duration) {
  const still = layout === "pose";
  for (const figure of figures) {
    figure.place = [0, 0];
    figure.level = 0;
    figure.room = Infinity;
    figure.walksInPlace = still;
    figure.path = null;
    figure.stand(still ? figure.frameAt(duration / 2) : 0);
  }
  const shown = figures.filter((figure) => figure.visible);
  if (layout === "overlay" || shown.length < 2) return [];
  for (const figure of shown) figure.turn(TURN);
  if (still) return placeOnShelves(shown, aspect, duration);
  placeInLanes(shown, aspect);
  return [];
}

/** @param {Figure[]} shown @param {number} aspect */
function placeInLanes(shown, aspect) {
  const boxes = shown.map((figure) => figure.extent());
  /** @param {number} low @param {number} high */
  const span = (low, high) => Math.max(...boxes.map((b) => b[high] - b[low]));
  const width = Math.min(Math.max(span(0, 1) + LANE.gap, LANE.least), LANE.most);
  const depth = Math.min(Math.max(span(2, 3) + LANE.gap, ROW.least), ROW.most);
  // seen from the front, rows cost little height: rather few long ones
  const wanted = Math.round(Math.sqrt((shown.length * aspect * (0.6 * depth + 0.8)) / width));
  inRows(shown, Math.max(wanted, 2), (figure, k, row, rows, column) => {
    const box = boxes[k];
    figure.room = width;
    figure.walksInPlace = box[1] - box[0] > LANE.most || box[3] - box[2] > ROW.most;
    const middle = figure.walksInPlace ? [0, 0] : [(box[0] + box[1]) / 2, (box[2] + box[3]) / 2];
    const stagger = rows > 1 ? (row % 2 ? 0.25 : -0.25) * width : 0; // seen between those in front
    figure.place = [column * width + stagger - middle[0], ((rows - 1) / 2 - row) * depth - middle[1]];
  });
}

/**
 * One row above the other, so that no still hides another: [{level, half: half of its width}].
 * @param {Figure[]} shown
 * @param {number} aspect
 * @param {number} duration
 */
function placeOnShelves(shown, aspect, duration) {
  const boxes = shown.map((figure) => figure.extent(duration / 2, duration / 2, 1));
  const width = Math.min(Math.max(...boxes.map((b) => b[1] - b[0] + SHELF.gap), SHELF.least), SHELF.most);
  const height = Math.max(...boxes.map((b) => b[4])) + SHELF.above;
  /** @param {number} columns */
  const size = (columns) => Math.min(aspect / (columns * width), 1 / (Math.ceil(shown.length / columns) * height));
  const columns = shown.map((_, k) => k + 1).reduce((best, k) => (size(k) > size(best) ? k : best));
  /** @type {Shelf[]} */
  const shelves = [];
  inRows(shown, columns, (figure, k, row, rows, column) => {
    figure.room = width;
    figure.level = (rows - 1 - row) * height;
    figure.place = [column * width - (boxes[k][0] + boxes[k][1]) / 2, 0];
    const half = Math.abs(column * width) + width / 2;
    shelves[row] = { level: figure.level, half: Math.max(shelves[row]?.half ?? 0, half) };
  });
  return shelves;
}

/**
 * Hand out places: row, number of rows, and the column counted from the middle of its row.
 * @param {Figure[]} shown
 * @param {number} wanted
 * @param {(figure: Figure, k: number, row: number, rows: number, column: number) => void} put
 */
function inRows(shown, wanted, put) {
  const rows = Math.ceil(shown.length / wanted);
  const columns = Math.ceil(shown.length / rows);
  shown.forEach((figure, k) => {
    const row = Math.floor(k / columns);
    const inRow = row < rows - 1 ? columns : shown.length - columns * (rows - 1);
    put(figure, k, row, rows, (k % columns) - (inRow - 1) / 2);
  });
}

/**
 * Mean place on the ground of the visible figures' roots, from their current points.
 * @param {Figure[]} figures
 * @param {number[]} out
 */
export function groundCentre(figures, out) {
  let [x, z, n] = [0, 0, 0];
  for (const figure of figures) {
    if (!figure.visible) continue;
    const root = 3 * figure.header.root;
    x += figure.points[root];
    z += figure.points[root + 2];
    n++;
  }
  out[0] = n ? x / n : 0;
  out[1] = n ? z / n : 0;
  return out;
}

/**
 * All places that joints take relative to the figures' common centre on the ground, as seen by a camera that follows
 * it: {cloud: (n, 3) sampled over the motion, radius: the furthest from the centre on the ground}.
 * @param {Figure[]} figures
 * @param {number} duration
 * @param {number} [samples]
 */
export function measureStage(figures, duration, samples = 24) {
  const shown = figures.filter((figure) => figure.visible);
  const cloud = new Float32Array(samples * shown.reduce((sum, figure) => sum + figure.points.length, 0));
  const centre = [0, 0];
  let radius = 0.7;
  let n = 0;
  for (let s = 0; s < samples; s++) {
    for (const figure of shown) figure.pose((duration * s) / (samples - 1));
    groundCentre(shown, centre);
    for (const { points } of shown) {
      for (let k = 0; k < points.length; k += 3) {
        cloud[n++] = points[k] - centre[0];
        cloud[n++] = points[k + 1];
        cloud[n++] = points[k + 2] - centre[1];
        radius = Math.max(radius, Math.hypot(cloud[n - 3], cloud[n - 1]));
      }
    }
  }
  return { cloud, radius };
}

/**
 * Where the camera stands at first: before a single group, or before rows.
 * @param {Figure[]} figures
 * @param {string} layout
 */
export function homeView(figures, layout) {
  if (layout === "overlay" || figures.length < 2) return { yaw: 0.62, pitch: 0.2 };
  return layout === "pose" ? { yaw: 0.02, pitch: 0.07 } : { yaw: 0.06, pitch: 0.34 };
}
