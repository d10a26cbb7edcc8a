// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.grammar.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * The view below the recordings, and what is chosen in it.
 * @typedef {object} View
 * @property {string} [show]
 * @property {string} [routine]
 * @property {string} [sentence]
 * @property {string} [pick]
 * @property {string} [up]
 * @property {string} [alt]
 * @property {string} [counts]
 */

/**
 * An action of the recordings.
 * @typedef {object} Action
 * @property {number} id
 * @property {string} name
 * @property {string} short
 * @property {boolean} named
 * @property {string} hint
 * @property {string} colour
 * @property {string} ink
 * @property {number} count
 * @property {number} seconds
 * @property {number} clips
 * @property {string} label
 * @property {string} strip
 * @property {string} icon
 */

/**
 * A recording as a string of actions, in seconds.
 * @typedef {object} Row
 * @property {string} clip
 * @property {string} brief
 * @property {number} fps
 * @property {number} seconds
 * @property {Array<[number, number, number, number]>} pieces
 * @property {Array<number>} cuts
 * @property {Array<[number, number, string]>} labels
 */

/**
 * What may stand for a phrase: actions as numbers, phrases as their ids.
 * @typedef {object} Way
 * @property {Array<number | string>} parts
 * @property {number} count
 */

/**
 * A phrase and all that may stand for it.
 * @typedef {object} Phrase
 * @property {string} id
 * @property {string} name
 * @property {number} seen
 * @property {boolean} cyclic
 * @property {Array<Way>} ways
 */

/**
 * A stretch of a recording that obeys the rules as a whole.
 * @typedef {object} Routine
 * @property {string} clip
 * @property {[number, number]} seconds
 * @property {Array<number>} actions
 * @property {Array<[number, number]>} leaves
 */

/**
 * What is drawn of a result, except trees and new routines.
 * @typedef {object} GrammarData
 * @property {string} key
 * @property {string} dataset
 * @property {string} version
 * @property {string} names
 * @property {Array<Action>} actions
 * @property {Array<Row>} rows
 * @property {Array<Phrase>} rules
 * @property {Array<Routine>} routines
 */

/**
 * The routine that is shown, with its tree as a drawing.
 * @typedef {object} RoutineData
 * @property {string} key
 * @property {number} number
 * @property {string} svg
 */

/**
 * The part of a new routine that is chosen: its path in the tree, and its actions ``[first, end)``.
 * @typedef {object} Part
 * @property {Array<number>} at
 * @property {string} path
 * @property {number} first
 * @property {number} end
 * @property {string} name
 * @property {number} ways
 * @property {boolean} varies
 * @property {boolean} larger
 * @property {boolean} smaller
 */

/**
 * The new routine of the link and its motion, or why there is none.
 * @typedef {object} Composed
 * @property {string} [key]
 * @property {Record<string, string>} [inputs]
 * @property {string} [error]
 * @property {string} [name]
 * @property {string} [clip]
 * @property {Array<number>} [actions]
 * @property {Array<[number, number]>} [spans]
 * @property {number} [frames]
 * @property {number} [seconds]
 * @property {[number, number, number]} [skate]
 * @property {[number, number]} [speeds]
 * @property {boolean} [jump]
 * @property {Array<string>} [warnings]
 * @property {Array<import("../shared/ids.mjs").Colour>} [bands]
 * @property {boolean} [novel]
 * @property {Record<string, string>} [recipes]
 * @property {string} [code]
 * @property {string} [svg]
 * @property {Part | null} [chosen]
 * @property {Array<string>} [parents]
 */

/**
 * Another way for the chosen part of a new routine.
 * @typedef {object} Other
 * @property {string} code
 * @property {string} name
 * @property {string} clip
 * @property {Array<number>} actions
 * @property {number} first
 * @property {number} end
 * @property {number} start
 * @property {number} stop
 * @property {number} seconds
 * @property {Array<import("../shared/ids.mjs").Colour>} bands
 */

/**
 * Other ways for the chosen part, or why there are none.
 * @typedef {object} Others
 * @property {Record<string, string>} inputs
 * @property {string} [error]
 * @property {string} [part]
 * @property {Array<Other>} [others]
 */

/**
 * The way of making motion that is to be played; all, where none is named.
 * @typedef {object} BakeoffPlay
 * @property {string} [only]
 * @property {number} [at]
 */

export const GRAMMAR_RUN = "grammar-run";
export const GRAMMAR_ESTIMATE = "grammar-estimate";
export const GRAMMAR_LEFT_OUT = "grammar-left-out";
export const GRAMMAR_FOLD = "grammar-fold";
export const GRAMMAR_SUMMARY = "grammar-summary";
export const GRAMMAR_FORM = "grammar-form";
export const GRAMMAR_STATUS = "grammar-status";
export const GRAMMAR_SETTINGS = /** @type {StoreId<Record<string, string>>} */ ("grammar-settings");
export const GRAMMAR_RESULT_KEY = /** @type {StoreId<string>} */ ("grammar-result-key");
export const GRAMMAR_STATUS_OF = /** @type {StoreId<Array<any>>} */ ("grammar-status-of");
export const GRAMMAR_AGAIN = /** @type {StoreId<Record<string, boolean | number>>} */ ("grammar-again");
export const GRAMMAR_MENUS = "grammar-menus";
export const GRAMMAR_RESULT = "grammar-result";
export const GRAMMAR_STRING = "grammar-string";
export const GRAMMAR_SHOW = "grammar-show";
export const GRAMMAR_RULES = "grammar-rules";
export const PHRASE = "phrase-";
export const GRAMMAR_DATA = /** @type {StoreId<GrammarData>} */ ("grammar-data");
export const GRAMMAR_NAMES = /** @type {StoreId<string>} */ ("grammar-names");
export const GRAMMAR_DRAWN = /** @type {StoreId<any>} */ ("grammar-drawn");
export const ACTION_ORDER = "action-order";
export const ACTION_CARDS = "action-cards";
export const ACTION_HINT = "action-hint";
export const ACTION_DETAIL = "action-detail";
export const ACTION_TITLE = "action-title";
export const ACTION_COUNT = "action-count";
export const ACTION_ALL = "action-all";
export const ACTION_NAME = "action-name";
export const ACTION_NAME_STATUS = "action-name-status";
export const ACTION_NAMED = /** @type {StoreId<number>} */ ("action-named");
export const OCCURRENCES = "occurrences";
export const ROUTINE_LIST = "routine-list";
export const ROUTINE_TITLE = "routine-title";
export const ROUTINE_COUNT = "routine-count";
export const ROUTINE_PLAY = "routine-play";
export const ROUTINE_SVG = "routine-svg";
export const ROUTINE_TREE = "routine-tree";
export const ROUTINE_DATA = /** @type {StoreId<RoutineData>} */ ("routine-data");
export const ROUTINE_DRAWN = /** @type {StoreId<any>} */ ("routine-drawn");
export const COMPOSE_ERROR = "compose-error";
export const COMPOSE_STATUS = "compose-status";
export const COMPOSE_STRING = "compose-string";
export const COMPOSE_CHOSEN = "compose-chosen";
export const COMPOSE_OTHERS = "compose-others";
export const COMPOSE_TREE = "compose-tree";
export const COMPOSE_METERS = "compose-meters";
export const COMPOSE_WARNINGS = "compose-warnings";
export const COMPOSE_MOST = "compose-most";
export const COMPOSE_BVH = "compose-bvh";
export const COMPOSE_JSON = "compose-json";
export const COMPOSE_SVG = "compose-svg";
export const COMPOSE_NAME = "compose-name";
export const COMPOSE_SAVE = "compose-save";
export const COMPOSE_SAVE_STATUS = "compose-save-status";
export const COMPOSE_DATA = /** @type {StoreId<Composed>} */ ("compose-data");
export const COMPOSE_DRAWN = /** @type {StoreId<any>} */ ("compose-drawn");
export const COMPOSE_OTHER_DATA = /** @type {StoreId<Others>} */ ("compose-other-data");
export const COMPOSE_OTHER_DRAWN = /** @type {StoreId<any>} */ ("compose-other-drawn");
export const TUNE_ACTIONS = "tune-actions";
export const TUNE_WEIGHT = "tune-weight";
export const TUNE_ACTIONS_LABEL = "tune-actions-label";
export const TUNE_WEIGHT_LABEL = "tune-weight-label";
export const TUNE_LEARN = "tune-learn";
export const TUNE_COUNTS = "tune-counts";
export const TUNE_RUN = "tune-run";
export const TUNE_PLAN = "tune-plan";
export const TUNE_STATUS = "tune-status";
export const TUNE_STATUS_OF = /** @type {StoreId<Array<any>>} */ ("tune-status-of");
export const TUNE_SEEN = /** @type {StoreId<Array<string>>} */ ("tune-seen");
export const TUNE_RESULT = "tune-result";
export const TUNE_QUALITY = "tune-quality";
export const TUNE_RULES = "tune-rules";
export const TUNE_TABLE = "tune-table";
export const TUNE_TABLE_PLACE = "tune-table-place";
export const BAKEOFF_PLACE = "bakeoff-place";
export const BAKEOFF_CHART = "bakeoff-chart";
export const BAKEOFF_TABLE = "bakeoff-table";
export const BAKEOFF_RUN = /** @type {StoreId<Record<string, boolean | number>>} */ ("bakeoff-run");
export const BAKEOFF_JOB = /** @type {StoreId<number>} */ ("bakeoff-job");
export const BAKEOFF_SHOWN = /** @type {StoreId<Array<any>>} */ ("bakeoff-shown");
export const BAKEOFF_PLAY = /** @type {StoreId<BakeoffPlay>} */ ("bakeoff-play");
