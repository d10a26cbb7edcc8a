// What one sees, as plain values: for links, for charts that follow, and back again.
import { TRAILS } from "./traces.mjs";
/** @import { Figure } from "./figure.mjs" */
/** @import { Stage } from "./stage.mjs" */
/** @import { Moment, SavedState } from "./types.d.ts" */

export const LAYOUTS = ["overlay", "side", "pose"];
/** @param {number} value */
const round = (value) => Math.round(value * 1000) / 1000;
/** @param {any} value @param {string[]} choices @param {string} otherwise */
const oneOf = (value, choices, otherwise) => (choices.includes(value) ? value : otherwise);
/** @param {any} value @param {number} otherwise */
const number = (value, otherwise) => (Number.isFinite(value) ? value : otherwise);

/**
 * Small enough for a link.
 * @param {Stage} stage
 */
export function takeState({ clock, camera, traces, layout, sync, figures }) {
  return {
    time: round(clock.time), speed: clock.speed, loop: clock.loop, playing: clock.playing,
    layout, sync, ghosts: traces.ghosts, trails: traces.trails,
    hidden: figures.flatMap((figure, k) => (figure.visible ? [] : [k])),
    camera: {
      yaw: round(camera.yaw), pitch: round(camera.pitch), distance: round(camera.distance),
      pan: camera.pan.map(round), follow: camera.follow, centre: camera.follow ? undefined : camera.centre.map(round),
    },
  };
}

/**
 * Take up a state again; what is missing or makes no sense stays as it is.
 * @param {Stage} stage
 * @param {SavedState} state
 */
export function restoreState(stage, state) {
  const { clock, camera, traces } = stage;
  stage.layout = oneOf(state.layout, LAYOUTS, stage.layout);
  stage.sync = oneOf(state.sync, ["warp", "start"], stage.sync);
  stage.figures.forEach((figure, k) => (figure.visible = !state.hidden?.includes(k)));
  traces.ghosts = Boolean(state.ghosts ?? traces.ghosts);
  traces.trails = oneOf(state.trails, TRAILS, traces.trails);
  clock.speed = Math.min(Math.max(number(state.speed, clock.speed), 0.1), 4);
  clock.loop = oneOf(state.loop, ["loop", "bounce", "once"], clock.loop);
  stage.prepare();
  const seen = state.camera || {};
  camera.moved = Number.isFinite(seen.distance) || camera.moved;
  for (const name of /** @type {const} */ (["yaw", "pitch", "distance"])) camera[name] = number(seen[name], camera[name]);
  if (seen.pan?.length === 3 && seen.pan.every(Number.isFinite)) camera.pan = [...seen.pan];
  if (seen.centre?.length === 2 && seen.centre.every(Number.isFinite)) camera.centre = [...seen.centre];
  camera.follow = Boolean(seen.follow ?? camera.follow);
  clock.seek(number(state.time, clock.time));
  clock.playing = Boolean(state.playing ?? clock.playing) && !calm();
}

/**
 * Where a figure stands: clip, its frame at the clip's own rate, and the coloured span it is in.
 * @param {Figure} figure
 * @param {number} time
 */
export function standing(figure, time) {
  const frame = figure.recordedFrame(time);
  const { start, end } = figure.header;
  return {
    index: figure.index, dataset: figure.item.dataset, clip: figure.header.clip, label: figure.label,
    start, end, frame, span: figure.spanAt(frame)?.label ?? null,
  };
}

/**
 * Time at which a frame of a clip is shown, by the visible figure whose segment holds it or comes nearest; or null.
 * @param {Figure[]} figures
 * @param {Moment} moment
 */
export function timeOf(figures, { clip, frame, dataset, index }) {
  /** @param {Figure} figure */
  const away = ({ header }) => Math.max(header.start - frame, frame - (header.end - 1), 0);
  const fitting = figures.filter((figure) => figure.header.clip === clip
    && (dataset === undefined || figure.item.dataset === dataset) && (index === undefined || figure.index === index));
  if (!fitting.length || !Number.isFinite(frame)) return null;
  /** @param {Figure} figure */
  const rank = (figure) => away(figure) + (figure.visible ? 0 : 0.5);
  return fitting.reduce((best, figure) => (rank(figure) < rank(best) ? figure : best)).timeAt(frame);
}

export const calm = () => window.matchMedia("(prefers-reduced-motion: reduce)").matches;
