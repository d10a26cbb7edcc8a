// The picture: sky, ground, shadows, traces, bodies and labels on one canvas.
import { context2d } from "../shared/dom.mjs";
import { BodyPainter, disc } from "./body.mjs";
import { NEAR } from "./camera.mjs";
import { css } from "./colours.mjs";
import { Ground } from "./ground.mjs";
import { shorten } from "./names.mjs";
/** @import { Camera } from "./camera.mjs" */
/** @import { Figure } from "./figure.mjs" */
/** @import { Clock } from "./timeline.mjs" */
/** @import { Traces } from "./traces.mjs" */
/** @import { Theme } from "./types.d.ts" */

const [LEAST_LETTERS, MOST_LETTERS] = [11, 26]; // with fewer the brief name tells more
const LABELS_OVERLAID = 3; // more would cover one another

export class Scene {
  /** @param {HTMLCanvasElement} canvas @param {Theme} theme */
  constructor(canvas, theme) {
    this.canvas = canvas;
    this.context = context2d(canvas, { alpha: false });
    this.ground = new Ground();
    this.bodies = new BodyPainter();
    this.sky = document.createElement("canvas");
    this.labels = new Map();
    this.width = this.height = 0;
    this.ratio = 0; // of the screen's pixels to those of the page
    this.theme = theme;
  }

  /** Match the canvas to its box and the screen's pixels; true when anything changed. */
  resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (width === this.width && height === this.height && ratio === this.ratio) return false;
    this.canvas.width = this.width = width;
    this.canvas.height = this.height = height;
    this.ratio = ratio;
    this.labels.clear();
    this.paintSky();
    return true;
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    this.theme = theme;
    for (const name of ["floor", "rim", "grid", "shadow", "contact", "text"]) theme[`${name}Css`] = css(theme[name]);
    this.labels.clear();
    this.paintSky();
  }

  paintSky() {
    if (!this.theme || !this.width) return;
    this.sky.width = this.width;
    this.sky.height = this.height;
    const context = context2d(this.sky);
    const gradient = context.createLinearGradient(0, 0, 0, this.height);
    gradient.addColorStop(0, css(this.theme.sky));
    gradient.addColorStop(1, css(this.theme.haze));
    context.fillStyle = gradient;
    context.fillRect(0, 0, this.width, this.height);
  }

  /**
   * @param {Camera} camera
   * @param {Figure[]} figures
   * @param {Traces} traces
   * @param {Clock} clock
   * @param {boolean} overlaid
   */
  paint(camera, figures, traces, clock, overlaid) {
    const { context, theme } = this;
    camera.prepare(this.width, this.height);
    context.drawImage(this.sky, 0, 0);
    this.ground.paint(context, camera, theme);
    for (const figure of figures) {
      if (!figure.visible) continue;
      camera.project(figure.points, figure.n, figure.x, figure.y, figure.scale, figure.depth);
      this.ground.paintShadow(context, camera, figure, theme);
    }
    this.ground.paintGrid(context, camera, theme);
    traces.paint(context, camera, figures, clock);
    this.bodies.paint(context, camera, Math.min(this.ground.radius, 0.8 * camera.distance));
    if (figures.length > 1) this.paintLabels(figures, overlaid);
  }

  /**
   * The visible figure at a place of the picture, in its pixels; undefined where there is none near.
   * @param {Figure[]} figures
   * @param {number} x
   * @param {number} y
   */
  figureAt(figures, x, y) {
    /** @type {Figure | undefined} */
    let hit;
    let least = Infinity;
    for (const figure of figures) {
      if (!figure.visible) continue;
      for (let j = 0; j < figure.n; j++) {
        if (figure.depth[j] < NEAR) continue;
        const away = Math.hypot(figure.x[j] - x, figure.y[j] - y);
        const near = away + 0.02 * figure.depth[j]; // of two as near, the one in front
        if (away < Math.max(14 * this.ratio, 0.16 * figure.scale[j]) && near < least) [hit, least] = [figure, near];
      }
    }
    return hit;
  }

  /** @param {Figure[]} figures @param {boolean} overlaid */
  paintLabels(figures, overlaid) {
    const shown = figures.filter((figure) => figure.visible);
    if (overlaid && shown.length > LABELS_OVERLAID) return;
    /** @type {number[][]} */
    const taken = [];
    for (const figure of shown.sort((a, b) => a.depth[a.header.root] - b.depth[b.header.root])) {
      const top = figure.header.head >= 0 ? figure.header.head : figure.header.root;
      if (figure.depth[top] < NEAR) continue;
      const sprite = this.label(figure, figure.room * figure.scale[top]);
      if (!sprite) continue;
      const room = this.canvas.width - sprite.width;
      if (figure.x[top] < 0 || figure.x[top] > this.canvas.width) continue;
      const x = Math.round(Math.min(Math.max(figure.x[top] - sprite.width / 2, 0), Math.max(room, 0))); // whole, not cut
      const highest = figure.room === Infinity ? figure.y[top] : Math.min(...figure.y) + 0.12 * figure.size * figure.scale[top];
      let y = Math.round(highest - (0.17 * figure.size * figure.scale[top] + 1.2 * sprite.height));
      /** @param {number[]} box */
      const hits = (box) => Math.abs(box[0] - x) < (box[2] + sprite.width) / 2 && Math.abs(box[1] - y) < sprite.height;
      for (let tries = 0; tries < 4 && shown.length <= 4 && taken.some(hits); tries++) y -= sprite.height + 2;
      if (taken.some(hits) || y < 0) continue;
      taken.push([x, y, sprite.width]);
      this.context.drawImage(sprite, x, y);
    }
  }

  /**
   * A label drawn once: text on a soft plate with the figure's colour, no wider than `room` pixels; or none.
   * @param {Figure} figure
   * @param {number} room
   */
  label(figure, room) {
    const size = 11.5 * this.ratio;
    const letters = Math.min(Math.floor((0.96 * room - 2.1 * size) / (0.56 * size)), MOST_LETTERS);
    const whole = letters >= Math.min(LEAST_LETTERS, figure.name.length);
    if (!whole && figure.brief.length > letters + 1) return null;
    const text = whole ? shorten(figure.name, letters) : figure.brief;
    const key = `${text}|${figure.shades.fill[2][0]}`;
    if (this.labels.has(key)) return this.labels.get(key);
    const sprite = document.createElement("canvas");
    let context = context2d(sprite);
    const font = `500 ${size}px ${this.theme.font}`;
    context.font = font;
    sprite.width = Math.ceil(context.measureText(text).width + 2.1 * size);
    sprite.height = Math.ceil(1.7 * size);
    context = context2d(sprite);
    context.globalAlpha = 0.82;
    context.fillStyle = css(this.theme.sky);
    context.beginPath();
    context.roundRect(0, 0, sprite.width, sprite.height, sprite.height / 2);
    context.fill();
    context.globalAlpha = 1;
    context.fillStyle = figure.shades.fill[2][0];
    disc(context, 0.85 * size, sprite.height / 2, 0.32 * size);
    context.font = font;
    context.textBaseline = "middle";
    context.fillStyle = this.theme.textCss;
    context.fillText(text, 1.4 * size, sprite.height / 2 + 0.5);
    this.labels.set(key, sprite);
    return sprite;
  }
}
