// The link of what is shown: how the address is written, and what it says of the Stage.
/** @import { Selection, View } from "../shared/types.d.ts" */
/** @import { SavedState, StageState } from "../stage/types.d.ts" */

/**
 * What the address says: `keys` of the view that a page's links have, by page; `chosen` the selection as text.
 * @typedef {{
 *   dataset: string | null,
 *   selection: Selection | null,
 *   view: Record<string, string | undefined> | null,
 *   keys: Record<string, string[]>,
 *   chosen: string,
 *   stage: Record<string, any>,
 * }} Shown
 */

/** The page's name in an address. @param {string} pathname */
export const pageOf = (pathname) => pathname.replace(/\//g, "") || "library";

/**
 * The address of what is shown; of the Stage only where something is on it.
 * @param {string} pathname
 * @param {Shown} shown
 */
export function addressOf(pathname, { dataset, selection, view, keys, chosen, stage }) {
  const ofPage = (keys[pageOf(pathname)] || []).map((key) => [key, view?.[key]]);
  const onStage = chosen !== "{}" || view?.walk || view?.sentence;
  const pairs = new URLSearchParams();
  for (const [key, value] of [
    ["dataset", dataset], ...ofPage, ...Object.entries(selection || {}), ...Object.entries(onStage ? stage : {}),
  ]) if (value !== null && value !== undefined && value !== "") pairs.set(String(key), String(value));
  return `${pathname}?${pairs.toString().replace(/%2C/g, ",").replace(/%3A/g, ":")}`;
}

/**
 * What a link says of the Stage. The moment counts only where it stands still, the camera where it was turned by hand.
 * @param {StageState} state
 * @param {boolean} turnedByHand
 */
export const stageOfLink = ({ time, playing, speed, layout, camera }, turnedByHand) => ({
  time: playing ? "" : time,
  speed: speed === 1 ? "" : speed,
  layout: layout === "overlay" ? "" : layout,
  camera: turnedByHand ? [camera.yaw, camera.pitch, camera.distance, ...camera.pan, camera.follow ? 1 : 0].join(",") : "",
});

/**
 * The state of the Stage that a link asks for.
 * @param {Record<string, string>} link
 * @returns {SavedState}
 */
export function stateOfLink({ time, speed, layout, camera }) {
  /** @type {SavedState} */
  const state = {};
  if (time) Object.assign(state, { time: Number(time), playing: false });
  if (speed) state.speed = Number(speed);
  if (layout) state.layout = layout;
  if (camera) {
    const [yaw, pitch, distance, x, y, z, follow] = camera.split(",").map(Number);
    state.camera = { yaw, pitch, distance, pan: [x, y, z], follow: follow !== 0 };
  }
  return state;
}
