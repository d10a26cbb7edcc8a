// Events by which the Stage tells the rest of the page what it shows: docs/reference/stage.md.
/** @import { Figure } from "./figure.mjs" */
/** @import { Stage } from "./stage.mjs" */

const STATE_EVERY = 400; // milliseconds between "stage-state" events

export class StageEvents {
  /** @param {Stage} stage */
  constructor(stage) {
    this.stage = stage;
    this.waiting = 0; // the timer of the next "stage-state"
    /** @type {{ time: number, figures: Figure[] } | undefined} */
    this.lastFrame = undefined;
  }

  /** "stage-state", a little later, so that many changes make one event: for the link. */
  tellState() {
    const { stage } = this;
    if (this.waiting || stage.status !== "ready") return;
    this.waiting = window.setTimeout(() => {
      this.waiting = 0;
      window.dispatchEvent(new CustomEvent("stage-state", { detail: { ...stage.state(), items: stage.standing() } }));
    }, STATE_EVERY);
  }

  /** "stage-frame", where another frame is shown than before: for cursors in charts and lit nodes. */
  tellFrame() {
    const { stage } = this;
    const { time, duration, playing } = stage.clock;
    if (stage.status !== "ready" || (time === this.lastFrame?.time && stage.figures === this.lastFrame.figures)) return;
    this.lastFrame = { time, figures: stage.figures };
    window.dispatchEvent(new CustomEvent("stage-frame", { detail: { time, duration, playing, items: stage.standing() } }));
    if (playing) this.tellState();
  }
}
