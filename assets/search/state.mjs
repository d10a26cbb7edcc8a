// What the Search page shows now, and how a query is written, changed and taken back.
import { changeView } from "../shared/dash.mjs";

/** What is shown now; the parts of the page read it and never keep a copy. `active`: the piece that takes the parts one clicks. */
export const now = { found: null, view: {}, clips: null, motifs: [], scheme: "light", presets: {}, body: null, engines: [], key: null, selection: {}, active: 0 };

/** Change what is searched for; a hit of another search is none of this one. */
export const changeSearch = (values) => changeView({ hit: "", ...values });

// ---- links: as webapp/queries.py writes them ----
const bytes = new TextEncoder();
export const escapeName = (name) => [...name].map((c) => (/[-0-9A-Za-z._ ]/.test(c) ? c
  : [...bytes.encode(c)].map((byte) => "~" + byte.toString(16).padStart(2, "0")).join(""))).join("");

/** The fewest nodes of the body's hierarchy with exactly these leaves. */
export const nodesOf = (leaves) => {
  const wanted = new Set(leaves);
  const found = [];
  const left = new Set(leaves);
  for (const [node, below] of Object.entries(now.body.nodes)) { // parents come before children
    if (below.every((leaf) => wanted.has(leaf)) && below.some((leaf) => left.has(leaf))) {
      found.push(node);
      below.forEach((leaf) => left.delete(leaf));
    }
  }
  return found;
};
export const wordsOf = (leaves) => nodesOf(leaves).map((node) => now.body.words[node]).join(", ");

export const writeQuery = (pieces) => pieces.filter((piece) => piece.leaves.length).map((piece) => [
  ...(piece.leaves.length === now.body.leaves.length ? [] : [nodesOf(piece.leaves).join("+")]),
  escapeName(piece.clip), `${piece.start}-${piece.end}`, ...(piece.dataset ? [escapeName(piece.dataset)] : []),
].join(":")).join(",");

/** The pieces that are shown, free to be changed. */
export const copyPieces = () => ((now.found && now.found.pieces) || []).map((piece) => ({ ...piece, leaves: [...piece.leaves] }));

export const searchFor = (pieces, more = {}) => {
  const query = writeQuery(pieces);
  if (query !== (now.view.query || "")) remember();
  changeSearch({ query, ...more });
};

// ---- back to what was looked for before ----
const before = [];
export const remember = () => {
  const { query, parts: weights } = now.view;
  if (query && (!before.length || before.at(-1).query !== query)) before.push({ query, parts: weights || "" });
  if (before.length > 30) before.shift();
};
export const goBack = () => {
  while (before.length) {
    const last = before.pop();
    if (last.query !== now.view.query) return changeSearch(last);
  }
  return undefined;
};
export const canGoBack = () => before.some((one) => one.query !== now.view.query);

/** The part of the address that says which search it is, with a hit or without. */
export const searchAddress = (hit) => {
  const pairs = new URLSearchParams({ dataset: now.clips.dataset, v: now.clips.version.slice(0, 8) });
  for (const [key, value] of Object.entries(now.view)) {
    if (["query", "parts"].includes(key) || key.startsWith("search-")) pairs.set(key, value);
  }
  if (hit) pairs.set("hit", hit);
  return pairs.toString();
};
