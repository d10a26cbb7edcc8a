// One figure: a motion placed on the stage, its limbs, and where its joints are at any time.
import { readSpans } from "./spans.mjs";
/** @import { Header, Item, Limb, Motion, Path, Rgb, Shades } from "./types.d.ts" */

// Radii in metres of a body 1.75 m high, by role without its side.
/** @type {Record<string, number>} */
const RADII = {
  pelvis: 0.062, spine: 0.062, chest: 0.058, neck: 0.034, head: 0.03,
  clavicle: 0.04, shoulder: 0.041, elbow: 0.031, wrist: 0.022, hand: 0.013,
  hip: 0.055, knee: 0.041, ankle: 0.027, toe: 0.023, foot: 0.017,
};
/** @type {Record<string, number>} */
const SIDES = { left: 0, right: 1, centre: 2 };
const TRUNK = new Set(["pelvis", "spine", "chest", "neck", "head", "clavicle", ""]);

/** @type {Shades} */
const NO_SHADES = { ball: () => document.createElement("canvas"), fill: [], edge: [], sheen: [], light: [] };

export class Figure {
  /** @param {Item} item @param {Motion} motion @param {number} index */
  constructor(item, motion, index) {
    const { header, positions } = motion;
    this.item = item;
    this.header = header;
    this.positions = positions;
    this.index = index;
    this.label = item.label || header.clip;
    this.frames = header.frames;
    this.fps = header.fps;
    this.ownFps = header.fps * header.step;
    this.n = header.joints.length;
    this.visible = true;
    this.warp = usableWarp(item.warp ?? undefined);
    this.warpFps = 0;
    this.stretch = 0; // seconds over which all of the motion is spread; 0: its own pace
    this.offset = 0; // frames (of those received) added to where time leads
    this.spans = readSpans(item.colours, header);
    this.yaw = [1, 0]; // cosine and sine
    this.origin = [0, 0, 0]; // of the recording, comes to stand at `place`
    this.place = [0, 0];
    this.level = 0; // of the floor it stands on
    this.walksInPlace = false;
    this.room = Infinity; // metres its label may be wide
    /** @type {Path | null} */
    this.path = null;
    this.name = this.label; // where there is little room
    this.brief = this.label; // where there is hardly any
    this.heading = 0;
    /** @type {Rgb[]} */
    this.colours = [];
    this.shades = NO_SHADES;
    this.points = new Float32Array(3 * this.n);
    this.spare = new Float32Array(3 * this.n);
    this.x = new Float32Array(this.n);
    this.y = new Float32Array(this.n);
    this.scale = new Float32Array(this.n);
    this.depth = new Float32Array(this.n);
    this.size = header.height > 0 ? header.height / 1.75 : 1;
    this.sides = Uint8Array.from(header.sides, (side) => SIDES[side] ?? 2);
    this.radii = Float32Array.from(header.roles, (role) => (RADII[role.split("_").pop() ?? ""] ?? 0.02) * this.size);
    this.limbs = makeLimbs(header, this.sides);
    this.stand();
  }

  get duration() {
    return this.warp && this.warpFps ? (this.warp.length - 1) / this.warpFps : this.ownDuration;
  }

  get ownDuration() {
    return (this.frames - 1) / this.fps;
  }

  /**
   * Follow the medoid's frames at this rate; 0: run at the motion's own pace, or spread over `stretch` seconds.
   * @param {number} medoidFps
   * @param {number} [stretch]
   */
  follow(medoidFps, stretch = 0) {
    this.warpFps = medoidFps;
    this.stretch = stretch;
    this.offset = 0;
  }

  /**
   * Frame (a fraction, among the frames received) at a time in seconds of the stage.
   * @param {number} time
   */
  frameAt(time) {
    return Math.min(Math.max(this.ledTo(time) + this.offset, 0), this.frames - 1);
  }

  /** @param {number} time */
  ledTo(time) {
    if (!this.warp || !this.warpFps) return this.stretch ? (time / this.stretch) * (this.frames - 1) : time * this.fps;
    const at = Math.min(time * this.warpFps, this.warp.length - 1);
    const k = Math.min(Math.floor(at), this.warp.length - 2);
    const own = k < 0 ? this.warp[0] : this.warp[k] + (this.warp[k + 1] - this.warp[k]) * (at - k);
    return own / this.header.step;
  }

  /**
   * Time in seconds of the stage at which a frame of the recording is reached; the end where it never is.
   * @param {number} recorded
   */
  timeAt(recorded) {
    const frame = Math.min((recorded - this.header.start) / this.header.step, this.frames - 1);
    let [low, high] = [0, this.stretch || this.duration];
    for (let k = 0; k < 40; k++) {
      const middle = (low + high) / 2;
      if (this.frameAt(middle) < frame) low = middle;
      else high = middle;
    }
    return high;
  }

  /**
   * The coloured span that holds a frame of the recording.
   * @param {number} recorded
   */
  spanAt(recorded) {
    return this.spans.find((span) => span.start <= recorded && recorded < span.end);
  }

  /**
   * Number of a frame in the recording itself.
   * @param {number} time
   */
  recordedFrame(time) {
    return Math.round(this.header.start + this.frameAt(time) * this.header.step);
  }

  /**
   * Joints at a time, in the stage's frame, written into `out` (3 n) or the figure's own points.
   * @param {number} time
   * @param {Float32Array} [out]
   */
  pose(time, out = this.points) {
    const at = this.frameAt(time);
    const first = Math.floor(at);
    const next = Math.min(first + 1, this.frames - 1);
    const t = at - first;
    const [a, b, n, from] = [3 * this.n * first, 3 * this.n * next, 3 * this.n, this.positions];
    const [cos, sin] = this.yaw;
    const root = 3 * this.header.root;
    const still = this.walksInPlace;
    const ox = still ? from[a + root] + (from[b + root] - from[a + root]) * t : this.origin[0];
    const oz = still ? from[a + root + 2] + (from[b + root + 2] - from[a + root + 2]) * t : this.origin[2];
    for (let k = 0; k < n; k += 3) {
      const x = from[a + k] + (from[b + k] - from[a + k]) * t - ox;
      const z = from[a + k + 2] + (from[b + k + 2] - from[a + k + 2]) * t - oz;
      out[k] = cos * x + sin * z + this.place[0];
      out[k + 1] = from[a + k + 1] + (from[b + k + 1] - from[a + k + 1]) * t - this.origin[1] + this.level;
      out[k + 2] = cos * z - sin * x + this.place[1];
    }
    return out;
  }

  /**
   * Put a frame's root (the first's) at the origin, facing +Z, feet on the floor.
   * @param {number} [frame]
   */
  stand(frame = 0) {
    const first = Math.min(Math.max(Math.floor(frame), 0), this.frames - 1);
    const root = 3 * (first * this.n + this.header.root);
    this.origin = [this.positions[root], this.header.floor || 0, this.positions[root + 2]];
    const [x, z] = this.facing(first);
    const length = Math.hypot(x, z);
    this.heading = length > 1e-3 ? Math.atan2(-x, z) : 0;
    this.turn(0);
  }

  /**
   * Turn to the left of +Z by so many radians.
   * @param {number} angle
   */
  turn(angle) {
    this.yaw = [Math.cos(this.heading + angle), Math.sin(this.heading + angle)];
  }

  /**
   * Where the trunk faces over a fifth of a second from a frame on, on the ground.
   * @param {number} first
   */
  facing(first) {
    /** @param {string} name */
    const role = (name) => this.header.roles.indexOf(name);
    const pairs = [["left_hip", "right_hip"], ["left_shoulder", "right_shoulder"]];
    let [x, z] = [0, 0];
    const end = Math.min(this.frames, first + 1 + Math.round(this.fps / 5));
    for (const [left, right] of pairs.map((pair) => pair.map(role))) {
      if (left < 0 || right < 0) continue;
      for (let f = first; f < end; f++) {
        const [l, r] = [3 * (f * this.n + left), 3 * (f * this.n + right)];
        x -= this.positions[l + 2] - this.positions[r + 2];
        z += this.positions[l] - this.positions[r];
      }
    }
    return [x, z];
  }

  /**
   * Space the motion takes between two times when it starts at the origin: [min x, max x, min z, max z, max y].
   * @param {number} [from]
   * @param {number} [to]
   * @param {number} [samples]
   */
  extent(from = 0, to = this.duration, samples = 32) {
    const box = [0, 0, 0, 0, 0];
    const points = this.spare;
    for (let s = 0; s < samples; s++) {
      this.pose(from + ((to - from) * s) / Math.max(samples - 1, 1), points);
      for (let k = 0; k < points.length; k += 3) {
        const [x, z] = [points[k] - this.place[0], points[k + 2] - this.place[1]];
        box[0] = Math.min(box[0], x);
        box[1] = Math.max(box[1], x);
        box[2] = Math.min(box[2], z);
        box[3] = Math.max(box[3], z);
        box[4] = Math.max(box[4], points[k + 1]);
      }
    }
    return box;
  }
}

/**
 * Float array of finite frames, or null.
 * @param {number[] | undefined} warp
 */
function usableWarp(warp) {
  if (!warp || warp.length < 2) return null;
  const frames = Float32Array.from(warp);
  return frames.every(Number.isFinite) ? frames : null;
}

/**
 * Bones gathered into limbs (trunk, arms, legs), the unit that is sorted by depth: [{side, bones: [[parent, child]],
 * joints, flanks}]; flanks
 * are drawn like bones and the trunk filled between them. Where the anatomy is unknown every bone is its own limb.
 * @param {Header} header
 * @param {Uint8Array} sides
 */
function makeLimbs(header, sides) {
  const { parents, roles, head, nose } = header;
  /** @param {number} j */
  const part = (j) => roles[j].split("_").pop() ?? "";
  const known = roles.some((role) => role === "left_knee");
  /** @type {Limb[]} */
  const limbs = [];
  const limbOf = new Array(parents.length).fill(-1);
  /** @param {number} side */
  const start = (side) => limbs.push({ side, bones: [], joints: [] }) - 1;
  parents.forEach((parent, j) => {
    if (parent < 0 || j === head || j === nose) return;
    const inTrunk = known && TRUNK.has(part(j)) && TRUNK.has(part(parent));
    const toHip = known && (part(j) === "hip" || part(j) === "shoulder");
    if (!known) limbOf[j] = start(sides[j]);
    else if (inTrunk || toHip) limbOf[j] = limbs.findIndex((limb) => limb.trunk);
    else limbOf[j] = limbOf[parent] >= 0 && !limbs[limbOf[parent]].trunk ? limbOf[parent] : start(sides[j]);
    if (limbOf[j] < 0) {
      limbOf[j] = start(2);
      limbs[limbOf[j]].trunk = true;
    }
    limbs[limbOf[j]].bones.push(parent, j);
  });
  for (const limb of limbs) limb.joints = [...new Set(limb.bones)];
  const flanks = ["left_shoulder", "left_hip", "right_shoulder", "right_hip"].map((role) => roles.indexOf(role));
  const trunk = limbs.find((limb) => limb.trunk);
  if (trunk && Math.min(...flanks) >= 0) trunk.flanks = flanks;
  return limbs;
}
