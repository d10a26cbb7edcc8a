// A small Stage for a block or a report: the figures of the Stage, without its bars.
import { Camera } from "../stage/camera.mjs";
import { figureColours, readTheme, shades } from "../stage/colours.mjs";
import { groundCentre, homeView, measureStage, placeFigures } from "../stage/layout.mjs";
import { nameFigures } from "../stage/names.mjs";
import { Scene } from "../stage/scene.mjs";
import { Clock, makeTimeline } from "../stage/timeline.mjs";
import { Traces } from "../stage/traces.mjs";
/** @import { Figure } from "../stage/figure.mjs" */

const calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

export class Player {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.scene = new Scene(canvas, readTheme(canvas));
    this.camera = new Camera();
    this.clock = new Clock();
    this.traces = new Traces();
    /** @type {Figure[]} */
    this.figures = [];
    this.layout = "overlay";
    this.closed = false;
    this.dirty = true;
    this.before = 0;
    this.onFrame = () => {};
    this.sizes = new ResizeObserver(() => this.fit());
    this.sizes.observe(canvas);
    this.takeHand();
    this.recolour();
    /** @param {number} now */
    this.frame = (now) => this.tick(now);
    requestAnimationFrame(this.frame);
  }

  close() {
    this.closed = true;
    this.sizes.disconnect();
  }

  /** @param {Figure[]} figures */
  show(figures) {
    this.figures = figures;
    nameFigures(figures);
    this.clock.duration = makeTimeline(figures, "warp", this.layout).duration;
    this.clock.seek(0);
    this.camera.reset(homeView(figures, this.layout));
    this.traces.suit(figures);
    this.place();
    this.recolour();
    if (calm()) this.clock.playing = false;
    else this.clock.play();
  }

  /** @param {string} layout "overlay" or "side" */
  lay(layout) {
    this.layout = layout;
    this.camera.reset(homeView(this.figures, layout));
    this.place();
  }

  place() {
    this.scene.resize();
    const aspect = this.scene.width / Math.max(this.scene.height, 1);
    this.scene.ground.shelves = placeFigures(this.figures, this.layout, aspect, this.clock.duration);
    this.scene.bodies.collect(this.figures, this.layout === "overlay");
    this.fit();
    this.clock.jumped = true;
  }

  fit() {
    this.scene.resize();
    if (this.figures.length) {
      const { cloud, radius } = measureStage(this.figures, this.clock.duration);
      this.camera.fit(cloud, this.scene.width / Math.max(this.scene.height, 1));
      this.scene.ground.radius = Math.max(2.2, radius * 1.5 + 0.6);
    }
    this.dirty = true;
  }

  recolour() {
    this.scene.setTheme(readTheme(this.canvas));
    this.figures.forEach((figure, k) => {
      figure.colours = figureColours(this.scene.theme, k, this.figures.length, figure.item.colour);
      figure.shades = shades(this.scene.theme, figure.colours, 0);
    });
    this.dirty = true;
  }

  /** @param {number} share of the time, 0 to 1 */
  seek(share) {
    this.clock.seek(share * this.clock.duration);
    this.dirty = true;
  }

  toggle() {
    if (this.clock.playing) this.clock.playing = false;
    else this.clock.play();
    this.dirty = true;
  }

  takeHand() {
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (!(event.buttons & 3)) return;
      if (event.shiftKey || event.buttons & 2) this.camera.shift(event.movementX, event.movementY, canvas.clientHeight);
      else this.camera.orbit(event.movementX / 160, event.movementY / 200);
      this.dirty = true;
    });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && document.activeElement !== canvas) return; // the page scrolls
      event.preventDefault();
      this.camera.zoom(event.deltaY > 0 ? 1.1 : 1 / 1.1);
      this.dirty = true;
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    /** @type {Record<string, () => void>} */
    const keys = {
      " ": () => this.toggle(),
      ArrowLeft: () => this.camera.orbit(-0.1, 0), ArrowRight: () => this.camera.orbit(0.1, 0),
      "+": () => this.camera.zoom(1 / 1.15), "-": () => this.camera.zoom(1.15),
    };
    if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
    this.dirty = true;
  }

  /** @param {number} now */
  tick(now) {
    if (this.closed) return;
    requestAnimationFrame(this.frame);
    const seconds = Math.min(Math.max((now - this.before) / 1000, 0), 0.25);
    this.before = now;
    if (this.clock.playing) this.clock.advance(seconds);
    if (!this.clock.playing && !this.dirty) return;
    this.dirty = false;
    this.paint(this.clock.playing ? seconds : Infinity);
    this.onFrame();
  }

  /**
   * Paint the moment of the clock.
   * @param {number} seconds since the picture before, while which the camera follows; Infinity: it is there at once
   */
  paint(seconds) {
    for (const figure of this.figures) if (figure.visible) figure.pose(this.clock.time);
    if (this.figures.length) {
      const [x, z] = groundCentre(this.figures, [0, 0]);
      if (this.camera.follow) this.camera.track(x, z, seconds, this.clock.jumped || seconds === Infinity);
      this.clock.jumped = false;
    }
    this.scene.paint(this.camera, this.figures, this.traces, this.clock, this.layout === "overlay");
  }
}
