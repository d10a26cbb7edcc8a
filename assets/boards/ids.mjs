// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.boards.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * The board that is open, and whether only to look at it.
 * @typedef {object} View
 * @property {string} [board]
 * @property {string} [screen]
 */

export const BOARDS_PLACE = "boards-place";
export const SAVE_VIEW = "save-view";
export const COMMENTS_BUTTON = "comments-button";
export const BOARDS_SHOWN = /** @type {StoreId<any>} */ ("boards-shown");
