// The words on the Stage: title, message, the short notice of what a button did, the list of keys, and the read-out.
import { within } from "../shared/dom.mjs";
/** @import { Figure } from "./figure.mjs" */
/** @import { Stage } from "./stage.mjs" */

const NOTICE = 1100; // milliseconds

/** The moment, the frame of the leading figure, and the coloured span it is in. @param {Stage} stage */
export function readout({ clock: { time, duration }, figures, timeline, layout }) {
  const figure = figures[timeline.reference];
  const frame = figure.recordedFrame(time);
  const span = figure.spanAt(frame)?.label;
  const moment = layout === "pose" ? `${Math.round((100 * time) / (duration || 1))} % of each`
    : `${time.toFixed(2)} / ${duration.toFixed(2)} s`;
  return `${moment} · frame ${frame}${span ? ` · ${span}` : ""}`;
}

/** What moves, for screen readers. @param {Figure[]} figures */
export function describe(figures) {
  const count = figures.length === 1 ? "One figure" : `${figures.length} figures`;
  return `${count} moving: ${figures.slice(0, 6).map((figure) => figure.label).join(", ")}`;
}

export class Messages {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.root = root;
    this.timer = 0;
  }

  /** @param {string} title @param {string} message */
  show(title, message) {
    within(this.root, ".ms-stage-title").textContent = title;
    within(this.root, ".ms-message-text").textContent = message;
    within(this.root, ".ms-stage-note").hidden = true;
  }

  /** Show for a moment what a button or a key did. @param {string} text */
  say(text) {
    const toast = within(this.root, ".ms-toast");
    toast.textContent = text;
    toast.classList.add("ms-shown");
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => toast.classList.remove("ms-shown"), NOTICE);
  }

  /** Open or close the list of keys; true when it was open. @param {boolean} [open] */
  toggleHelp(open) {
    const help = within(this.root, ".ms-help");
    const was = !help.hidden;
    help.hidden = open === undefined ? was : !open;
    return was;
  }
}
