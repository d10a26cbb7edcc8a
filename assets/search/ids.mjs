// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.search.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * What is searched for (see searching.py), the hit that is chosen, and the view.
 * @typedef {object} View
 * @property {string} [query]
 * @property {string} [parts]
 * @property {string} [level]
 * @property {string} [route]
 * @property {string} [label]
 * @property {string} [named]
 * @property {string} [lasting]
 * @property {string} [top]
 * @property {string} [hit]
 * @property {string} [look]
 * @property {string} [study]
 * @property {string} [asks]
 * @property {string} [measure]
 * @property {string} [words]
 * @property {string} [seen]
 */

/**
 * A choice of a menu.
 * @typedef {object} Choice
 * @property {string} value
 * @property {string} label
 */

/**
 * The hierarchy of the body and its words.
 * @typedef {object} Body
 * @property {Array<string>} leaves
 * @property {Record<string, string>} words
 * @property {Record<string, Array<string>>} nodes
 */

/**
 * The clips and actions there are to choose from.
 * @typedef {object} Clips
 * @property {string} dataset
 * @property {string} version
 * @property {Array<[string, number]>} clips
 * @property {Array<string>} actions
 */

/**
 * A motif that can be looked for.
 * @typedef {object} MotifChoice
 * @property {string} name
 * @property {number} motions
 * @property {string} query
 */

/**
 * One piece of the query.
 * @typedef {object} PieceRow
 * @property {string} clip
 * @property {string} dataset
 * @property {string} source
 * @property {string} version
 * @property {number} start
 * @property {number} end
 * @property {number} frames
 * @property {number} fps
 * @property {Array<string>} leaves
 * @property {string} gives
 * @property {string} colour
 * @property {Array<[number, number, string]>} labels
 */

/**
 * One hit.
 * @typedef {object} HitRow
 * @property {string} name
 * @property {number} rank
 * @property {string} clip
 * @property {number} start
 * @property {number} end
 * @property {string} when
 * @property {number} score
 * @property {string} label
 * @property {string} strip
 */

/**
 * How alike the parts of the body are over the query's time: a row for each leaf.
 * @typedef {object} Strip
 * @property {Array<Array<number>>} rows
 * @property {Array<number | null>} means
 */

/**
 * Why a hit is one, and the request that plays it beside the query.
 * @typedef {object} Reason
 * @property {Strip} strip
 * @property {import("../shared/ids.mjs").StageRequest} request
 */

/**
 * The query and its hits, or why there are none.
 * @typedef {object} Found
 * @property {Record<string, string | null>} inputs
 * @property {Array<PieceRow>} [pieces]
 * @property {string} [level]
 * @property {import("../shared/ids.mjs").StageRequest} [request]
 * @property {Array<HitRow>} [hits]
 * @property {number} [total]
 * @property {number} [unlike]
 * @property {boolean} [chances]
 * @property {number} [milliseconds]
 * @property {string} [doubt]
 * @property {string} [error]
 */

/**
 * A recording that has arrived.
 * @typedef {object} Upload
 * @property {string} token
 * @property {string} name
 */

/**
 * The job that reads a recording.
 * @typedef {object} Reading
 * @property {number} job
 */

/**
 * A setting that is a list of names: its key in the view, the names there are, and what is usual.
 * @typedef {object} ListChoice
 * @property {string} key
 * @property {Array<string>} names
 * @property {string} usual
 */

/**
 * Who answers in this browser.
 * @typedef {object} Person
 * @property {string} [id]
 * @property {string} [name]
 */

/**
 * A rating of a hit, or a choice between two.
 * @typedef {object} Answer
 * @property {string} kind
 * @property {string} query
 * @property {string} [hit]
 * @property {string} [left]
 * @property {string} [right]
 * @property {number} [value]
 * @property {string} [choice]
 * @property {string | null} [person]
 * @property {string} [id]
 */

/**
 * Answers that the server has not confirmed.
 * @typedef {object} Answers
 * @property {Array<Answer>} answers
 * @property {number} [at]
 */

/**
 * Ids of answers that the server has received.
 * @typedef {object} ReceivedAnswers
 * @property {Array<string | null>} [received]
 * @property {number | null} [at]
 */

/**
 * A task for the server, one of these.
 * @typedef {object} Wish
 * @property {string} [build]
 * @property {number} [draw]
 * @property {boolean} [clear]
 * @property {number} [at]
 */

/**
 * An engine of the study.
 * @typedef {object} Engine
 * @property {string} method
 * @property {string} label
 * @property {boolean} ready
 */

/**
 * A query of the study.
 * @typedef {object} StudyQuery
 * @property {string} name
 * @property {string} clip
 * @property {string} when
 * @property {string} strip
 */

/**
 * A pair to be rated, or a duel to be decided, and the answer that was given.
 * @typedef {object} Question
 * @property {string} query
 * @property {import("../shared/ids.mjs").StageRequest} request
 * @property {number | string | null} value
 * @property {string} [hit]
 * @property {string} [left]
 * @property {string} [right]
 */

/**
 * What a study was gathered from.
 * @typedef {object} StudyInputs
 * @property {string} dataset
 * @property {Record<string, string>} link
 * @property {string} person
 * @property {string} finished
 */

/**
 * What the browser shows of the study, or why there is nothing to show.
 * @typedef {object} Study
 * @property {StudyInputs} inputs
 * @property {string} [error]
 * @property {Array<Engine>} [engines]
 * @property {Array<StudyQuery>} [queries]
 * @property {Array<Question>} [pairs]
 * @property {Array<Question>} [duels]
 */

export const SEARCH_RUN = "search-run";
export const SEARCH_ESTIMATE = "search-estimate";
export const SEARCH_LEFT_OUT = "search-left-out";
export const SEARCH_FOLD = "search-fold";
export const SEARCH_SUMMARY = "search-summary";
export const SEARCH_FORM = "search-form";
export const SEARCH_STATUS = "search-status";
export const SEARCH_SETTINGS = /** @type {StoreId<Record<string, string>>} */ ("search-settings");
export const SEARCH_RESULT_KEY = /** @type {StoreId<string>} */ ("search-result-key");
export const SEARCH_STATUS_OF = /** @type {StoreId<Array<any>>} */ ("search-status-of");
export const SEARCH_AGAIN = /** @type {StoreId<Record<string, boolean | number>>} */ ("search-again");
export const SEARCH_MENUS = "search-menus";
export const SEARCH_LOOK = "search-look";
export const SEARCH_ERROR = "search-error";
export const SEARCH_HITS_HEAD = "search-hits-head";
export const SEARCH_HITS = "search-hits";
export const SEARCH_SOURCES = "search-sources";
export const SEARCH_CLIP_NAMES = "search-clip-names";
export const SEARCH_MOTIF = "search-motif";
export const SEARCH_WARNING = "search-warning";
export const SEARCH_COUNTS = "search-counts";
export const SEARCH_COUNTS_SAYS = "search-counts-says";
export const SEARCH_WANTED = "search-wanted";
export const SEARCH_BODY = "search-body";
export const SEARCH_OPTIONS = "search-options";
export const SEARCH_PRESET = "search-preset";
export const SEARCH_ENGINE = "search-engine";
export const SEARCH_LEVEL = "search-level";
export const SEARCH_ROUTE = "search-route";
export const SEARCH_LABEL = "search-label";
export const SEARCH_NAMED = "search-named";
export const SEARCH_SHORTEST = "search-shortest";
export const SEARCH_LONGEST = "search-longest";
export const SEARCH_ENGINES = /** @type {StoreId<Array<Choice>>} */ ("search-engines");
export const SEARCH_PRESETS = /** @type {StoreId<Record<string, Record<string, number>>>} */ ("search-presets");
export const SEARCH_PARTS = /** @type {StoreId<Body>} */ ("search-parts");
export const SEARCH_CLIPS = /** @type {StoreId<Clips>} */ ("search-clips");
export const SEARCH_TYPED = /** @type {StoreId<string>} */ ("search-typed");
export const SEARCH_MOTIFS = /** @type {StoreId<Array<MotifChoice>>} */ ("search-motifs");
export const SEARCH_FOUND = /** @type {StoreId<Found>} */ ("search-found");
export const SEARCH_DRAWN = /** @type {StoreId<any>} */ ("search-drawn");
export const SEARCH_LISTED = /** @type {StoreId<any>} */ ("search-listed");
export const SEARCH_UPLOAD = /** @type {StoreId<Upload>} */ ("search-upload");
export const SEARCH_UPLOAD_JOB = /** @type {StoreId<Reading>} */ ("search-upload-job");
export const SEARCH_UPLOAD_DONE = /** @type {StoreId<any>} */ ("search-upload-done");
export const SEARCH_UPLOAD_STATUS = "search-upload-status";
export const SEARCH_STORAGE = "search-storage";
export const SEARCH_WORDS = "search-words";
export const SEARCH_WORDS_LEVEL = "search-words-level";
export const SEARCH_WORDS_FOUND = "search-words-found";
export const SEARCH_STUDY = "search-study";
export const STUDY_SETUP = "study-setup";
export const STUDY_RATE = "study-rate";
export const STUDY_VOTE = "study-vote";
export const STUDY_RESULTS = "study-results";
export const STUDY_NAME = "study-name";
export const STUDY_CHART = "study-chart";
export const STUDY_DATA = /** @type {StoreId<Study>} */ ("study-data");
export const STUDY_DRAWN = /** @type {StoreId<any>} */ ("study-drawn");
export const STUDY_ANSWER = /** @type {StoreId<Answers>} */ ("study-answer");
export const STUDY_RECEIVED = /** @type {StoreId<ReceivedAnswers>} */ ("study-received");
export const STUDY_WISH = /** @type {StoreId<Wish>} */ ("study-wish");
export const STUDY_PERSON = /** @type {StoreId<Person>} */ ("study-person");
export const RANKING_RUN = "ranking-run";
export const RANKING_ESTIMATE = "ranking-estimate";
export const RANKING_LEFT_OUT = "ranking-left-out";
export const RANKING_FOLD = "ranking-fold";
export const RANKING_SUMMARY = "ranking-summary";
export const RANKING_FORM = "ranking-form";
export const RANKING_STATUS = "ranking-status";
export const RANKING_SETTINGS = /** @type {StoreId<Record<string, string>>} */ ("ranking-settings");
export const RANKING_RESULT_KEY = /** @type {StoreId<string>} */ ("ranking-result-key");
export const RANKING_STATUS_OF = /** @type {StoreId<Array<any>>} */ ("ranking-status-of");
export const RANKING_AGAIN = /** @type {StoreId<Record<string, boolean | number>>} */ ("ranking-again");
export const RANKING_ENGINES = "ranking-engines";
export const RANKING_ENGINES_OF = /** @type {StoreId<ListChoice>} */ ("ranking-engines-of");
export const RANKING_RESULT = "ranking-result";
export const RANKING_REGIME = "ranking-regime";
export const RANKING_CONFUSED = "ranking-confused";
export const RANKING_CURVES = "ranking-curves";
export const RANKING_CONFUSION = "ranking-confusion";
