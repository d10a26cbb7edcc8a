// Bodies: limbs as tapered capsules, sorted by depth. Convex polygons, one by one, are what a software rasteriser
// fills fastest (measured: 1500 a frame at 50 frames a second, against 25 for round strokes).
(function (parts) {
  "use strict";

  const CAP = [-0.92388, -0.38268, 0.38268, 0.92388]; // sines of the cap's corners
  const CAP_COS = [0.38268, 0.92388, 0.92388, 0.38268];
  const CIRCLE = Array.from({ length: 20 }, (_, k) => [Math.cos((k * Math.PI) / 10), Math.sin((k * Math.PI) / 10)]);

  /** A capsule from one circle to another, as a convex polygon. */
  function capsule(context, x1, y1, r1, x2, y2, r2) {
    let dx = x2 - x1;
    let dy = y2 - y1;
    const length = Math.sqrt(dx * dx + dy * dy);
    if (length < 0.5) {
      disc(context, x1, y1, Math.max(r1, r2));
      return;
    }
    dx /= length;
    dy /= length;
    context.beginPath();
    for (let k = 0; k < 4; k++) {
      const along = r2 * CAP_COS[k];
      const across = r2 * CAP[k];
      context.lineTo(x2 + along * dx - across * dy, y2 + along * dy + across * dx);
    }
    for (let k = 3; k >= 0; k--) {
      const along = -r1 * CAP_COS[k];
      const across = r1 * CAP[k];
      context.lineTo(x1 + along * dx - across * dy, y1 + along * dy + across * dx);
    }
    context.fill();
  }

  function disc(context, x, y, r) {
    context.beginPath();
    for (let k = 0; k < 20; k++) context.lineTo(x + r * CIRCLE[k][0], y + r * CIRCLE[k][1]);
    context.fill();
  }

  const HEAD = -1;
  const NOSE = -2;

  /** Draws all limbs, heads and noses of the figures, furthest first. */
  class BodyPainter {
    constructor() {
      this.items = []; // kept from frame to frame: nearly sorted already
      this.owners = [];
    }

    /** Call when the set of visible figures changes. */
    collect(figures) {
      this.items = [];
      this.owners = figures.filter((figure) => figure.visible);
      for (const figure of this.owners) {
        figure.limbs.forEach((_, limb) => this.items.push({ figure, limb, depth: 0 }));
        if (figure.header.head >= 0) this.items.push({ figure, limb: HEAD, depth: 0 });
        if (figure.header.nose >= 0) this.items.push({ figure, limb: NOSE, depth: 0 });
      }
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

    paint(context, camera, reach) {
      this.sort();
      const levels = parts.FOG_LEVELS;
      for (const { figure, limb, depth } of this.items) {
        if (depth < parts.NEAR) continue;
        const far = (depth - camera.distance + reach) / (2 * reach);
        const level = Math.min(Math.max(Math.round(far * (levels - 1)), 0), levels - 1);
        if (limb === HEAD) this.paintHead(context, figure, level);
        else if (limb === NOSE) this.paintNose(context, figure, level);
        else this.paintLimb(context, figure, figure.limbs[limb], level);
      }
    }

    paintLimb(context, figure, limb, level) {
      const { x, y, scale, radii, shades } = figure;
      const bones = limb.bones;
      if (this.outlined) {
        context.fillStyle = shades.edge[limb.side][level];
        for (let k = 0; k < bones.length; k += 2) {
          const a = bones[k];
        const b = bones[k + 1];
          const line = 1 + 0.004 * scale[a];
          capsule(context, x[a], y[a], radii[a] * scale[a] + line, x[b], y[b], radii[b] * scale[b] + line);
        }
      }
      context.fillStyle = shades.fill[limb.side][level];
      for (let k = 0; k < bones.length; k += 2) {
        const a = bones[k];
        const b = bones[k + 1];
        capsule(context, x[a], y[a], radii[a] * scale[a], x[b], y[b], radii[b] * scale[b]);
      }
      if (!this.detailed) return;
      context.fillStyle = shades.light[limb.side][level];
      for (let k = 0; k < bones.length; k += 2) {
        const a = bones[k];
        const b = bones[k + 1];
        const ra = radii[a] * scale[a];
        const rb = radii[b] * scale[b];
        capsule(context, x[a] - 0.32 * ra, y[a] - 0.32 * ra, 0.36 * ra, x[b] - 0.32 * rb, y[b] - 0.32 * rb, 0.36 * rb);
      }
    }

    paintHead(context, figure, level) {
      const { header, shades } = figure;
      const [x, y] = [figure.x[header.head], figure.y[header.head]];
      const r = header.head_radius * figure.scale[header.head];
      if (this.outlined) {
        context.fillStyle = shades.edge[2][level];
        disc(context, x, y, r + 1 + 0.004 * figure.scale[header.head]);
      }
      context.fillStyle = shades.fill[2][level];
      disc(context, x, y, r);
      if (!this.detailed) return;
      context.fillStyle = shades.light[2][level];
      disc(context, x - 0.3 * r, y - 0.32 * r, 0.42 * r);
    }

    /** A small cone from the face to the tip. */
    paintNose(context, figure, level) {
      const { header, shades, x, y, scale } = figure;
      const [h, t] = [header.head, header.nose];
      const r = header.head_radius * scale[h];
      const [fx, fy] = [x[h] + 0.72 * (x[t] - x[h]), y[h] + 0.72 * (y[t] - y[h])];
      const [tx, ty] = [x[h] + 1.25 * (x[t] - x[h]), y[h] + 1.25 * (y[t] - y[h])];
      context.fillStyle = shades.edge[2][level];
      capsule(context, fx, fy, 0.3 * r, tx, ty, 0.13 * r);
    }
  }

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
    return near < parts.NEAR ? 0 : sum / joints.length;
  }

  Object.assign(parts, { BodyPainter, capsule, disc });
})((window.motionscapeStageParts ||= {}));
