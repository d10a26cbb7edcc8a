/* A motion map in the browser: its postures, the nodes a key grows to, and the search for keys, without the server. */
/** @import { MapHeader, Pace } from "./types.d.ts" */

/** What /api/map/KEY.bin holds (webapp/features/motion_map/routes.py). */
export class MapData {
  /** @param {ArrayBuffer} buffer @param {string} key */
  constructor(buffer, key) {
    const length = new DataView(buffer).getUint32(0, true);
    const header = /** @type {MapHeader} */ (JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))));
    this.key = key;
    this.nx = header.grid[0];
    this.ny = header.grid[1];
    this.fps = header.fps;
    this.runs = header.runs;
    this.joints = header.joints;
    this.roles = header.roles;
    this.sides = header.sides;
    this.parents = header.parents;
    this.lengths = header.lengths; // of bones, in metres
    this.clips = header.clips;
    this.regions = header.regions;
    this.icons = header.icons;
    this.usual = header.usual; // distance of a posture to its node
    this.n = this.nx * this.ny;
    this.width = 3 * this.joints.length;
    let at = 4 + length;
    /** Where the next `n` numbers of four bytes begin. @param {number} n */
    const take = (n) => (at += 4 * n) - 4 * n;
    this.weights = new Float32Array(buffer, take(this.n * this.width), this.n * this.width);
    const ints = () => new Int32Array(buffer, take(this.runs), this.runs);
    const floats = () => new Float32Array(buffer, take(this.runs), this.runs);
    // the runs of frames on one node, in the order in which the file has their columns
    const table = { clip: ints(), start: ints(), end: ints(), node: ints(), distance: floats(), ahead: floats(), aside: floats() };
    this.table = table;
    this.seconds = new Float32Array(this.n);
    this.speed = new Float32Array(this.runs);
    this.fastest = 0;
    for (let r = 0; r < this.runs; r++) {
      this.seconds[table.node[r]] += (table.end[r] - table.start[r]) / this.fps;
      this.speed[r] = Math.hypot(table.ahead[r], table.aside[r]);
      this.fastest = Math.max(this.fastest, this.speed[r]);
    }
    this.numbers = new Map(this.clips.map((clip, k) => [clip.name, k]));
    this.reach = Math.ceil(10 * this.spread()) / 10;
    /** @type {Map<number, Float64Array>} */
    this.postures = new Map();
    /** @type {Map<number, Float32Array>} */
    this.near = new Map(); // node -> distances of all nodes to it
  }

  /** Largest distance of a posture from the mean one. */
  spread() {
    const mean = new Float64Array(this.width);
    for (let k = 0; k < this.weights.length; k++) mean[k % this.width] += this.weights[k] / this.n;
    let most = 0;
    for (let node = 0; node < this.n; node++) most = Math.max(most, this.apart(node, mean));
    return most;
  }

  /** @param {number} x @param {number} y */
  index(x, y) { return x * this.ny + y; }
  /** @param {number} node */
  place(node) { return [Math.floor(node / this.ny), node % this.ny]; }

  /**
   * Distance of a node's model vector to a vector.
   * @param {number} node
   * @param {ArrayLike<number>} vector
   */
  apart(node, vector) {
    let sum = 0;
    for (let k = 0, at = node * this.width; k < this.width; k++, at++) sum += (this.weights[at] - vector[k]) ** 2;
    return Math.sqrt(sum);
  }

  /** @param {number} node */
  model(node) { return this.weights.subarray(node * this.width, (node + 1) * this.width); }

  /**
   * Distances (n) of all nodes to a key node's model vector.
   * @param {number} node
   */
  distances(node) {
    if (!this.near.has(node)) {
      const own = this.model(node), distances = new Float32Array(this.n);
      for (let k = 0; k < this.n; k++) distances[k] = this.apart(k, own);
      if (this.near.size > 64) this.near.clear();
      this.near.set(node, distances);
    }
    return /** @type {Float32Array} */ (this.near.get(node));
  }

  /**
   * The node nearest to a vector of joint positions, and the distance.
   * @param {ArrayLike<number>} vector
   */
  nearest(vector) {
    let [best, least] = [0, Infinity];
    for (let node = 0; node < this.n; node++) {
      const apart = this.apart(node, vector);
      if (apart < least) [best, least] = [node, apart];
    }
    return { node: best, distance: least };
  }

  /**
   * The posture of a node, bones at their real lengths: positions (3 n_joints), the pelvis at the origin.
   * @param {number} node
   */
  posture(node) {
    if (!this.postures.has(node)) this.postures.set(node, this.withBones(this.model(node)));
    return /** @type {Float64Array} */ (this.postures.get(node));
  }

  /** @param {ArrayLike<number>} vector */
  withBones(vector) {
    const made = new Float64Array(this.width);
    this.parents.forEach((parent, joint) => {
      /** @param {ArrayLike<number>} array @param {number} k */
      const from = (array, k) => (parent < 0 ? 0 : array[3 * parent + k]);
      const bone = [0, 1, 2].map((k) => vector[3 * joint + k] - from(vector, k));
      const size = Math.hypot(...bone);
      const way = size > 1e-9 ? bone.map((part) => part / size) : [0, 1, 0];
      for (let k = 0; k < 3; k++) made[3 * joint + k] = from(made, k) + way[k] * this.lengths[joint];
    });
    return made;
  }

  /**
   * Whether a run travels as a pace says: {slowest, fastest, way}.
   * @param {number} run
   * @param {Pace | null} pace
   */
  allows(run, pace) {
    if (!pace) return true;
    const speed = this.speed[run];
    if (speed < pace.slowest || speed > pace.fastest) return false;
    if (!pace.way || pace.way === "any") return true;
    const straight = pace.way === "forward" || pace.way === "backward";
    let [along, across] = [this.table.ahead[run], this.table.aside[run]];
    if (!straight) [along, across] = [across, along];
    if (pace.way === "backward" || pace.way === "right") along = -along;
    return along > 0 && along >= Math.abs(across);
  }

  /**
   * Stretches that pass all keys in order, best first; as core/motion_map/keypose_search.py, which says why. keys: node
   * numbers; reach: the paper's T. Gives [{clip, start, end, distance}], clip a number, analysis frames.
   * @param {number[]} keys
   * @param {number} reach
   * @param {Pace | null} pace
   */
  search(keys, reach, pace) {
    if (!keys.length) return [];
    const { clip, start, end, node } = this.table;
    const passes = keys.map((key) => {
      const apart = this.distances(key);
      const rows = [];
      for (let r = 0; r < this.runs; r++) {
        const on = node[r];
        if ((on === key || apart[on] < reach) && this.allows(r, pace)) rows.push(r);
      }
      return { rows, apart };
    });
    let chains = passes[0].rows.map((r) => ({ first: r, last: r, distance: passes[0].apart[node[r]] }));
    for (const { rows, apart } of passes.slice(1)) {
      let at = 0; // chains come by their last run, so the follower only moves on
      const next = [];
      for (const chain of chains) {
        while (at < rows.length && rows[at] <= chain.last) at++;
        if (at === rows.length) break;
        if (clip[rows[at]] !== clip[chain.last]) continue;
        next.push({ first: chain.first, last: rows[at], distance: chain.distance + apart[node[rows[at]]] });
      }
      chains = next;
    }
    const shortest = chains.filter((chain, k) => k + 1 === chains.length || chains[k + 1].last !== chain.last);
    const hits = shortest.map((chain) => ({
      clip: clip[chain.first], start: start[chain.first], end: end[chain.last], distance: chain.distance,
    }));
    /** @param {number} value */
    const rough = (value) => Math.round(value * 1e5);
    return hits.sort((a, b) => rough(a.distance) - rough(b.distance) || (a.end - a.start) - (b.end - b.start)
      || a.clip - b.clip || a.start - b.start);
  }

  /**
   * A stretch in frames of the clip's own rate: {clip: name, start, end}.
   * @param {{ clip: number, start: number, end: number }} hit
   */
  segment({ clip, start, end }) {
    const { name, frames, fps } = this.clips[clip];
    /** @param {number} value */
    const even = (value) => (value % 1 === 0.5 ? 2 * Math.round(value / 2) : Math.round(value)); // as Python rounds
    const first = Math.min(even((start * fps) / this.fps), frames - 1);
    return { clip: name, start: first, end: Math.max(Math.min(even((end * fps) / this.fps), frames), first + 1) };
  }

  /**
   * The node on which a frame (of the clip's own rate) of a clip of the map lies, or -1.
   * @param {string} name
   * @param {number} frame
   */
  nodeAt(name, frame) {
    const k = this.numbers.get(name);
    if (k === undefined) return -1;
    const { clip, start, end, node } = this.table;
    const wanted = Math.max(Math.round((frame * this.fps) / this.clips[k].fps), 0);
    let [low, high] = [0, this.runs - 1];
    while (low < high) { // the last run that begins at or before the frame
      const middle = (low + high + 1) >> 1;
      if (clip[middle] < k || (clip[middle] === k && start[middle] <= wanted)) low = middle;
      else high = middle - 1;
    }
    return clip[low] === k && start[low] <= wanted && wanted <= end[low] ? node[low] : -1;
  }
}

/** @type {Map<string, Promise<MapData>>} */
const loaded = new Map();
/**
 * The map with this key; fetched once.
 * @param {string} key
 */
export const loadMap = (key) => {
  if (!loaded.has(key)) {
    const answer = fetch(`/api/map/${key}.bin`).then(async (response) => {
      if (!response.ok) throw new Error((await response.json().catch(() => ({}))).error || "The map cannot be read.");
      return new MapData(await response.arrayBuffer(), key);
    });
    loaded.set(key, answer);
    answer.catch(() => loaded.delete(key));
    if (loaded.size > 4) loaded.delete(/** @type {string} */ (loaded.keys().next().value));
  }
  return /** @type {Promise<MapData>} */ (loaded.get(key));
};
