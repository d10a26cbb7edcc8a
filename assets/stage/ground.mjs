// The stage's floor: a round platform, a metre grid that stands still in the world, and the figures' shadows.
import { capsule } from "./body.mjs";
import { NEAR } from "./camera.mjs";
/** @import { Camera } from "./camera.mjs" */
/** @import { Figure } from "./figure.mjs" */
/** @import { Shelf, Theme } from "./types.d.ts" */

const LIGHT = [0.28, -0.22]; // metres a shadow slides along x and z for each metre of height
const SHELF_DEPTH = 0.5; // metres before and behind the stills
const ROUND = Array.from({ length: 72 }, (_, k) => [Math.cos((k * Math.PI) / 36), Math.sin((k * Math.PI) / 36)]);

export class Ground {
  constructor() {
    this.radius = 3;
    /** @type {Shelf[]} */
    this.shelves = []; // [{level, half}]: instead of the floor
    this.corners = new Float32Array(3 * 74);
    this.world = new Float32Array(6);
    this.x = new Float32Array(74);
    this.y = new Float32Array(74);
    this.scale = new Float32Array(74);
    this.depth = new Float32Array(74);
    this.sx = new Float32Array(256);
    this.sy = new Float32Array(256);
    this.ss = new Float32Array(256);
    this.sd = new Float32Array(256);
    this.flat = new Float32Array(3 * 256);
  }

  /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Theme} theme */
  paint(context, camera, theme) {
    if (this.shelves.length) {
      for (const shelf of this.shelves) this.paintShelf(context, camera, theme, shelf);
      return;
    }
    const [cx, cz] = [camera.target[0], camera.target[2]];
    context.fillStyle = theme.floorCss;
    if (this.platform(context, camera, cx, cz, this.radius)) context.fill();
    context.strokeStyle = theme.rimCss;
    context.lineWidth = 1.25;
    context.stroke();
  }

  /**
   * Outline of the platform as a path, cut off where it would lie behind the camera.
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {number} cx
   * @param {number} cz
   * @param {number} radius
   */
  platform(context, camera, cx, cz, radius) {
    let n = 0;
    const points = this.corners;
    const last = ROUND.length - 1;
    let [px, pz] = [cx + radius * ROUND[last][0], cz + radius * ROUND[last][1]];
    let before = camera.depth(px, 0, pz) - 2 * NEAR;
    for (const [cos, sin] of ROUND) {
      const [x, z] = [cx + radius * cos, cz + radius * sin];
      const here = camera.depth(x, 0, z) - 2 * NEAR;
      if (here * before < 0) {
        const t = before / (before - here);
        points[3 * n] = px + (x - px) * t;
        points[3 * n + 2] = pz + (z - pz) * t;
        n++;
      }
      if (here >= 0) {
        points[3 * n] = x;
        points[3 * n + 2] = z;
        n++;
      }
      [px, pz, before] = [x, z, here];
    }
    context.beginPath();
    if (n < 3) return false;
    camera.project(points, n, this.x, this.y, this.scale, this.depth);
    for (let k = 0; k < n; k++) context.lineTo(this.x[k], this.y[k]);
    context.closePath();
    return true;
  }

  /**
   * A board across the view under a row of stills.
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {Theme} theme
   * @param {Shelf} shelf
   */
  paintShelf(context, camera, theme, { level, half }) {
    [[-half, SHELF_DEPTH], [half, SHELF_DEPTH], [half, -SHELF_DEPTH], [-half, -SHELF_DEPTH]].forEach(([x, z], k) => {
      this.corners.set([x, level, z], 3 * k);
    });
    camera.project(this.corners, 4, this.x, this.y, this.scale, this.depth);
    if (Math.min(...this.depth.subarray(0, 4)) < NEAR) return;
    context.beginPath();
    for (let k = 0; k < 4; k++) context.lineTo(this.x[k], this.y[k]);
    context.closePath();
    context.fillStyle = theme.floorCss;
    context.fill();
    context.strokeStyle = theme.rimCss;
    context.lineWidth = 1.25;
    context.stroke();
  }

  /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Theme} theme */
  paintGrid(context, camera, theme) {
    if (this.shelves.length) return;
    const [cx, cz] = [camera.target[0], camera.target[2]];
    const step = this.radius > 9 ? 2 : this.radius > 4 ? 1 : 0.5;
    context.strokeStyle = theme.gridCss;
    context.lineWidth = 1;
    context.beginPath();
    for (let k = Math.ceil((cx - this.radius) / step); k * step < cx + this.radius; k++) {
      const half = Math.sqrt(Math.max(this.radius ** 2 - (k * step - cx) ** 2, 0));
      this.line(context, camera, k * step, cz - half, k * step, cz + half);
    }
    for (let k = Math.ceil((cz - this.radius) / step); k * step < cz + this.radius; k++) {
      const half = Math.sqrt(Math.max(this.radius ** 2 - (k * step - cz) ** 2, 0));
      this.line(context, camera, cx - half, k * step, cx + half, k * step);
    }
    context.stroke();
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {number} x1
   * @param {number} z1
   * @param {number} x2
   * @param {number} z2
   */
  line(context, camera, x1, z1, x2, z2) {
    const w = this.world;
    let [a, b] = [0, 1];
    const d1 = camera.depth(x1, 0, z1) - 2 * NEAR;
    const d2 = camera.depth(x2, 0, z2) - 2 * NEAR;
    if (d1 < 0 && d2 < 0) return;
    if (d1 < 0) a = d1 / (d1 - d2);
    if (d2 < 0) b = d1 / (d1 - d2);
    w[0] = x1 + (x2 - x1) * a;
    w[2] = z1 + (z2 - z1) * a;
    w[3] = x1 + (x2 - x1) * b;
    w[5] = z1 + (z2 - z1) * b;
    camera.project(w, 2, this.x, this.y, this.scale, this.depth);
    context.moveTo(this.x[0], this.y[0]);
    context.lineTo(this.x[1], this.y[1]);
  }

  /**
   * The figure laid flat along the light; then once more, darker, where it comes close to the floor.
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {Figure} figure
   * @param {Theme} theme
   */
  paintShadow(context, camera, figure, theme) {
    const n = Math.min(figure.n, 256);
    const { points } = figure;
    for (let k = 0; k < 3 * n; k += 3) {
      const height = Math.max(points[k + 1] - figure.level, 0);
      this.flat[k] = points[k] + LIGHT[0] * height;
      this.flat[k + 1] = figure.level;
      this.flat[k + 2] = points[k + 2] + LIGHT[1] * height;
    }
    camera.project(this.flat, n, this.sx, this.sy, this.ss, this.sd);
    context.fillStyle = theme.shadowCss;
    for (const limb of figure.limbs) this.shadowLimb(context, camera, figure, limb.bones, Infinity);
    const { head, head_radius: radius } = figure.header;
    if (head >= 0) {
      const r = radius * this.ss[head];
      capsule(context, this.sx[head] - 0.4 * r, this.sy[head], 0.6 * r, this.sx[head] + 0.4 * r, this.sy[head], 0.6 * r);
    }
    context.fillStyle = theme.contactCss;
    for (const limb of figure.limbs) this.shadowLimb(context, camera, figure, limb.bones, figure.level + 0.16 * figure.size);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {Figure} figure
   * @param {number[]} bones
   * @param {number} below
   */
  shadowLimb(context, camera, figure, bones, below) {
    const squash = 0.45 + 0.5 * Math.sin(camera.pitch);
    for (let k = 0; k < bones.length; k += 2) {
      const a = bones[k];
      const b = bones[k + 1];
      if (figure.points[3 * a + 1] > below || figure.points[3 * b + 1] > below) continue;
      if (this.sd[a] < NEAR || this.sd[b] < NEAR) continue;
      const ra = figure.radii[a] * this.ss[a] * squash;
      const rb = figure.radii[b] * this.ss[b] * squash;
      capsule(context, this.sx[a], this.sy[a], ra, this.sx[b], this.sy[b], rb);
    }
  }
}
