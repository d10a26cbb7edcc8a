// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from
// webapp.features.motifs.names: change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

/**
 * The views below and beside the graph, and what is chosen in them.
 * @typedef {object} View
 * @property {string} [view]
 * @property {string} [side]
 * @property {string} [walk]
 * @property {string} [weights]
 * @property {string} [other]
 * @property {string} [gained]
 * @property {string} [extra]
 * @property {string} [gaps]
 * @property {string} [ends]
 * @property {string} [feet]
 * @property {string} [stability]
 * @property {string} [step]
 */

/**
 * A motion of the selected motif, or a transition of the selected edge.
 * @typedef {object} MotionRow
 * @property {string} clip
 * @property {string} brief
 * @property {string} when
 * @property {string} strip
 * @property {import("../shared/ids.mjs").Selection} selection
 * @property {boolean} chosen
 */

/**
 * The motions of what is selected; empty where nothing is.
 * @typedef {object} Motions
 * @property {string} [name]
 * @property {Array<MotionRow>} [rows]
 * @property {number} [more]
 */

/**
 * How the view of the graph is to change: "in", "out" or "fit".
 * @typedef {object} GraphTool
 * @property {string} graph
 * @property {number} [at]
 */

/**
 * What is drawn of a large graph: a part of it, and around which motif.
 * @typedef {object} GraphPart
 * @property {string} part
 * @property {number | null} centre
 */

/**
 * A clip, in seconds.
 * @typedef {object} TimelineRow
 * @property {string} clip
 * @property {string} brief
 * @property {number} fps
 * @property {number} seconds
 * @property {number} share
 * @property {Array<[number, number, number, number]>} motions
 * @property {Array<[number, number, number]>} labels
 */

/**
 * A motif in the timeline.
 * @typedef {object} TimelineMotif
 * @property {string} name
 * @property {string} colour
 * @property {number} motions
 */

/**
 * Every clip with its labels and motifs.
 * @typedef {object} Timeline
 * @property {string} dataset
 * @property {Array<TimelineRow>} rows
 * @property {Record<string, TimelineMotif>} motifs
 * @property {Array<string>} actions
 * @property {Array<string>} colours
 * @property {string} drawing
 */

/**
 * A motion that can be mixed, and its seconds at moments of the reference.
 * @typedef {object} BlendMotion
 * @property {number} motion
 * @property {string} clip
 * @property {string} brief
 * @property {number} start
 * @property {number} end
 * @property {number} fps
 * @property {string} when
 * @property {Array<number>} seconds
 */

/**
 * Motions of one body.
 * @typedef {object} BlendBody
 * @property {Array<BlendMotion>} motions
 * @property {Array<number>} chosen
 * @property {number} reference
 */

/**
 * What can be mixed of a motif; only the first two where nothing can.
 * @typedef {object} BlendData
 * @property {string} key
 * @property {number | null} motif
 * @property {string} [title]
 * @property {number} [total]
 * @property {string} [dataset]
 * @property {string} [version]
 * @property {number} [most]
 * @property {Array<BlendBody>} [bodies]
 * @property {import("../shared/ids.mjs").StageRequest} [middles]
 * @property {import("../shared/ids.mjs").StageRequest | null} [together]
 */

/**
 * A motif that a walk can pass.
 * @typedef {object} WalkMotif
 * @property {number} id
 * @property {string} name
 */

/**
 * The ways of the graph, and the walk of the link or why there is none.
 * @typedef {object} WalkData
 * @property {string} key
 * @property {Record<string, string>} inputs
 * @property {string} [dataset]
 * @property {Array<WalkMotif>} [motifs]
 * @property {string} [error]
 * @property {Array<number>} [dead]
 * @property {Array<number>} [parts]
 * @property {Array<[number, number]>} [further]
 * @property {[number, number]} [gap]
 * @property {Array<number>} [detour]
 * @property {string} [name]
 * @property {Array<number>} [path]
 * @property {Array<string>} [kinds]
 * @property {Array<[number, number]>} [visits]
 * @property {number} [frames]
 * @property {number} [seconds]
 * @property {number} [blends]
 * @property {[number, number, number]} [skate]
 * @property {[number, number]} [speeds]
 * @property {boolean} [jump]
 * @property {Array<string>} [warnings]
 * @property {Array<import("../shared/ids.mjs").Colour>} [bands]
 * @property {number} [unseen]
 * @property {Record<string, string>} [recipes]
 */

/**
 * A motif of one of two results that are compared, as high as the motion in it.
 * @typedef {object} FlowBar
 * @property {"a" | "b"} side
 * @property {number | null} motif
 * @property {string} label
 * @property {number} y
 * @property {number} h
 * @property {string | null} change
 * @property {string} title
 */

/**
 * Motion that a motif of each result shares.
 * @typedef {object} FlowRibbon
 * @property {number | null} a
 * @property {number | null} b
 * @property {number} ya
 * @property {number} yb
 * @property {number} h
 * @property {"kept" | "linked" | "rest"} kind
 * @property {string} title
 */

/**
 * How the motion of one result is found again in another, in pixels.
 * @typedef {object} Flow
 * @property {number} height
 * @property {Array<FlowBar>} bars
 * @property {Array<FlowRibbon>} ribbons
 */

/**
 * Settings of the other result, as the link has them, that is to be computed.
 * @typedef {object} OtherResult
 * @property {string} other
 * @property {number} [at]
 */

/**
 * How often a motif was found again: its mean share over the kinds of repeat, in how many, and each kind.
 * @typedef {object} MotifStability
 * @property {number} overall
 * @property {number} kept
 * @property {number} [noise]
 * @property {number} [seed]
 * @property {number} [parameters]
 */

/**
 * How often the motifs were found again, by motif.
 * @typedef {object} StabilityData
 * @property {number} repeats
 * @property {Record<string, MotifStability>} motifs
 */

export const MOTIF_MENUS = "motif-menus";
export const MOTIF_RESULT = "motif-result";
export const MOTIFS_DRAWN = /** @type {StoreId<string>} */ ("motifs-drawn");
export const MOTIF_GRAPH = "motif-graph";
export const EDGE_FILTER_LABEL = "edge-filter-label";
export const GRAPH_PART = "graph-part";
export const GRAPH_PART_WORDS = "graph-part-words";
export const GRAPH_SOUGHT = /** @type {StoreId<Record<string, number>>} */ ("graph-sought");
export const GRAPH_PART_SHOWN = /** @type {StoreId<GraphPart>} */ ("graph-part-shown");
export const EDGE_THRESHOLD = "edge-threshold";
export const GRAPH_TOOL = /** @type {StoreId<GraphTool>} */ ("graph-tool");
export const GRAPH_TAPPED = /** @type {StoreId<any>} */ ("graph-tapped");
export const GRAPH_MARKED = /** @type {StoreId<any>} */ ("graph-marked");
export const MOTIF_VIEW = "motif-view";
export const MOTIF_SIDE = "motif-side";
export const MOTIF_SEARCH = "motif-search";
export const MOTIF_TABLE = "motif-table";
export const MOTIF_TABLE_PLACE = "motif-table-place";
export const MOTIFS_MARKED = /** @type {StoreId<any>} */ ("motifs-marked");
export const MOTIFS_SEARCHED = /** @type {StoreId<any>} */ ("motifs-searched");
export const MOTIF_SELECTION = "motif-selection";
export const MOTION_LIST = "motion-list";
export const MOTIONS = /** @type {StoreId<Motions>} */ ("motions");
export const TIMELINE_ORDER = "timeline-order";
export const TIMELINE_SCALE = "timeline-scale";
export const TIMELINE_LEGEND = "timeline-legend";
export const TIMELINE_ROWS = "timeline-rows";
export const TIMELINE_DATA = /** @type {StoreId<Timeline>} */ ("timeline-data");
export const TIMELINE_DRAWN = /** @type {StoreId<any>} */ ("timeline-drawn");
export const TIMELINE_MARKED = /** @type {StoreId<any>} */ ("timeline-marked");
export const REPORT_BODY = "report-body";
export const REPORT_FIND = /** @type {StoreId<Record<string, boolean | number>>} */ ("report-find");
export const REPORT_JOB = /** @type {StoreId<number>} */ ("report-job");
export const REPORT_SHOWN = /** @type {StoreId<Array<any>>} */ ("report-shown");
export const REPORT_CHART = "report-chart";
export const COMPARE_OTHER = "compare-other";
export const COMPARE_STATUS = "compare-status";
export const COMPARE_RESULT = "compare-result";
export const COMPARE_SENTENCE = "compare-sentence";
export const COMPARE_FLOW = "compare-flow";
export const COMPARE_FILTER = "compare-filter";
export const COMPARE_AGAIN = "compare-again";
export const COMPARE_TABLE = "compare-table";
export const COMPARE_STATUS_OF = /** @type {StoreId<Array<any>>} */ ("compare-status-of");
export const COMPARE_KEYS = /** @type {StoreId<[string, string]>} */ ("compare-keys");
export const COMPARE_FLOW_DATA = /** @type {StoreId<Flow>} */ ("compare-flow-data");
export const COMPARE_REQUEST = /** @type {StoreId<import("../shared/ids.mjs").StageRequest>} */ ("compare-request");
export const COMPARE_FIND = /** @type {StoreId<OtherResult>} */ ("compare-find");
export const COMPARE_STARTED = /** @type {StoreId<any>} */ ("compare-started");
export const COMPARE_DRAWN = /** @type {StoreId<any>} */ ("compare-drawn");
export const COMPARE_MARKED = /** @type {StoreId<any>} */ ("compare-marked");
export const COMPARE_ROW_MARKED = /** @type {StoreId<any>} */ ("compare-row-marked");
export const COMPRESSION_WHOLE = "compression-whole";
export const COMPRESSION_FIND = /** @type {StoreId<Record<string, boolean | number>>} */ ("compression-find");
export const COMPRESSION_JOB = /** @type {StoreId<number>} */ ("compression-job");
export const COMPRESSION_SHOWN = /** @type {StoreId<Array<any>>} */ ("compression-shown");
export const COMPRESSION_TITLE = "compression-title";
export const COMPRESSION_MEASURE = "compression-measure";
export const COMPRESSION_SENTENCE = "compression-sentence";
export const COMPRESSION_MOTIF = "compression-motif";
export const COMPRESSION_CHART = "compression-chart";
export const COMPRESSION_STEP = "compression-step";
export const COMPRESSION_MOTION = "compression-motion";
export const COMPRESSION_ALL = "compression-all";
export const COMPRESSION_OF = /** @type {StoreId<Array<any>>} */ ("compression-of");
export const BLEND_HINT = "blend-hint";
export const BLEND_PANEL = "blend-panel";
export const BLEND_TITLE = "blend-title";
export const BLEND_COUNT = "blend-count";
export const BLEND_CONTROLS = "blend-controls";
export const BLEND_BVH = "blend-bvh";
export const BLEND_NOTE = "blend-note";
export const BLEND_DATA = /** @type {StoreId<BlendData>} */ ("blend-data");
export const BLEND_DRAWN = /** @type {StoreId<any>} */ ("blend-drawn");
export const WALK_TITLE = "walk-title";
export const WALK_LENGTH = "walk-length";
export const WALK_HINT = "walk-hint";
export const WALK_PATH = "walk-path";
export const WALK_ERROR = "walk-error";
export const WALK_METERS = "walk-meters";
export const WALK_BVH = "walk-bvh";
export const WALK_JSON = "walk-json";
export const WALK_NOTES = "walk-notes";
export const WALK_ADD = "walk-add";
export const WALK_FROM = "walk-from";
export const WALK_TO = "walk-to";
export const WALK_SECONDS = "walk-seconds";
export const WALK_SEED = "walk-seed";
export const WALK_EXTRA = "walk-extra";
export const WALK_BRIDGE = "walk-bridge";
export const WALK_STOP = "walk-stop";
export const WALK_FEET = "walk-feet";
export const WALK_WAYS = "walk-ways";
export const WALK_DATA = /** @type {StoreId<WalkData>} */ ("walk-data");
export const WALK_DRAWN = /** @type {StoreId<any>} */ ("walk-drawn");
export const NOTES_HINT = "notes-hint";
export const NOTES_FORM = "notes-form";
export const NOTES_TITLE = "notes-title";
export const NOTES_NAME = "notes-name";
export const NOTES_TAGS = "notes-tags";
export const NOTES_TEXT = "notes-text";
export const NOTES_STATUS = "notes-status";
export const NOTES_MOTIF = /** @type {StoreId<number>} */ ("notes-motif");
export const NOTES_NAMES = /** @type {StoreId<Record<string, [string, Array<string>, string]>>} */ ("notes-names");
export const NOTES_DRAWN = /** @type {StoreId<any>} */ ("notes-drawn");
export const STABILITY_BUTTON = "stability-button";
export const STABILITY_REPETITIONS = "stability-repetitions";
export const STABILITY_NOISE_DEGREES = "stability-noise_degrees";
export const STABILITY_STATUS = "stability-status";
export const STABILITY_SHOW = "stability-show";
export const STABILITY_HIDE = "stability-hide";
export const STABILITY_LEGEND = "stability-legend";
export const STABILITY_WORDS = "stability-words";
export const STABILITY_DATA = /** @type {StoreId<StabilityData>} */ ("stability-data");
export const STABILITY_OF = /** @type {StoreId<Array<any>>} */ ("stability-of");
export const STABILITY_DRAWN = /** @type {StoreId<any>} */ ("stability-drawn");
export const STABILITY_LISTED = /** @type {StoreId<any>} */ ("stability-listed");
