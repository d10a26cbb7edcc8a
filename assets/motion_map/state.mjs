// What the Map page shows now.
/** @import { MapData } from "./data.mjs" */
/** @import { Overlay } from "./overlay.mjs" */
/** @import { Follower } from "./paths.mjs" */
/** @import { Facts, Hit, KnownMap, Pace } from "./types.d.ts" */
/** @import { Selection } from "../shared/types.d.ts" */

/** A part of the state that is null until the page has it; who uses it before has to ask. @type {any} */
const none = null;

export const state = {
  map: /** @type {MapData} */ (none),
  known: /** @type {KnownMap} */ (none),
  keys: /** @type {number[]} */ ([]), // nodes
  reach: 0, // metres that keys grow
  pace: /** @type {Pace | null} */ (null),
  facts: /** @type {Facts | null} */ (null),
  mode: "keys", // what a click does
  selection: /** @type {Selection | null} */ (null),
  hits: /** @type {Hit[]} */ ([]),
  path: "", // one drawn by hand
  lit: /** @type {number[]} */ ([]),
  shownOn: /** @type {string | null} */ (null), // key of the map on which keys and reach were shown last
  overlay: /** @type {Overlay} */ (none), // over the heatmap of the page, with its follower
  follower: /** @type {Follower} */ (none),
};
