// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.boards.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * The board that is open.
 * @typedef {object} View
 * @property {string} [board]
 */

export const BOARDS_PLACE = "boards-place";
