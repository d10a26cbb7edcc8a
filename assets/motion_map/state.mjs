// What the Map page shows now.

export const state = {
  map: null,
  known: null,
  keys: [],
  reach: 0,
  pace: null,
  facts: null,
  mode: "keys",
  selection: null,
  hits: [],
  path: "",
  lit: [],
  overlay: null, // over the heatmap of the page, with its follower
  follower: null,
};
