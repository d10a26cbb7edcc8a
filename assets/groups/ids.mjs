// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.groups.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * The property that makes the groups, two of its values, the property that names who moves, and what is counted.
 * @typedef {object} View
 * @property {string} [by]
 * @property {string} [first]
 * @property {string} [second]
 * @property {string} [who]
 * @property {string} [counted]
 * @property {string} [paired]
 */

export const GROUPS_PLACE = "groups-place";
export const GROUPS_SHOWN = /** @type {StoreId<any>} */ ("groups-shown");
