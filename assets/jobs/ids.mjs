// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.jobs.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * A row of the bar; ``error`` is there where the job has failed.
 * @typedef {object} JobRow
 * @property {number} id
 * @property {string} title
 * @property {string} [stage]
 * @property {number | null} [percent]
 * @property {boolean} [stopping]
 * @property {boolean} [held]
 * @property {string} [expected]
 * @property {string} [error]
 */

/**
 * What is to be done with a job.
 * @typedef {object} JobAction
 * @property {"start" | "cancel" | "retry" | "dismiss"} action
 * @property {number} job
 * @property {number} [at]
 */

/**
 * Marks of what the bar showed last.
 * @typedef {object} JobMarks
 * @property {string} [rows]
 * @property {number} [speed]
 * @property {string} [revision]
 * @property {string} [finished]
 */

/**
 * A change of a data set that was started here.
 * @typedef {object} ChangeStarted
 * @property {number} job
 */

/**
 * What to undo: a version to go back to, or what goes to or comes from the trash.
 * @typedef {object} Undo
 * @property {string} [revert]
 * @property {string} [restore]
 * @property {string} [trash]
 * @property {number} [at]
 */

export const JOB_LIST = "job-list";
export const JOB_TICK = "job-tick";
export const JOBS_SHOWN = /** @type {StoreId<Array<JobRow>>} */ ("jobs-shown");
export const JOB_POKE = /** @type {StoreId<number>} */ ("job-poke");
export const JOB_ACTION = /** @type {StoreId<JobAction>} */ ("job-action");
export const JOBS_SEEN = /** @type {StoreId<JobMarks>} */ ("jobs-seen");
export const JOBS_DISMISSED = /** @type {StoreId<Array<number>>} */ ("jobs-dismissed");
export const JOBS_FINISHED = /** @type {StoreId<string>} */ ("jobs-finished");
export const CHANGE_STARTED = /** @type {StoreId<ChangeStarted>} */ ("change-started");
export const CHANGES = /** @type {StoreId<Array<number>>} */ ("changes");
export const UNDO = /** @type {StoreId<Undo>} */ ("undo");
