// Puts the modules and style sheets into bundle/, which is what the app serves: `node assets/build.mjs`.
// With --check nothing is written; it fails where the bundle is not what the sources give.
import { readFileSync, writeFileSync } from "node:fs";
import { relative } from "node:path";
import { build } from "esbuild";

const folder = import.meta.dirname;
const { outputFiles } = await build({
  absWorkingDir: folder,
  entryPoints: ["main.mjs", "main.css"],
  entryNames: "motionscape",
  outdir: "bundle",
  bundle: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  logLevel: "warning",
  write: false,
});
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
  for (const { path, text } of stale) writeFileSync(path, text);
}
