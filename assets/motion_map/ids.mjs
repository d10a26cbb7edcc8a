// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.motion_map.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * The keys and the path that are searched for, and how the map is drawn.
 * @typedef {object} View
 * @property {string} [keys]
 * @property {string} [drawn]
 * @property {string} [within]
 * @property {string} [pace]
 * @property {string} [way]
 * @property {string} [colour]
 * @property {string} [click]
 * @property {string} [below]
 * @property {string} [region]
 */

/**
 * What the page tells of each node beside its posture.
 * @typedef {object} Facts
 * @property {Array<string>} names
 * @property {Array<Array<[number, number]>>} labels
 */

/**
 * The map that is shown.
 * @typedef {object} KnownMap
 * @property {string} key
 * @property {string} dataset
 * @property {string} version
 * @property {Facts} facts
 */

/**
 * A clip that a map was made of.
 * @typedef {object} MapClip
 * @property {string} name
 * @property {number} frames
 * @property {number} fps
 * @property {number} fit
 */

/**
 * The part of a map's file that is JSON (see routes.py); nodes are numbered along the second axis of the grid.
 * @typedef {object} MapHeader
 * @property {[number, number]} grid
 * @property {Array<string>} joints
 * @property {Array<string>} roles
 * @property {Array<string>} sides
 * @property {Array<number>} parents
 * @property {Array<number>} lengths
 * @property {Array<MapClip>} clips
 * @property {number} fps
 * @property {Array<number>} regions
 * @property {Array<[number, number]>} icons
 * @property {number} usual
 * @property {number} runs
 */

/**
 * Those parts of the view that the server draws by.
 * @typedef {object} Look
 * @property {string} [colour]
 * @property {string} [below]
 * @property {string} [region]
 */

/**
 * Nodes that the selected motifs pass.
 * @typedef {object} Lit
 * @property {Array<number>} nodes
 */

/**
 * The earlier map that these clips are to be laid on: key of its result.
 * @typedef {object} Extend
 * @property {string} model
 * @property {number} [at]
 */

export const MAP_RUN = "map-run";
export const MAP_ESTIMATE = "map-estimate";
export const MAP_LEFT_OUT = "map-left-out";
export const MAP_FOLD = "map-fold";
export const MAP_SUMMARY = "map-summary";
export const MAP_FORM = "map-form";
export const MAP_STATUS = "map-status";
export const MAP_SETTINGS = /** @type {StoreId<Record<string, string>>} */ ("map-settings");
export const MAP_RESULT_KEY = /** @type {StoreId<string>} */ ("map-result-key");
export const MAP_STATUS_OF = /** @type {StoreId<Array<any>>} */ ("map-status-of");
export const MAP_AGAIN = /** @type {StoreId<Record<string, boolean | number>>} */ ("map-again");
export const MAP_MENUS = "map-menus";
export const MAP_MORE = "map-more";
export const MAP_RESULT = "map-result";
export const MAP_PLOT = "map-plot";
export const MAP_GRAPH = "map-graph";
export const MAP_PAINTED = /** @type {StoreId<Array<string | null>>} */ ("map-painted");
export const MAP_LEGEND = "map-legend";
export const MAP_EXPLANATION = "map-explanation";
export const MAP_COLOUR = "map-colour";
export const MAP_CLICK = "map-click";
export const MAP_PACE = "map-pace";
export const MAP_WAY = "map-way";
export const MAP_BELOW = "map-below";
export const MAP_PREVIEW = "map-preview";
export const MAP_KEYS = "map-keys";
export const MAP_REACH = "map-reach";
export const MAP_REACH_LABEL = "map-reach-label";
export const MAP_REACH_BOX = "map-reach-box";
export const MAP_REACH_VALUE = "map-reach-value";
export const MAP_COUNT = "map-count";
export const MAP_PLAY_ALL = "map-play-all";
export const MAP_HITS = "map-hits";
export const MAP_EDITOR = "map-editor";
export const MAP_EDITOR_TITLE = "map-editor-title";
export const MAP_MULTIPLES = "map-multiples";
export const MAP_MULTIPLES_GRAPH = "map-multiples-graph";
export const MAP_CLIPS_PLACE = "map-clips-place";
export const MAP_CLIPS = "map-clips";
export const MAP_REGION = "map-region";
export const MAP_KNOWN = /** @type {StoreId<KnownMap>} */ ("map-known");
export const MAP_LOOK = /** @type {StoreId<Look>} */ ("map-look");
export const MAP_LIT = /** @type {StoreId<Lit>} */ ("map-lit");
export const MAP_EXTEND = /** @type {StoreId<Extend>} */ ("map-extend");
export const MAP_LOADED = /** @type {StoreId<any>} */ ("map-loaded");
export const MAP_SHOWN = /** @type {StoreId<any>} */ ("map-shown");
export const MAP_DRAWN = /** @type {StoreId<any>} */ ("map-drawn");
export const MAP_MARKED = /** @type {StoreId<any>} */ ("map-marked");
