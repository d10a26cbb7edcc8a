// The frames of the Stage: when they are painted, and what is brought up to date before each.
import { groundCentre } from "./layout.mjs";
import { readout } from "./messages.mjs";
/** @import { Stage } from "./stage.mjs" */

const LONGEST_STEP = 0.25; // seconds that the clock goes on at once, however long the browser was busy

export class Frames {
  /** @param {Stage} stage */
  constructor(stage) {
    this.stage = stage;
    this.fps = 0; // a running mean
    this.stale = true; // what is painted differs from what is to be seen
    /** @type {number | undefined} */
    this.before = undefined; // when the last frame was
    this.followed = [0, 0]; // the place on the ground that the camera follows
    /** @type {FrameRequestCallback} */
    this.next = (now) => this.tick(now);
  }

  start() {
    requestAnimationFrame(this.next);
  }

  /** @param {number} now */
  tick(now) {
    const { stage } = this;
    if (stage.closed) return;
    requestAnimationFrame(this.next);
    const seconds = Math.min(Math.max((now - (this.before ?? now)) / 1000, 0), LONGEST_STEP);
    this.before = now;
    if (stage.status !== "ready" && !this.stale) return;
    const playing = stage.clock.playing;
    if (playing) {
      stage.clock.advance(seconds);
      this.fps += ((seconds > 0 ? 1 / seconds : 60) - this.fps) * 0.05;
      if (!stage.clock.playing) stage.touch(true);
    }
    if (!playing && !this.stale) return;
    this.stale = false;
    this.paint(seconds);
  }

  /** @param {number} seconds */
  paint(seconds) {
    const { stage } = this;
    const { camera, clock, figures, scene } = stage;
    for (const figure of figures) if (figure.visible) figure.pose(clock.time);
    if (figures.length) {
      const [x, z] = groundCentre(figures, this.followed);
      if (camera.follow) camera.track(x, z, seconds, clock.jumped || !clock.playing);
      clock.jumped = false;
    }
    scene.paint(camera, figures, stage.traces, clock, stage.layout === "overlay");
    stage.warpStrip.refresh(scene.theme);
    stage.controls.tick(figures.length ? readout(stage) : "");
    stage.events.tellFrame();
  }
}
