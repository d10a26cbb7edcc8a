/* Where the motions on the Stage go over the map, and dots that move along with the playing figures. */
/** @import { MapData } from "./data.mjs" */
/** @import { Overlay } from "./overlay.mjs" */
/** @import { Dot, Followed, MapPath } from "./types.d.ts" */

export const TONES = ["#d1495b", "#00798c", "#edae49", "#6a4c93", "#3a7d44", "#c8553d", "#1982c4", "#8a6d3b"];
const MOST = 24;
const known = new Map(); // map and segment -> promise of a path

/** @param {MapData} map @param {Followed} item */
const nameOf = (map, item) => [map.key, item.dataset, item.clip, item.start, item.end].join("\n");

/**
 * The paths of segments [{dataset, clip, start, end}], in their order; null where one cannot be had.
 * @param {MapData} map
 * @param {Followed[]} items
 */
export async function pathsOf(map, items) {
  const missing = items.filter((item) => !known.has(nameOf(map, item)));
  for (const dataset of new Set(missing.map((item) => item.dataset))) {
    const mine = missing.filter((item) => item.dataset === dataset);
    const query = new URLSearchParams({ dataset });
    for (const { clip, start, end } of mine) for (const [key, value] of Object.entries({ clip, start, end })) query.append(key, String(value));
    const answer = fetch(`/api/map/${map.key}/paths?${query}`).then((response) => (response.ok ? response.json() : []), () => []);
    mine.forEach((item, k) => known.set(nameOf(map, item), answer.then((paths) => paths[k] || null)));
  }
  while (known.size > 600) known.delete(known.keys().next().value);
  return Promise.all(items.map((item) => known.get(nameOf(map, item)) ?? null));
}

/**
 * Where on its path a motion is at a frame of the clip's own rate.
 * @param {MapPath} path
 * @param {number} frame
 */
function along(path, frame) {
  const at = Math.min(Math.max((frame - path.start) / path.step, 0), path.points.length - 1);
  const k = Math.min(Math.floor(at), path.points.length - 2);
  if (k < 0) return path.points[0];
  const t = at - k;
  return [0, 1].map((d) => path.points[k][d] + t * (path.points[k + 1][d] - path.points[k][d]));
}

export class Follower {
  /** @param {Overlay} overlay */
  constructor(overlay) {
    this.overlay = overlay;
    /** @type {Followed[]} */
    this.items = [];
    /** @type {(MapPath | null)[]} */
    this.paths = [];
    /** @type {Dot[]} */
    this.dots = [];
    this.name = ""; // of what is shown
    this.on = true;
  }

  /**
   * Take up what the Stage shows.
   * @param {MapData} map
   * @param {Followed[]} items
   */
  async take(map, items) {
    const shown = this.on ? items.slice(0, MOST).map(({ dataset, clip, start, end, index }) => ({ dataset, clip, start, end, index })) : [];
    const name = JSON.stringify([map.key, shown]);
    if (name === this.name) return;
    this.name = name;
    const paths = shown.length ? await pathsOf(map, shown) : [];
    if (name !== this.name) return; // something else is shown by now
    this.items = shown;
    this.paths = paths;
    this.overlay.drawPaths(paths.flatMap((path, k) => (path ? [{ points: path.points, colour: TONES[k % TONES.length] }] : [])));
    this.step(items);
  }

  /**
   * Move the dots to where the figures are.
   * @param {Followed[]} items
   */
  step(items) {
    const now = new Map(items.map((item) => [item.index, item.frame]));
    this.dots = this.items.flatMap((item, k) => {
      const frame = now.get(item.index), path = this.paths[k];
      if (frame === undefined || !path) return [];
      const [x, y] = along(path, frame);
      return [{ x, y, colour: TONES[k % TONES.length] }];
    });
    this.overlay.drawDots(this.dots);
  }
}

