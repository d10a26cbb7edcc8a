// From a request to figures: asks for the motions, tells what could not be loaded, lets the newest request win.
import { within } from "../shared/dom.mjs";
import { Figure } from "./figure.mjs";
import { MotionCache } from "./motion.mjs";
/** @import { Stage } from "./stage.mjs" */
/** @import { StageRequest } from "./types.d.ts" */

const MOST_FIGURES = 48;

export class Requests {
  /** @param {Stage} stage */
  constructor(stage) {
    this.stage = stage;
    this.cache = new MotionCache();
    /** @type {StageRequest | null} */
    this.next = null; // the newest of those that wait to replace what is shown
    /** @type {Promise<void> | null} */
    this.replacing = null;
    this.turn = 0; // counts the requests to show
  }

  /**
   * Fetch what a request needs, so that showing it later costs nothing.
   * @param {StageRequest} request
   */
  prefetch(request) {
    const items = (request?.items ?? []).slice(0, MOST_FIGURES);
    return this.cache.load(this.api, request, items);
  }

  get api() {
    return this.stage.root.dataset.api || "/api";
  }

  /**
   * Show a request from its start.
   * @param {StageRequest | null} request
   */
  async show(request) {
    const { stage } = this;
    const turn = ++this.turn;
    this.next = null;
    stage.request = request;
    if (!request?.items?.length) {
      stage.setFigures([]);
      return stage.setStatus("empty");
    }
    const n = Math.min(request.items.length, MOST_FIGURES);
    stage.setStatus("loading", n > 1 ? `Loading ${n} motions …` : "Loading …");
    const { figures, failed } = await this.figures(request);
    if (turn !== this.turn || stage.closed) return undefined;
    if (!figures.length) {
      stage.setFigures([]);
      return stage.setStatus("error", failed[0].message);
    }
    stage.begin(figures, request);
    return this.notice(request, n, failed);
  }

  /**
   * Put other motions in place of those that are shown; time (as a share), camera, layout and what plays stay. While
   * one is being loaded only the newest waits, so that a slider may call this for every step.
   * @param {StageRequest} request
   */
  replace(request) {
    const { stage } = this;
    if (stage.status !== "ready" || !request?.items?.length) return this.show(request);
    this.next = request;
    return (this.replacing ??= this.replaceAll().finally(() => (this.replacing = null)));
  }

  async replaceAll() {
    const { stage, turn } = this;
    while (this.next && turn === this.turn && !stage.closed) {
      const request = this.next;
      this.next = null;
      const { figures, failed } = await this.figures(request);
      if (turn !== this.turn || stage.closed) return;
      stage.request = request;
      if (figures.length) stage.exchange(figures);
      this.notice(request, Math.min(request.items.length, MOST_FIGURES), failed);
    }
  }

  /** @param {StageRequest} request */
  async figures(request) {
    const items = request.items.slice(0, MOST_FIGURES);
    const motions = await this.cache.load(this.api, request, items);
    return {
      figures: items.flatMap((item, k) => (motions[k] instanceof Error ? [] : [new Figure(
        { ...item, dataset: item.dataset ?? request.dataset ?? undefined }, motions[k], k)])),
      failed: motions.filter((motion) => motion instanceof Error),
    };
  }

  /**
   * Tell what is missing, without hiding what is there.
   * @param {StageRequest} request
   * @param {number} n
   * @param {Error[]} failed
   */
  notice(request, n, failed) {
    const missing = failed.length ? `${failed.length} of ${n} motions could not be loaded: ${failed[0].message}` : "";
    const cut = request.items.length > n ? `Showing ${n} of ${request.items.length} motions.` : "";
    const note = within(this.stage.root, ".ms-stage-note");
    within(note, "span").textContent = [missing, cut].filter(Boolean).join(" ");
    note.hidden = !missing && !cut;
    within(note, "button").hidden = !missing;
  }
}
