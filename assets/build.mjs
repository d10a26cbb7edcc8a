// Puts the modules and style sheets into bundle/, which is what the app serves: `node assets/build.mjs`.
// With --check nothing is written; it fails where the bundle is not what the sources give.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { relative } from "node:path";
import { build } from "esbuild";

const folder = import.meta.dirname;
/** What each file of the bundle is made of: the app, and the scripts and styles of a report and of the page of a film. */
const ENTRIES = {
  motionscape: ["main.mjs", "main.css"],
  report: ["report/main.mjs", "report/report.css"],
  film: ["film/main.mjs", "film/film.css"],
};
const outputFiles = [];
for (const [name, entryPoints] of Object.entries(ENTRIES)) {
  const made = await build({
    absWorkingDir: folder,
    entryPoints,
    entryNames: name === "motionscape" ? name : `parts/${name}`,
    outdir: "bundle",
    outbase: name === "motionscape" ? "." : name,
    bundle: true,
    minify: name !== "motionscape",
    format: "iife",
    target: "es2022",
    charset: "utf8",
    logLevel: "warning",
    write: false,
  });
  outputFiles.push(...made.outputFiles);
}
// Libraries that are too big for the bundle: files of their own, which pages load when they need them.
const COPIES = {
  "plotly.js-cartesian-dist-min/plotly-cartesian.min.js": "plotly-cartesian.min.js",
  "plotly.js-cartesian-dist-min/LICENSE": "plotly-cartesian.LICENSE.txt",
  "gridstack/dist/gridstack-all.js": "gridstack.js",
  "gridstack/dist/gridstack.min.css": "gridstack.css",
  "gridstack/LICENSE": "gridstack.LICENSE.txt",
};
for (const [source, copy] of Object.entries(COPIES)) {
  const text = readFileSync(`${folder}/node_modules/${source}`, "utf8").replace(/\n\/\/# sourceMappingURL=.*\n?$/, "\n");
  outputFiles.push({ path: `${folder}/bundle/vendor/${copy}`, text });
}
const current = (path) => {
  try {
    return readFileSync(path, "utf8");
  } catch {
    return null;
  }
};
const stale = outputFiles.filter(({ path, text }) => current(path) !== text);
if (process.argv.includes("--check")) {
  for (const { path } of stale) console.error(`assets/${relative(folder, path)} is not up to date: run "make bundle".`);
  process.exitCode = stale.length ? 1 : 0;
} else {
  for (const part of ["vendor", "parts"]) mkdirSync(`${folder}/bundle/${part}`, { recursive: true });
  for (const { path, text } of stale) writeFileSync(path, text);
}
