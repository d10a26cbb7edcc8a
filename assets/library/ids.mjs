// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.library.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * The tab that is open, and the files of the report that are listed.
 * @typedef {object} View
 * @property {string} [tab]
 * @property {string} [files]
 */

/**
 * What is to be done with a data set, or with the trash.
 * @typedef {object} DatasetAction
 * @property {"rename" | "trash" | "empty" | "analyse"} action
 * @property {string} [dataset]
 * @property {number} [at]
 */

/**
 * What is to be done with the clips that are chosen in the table.
 * @typedef {object} ClipsAction
 * @property {"remove" | "clear" | "reread" | "repair" | "properties" | "all"} action
 * @property {number} [at]
 */

/**
 * All clips of a data set are chosen that the filters of their table, AG Grid's own, leave.
 * @typedef {object} ClipsAll
 * @property {string} dataset
 * @property {Record<string, any>} filter
 */

/**
 * The data set that the dialog is opened for.
 * @typedef {object} UploadInto
 * @property {string} dataset
 * @property {number} [at]
 */

/**
 * Clips of a data set that a dialog is about; all of them where none is named.
 * @typedef {object} ClipsOf
 * @property {string} dataset
 * @property {Array<string>} [clips]
 * @property {number} [at]
 */

/**
 * The data set whose bodies are to be edited.
 * @typedef {object} BodyOf
 * @property {string} dataset
 * @property {number} [at]
 */

/**
 * Clips whose joints have the same names: which part of the body each joint is, and what someone said about it.
 * @typedef {object} BodyRig
 * @property {Array<string>} names
 * @property {Array<number>} parents
 * @property {Array<boolean>} ends
 * @property {Record<string, string>} joints
 * @property {Record<string, string | null>} said
 * @property {Record<string, string>} suggested
 * @property {string} body
 * @property {string | null} said_body
 * @property {string} words
 */

/**
 * The rigs of a data set, the parts of a body, and the format of corrections in files.
 * @typedef {object} BodyRigs
 * @property {string} dataset
 * @property {Array<string>} parts
 * @property {string} format
 * @property {Array<BodyRig>} rigs
 * @property {number | null} at
 */

/**
 * Places of all joints in two drawings; frame -1 is the rest pose.
 * @typedef {object} BodyPosture
 * @property {number} rig
 * @property {string} clip
 * @property {number} frame
 * @property {Array<Array<number>>} front
 * @property {Array<Array<number>>} side
 */

/**
 * What is to be said of a rig.
 * @typedef {object} BodySaid
 * @property {boolean} changed
 * @property {Record<string, string | null>} joints
 * @property {string | null} body
 */

/**
 * What is to be said of all rigs of a data set.
 * @typedef {object} BodyDraft
 * @property {string} dataset
 * @property {Array<BodySaid>} rigs
 */

/**
 * A file of corrections that someone chose.
 * @typedef {object} BodyFile
 * @property {string} text
 * @property {number} at
 */

/**
 * What a file says of a rig.
 * @typedef {object} BodyFileSaid
 * @property {Record<string, string | null>} joints
 * @property {string | null} body
 */

/**
 * What a file of corrections says of each rig; null where it says nothing.
 * @typedef {object} BodyFilled
 * @property {Array<BodyFileSaid | null>} rigs
 * @property {number | null} at
 */

/**
 * What has arrived of the files of an upload, and of which kinds they are.
 * @typedef {object} Upload
 * @property {string | null} [token]
 * @property {number} [received]
 * @property {number} [total]
 * @property {boolean} [done]
 * @property {string} [name]
 * @property {number} [recordings]
 * @property {number} [labels]
 * @property {number} [amc]
 * @property {number} [archives]
 */

/**
 * A file of the import report.
 * @typedef {object} ReportRow
 * @property {string} key
 * @property {"ok" | "warning" | "error"} verdict
 * @property {boolean} added
 * @property {string} name
 * @property {string} path
 * @property {string} messages
 * @property {Record<string, string>} [selection]
 */

/**
 * Features of a data set that someone waits for.
 * @typedef {object} FeaturesChoice
 * @property {string} dataset
 * @property {".npz" | ".parquet"} suffix
 * @property {number} [job]
 * @property {number} [at]
 */

/**
 * Where a file that is ready is downloaded from.
 * @typedef {object} Download
 * @property {string} address
 * @property {number | null} at
 */

export const DATASET_CARDS = "dataset-cards";
export const DATASET_DETAIL = "dataset-detail";
export const DETAIL_SHOWN = /** @type {StoreId<string>} */ ("detail-shown");
export const DATASET_TABS = "dataset-tabs";
export const DATASET_ACTION = /** @type {StoreId<DatasetAction>} */ ("dataset-action");
export const CLIPS_TABLE = "clips-table";
export const CLIPS_CHOSEN = "clips-chosen";
export const CLIPS_ALL = /** @type {StoreId<ClipsAll>} */ ("clips-all");
export const CLIPS_ACTION = /** @type {StoreId<ClipsAction>} */ ("clips-action");
export const CLIPS_MARKED = /** @type {StoreId<any>} */ ("clips-marked");
export const REPORT_TABLE = "report-table";
export const REPORT_FILTER = "report-filter";
export const REPORT_ROWS = /** @type {StoreId<Array<ReportRow>>} */ ("report-rows");
export const RENAME_DIALOG = "rename-dialog";
export const RENAME_OLD = /** @type {StoreId<string>} */ ("rename-old");
export const RENAME_NAME = "rename-name";
export const RENAME_PROBLEM = "rename-problem";
export const RENAME_SAVE = "rename-save";
export const TRASH_OPEN = "trash-open";
export const TRASH_DIALOG = "trash-dialog";
export const TRASH_LIST = "trash-list";
export const UPLOAD_OPEN = "upload-open";
export const UPLOAD_DIALOG = "upload-dialog";
export const DROP_ZONE = "drop-zone";
export const UPLOAD_BAR = "upload-bar";
export const UPLOAD_PROGRESS = "upload-progress";
export const UPLOAD_SUMMARY = "upload-summary";
export const UPLOAD_LIST = "upload-list";
export const UPLOAD_TARGET = "upload-target";
export const UPLOAD_NAME = "upload-name";
export const UPLOAD_LABELS = "upload-labels";
export const UPLOAD_LABELS_BOX = "upload-labels-box";
export const UPLOAD_LABELS_LABEL = "upload-labels-label";
export const UPLOAD_UNIT = "upload-unit";
export const UPLOAD_UP = "upload-up";
export const UPLOAD_FPS = "upload-fps";
export const UPLOAD_POINTS = "upload-points";
export const UPLOAD_SMOOTH = "upload-smooth";
export const UPLOAD_IMPORT = "upload-import";
export const UPLOAD_PROBLEM = "upload-problem";
export const UPLOAD = /** @type {StoreId<Upload>} */ ("upload");
export const UPLOAD_INTO = /** @type {StoreId<UploadInto>} */ ("upload-into");
export const UPLOAD_SUGGESTED = /** @type {StoreId<string>} */ ("upload-suggested");
export const UPLOADED = /** @type {StoreId<string>} */ ("uploaded");
export const REREAD_DIALOG = "reread-dialog";
export const REPAIR_OF = /** @type {StoreId<ClipsOf>} */ ("repair-of");
export const REPAIR_DIALOG = "repair-dialog";
export const REPAIR_WHAT = "repair-what";
export const REPAIR_KINDS = "repair-kinds";
export const REPAIR_PROBLEM = "repair-problem";
export const REPAIR_DO = "repair-do";
export const REREAD_OF = /** @type {StoreId<ClipsOf>} */ ("reread-of");
export const PROPERTIES_OF = /** @type {StoreId<ClipsOf>} */ ("properties-of");
export const REREAD_NOW = "reread-now";
export const REREAD_UNIT = "reread-unit";
export const REREAD_UP = "reread-up";
export const REREAD_FPS = "reread-fps";
export const REREAD_PROBLEM = "reread-problem";
export const REREAD_DO = "reread-do";
export const BODY_DIALOG = "body-dialog";
export const BODY_OF = /** @type {StoreId<BodyOf>} */ ("body-of");
export const BODY_RIGS = /** @type {StoreId<BodyRigs>} */ ("body-rigs");
export const BODY_POSTURE = /** @type {StoreId<BodyPosture>} */ ("body-posture");
export const BODY_DRAFT = /** @type {StoreId<BodyDraft>} */ ("body-draft");
export const BODY_FILE = /** @type {StoreId<BodyFile>} */ ("body-file");
export const BODY_FILLED = /** @type {StoreId<BodyFilled>} */ ("body-filled");
export const BODY_RIG = "body-rig";
export const BODY_CLIP = "body-clip";
export const BODY_FRAME = "body-frame";
export const BODY_FRAME_LABEL = "body-frame-label";
export const BODY_EDITOR = "body-editor";
export const BODY_PROBLEM = "body-problem";
export const BODY_SAVE = "body-save";
export const FEATURES_CHOICE = /** @type {StoreId<FeaturesChoice>} */ ("features-choice");
export const FEATURES_READY = /** @type {StoreId<Download>} */ ("features-ready");
