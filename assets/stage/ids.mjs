// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.stage.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * What the Stage needs to know besides positions. Lengths in metres; joints by their place among the drawn ones.
 * @typedef {object} MotionHeader
 * @property {string} clip
 * @property {number} start
 * @property {number} end
 * @property {number} fps
 * @property {number} step
 * @property {number} frames
 * @property {Array<string>} joints
 * @property {Array<number>} parents
 * @property {Array<string>} sides
 * @property {Array<string>} roles
 * @property {number} root
 * @property {number} head
 * @property {number} nose
 * @property {Array<number>} hands
 * @property {Array<number>} feet
 * @property {number} height
 * @property {number} head_radius
 * @property {number} floor
 */

export const STAGE = "stage";
export const STAGE_CANVAS = "stage-canvas";
export const STAGE_SHOWN = /** @type {StoreId<any>} */ ("stage-shown");
