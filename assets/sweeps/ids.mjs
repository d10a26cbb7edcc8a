// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.sweeps.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * The axes with their values, and how often each point is repeated.
 * @typedef {object} View
 * @property {string} [x]
 * @property {string} [y]
 * @property {string} [seeds]
 */

export const SWEEP_MENU = "sweep-menu";
export const SWEEP_RUN = "sweep-run";
export const SWEEP_X_NAME = "sweep-x-name";
export const SWEEP_Y_NAME = "sweep-y-name";
export const SWEEP_X_VALUES = "sweep-x-values";
export const SWEEP_Y_VALUES = "sweep-y-values";
export const SWEEP_X_BOX = "sweep-x-box";
export const SWEEP_Y_BOX = "sweep-y-box";
export const SWEEP_SEEDS = "sweep-seeds";
export const SWEEP_PLAN = "sweep-plan";
export const SWEEP_BASE = "sweep-base";
export const SWEEP_BASE_FOLD = "sweep-base-fold";
export const SWEEP_BASE_SUMMARY = "sweep-base-summary";
export const SWEEP_STATUS = "sweep-status";
export const SWEEP_STATUS_OF = /** @type {StoreId<Array<any>>} */ ("sweep-status-of");
export const SWEEP_SEEN = /** @type {StoreId<string>} */ ("sweep-seen");
export const SWEEP_RESULT = "sweep-result";
export const SWEEP_SUGGESTION = "sweep-suggestion";
export const SWEEP_CARD_X = "sweep-card-x";
export const SWEEP_CARD_Y = "sweep-card-y";
export const SWEEP_CARD_HEAT = "sweep-card-heat";
export const SWEEP_PAIR_X = "sweep-pair-x";
export const SWEEP_PAIR_Y = "sweep-pair-y";
export const SWEEP_AT_X = "sweep-at-x";
export const SWEEP_AT_Y = "sweep-at-y";
export const SWEEP_AT_NAME_X = "sweep-at-name-x";
export const SWEEP_AT_NAME_Y = "sweep-at-name-y";
export const SWEEP_AT_BOX_X = "sweep-at-box-x";
export const SWEEP_AT_BOX_Y = "sweep-at-box-y";
export const SWEEP_LINES_X = "sweep-lines-x";
export const SWEEP_LINES_Y = "sweep-lines-y";
export const SWEEP_HEAT = "sweep-heat";
export const SWEEP_MEASURE = "sweep-measure";
export const SWEEP_MEASURE_HELP = "sweep-measure-help";
export const SWEEP_TABLE = "sweep-table";
export const SWEEP_TABLE_PLACE = "sweep-table-place";
