// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.clip.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * What the chart shows.
 * @typedef {object} View
 * @property {string} [chart]
 * @property {string} [angles]
 * @property {string} [joints]
 * @property {string} [rig]
 * @property {string} [channels]
 * @property {string} [span]
 */

/**
 * The clip that the page shows.
 * @typedef {object} ClipShown
 * @property {string} dataset
 * @property {string} version
 * @property {string} clip
 * @property {number} fps
 * @property {number} frames
 */

/**
 * The joints and channels that the chart shows.
 * @typedef {object} ClipChoice
 * @property {Array<string>} joints
 * @property {Array<string>} channels
 */

/**
 * A stretch of walking or running: frames ``[start, end)`` and its measures.
 * @typedef {object} Bout
 * @property {string} title
 * @property {string} facts
 * @property {number} start
 * @property {number} end
 * @property {Array<Array<string>>} rows
 */

/**
 * The gait of a clip; ``why`` where there is none.
 * @typedef {object} GaitTable
 * @property {string} clip
 * @property {string} why
 * @property {Array<string>} head
 * @property {Array<Bout>} bouts
 * @property {Array<[number, string, string, string]>} events
 */

/**
 * A frame of a clip that someone chose in a list.
 * @typedef {object} Moment
 * @property {string} clip
 * @property {number} frame
 * @property {number} [at]
 */

/**
 * An edit that is to be made.
 * @typedef {object} ClipEdit
 * @property {"trim" | "mirror" | "rate" | "split" | "labels"} action
 * @property {number} [frame]
 * @property {number} [at]
 */

/**
 * A repair that is to be made of a clip of the dataset with this fingerprint.
 * @typedef {object} ClipRepair
 * @property {string} dataset
 * @property {string} version
 * @property {string} clip
 * @property {"fill" | "smooth" | "cut" | "turn" | "rescale" | "mirror"} action
 * @property {number} start
 * @property {number} end
 * @property {string} value
 * @property {number} [at]
 */

export const CLIP_PICKER = "clip-picker";
export const CLIP_PREVIOUS = "clip-previous";
export const CLIP_NEXT = "clip-next";
export const CLIP_NOTHING = "clip-nothing";
export const CLIP_BODY = "clip-body";
export const CLIP_FACTS = "clip-facts";
export const CLIP_SHOWN = /** @type {StoreId<ClipShown>} */ ("clip-shown");
export const CLIP_CHART = "clip-chart";
export const CLIP_KIND = "clip-kind";
export const CLIP_KIND_BOX = "clip-kind-box";
export const CLIP_CHANNELS = "clip-channels";
export const CLIP_CHANNELS_BOX = "clip-channels-box";
export const CLIP_JOINTS = "clip-joints";
export const CLIP_JOINTS_BOX = "clip-joints-box";
export const CLIP_CHOICE = /** @type {StoreId<ClipChoice>} */ ("clip-choice");
export const CLIP_LEGEND = "clip-legend";
export const CLIP_BOX = "clip-box";
export const CLIP_GRAPH = "clip-graph";
export const CLIP_RANGE = "clip-range";
export const CLIP_DRAWN = /** @type {StoreId<string>} */ ("clip-drawn");
export const CLIP_MARKED = /** @type {StoreId<any>} */ ("clip-marked");
export const CLIP_SOUGHT = /** @type {StoreId<any>} */ ("clip-sought");
export const CLIP_SEEK = /** @type {StoreId<Moment>} */ ("clip-seek");
export const CLIP_DOUBTS = "clip-doubts";
export const CLIP_REPAIR = /** @type {StoreId<ClipRepair>} */ ("clip-repair");
export const CLIP_GAIT = "clip-gait";
export const CLIP_GAIT_TABLE = /** @type {StoreId<GaitTable>} */ ("clip-gait-table");
export const CLIP_GAIT_DRAWN = /** @type {StoreId<any>} */ ("clip-gait-drawn");
export const CLIP_EDIT = /** @type {StoreId<ClipEdit>} */ ("clip-edit");
export const CLIP_EDIT_AT_FRAME = /** @type {StoreId<ClipEdit>} */ ("clip-edit-at-frame");
export const CLIP_EDIT_MENU = "clip-edit-menu";
export const CLIP_EDIT_DIALOG = "clip-edit-dialog";
export const CLIP_EDIT_SAYS = "clip-edit-says";
export const CLIP_EDIT_WHERE = "clip-edit-where";
export const CLIP_EDIT_FPS = "clip-edit-fps";
export const CLIP_EDIT_FRAME = "clip-edit-frame";
export const CLIP_EDIT_NAME = "clip-edit-name";
export const CLIP_EDIT_EFFECT = "clip-edit-effect";
export const CLIP_EDIT_PROBLEM = "clip-edit-problem";
export const CLIP_EDIT_DO = "clip-edit-do";
export const CLIP_TABLE_OPEN = "clip-table-open";
export const CLIP_TABLE_DIALOG = "clip-table-dialog";
export const CLIP_TABLE_COLUMNS = "clip-table-columns";
export const CLIP_TABLE_JOINTS = "clip-table-joints";
export const CLIP_TABLE_FRAMES = "clip-table-frames";
export const CLIP_TABLE_WHAT = "clip-table-what";
export const CLIP_TABLE_LINK = "clip-table-link";
