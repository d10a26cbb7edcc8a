// A perspective camera that orbits a target. Y up; at yaw 0 it looks at the faces of figures that face +Z.
import { clamp } from "../shared/numbers.mjs";

const FIELD_OF_VIEW = (30 * Math.PI) / 180;
export const NEAR = 0.1;
const [NEAREST, FURTHEST] = [2.2, 200]; // metres from which all figures are shown

export class Camera {
  constructor() {
    this.follow = true;
    this.centre = [0, 0]; // followed point on the ground
    this.eye = new Float64Array(3);
    this.target = [0, 0, 0];
    this.right = [1, 0, 0];
    this.up = [0, 1, 0];
    this.forward = [0, 0, -1];
    this.focal = this.middleX = this.middleY = 1;
    this.moved = false; // the person has chosen distance or place
    this.yaw = this.pitch = 0;
    this.pan = [0, 0, 0];
    this.distance = 5;
    this.reset({ yaw: 0.62, pitch: 0.2 });
  }

  /** @param {{ yaw: number, pitch: number }} view */
  reset({ yaw, pitch }) {
    this.moved = false;
    this.yaw = yaw;
    this.pitch = pitch;
    this.pan = [0, 0.85, 0];
    this.distance = 5;
  }

  /** @param {number} dx @param {number} dy */
  orbit(dx, dy) {
    this.yaw -= dx;
    this.pitch = clamp(this.pitch + dy, 0.01, 1.55);
  }

  /** @param {number} factor */
  zoom(factor) {
    this.moved = true;
    this.distance = clamp(this.distance * factor, 0.6, 200);
  }

  /**
   * Shift by pixels of a view that is `height` pixels high, in the plane that faces the camera.
   * @param {number} dx
   * @param {number} dy
   * @param {number} height
   */
  shift(dx, dy, height) {
    const metres = (2 * this.distance * Math.tan(FIELD_OF_VIEW / 2)) / height;
    for (let k = 0; k < 3; k++) this.pan[k] += metres * (dy * this.up[k] - dx * this.right[k]);
    this.pan[1] = clamp(this.pan[1], -1, 20);
    this.moved = true;
  }

  /**
   * Glide towards the followed point, or be there at once.
   * @param {number} x
   * @param {number} z
   * @param {number} seconds
   * @param {boolean} immediately
   */
  track(x, z, seconds, immediately) {
    const share = immediately ? 1 : 1 - Math.exp(-seconds * 6);
    this.centre[0] += (x - this.centre[0]) * share;
    this.centre[1] += (z - this.centre[1]) * share;
  }

  /**
   * Stand as near as shows a cloud of points around the target, with room at the edges.
   * @param {ArrayLike<number>} cloud
   * @param {number} aspect
   */
  fit(cloud, aspect) {
    if (this.moved) return;
    const vertical = Math.tan(FIELD_OF_VIEW / 2);
    this.prepare(1, 1);
    /** @param {{ low: number, high: number, wide: number }} span */
    const tooNear = ({ low, high, wide }) => high - low > 1.5 * vertical || wide > 0.86 * vertical * aspect;
    let [near, far] = [NEAREST, FURTHEST];
    if (!tooNear(this.span(cloud, near))) far = near;
    while (far / near > 1.02) {
      const middle = Math.sqrt(near * far);
      if (tooNear(this.span(cloud, middle))) near = middle;
      else far = middle;
    }
    const span = this.span(cloud, far);
    this.distance = far;
    this.pan = [0, (far * (span.high + span.low)) / 2 / this.up[1], 0];
  }

  /**
   * Tangents of the angles at which a cloud around the origin is seen from this far: lowest, highest, widest.
   * @param {ArrayLike<number>} cloud
   * @param {number} distance
   */
  span(cloud, distance) {
    const { right: r, up: u, forward: f } = this;
    let [low, high, wide] = [Infinity, 0, 0];
    for (let k = 0; k < cloud.length; k += 3) {
      const depth = Math.max(distance + cloud[k] * f[0] + cloud[k + 1] * f[1] + cloud[k + 2] * f[2], NEAR);
      const side = Math.abs(cloud[k] * r[0] + cloud[k + 2] * r[2]) / depth;
      const rise = (cloud[k] * u[0] + cloud[k + 1] * u[1] + cloud[k + 2] * u[2]) / depth;
      if (side > wide) wide = side;
      if (rise > high) high = rise;
      if (rise < low) low = rise;
    }
    return { low, high, wide };
  }

  /**
   * Set up for a view of this size in pixels; call before projecting.
   * @param {number} width
   * @param {number} height
   */
  prepare(width, height) {
    const [sy, cy, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    this.right = [cy, 0, -sy];
    this.up = [-sy * sp, cp, -cy * sp];
    this.forward = [-sy * cp, -sp, -cy * cp];
    this.target = [this.centre[0] + this.pan[0], this.pan[1], this.centre[1] + this.pan[2]];
    for (let k = 0; k < 3; k++) this.eye[k] = this.target[k] - this.distance * this.forward[k];
    this.focal = height / 2 / Math.tan(FIELD_OF_VIEW / 2);
    this.middleX = width / 2;
    this.middleY = height / 2;
  }

  /**
   * Distance along the view of a point; projectable where it exceeds `NEAR`.
   * @param {number} x
   * @param {number} y
   * @param {number} z
   */
  depth(x, y, z) {
    const { forward: f, eye: e } = this;
    return (x - e[0]) * f[0] + (y - e[1]) * f[1] + (z - e[2]) * f[2];
  }

  /**
   * Points (n, 3) to screen x, y, pixels per metre and depth, written into arrays of length n.
   * @param {ArrayLike<number>} points
   * @param {number} n
   * @param {Float32Array} x
   * @param {Float32Array} y
   * @param {Float32Array} scale
   * @param {Float32Array} depth
   */
  project(points, n, x, y, scale, depth) {
    const { right: r, up: u, forward: f, eye: e } = this;
    for (let j = 0, k = 0; j < n; j++, k += 3) {
      const a = points[k] - e[0];
      const b = points[k + 1] - e[1];
      const c = points[k + 2] - e[2];
      const d = a * f[0] + b * f[1] + c * f[2];
      const s = this.focal / Math.max(d, NEAR);
      x[j] = this.middleX + s * (a * r[0] + c * r[2]);
      y[j] = this.middleY - s * (a * u[0] + b * u[1] + c * u[2]);
      scale[j] = s;
      depth[j] = d;
    }
  }
}
