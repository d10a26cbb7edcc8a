import js from "@eslint/js";
import globals from "globals";

const FEATURES = ["library", "clip", "motifs", "sweeps", "motion_map", "search", "grammar", "boards"];
const SHARED = ["shared"];
// What the modules of a room may import: their own room and those below it. Features never import one another.
const BELOW = {
  shared: [],
  stage: SHARED,
  jobs: SHARED,
  shell: [...SHARED, "stage"],
  blocks: [...SHARED, "stage"],
  ...Object.fromEntries(FEATURES.map((room) => [room, [...SHARED, "stage", "blocks"]])),
  report: [...SHARED, "stage", "blocks", ...FEATURES],
  film: [...SHARED, "stage", "blocks"],
};
const rooms = Object.entries(BELOW).map(([room, below]) => ({
  files: [`assets/${room}/**/*.mjs`],
  rules: {
    "no-restricted-imports": ["error", {
      patterns: [{
        regex: `^\\.\\./(?!(${[room, ...below].join("|") || "nothing"})/)`,
        message: `${room} may import only from ${["itself", ...below].join(", ")}.`,
      }],
    }],
  },
}));

export default [
  { ignores: ["assets/node_modules/", "assets/bundle/"] },
  js.configs.recommended,
  {
    languageOptions: { globals: globals.browser },
    rules: {
      eqeqeq: "error",
      "no-shadow": "error",
      "no-unused-vars": ["error", { argsIgnorePattern: "^_" }],
      "prefer-const": "error",
    },
  },
  { files: ["assets/*.mjs", "tests/**/*.mjs"], languageOptions: { globals: globals.node } },
  ...rooms,
];
