// Files that were chosen together: which are sent, under which names, and which are left out and why.
/** @import { Batch, FoundFile, Limits, Upload } from "./types.d.ts" */

/** Kinds of files that may hold motion and are not read. */
const MOTION = ["FBX", "VMD", "PKL", "BIP", "HTR", "BLEND", "DAE", "USD"];
/** Endings of files that may hold anything: the server looks into them and says whether they are recordings. */
const MAYBE = /\.(csv|tsv|txt|json|npy|npz)(\.gz)?$/i;
/** Endings of files that are read beside recordings. */
const BESIDE = /\.(asf|bin|zip)(\.gz)?$/i;

/** A size as people read it. @param {number} bytes */
export const sizeInWords = (bytes) => bytes >= 2 ** 30 ? (bytes / 2 ** 30).toFixed(1) + " GB"
  : bytes >= 1e5 ? (bytes / 2 ** 20).toFixed(1) + " MB" : Math.max(1, Math.round(bytes / 1024)) + " kB";

/** Nothing has been chosen yet. @returns {Batch} */
export function freshBatch() {
  return { token: null, items: [], sent: 0, bytes: 0, active: 0, queue: [], stopped: false, name: "", hidden: 0, ignored: {} };
}

/**
 * The path under which a file is kept. Files of one name from two places do not overwrite one another: the second lies in a
 * folder of its own. Null for the very same file a second time.
 * @param {Batch} mine
 * @param {File} file
 * @param {string} path
 */
export function freePath(mine, file, path) {
  for (let k = 1; ; k++) {
    const tried = k === 1 ? path : k + "/" + path;
    const there = mine.items.find((item) => item.path === tried && item.state !== "error");
    if (!there) return tried;
    if (there.file.size === file.size && there.file.lastModified === file.lastModified) return null;
  }
}

/** Leave a file out. @param {Upload} item @param {string} message */
export function refuse(item, message) {
  item.state = "error";
  item.message = message;
}

/** What has come, by its names: the dialog asks only what matters for it. @param {Batch} mine */
export function kinds(mine) {
  /** @param {RegExp} pattern */
  const count = (pattern) => mine.items.filter((item) => item.state !== "error" && pattern.test(item.path)).length;
  const archives = count(/\.zip$/i);
  const here = mine.items.filter((item) => item.state !== "error");
  const recordings = here.filter((item) => MAYBE.test(item.path) ? item.recording : !BESIDE.test(item.path)).length + archives;
  const labels = here.filter((item) => /\.csv$/i.test(item.path) && !item.recording).length;
  return { recordings, labels, amc: count(/\.amc(\.gz)?$/i), archives };
}

/** The name of a data set that files which can be read suggest; none where there is no such file. @param {FoundFile[]} files */
function nameOf(files) {
  if (!files.length) return "";
  const parts = files[0].path.split("/");
  if (parts.length > 1) return parts[0];
  return files.length > 1 ? "Recordings" : parts[0].replace(/(\.[a-z0-9]{1,5})(\.gz)?$/i, "");
}

/** What kind of file a path is, as people call it: FBX, VMD; "other" without an ending. @param {string} path */
const kindOf = (path) => /\.([a-z0-9]{1,8})$/.exec(path)?.[1]?.toUpperCase() ?? "other";

/** Files that were left out, by kind: "3 FBX, 1 TXT left out"; empty where none was. @param {Batch} mine */
export function leftOut(mine) {
  const counts = Object.entries(mine.ignored).sort((a, b) => b[1] - a[1] || a[0].localeCompare(b[0]));
  const words = counts.map(([kind, count]) => `${count} ${kind}`).join(", ");
  const motion = counts.some(([kind]) => MOTION.includes(kind));
  return words && `${words} left out${motion ? "; convert motion to BVH, with Blender for example" : ""}`;
}

/**
 * Take files into a batch: those that may be sent into its queue, others with the reason why not. Gives the new ones.
 * Of several files, those that no recording could be are ignored.
 * @param {Batch} mine
 * @param {FoundFile[]} files
 * @param {Limits} limits
 */
export function takeFiles(mine, files, { fileBytes, totalBytes, files: most, suffixes }) {
  /** @param {string} path */
  const isReadable = (path) => suffixes.some((suffix) => path.toLowerCase().endsWith(suffix));
  if (!mine.name) mine.name = nameOf(files.filter(({ path }) => isReadable(path) && !/\.csv(\.gz)?$/i.test(path)));
  /** @type {Upload[]} */
  const taken = [];
  for (const { file, path: given } of files) {
    const path = freePath(mine, file, given);
    if (!path) continue;
    const lower = path.toLowerCase();
    const readable = isReadable(path);
    if (!readable && files.length > 1 && !/\.(bvh|amc|asf|zip)/i.test(lower)) {
      const kind = kindOf(lower);
      mine.ignored[kind] = (mine.ignored[kind] ?? 0) + 1;
      continue;
    }
    /** @type {Upload} */
    const item = { file, path, sent: 0, state: "waiting", message: "", row: null };
    mine.items.push(item);
    taken.push(item);
    if (!readable) refuse(item, "not a kind of file we read; convert it to BVH");
    else if (file.size > fileBytes) refuse(item, `too large: ${sizeInWords(file.size)}; a file may have ${sizeInWords(fileBytes)}`);
    else if (mine.queue.length + mine.sent >= most) refuse(item, `too many files: ${most} at most`);
    else if (mine.bytes + file.size > totalBytes) refuse(item, `too much altogether: ${sizeInWords(totalBytes)} at most`);
    else {
      mine.bytes += file.size;
      mine.queue.push(item);
    }
  }
  return taken;
}
