// Bodies: limbs as tapered capsules, sorted by depth. Convex polygons, one by one, are what a software rasteriser
// fills fastest (measured: 1500 a frame at 50 frames a second, against 25 for round strokes).
import { NEAR } from "./camera.mjs";
import { FOG_LEVELS } from "./colours.mjs";
/** @import { Camera } from "./camera.mjs" */
/** @import { Figure } from "./figure.mjs" */
/** @import { Limb } from "./types.d.ts" */

/** @param {number} n */
const corners = (n) => Array.from({ length: n }, (_, k) => -Math.PI / 2 + (Math.PI * (k + 0.5)) / n);
const [COARSE, FINE] = [3, 7].map((n) => ({ n, sin: corners(n).map(Math.sin), cos: corners(n).map(Math.cos) }));
const FINE_FROM = 7; // pixels of radius
const CIRCLE = Array.from({ length: 24 }, (_, k) => [Math.cos((k * Math.PI) / 12), Math.sin((k * Math.PI) / 12)]);

/**
 * A capsule from one circle to another, as a convex polygon.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x1
 * @param {number} y1
 * @param {number} r1
 * @param {number} x2
 * @param {number} y2
 * @param {number} r2
 */
export function capsule(context, x1, y1, r1, x2, y2, r2) {
  let dx = x2 - x1;
  let dy = y2 - y1;
  const length = Math.sqrt(dx * dx + dy * dy);
  if (length < 0.5) {
    disc(context, x1, y1, Math.max(r1, r2));
    return;
  }
  dx /= length;
  dy /= length;
  const { n, sin, cos } = r1 + r2 > 2 * FINE_FROM ? FINE : COARSE;
  context.beginPath();
  for (let k = 0; k < n; k++) {
    const along = r2 * cos[k];
    const across = r2 * sin[k];
    context.lineTo(x2 + along * dx - across * dy, y2 + along * dy + across * dx);
  }
  for (let k = n - 1; k >= 0; k--) {
    const along = -r1 * cos[k];
    const across = r1 * sin[k];
    context.lineTo(x1 + along * dx - across * dy, y1 + along * dy + across * dx);
  }
  context.fill();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} r */
export function disc(context, x, y, r) {
  context.beginPath();
  for (let k = 0; k < CIRCLE.length; k++) context.lineTo(x + r * CIRCLE[k][0], y + r * CIRCLE[k][1]);
  context.fill();
}

const HEAD = -1;
const NOSE = -2;

/** Draws all limbs, heads and noses of the figures, furthest first. */
export class BodyPainter {
  constructor() {
    /** @type {{ figure: Figure, limb: number, depth: number }[]} */
    this.items = []; // kept from frame to frame: nearly sorted already
    /** @type {Figure[]} */
    this.owners = [];
    this.girth = 1;
    this.headSize = 1;
    this.detailed = true;
    this.outlined = true;
  }

  /**
   * Call when the set of visible figures changes. Many bodies in one place are drawn slender, or none is seen.
   * @param {Figure[]} figures
   * @param {boolean} overlaid
   */
  collect(figures, overlaid) {
    this.items = [];
    this.owners = figures.filter((figure) => figure.visible);
    for (const figure of this.owners) {
      figure.limbs.forEach((_, limb) => this.items.push({ figure, limb, depth: 0 }));
      if (figure.header.head >= 0) this.items.push({ figure, limb: HEAD, depth: 0 });
      if (figure.header.nose >= 0) this.items.push({ figure, limb: NOSE, depth: 0 });
    }
    const crowd = overlaid ? this.owners.length : 1;
    this.girth = crowd > 8 ? 0.5 : crowd > 4 ? 0.62 : crowd > 1 ? 0.78 : 1;
    this.headSize = 0.3 + 0.7 * this.girth;
    this.detailed = this.owners.length <= 8;
    this.outlined = this.owners.length <= 16;
  }

  sort() {
    const items = this.items;
    for (const item of items) item.depth = depthOf(item);
    for (let i = 1; i < items.length; i++) {
      const item = items[i];
      let j = i - 1;
      for (; j >= 0 && items[j].depth < item.depth; j--) items[j + 1] = items[j];
      items[j + 1] = item;
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {number} reach */
  paint(context, camera, reach) {
    this.sort();
    const levels = FOG_LEVELS;
    for (const { figure, limb, depth } of this.items) {
      if (depth < NEAR) continue;
      const far = (depth - camera.distance + reach) / (2 * reach);
      const level = Math.min(Math.max(Math.round(far * (levels - 1)), 0), levels - 1);
      if (limb === HEAD) this.paintHead(context, figure, level);
      else if (limb === NOSE) this.paintNose(context, figure, level);
      else this.paintLimb(context, figure, figure.limbs[limb], level);
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {Figure} figure @param {Limb} limb @param {number} level */
  paintLimb(context, figure, limb, level) {
    const { shades } = figure;
    if (this.outlined) {
      context.fillStyle = shades.edge[limb.side][level];
      this.bones(context, figure, limb.bones, 1);
      if (limb.flanks) this.bones(context, figure, limb.flanks, 1);
    }
    context.fillStyle = shades.fill[limb.side][level];
    if (limb.flanks) this.plate(context, figure, limb.flanks);
    this.bones(context, figure, limb.bones, 0);
    if (!this.detailed) return;
    if (limb.flanks) {
      context.fillStyle = shades.sheen[limb.side][level];
      this.sheen(context, figure, limb.flanks);
      return;
    }
    context.fillStyle = shades.light[limb.side][level];
    this.highlights(context, figure, limb.bones);
  }

  /**
   * Each bone as a capsule; `line`: pixels of outline around it.
   * @param {CanvasRenderingContext2D} context
   * @param {Figure} figure
   * @param {number[]} bones
   * @param {number} line
   */
  bones(context, figure, bones, line) {
    const { x, y, scale, radii } = figure;
    for (let k = 0; k < bones.length; k += 2) {
      const a = bones[k];
      const b = bones[k + 1];
      const around = line && line + 0.003 * scale[a];
      const ra = radii[a] * this.girth * scale[a] + around;
      capsule(context, x[a], y[a], ra, x[b], y[b], radii[b] * this.girth * scale[b] + around);
    }
  }

  /**
   * The chest and belly between two flanks, shoulder to hip.
   * @param {CanvasRenderingContext2D} context
   * @param {Figure} figure
   * @param {number[]} flanks
   */
  plate(context, figure, flanks) {
    const { x, y } = figure;
    this.bones(context, figure, flanks, 0);
    context.beginPath();
    context.moveTo(x[flanks[0]], y[flanks[0]]);
    context.lineTo(x[flanks[1]], y[flanks[1]]);
    context.lineTo(x[flanks[3]], y[flanks[3]]);
    context.lineTo(x[flanks[2]], y[flanks[2]]);
    context.fill();
  }

  /**
   * A band down the side of the trunk that faces the light, which comes from the upper left.
   * @param {CanvasRenderingContext2D} context
   * @param {Figure} figure
   * @param {number[]} flanks
   */
  sheen(context, { x, y }, flanks) {
    const across = x[flanks[0]] < x[flanks[2]] ? 0.08 : 0.5;
    /** @param {number} k @param {number} share */
    const at = (k, share) => context.lineTo(
      x[flanks[k]] + (x[flanks[k + 2]] - x[flanks[k]]) * share, y[flanks[k]] + (y[flanks[k + 2]] - y[flanks[k]]) * share);
    context.beginPath();
    at(0, across);
    at(0, across + 0.42);
    at(1, across + 0.42);
    at(1, across);
    context.fill();
  }

  /** @param {CanvasRenderingContext2D} context @param {Figure} figure @param {number[]} bones */
  highlights(context, figure, bones) {
    const { x, y, scale, radii } = figure;
    for (let k = 0; k < bones.length; k += 2) {
      const a = bones[k];
      const b = bones[k + 1];
      const ra = radii[a] * this.girth * scale[a];
      const rb = radii[b] * this.girth * scale[b];
      capsule(context, x[a] - 0.32 * ra, y[a] - 0.32 * ra, 0.34 * ra, x[b] - 0.32 * rb, y[b] - 0.32 * rb, 0.34 * rb);
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {Figure} figure @param {number} level */
  paintHead(context, figure, level) {
    const { header, shades } = figure;
    const [x, y] = [figure.x[header.head], figure.y[header.head]];
    const scale = figure.scale[header.head];
    const r = header.head_radius * this.headSize * scale;
    if (this.outlined) {
      context.fillStyle = shades.edge[2][level];
      disc(context, x, y, r + 1 + 0.003 * scale);
    }
    if (this.detailed) {
      context.drawImage(shades.ball(level), x - r, y - r, 2 * r, 2 * r);
      return;
    }
    context.fillStyle = shades.fill[2][level];
    disc(context, x, y, r);
  }

  /**
   * A small cone from the face to the tip.
   * @param {CanvasRenderingContext2D} context
   * @param {Figure} figure
   * @param {number} level
   */
  paintNose(context, figure, level) {
    const { header, shades, x, y, scale } = figure;
    const { head: h, nose: t } = header;
    const r = header.head_radius * this.headSize * scale[h];
    const out = 1.18 * this.headSize;
    const fx = x[h] + 0.7 * this.headSize * (x[t] - x[h]);
    const fy = y[h] + 0.7 * this.headSize * (y[t] - y[h]);
    const tx = x[h] + out * (x[t] - x[h]);
    const ty = y[h] + out * (y[t] - y[h]);
    context.fillStyle = shades.edge[2][level];
    capsule(context, fx, fy, 0.27 * r + 1, tx, ty, 0.12 * r + 1);
    context.fillStyle = shades.light[2][level];
    capsule(context, fx, fy, 0.27 * r, tx, ty, 0.12 * r);
  }
}

/** @param {{ figure: Figure, limb: number }} item */
function depthOf({ figure, limb }) {
  const { depth, header } = figure;
  if (limb === HEAD) return depth[header.head];
  if (limb === NOSE) return depth[header.nose];
  const joints = figure.limbs[limb].joints;
  let [sum, near] = [0, Infinity];
  for (let k = 0; k < joints.length; k++) {
    const d = depth[joints[k]];
    sum += d;
    if (d < near) near = d;
  }
  return near < NEAR ? 0 : sum / joints.length;
}
