// The page's stage, and what other rooms may ask of it: docs/reference/stage.md.
import { register } from "../shared/dash.mjs";
import { find, whenParsed } from "../shared/dom.mjs";
import * as ids from "./ids.mjs";
import { Stage } from "./stage.mjs";
/** @import { Moment, SavedState, StageRequest, Standing } from "./types.d.ts" */

/** @type {Stage | null} */
let stage = null;
/** @type {HTMLElement | null} */
let mounted = null;
let requestCount = 0;
/** @type {{ request?: StageRequest, state?: SavedState } | null} */
let early = null; // a request or state that came before the page held a stage

/** Take hold of the page's stage; again when the page was rebuilt. */
function mount() {
  const root = find(ids.STAGE);
  if (root === mounted) return;
  mounted = root; // also where the next line fails: once is enough
  stage?.close();
  stage = null;
  stage = root ? new Stage(root) : null;
  if (stage && early?.request) stage.requests.show(early.request);
  if (stage && early?.state) stage.restore(early.state);
  if (stage) early = null;
}

/** @param {StageRequest} request */
const shown = (request) => stage !== null && stage.status !== "error" && JSON.stringify(request) === JSON.stringify(stage.request);

export const player = {
  /**
   * Show a request from its start (`replace: true` in it: as replace does); one that is shown already goes on.
   * @param {StageRequest} request
   */
  show(request) {
    requestCount += 1;
    mount();
    if (!stage) early = { ...early, request };
    else if (!shown(request)) return request?.replace ? stage.requests.replace(request) : stage.requests.show(request);
    return undefined;
  },
  /**
   * Swap the motions in place: the share of time, camera, layout and what plays stay as they are.
   * @param {StageRequest} request
   */
  replace: (request) => (stage ? stage.requests.replace(request) : player.show(request)),
  /**
   * Fetch a request's motions, so that showing them later is immediate.
   * @param {StageRequest} request
   */
  prefetch: (request) => stage?.requests.prefetch(request).then(() => undefined),
  /** How often something was to be shown. */
  get requestCount() { return requestCount; },
  /** @param {SavedState} state */
  restore(state) {
    if (!state) return;
    if (stage) stage.restore(state);
    else early = { ...early, state };
  },
  state: () => stage?.state(),
  play: () => stage?.play(),
  pause: () => stage?.pause(),
  /** @param {number | Moment | null} to */
  seek: (to) => stage?.seek(to) ?? false,
  /**
   * Where the figure of an item stands: {index, dataset, clip, label, start, end, frame, span}.
   * @param {number} index
   */
  frameOf: (index) => stage?.standing().find((item) => item.index === index),
  /** Where the figures of all items stand. @returns {Standing[]} */
  standing: () => stage?.standing() ?? [],
  get time() { return stage?.clock.time ?? 0; },
  get duration() { return stage?.clock.duration ?? 0; },
  get frame() { return stage?.figures.length ? stage.figures[stage.timeline.reference].recordedFrame(stage.clock.time) : 0; },
  /**
   * Frame of each figure, counted from its start, at a time in seconds.
   * @param {number} time
   */
  framesAt: (time) => stage?.figures.map((figure) => figure.frameAt(time) * figure.header.step),
  get camera() { return stage?.state().camera; },
  get playing() { return stage?.clock.playing ?? false; },
  get speed() { return stage?.clock.speed ?? 1; },
  get fps() { return stage?.frames.fps ?? 0; },
  get figures() { return stage?.figures.filter((figure) => figure.visible).length ?? 0; },
  get layout() { return stage?.layout; },
  get sync() { return stage?.timeline.warped ? "warp" : "start"; },
  get status() { return stage?.status ?? "absent"; },
};

whenParsed(() => {
  mount();
  new MutationObserver(mount).observe(document.body, { childList: true, subtree: true });
});

register("stage", {
  /** @param {StageRequest} request */
  show(request) {
    if (request) player.show(request);
    return null;
  },
});
