// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.shell.names: change that module and run `make bundle`.

/** The id of a store that holds a T. @template T @typedef {string & { content?: T }} StoreId */

/**
 * @typedef {object} Selection
 * @property {number} [motif]
 * @property {number} [motion]
 * @property {string} [motifs]
 * @property {string} [edge]
 * @property {number} [transition]
 * @property {number} [action]
 * @property {number} [segment]
 * @property {string} [clip]
 * @property {number} [start]
 * @property {number} [end]
 * @property {string} [as]
 * @property {number} [at]
 */

/**
 * Someone chose another data set.
 * @typedef {object} DatasetChoice
 * @property {string | null} dataset
 * @property {number} [at]
 */

/**
 * Frames of a motion that have a colour of their own.
 * @typedef {object} Colour
 * @property {number} start
 * @property {number} end
 * @property {string} colour
 * @property {string} label
 */

/**
 * One figure on the Stage: frames ``[start, end)`` of a clip.
 * @typedef {object} Figure
 * @property {string} clip
 * @property {string} label
 * @property {number} [start]
 * @property {number} [end]
 * @property {string} [dataset]
 * @property {string} [version]
 * @property {string} [colour]
 * @property {Array<number> | null} [warp]
 * @property {number} [frame]
 * @property {Array<Colour>} [colours]
 */

/**
 * What the Stage plays; docs/reference/stage.md describes it.
 * @typedef {object} StageRequest
 * @property {string | null} dataset
 * @property {Array<Figure>} items
 * @property {string} [version]
 * @property {string} [title]
 * @property {"overlay" | "side" | "pose"} [layout]
 * @property {"warp" | "start"} [sync]
 * @property {boolean} [replace]
 * @property {any} [at]
 */

/**
 * What the pages show beside the selection, by key of the link.
 * @typedef {object} PageView
 * @property {string} [tab] of the page library
 * @property {string} [files] of the page library
 * @property {string} [chart] of the page clip
 * @property {string} [angles] of the page clip
 * @property {string} [joints] of the page clip
 * @property {string} [rig] of the page clip
 * @property {string} [channels] of the page clip
 * @property {string} [span] of the page clip
 * @property {string} [view] of the page motifs
 * @property {string} [side] of the page motifs
 * @property {string} [walk] of the page motifs
 * @property {string} [weights] of the page motifs
 * @property {string} [other] of the page motifs
 * @property {string} [gained] of the page motifs
 * @property {string} [extra] of the page motifs
 * @property {string} [gaps] of the page motifs
 * @property {string} [ends] of the page motifs
 * @property {string} [feet] of the page motifs
 * @property {string} [stability] of the page motifs
 * @property {string} [step] of the page motifs
 * @property {string} [x] of the page sweeps
 * @property {string} [y] of the page sweeps
 * @property {string} [seeds] of the page sweeps
 * @property {string} [keys] of the page motion map
 * @property {string} [drawn] of the page motion map
 * @property {string} [within] of the page motion map
 * @property {string} [pace] of the page motion map
 * @property {string} [way] of the page motion map
 * @property {string} [colour] of the page motion map
 * @property {string} [click] of the page motion map
 * @property {string} [below] of the page motion map
 * @property {string} [region] of the page motion map
 * @property {string} [query] of the page search
 * @property {string} [parts] of the page search
 * @property {string} [level] of the page search
 * @property {string} [route] of the page search
 * @property {string} [label] of the page search
 * @property {string} [named] of the page search
 * @property {string} [lasting] of the page search
 * @property {string} [top] of the page search
 * @property {string} [hit] of the page search
 * @property {string} [look] of the page search
 * @property {string} [study] of the page search
 * @property {string} [asks] of the page search
 * @property {string} [measure] of the page search
 * @property {string} [words] of the page search
 * @property {string} [seen] of the page search
 * @property {string} [show] of the page grammar
 * @property {string} [routine] of the page grammar
 * @property {string} [sentence] of the page grammar
 * @property {string} [pick] of the page grammar
 * @property {string} [up] of the page grammar
 * @property {string} [alt] of the page grammar
 * @property {string} [counts] of the page grammar
 * @property {string} [by] of the page groups
 * @property {string} [first] of the page groups
 * @property {string} [second] of the page groups
 * @property {string} [who] of the page groups
 * @property {string} [counted] of the page groups
 * @property {string} [paired] of the page groups
 * @property {string} [board] of the page boards
 * @property {string} [screen] of the page boards
 */

export const LOADING = "loading";
export const FIRST_LAYOUT = "first-layout";
export const FIRST_PICTURE = "first-picture";
export const FIRST_DEPENDENCIES = "first-dependencies";
export const MOTIFS_RUN = "motifs-run";
export const MOTIFS_ESTIMATE = "motifs-estimate";
export const MOTIFS_LEFT_OUT = "motifs-left-out";
export const MOTIFS_FOLD = "motifs-fold";
export const MOTIFS_SUMMARY = "motifs-summary";
export const MOTIFS_FORM = "motifs-form";
export const MOTIFS_STATUS = "motifs-status";
export const MOTIFS_SETTINGS = /** @type {StoreId<Record<string, string>>} */ ("motifs-settings");
export const MOTIFS_RESULT_KEY = /** @type {StoreId<string>} */ ("motifs-result-key");
export const MOTIFS_STATUS_OF = /** @type {StoreId<Array<any>>} */ ("motifs-status-of");
export const MOTIFS_AGAIN = /** @type {StoreId<Record<string, boolean | number>>} */ ("motifs-again");
export const MANTINE = "mantine";
export const PERSON = "person";
export const SHELL = "shell";
export const PAGE = "page";
export const SPLITTER = "splitter";
export const NAV = "nav-";
export const DATASET_PICKER = "dataset-picker";
export const NOTICES = "notices";
export const SHARE = "share";
export const SCHEME_TOGGLE = "scheme-toggle";
export const URL = "url";
export const DATASET = /** @type {StoreId<string>} */ ("dataset");
export const SELECTION = /** @type {StoreId<Selection>} */ ("selection");
export const VIEW = /** @type {StoreId<Record<string, string>>} */ ("view");
export const VIEW_CHANGE = /** @type {StoreId<Record<string, string | number | boolean | null>>} */ ("view-change");
export const VIEW_KEYS = /** @type {StoreId<Record<string, Array<string>>>} */ ("view-keys");
export const SETTINGS_KEYS = /** @type {StoreId<Record<string, Array<string>>>} */ ("settings-keys");
export const VIEW_OF_DATASET = /** @type {StoreId<Array<string>>} */ ("view-of-dataset");
export const ADDRESS = /** @type {StoreId<string>} */ ("address");
export const DATASET_CHOICE = /** @type {StoreId<DatasetChoice>} */ ("dataset-choice");
export const AWAITED = /** @type {StoreId<string>} */ ("awaited");
export const STAGE_RESTORE = /** @type {StoreId<Record<string, string>>} */ ("stage-restore");
export const STAGE_REQUEST = /** @type {StoreId<StageRequest>} */ ("stage-request");
export const THEME = /** @type {StoreId<"light" | "dark">} */ ("theme");
export const REVISION = /** @type {StoreId<string>} */ ("revision");
export const JOB_STARTED = /** @type {StoreId<number>} */ ("job-started");
export const JOB_ENDED = /** @type {StoreId<string>} */ ("job-ended");
