// Motion that core/export/packed_motion.py packed: inflated once, each piece summed up when it first plays.
import { Figure } from "../stage/figure.mjs";
/** @import { Item, Motion } from "../stage/types.d.ts" */
/** @import { Piece, Report } from "./types.d.ts" */

/**
 * The numbers behind base64 of deflated int16.
 * @param {string} text
 */
export async function inflate(text) {
  const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Int16Array(await new Response(stream).arrayBuffer());
}

/**
 * Positions (frames, joints, 3) in metres of a piece that begins at `at` in the numbers.
 * @param {Int16Array} numbers
 * @param {number} at
 * @param {Piece} piece
 * @param {number} joints
 */
export function positionsOf(numbers, at, { frames, unit, origin }, joints) {
  const out = new Float32Array(frames * joints * 3);
  for (let column = 0; column < 3 * joints; column++) {
    let [value, slope] = [0, 0];
    for (let frame = 0; frame < frames; frame++) {
      slope = ((slope + numbers[at++]) << 16) >> 16;
      value = ((value + slope) << 16) >> 16;
      out[frame * 3 * joints + column] = value * unit + origin[column % 3];
    }
  }
  return out;
}

export class PackedMotion {
  /** @param {Report["motion"]} motion @param {string} text */
  constructor({ bodies, pieces }, text) {
    this.bodies = bodies;
    this.pieces = pieces;
    this.numbers = inflate(text);
    /** @type {Map<Piece, Float32Array<ArrayBuffer>>} */
    this.positions = new Map();
  }

  /** Whether all frames of an item are here. @param {Item} item */
  has(item) {
    return this.pieceOf(item) !== undefined;
  }

  /** @param {Item} item */
  pieceOf({ clip, start = 0, end = Infinity }) {
    const last = Math.min(end, this.bodies[clip]?.end ?? 0);
    return this.pieces.find((piece) => piece.clip === clip && piece.start <= start && last <= piece.end);
  }

  /** @param {Item[]} items */
  async figures(items) {
    const numbers = await this.numbers;
    return items.flatMap((item, k) => {
      const piece = this.pieceOf(item);
      return piece ? [new Figure(item, this.motion(numbers, piece, item), k)] : [];
    });
  }

  /** @param {Int16Array} numbers @param {Piece} piece @param {Item} item @returns {Motion} */
  motion(numbers, piece, { clip, start = 0, end = piece.end }) {
    const body = this.bodies[clip];
    const joints = body.joints.length;
    let all = this.positions.get(piece);
    if (!all) {
      const before = this.pieces.slice(0, this.pieces.indexOf(piece));
      const at = before.reduce((sum, one) => sum + one.frames * 3 * this.bodies[one.clip].joints.length, 0);
      this.positions.set(piece, (all = positionsOf(numbers, at, piece, joints)));
    }
    const first = Math.min(Math.round((start - piece.start) / piece.step), piece.frames - 1);
    const frames = Math.max(1, Math.min(Math.ceil((end - start) / piece.step), piece.frames - first));
    const positions = all.slice(first * 3 * joints, (first + frames) * 3 * joints);
    const header = { ...body, start: piece.start + first * piece.step, end, step: piece.step, fps: body.fps / piece.step, frames };
    return { header, positions, bytes: positions.byteLength };
  }
}
