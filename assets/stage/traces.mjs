// Ghosts (onion skins) and trails: where the figures were, and where they will be.
import { disc } from "./body.mjs";
import { NEAR } from "./camera.mjs";
import { PathPainter } from "./spans.mjs";
/** @import { Camera } from "./camera.mjs" */
/** @import { Figure } from "./figure.mjs" */
/** @import { Clock } from "./timeline.mjs" */

export const TRAILS = ["off", "root", "limbs"];
const GHOST_GAP = 0.22; // seconds of the stage between ghosts
const TRAIL_SECONDS = 1.6;
const TRAIL_POINTS = 40;

export class Traces {
  constructor() {
    this.ghosts = false;
    this.trails = "off";
    this.suited = false; // trails were switched on for the sake of coloured spans
    this.paths = new PathPainter();
    this.points = new Float32Array(3 * 256);
    this.x = new Float32Array(256);
    this.y = new Float32Array(256);
    this.scale = new Float32Array(256);
    this.depth = new Float32Array(256);
  }

  /**
   * Motions with coloured spans show them on the floor; without them trails are as the person left them.
   * @param {Figure[]} figures
   */
  suit(figures) {
    const coloured = figures.some((figure) => figure.spans.length);
    if (coloured && this.trails === "off") [this.trails, this.suited] = ["root", true];
    else if (!coloured && this.suited) [this.trails, this.suited] = ["off", false];
  }

  nextTrails() {
    this.suited = false;
    this.trails = TRAILS[(TRAILS.indexOf(this.trails) + 1) % TRAILS.length];
  }

  /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Figure[]} figures @param {Clock} clock */
  paint(context, camera, figures, clock) {
    const shown = figures.filter((figure) => figure.visible);
    context.lineJoin = "round";
    context.lineCap = "round";
    if (this.trails === "root") this.paths.paint(context, camera, shown, clock.duration);
    if (this.trails !== "off") for (const figure of shown) this.paintTrails(context, camera, figure, clock);
    if (!this.ghosts || !shown.length) return;
    const count = Math.min(Math.max(Math.floor(24 / shown.length), 1), 4);
    for (let g = count; g >= 1; g--) {
      context.globalAlpha = 0.34 * (1 - (g - 1) / (count + 0.5));
      for (const figure of shown) {
        if (clock.time - g * GHOST_GAP > 0) this.paintGhost(context, camera, figure, clock.time - g * GHOST_GAP);
        if (g <= count / 2 && clock.time + g * GHOST_GAP < clock.duration) {
          this.paintGhost(context, camera, figure, clock.time + g * GHOST_GAP);
        }
      }
    }
    context.globalAlpha = 1;
  }

  /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Figure} figure @param {number} time */
  paintGhost(context, camera, figure, time) {
    if (figure.n > 256) return;
    figure.pose(time, this.points);
    camera.project(this.points, figure.n, this.x, this.y, this.scale, this.depth);
    for (const limb of figure.limbs) {
      context.strokeStyle = figure.shades.fill[limb.side][0];
      context.lineWidth = Math.max(1.4 * figure.radii[limb.bones[1]] * this.scale[limb.bones[0]], 1.5);
      context.beginPath();
      let last = -1;
      for (let k = 0; k < limb.bones.length; k += 2) {
        const a = limb.bones[k];
        const b = limb.bones[k + 1];
        if (this.depth[a] < NEAR || this.depth[b] < NEAR) continue;
        if (a !== last) context.moveTo(this.x[a], this.y[a]);
        context.lineTo(this.x[b], this.y[b]);
        last = b;
      }
      context.stroke();
    }
    const { head, head_radius: radius } = figure.header;
    if (head < 0 || this.depth[head] < NEAR) return;
    context.fillStyle = figure.shades.fill[2][0];
    disc(context, this.x[head], this.y[head], radius * this.scale[head]);
  }

  /**
   * A ribbon of the last seconds for the root, or for hands and feet.
   * @param {CanvasRenderingContext2D} context
   * @param {Camera} camera
   * @param {Figure} figure
   * @param {Clock} clock
   */
  paintTrails(context, camera, figure, clock) {
    const { header } = figure;
    if (this.trails === "root" && figure.spans.length) return; // its path is on the floor
    const feet = header.feet.filter((j) => /_ankle$/.test(header.roles[j]));
    const joints = this.trails === "root" ? [header.root] : [...header.hands, ...feet];
    const from = Math.max(0, clock.time - TRAIL_SECONDS);
    const n = Math.max(2, Math.ceil((TRAIL_POINTS * (clock.time - from)) / TRAIL_SECONDS));
    const paths = joints.map(() => new Float32Array(3 * n));
    for (let s = 0; s < n; s++) {
      figure.pose(from + ((clock.time - from) * s) / (n - 1), this.points);
      joints.forEach((j, k) => paths[k].set(this.points.subarray(3 * j, 3 * j + 3), 3 * s));
    }
    joints.forEach((j, k) => {
      camera.project(paths[k], n, this.x, this.y, this.scale, this.depth);
      context.strokeStyle = figure.shades.fill[figure.sides[j]][0];
      context.lineWidth = 2;
      // three strokes, the older the fainter
      for (let third = 0; third < 3; third++) {
        context.globalAlpha = 0.25 + 0.3 * third;
        context.beginPath();
        for (let s = Math.floor((n * third) / 3); s < Math.min(n, Math.floor((n * (third + 1)) / 3) + 1); s++) {
          if (this.depth[s] > NEAR) context.lineTo(this.x[s], this.y[s]);
        }
        context.stroke();
      }
    });
    context.globalAlpha = 1;
  }
}
