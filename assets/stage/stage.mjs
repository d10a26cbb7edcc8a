// The Stage: a 3D player of stick figures on a 2D canvas. The server sends each motion once; the browser keeps the time.
import { within } from "../shared/dom.mjs";
import { Camera } from "./camera.mjs";
import { figureColours, readTheme, shades } from "./colours.mjs";
import { Controls } from "./controls.mjs";
import { StageEvents } from "./events.mjs";
import { Frames } from "./frames.mjs";
import * as ids from "./ids.mjs";
import { homeView, measureStage, placeFigures } from "./layout.mjs";
import { Looks } from "./looks.mjs";
import { describe, Messages } from "./messages.mjs";
import { nameFigures } from "./names.mjs";
import { Requests } from "./requests.mjs";
import { Scene } from "./scene.mjs";
import { SpanBands } from "./spans.mjs";
import { calm, LAYOUTS, restoreState, standing, takeState, timeOf } from "./state.mjs";
import { Clock, makeTimeline } from "./timeline.mjs";
import { Traces } from "./traces.mjs";
import { WarpStrip } from "./warp.mjs";
/** @import { Figure } from "./figure.mjs" */
/** @import { Moment, SavedState, StageRequest } from "./types.d.ts" */

/** @type {Record<string, string>} */
const LAYOUT_WORDS = { overlay: "Overlay", side: "Side by side", pose: "Stills in rows" };

export class Stage {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.root = root;
    this.clock = new Clock();
    this.camera = new Camera();
    this.traces = new Traces();
    this.scene = new Scene(/** @type {HTMLCanvasElement} */ (/** @type {Element} */ (within(root, `#${ids.STAGE_CANVAS}`))), readTheme(root));
    this.warpStrip = new WarpStrip(within(root, ".ms-warp"));
    this.bands = new SpanBands(within(root, ".ms-bands"));
    this.requests = new Requests(this);
    /** @type {Figure[]} */
    this.figures = [];
    /** @type {StageRequest | null | undefined} */
    this.request = undefined;
    this.timeline = { reference: 0, warped: false, fps: 30, duration: 0 };
    this.layout = "overlay";
    this.sync = "warp";
    this.status = "empty";
    this.chosen = -1;
    this.closed = false;
    /** @type {SavedState | undefined} */
    this.waiting = undefined;
    this.frames = new Frames(this);
    this.events = new StageEvents(this);
    this.messages = new Messages(root);
    this.controls = new Controls(this, root);
    this.looks = new Looks(this);
    this.readLooks();
    this.setStatus("empty");
    this.frames.start();
  }

  /** Colours and sizes are others: paint with them. */
  readLooks() {
    this.scene.setTheme(readTheme(this.root));
    this.colour();
  }

  resized() {
    if (this.scene.resize()) this.fit();
    this.warpStrip.paint();
    this.draw();
  }

  close() {
    this.closed = true;
    this.looks.close();
  }

  /** Show figures from their start, as a request wants it. @param {Figure[]} figures @param {StageRequest} request */
  begin(figures, request) {
    this.layout = request.layout && LAYOUTS.includes(request.layout) ? request.layout : "overlay";
    this.sync = request.sync === "start" ? "start" : "warp";
    this.clock.time = 0;
    this.camera.reset(homeView(figures, this.layout));
    this.traces.suit(figures);
    this.setFigures(figures);
    this.setStatus("ready");
    this.clock.playing = false;
    if (this.layout === "pose") this.standStill();
    else if (!calm()) this.clock.play();
    if (this.waiting) this.restore(this.waiting);
    this.touch(true);
  }

  /**
   * Put other figures in place of those that are shown; what a person has set, and the share of time, stay.
   * @param {Figure[]} figures
   */
  exchange(figures) {
    if (figures.length === this.figures.length) figures.forEach((figure, k) => (figure.visible = this.figures[k].visible));
    this.keepingShare(() => this.setFigures(figures, true));
    this.setStatus("ready");
    this.touch();
  }

  /** Stills show the middle of each motion, until one moves them. */
  standStill() {
    this.clock.playing = false;
    this.clock.seek(this.clock.duration / 2);
  }

  /** @param {Figure[]} figures @param {boolean} [keepView] */
  setFigures(figures, keepView = false) {
    this.figures = figures;
    nameFigures(figures);
    this.prepare(keepView);
  }

  /** Do what changes the length of time; the clock goes on at the same share of it. @param {() => void} change */
  keepingShare(change) {
    const { clock } = this;
    const share = clock.duration ? clock.time / clock.duration : 0;
    change();
    clock.seek(share * clock.duration);
  }

  /**
   * Everything that depends on which figures there are, how they are laid out and kept in step.
   * @param {boolean} [keepView]
   */
  prepare(keepView = false) {
    this.timeline = makeTimeline(this.figures, this.sync, this.layout);
    this.clock.duration = this.timeline.duration;
    this.clock.seek(this.clock.time);
    this.showStrips();
    this.place(keepView); // in the room that the strips leave
    this.controls.listFigures();
    this.colour();
  }

  /** The strips above the time bar: how fast each motion is, and its coloured spans. */
  showStrips() {
    this.warpStrip.show(this.figures, this.timeline);
    this.warpStrip.paint();
    this.bands.show(this.figures, this.timeline.duration);
  }

  /** @param {boolean} [keepView] */
  place(keepView = false) {
    this.scene.resize();
    const aspect = this.scene.width / Math.max(this.scene.height, 1);
    this.scene.ground.shelves = placeFigures(this.figures, this.layout, aspect, this.clock.duration);
    this.scene.bodies.collect(this.figures, this.layout === "overlay");
    if (!keepView) this.fit();
    this.clock.jumped = true;
    this.draw();
  }

  /** Frame all figures, unless the person has chosen a distance already. */
  fit() {
    if (!this.figures.length) return;
    const { cloud, radius } = measureStage(this.figures, this.clock.duration);
    this.camera.fit(cloud, this.scene.width / Math.max(this.scene.height, 1));
    this.scene.ground.radius = Math.max(2.2, radius * 1.5 + 0.6);
  }

  colour() {
    const { theme } = this.scene;
    this.figures.forEach((figure, k) => {
      figure.colours = figureColours(theme, k, this.figures.length, figure.item.colour);
      figure.shades = shades(theme, figure.colours, this.chosen >= 0 && this.chosen !== k ? 0.72 : 0);
    });
    this.controls.colourChips();
    this.warpStrip.paint();
    this.draw();
  }

  /** @param {number} k */
  highlight(k) {
    this.chosen = k;
    this.colour();
  }

  /** Say which figure is under the pointer. @param {number} x @param {number} y */
  pointAt(x, y) {
    const { canvas, ratio } = this.scene;
    const figure = this.figures.length > 1 ? this.scene.figureAt(this.figures, x * ratio, y * ratio) : undefined;
    const title = figure ? `${figure.label}, frame ${figure.recordedFrame(this.clock.time)}` : "";
    if (canvas.title !== title) canvas.title = title;
  }

  /** @param {number} k @param {boolean} visible */
  setVisible(k, visible) {
    this.figures[k].visible = visible;
    this.place();
    this.showStrips();
    this.touch(true);
  }

  /** @param {string} layout */
  setLayout(layout) {
    if (this.figures.length < 2) return;
    this.layout = layout;
    this.camera.reset(homeView(this.figures, layout));
    this.keepingShare(() => this.prepare());
    if (layout === "pose") this.standStill();
    this.messages.say(LAYOUT_WORDS[layout]);
  }

  /** @param {string} sync */
  setSync(sync) {
    if (!this.figures.some((figure) => figure.warp)) return;
    this.sync = sync;
    this.keepingShare(() => this.prepare());
    this.messages.say(this.timeline.warped ? "In step" : "Each at its own pace");
  }

  play() {
    this.clock.play();
    this.touch(true);
  }

  pause() {
    this.clock.playing = false;
    this.touch(true);
  }

  /**
   * To a time in seconds, or to a frame of a clip: {clip, frame, dataset?, index?}. False where that is not shown.
   * @param {number | Moment | null} to
   */
  seek(to) {
    const time = typeof to === "number" ? to : to ? timeOf(this.figures, to) : null;
    if (time === null || !Number.isFinite(time)) return false;
    this.clock.seek(time);
    this.touch();
    return true;
  }

  /** @param {number} frames */
  step(frames) {
    this.clock.playing = false;
    const { fps } = this.timeline;
    this.seek(Math.round(this.clock.time * fps + frames) / fps);
    this.controls.update();
  }

  resetCamera() {
    this.camera.reset(homeView(this.figures, this.layout));
    this.place();
    this.messages.say("View reset");
  }

  /**
   * Something changed: draw, bring the buttons in line (`byHand`: the person did it), tell the app.
   * @param {boolean} [byHand]
   */
  touch(byHand) {
    if (byHand) this.controls.update();
    this.draw();
    this.events.tellState();
  }

  draw() {
    this.frames.stale = true;
  }

  /** Where every figure stands now. */
  standing() {
    return this.figures.map((figure) => standing(figure, this.clock.time));
  }

  /** @param {string} status @param {string} [message] */
  setStatus(status, message = "") {
    this.status = status;
    this.root.dataset.status = status;
    this.messages.show(status === "empty" ? "" : this.request?.title || this.request?.items[0]?.label || "", message);
    this.scene.canvas.setAttribute("aria-label", status === "ready" ? describe(this.figures) : "Stage for moving figures");
    this.controls.update();
    this.draw();
  }

  state() {
    return takeState(this);
  }

  /** @param {SavedState} state */
  restore(state) {
    this.waiting = this.status === "ready" ? undefined : state;
    if (this.status !== "ready") return;
    restoreState(this, state);
    this.touch(true);
  }
}
