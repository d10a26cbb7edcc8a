// What the Search page shows now, and how a query is written, changed and taken back.
import { changeView } from "../shared/dash.mjs";
/** @import { Body, ClipList, Found, MotifQuery, QueryPiece, Weights } from "./types.d.ts" */
/** @import { Selection, View } from "../shared/types.d.ts" */

/** A part of the state that is null until the page has it; who uses it before has to ask. @type {any} */
const none = null;

/** What is shown now; the parts of the page read it and never keep a copy. `active`: the piece whose parts are clicked. */
export const now = {
  found: /** @type {Found} */ (none),
  view: /** @type {View} */ ({}),
  clips: /** @type {ClipList} */ (none),
  motifs: /** @type {MotifQuery[]} */ ([]),
  scheme: "light",
  presets: /** @type {Record<string, Weights>} */ ({}),
  body: /** @type {Body} */ (none),
  engines: /** @type {any[]} */ ([]),
  key: /** @type {any} */ (null),
  selection: /** @type {Selection} */ ({}),
  active: 0,
};

/**
 * Change what is searched for; the chosen hit is dropped, since it belongs to the search before.
 * @param {Record<string, string>} values
 */
export const changeSearch = (values) => changeView({ hit: "", ...values });

// ---- links: as webapp/features/search/queries.py writes them ----
const bytes = new TextEncoder();
/** @param {string} name */
export const escapeName = (name) => [...name].map((c) => (/[-0-9A-Za-z._ ]/.test(c) ? c
  : [...bytes.encode(c)].map((byte) => "~" + byte.toString(16).padStart(2, "0")).join(""))).join("");

/**
 * The fewest nodes of the body's hierarchy with exactly these leaves.
 * @param {string[]} leaves
 */
export const nodesOf = (leaves) => {
  const wanted = new Set(leaves);
  /** @type {string[]} */
  const nodes = [];
  const left = new Set(leaves);
  for (const [node, below] of Object.entries(now.body.nodes)) { // parents come before children
    if (below.every((leaf) => wanted.has(leaf)) && below.some((leaf) => left.has(leaf))) {
      nodes.push(node);
      below.forEach((leaf) => left.delete(leaf));
    }
  }
  return nodes;
};
/** @param {string[]} leaves */
export const wordsOf = (leaves) => nodesOf(leaves).map((node) => now.body.words[node]).join(", ");

/** @param {QueryPiece[]} pieces */
export const writeQuery = (pieces) => pieces.filter((piece) => piece.leaves.length).map((piece) => [
  ...(piece.leaves.length === now.body.leaves.length ? [] : [nodesOf(piece.leaves).join("+")]),
  escapeName(piece.clip), `${piece.start}-${piece.end}`, ...(piece.dataset ? [escapeName(piece.dataset)] : []),
].join(":")).join(",");

/** The pieces that are shown, free to be changed. */
export const copyPieces = () => ((now.found && now.found.pieces) || []).map((piece) => ({ ...piece, leaves: [...piece.leaves] }));

/** @param {QueryPiece[]} pieces @param {Record<string, string>} [more] */
export const searchFor = (pieces, more = {}) => {
  const query = writeQuery(pieces);
  if (query !== (now.view.query || "")) remember();
  changeSearch({ query, ...more });
};

// ---- back to what was looked for before ----
/** @type {{ query: string, parts: string }[]} */
const before = [];
export const remember = () => {
  const { query, parts: weights } = now.view;
  if (query && (!before.length || before.at(-1)?.query !== query)) before.push({ query, parts: weights || "" });
  if (before.length > 30) before.shift();
};
export const goBack = () => {
  while (before.length) {
    const last = before.pop();
    if (last && last.query !== now.view.query) return changeSearch(last);
  }
  return undefined;
};
export const canGoBack = () => before.some((one) => one.query !== now.view.query);

/**
 * The part of the address that says which search it is, with a hit or without.
 * @param {string} [hit]
 */
export const searchAddress = (hit) => {
  const pairs = new URLSearchParams({ dataset: now.clips.dataset, v: now.clips.version.slice(0, 8) });
  for (const [key, value] of Object.entries(now.view)) {
    if (value && (["query", "parts"].includes(key) || key.startsWith("search-"))) pairs.set(key, value);
  }
  if (hit) pairs.set("hit", hit);
  return pairs.toString();
};
