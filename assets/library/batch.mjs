// Files that were chosen together: which are sent, under which names, and which are left out and why.
/** @import { Batch, FoundFile, Limits, Upload } from "./types.d.ts" */

/** A size as people read it. @param {number} bytes */
export const sizeInWords = (bytes) => bytes >= 2 ** 30 ? (bytes / 2 ** 30).toFixed(1) + " GB"
  : bytes >= 1e5 ? (bytes / 2 ** 20).toFixed(1) + " MB" : Math.max(1, Math.round(bytes / 1024)) + " kB";

/** Nothing has been chosen yet. @returns {Batch} */
export function freshBatch() {
  return { token: null, items: [], sent: 0, bytes: 0, active: 0, queue: [], stopped: false, name: "", hidden: 0, ignored: 0 };
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
  return { recordings: count(/\.(bvh|amc)(\.gz)?$/i) + archives, labels: count(/\.csv$/i), amc: count(/\.amc(\.gz)?$/i), archives };
}

/** The name of a data set that files suggest. @param {FoundFile[]} files */
function nameOf(files) {
  const parts = files[0].path.split("/");
  if (parts.length > 1) return parts[0];
  return files.length > 1 ? "Recordings" : parts[0].replace(/\.(bvh|amc|asf|csv|zip)(\.gz)?$/i, "");
}

/**
 * Take files into a batch: those that may be sent into its queue, others with the reason why not. Gives the new ones.
 * Of several files, those that no recording could be are ignored.
 * @param {Batch} mine
 * @param {FoundFile[]} files
 * @param {Limits} limits
 */
export function takeFiles(mine, files, { fileBytes, totalBytes, files: most, suffixes }) {
  if (!mine.name) mine.name = nameOf(files);
  /** @type {Upload[]} */
  const taken = [];
  for (const { file, path: given } of files) {
    const path = freePath(mine, file, given);
    if (!path) continue;
    const lower = path.toLowerCase();
    const readable = suffixes.some((suffix) => lower.endsWith(suffix));
    if (!readable && files.length > 1 && !/\.(bvh|amc|asf|zip)/i.test(lower)) {
      mine.ignored += 1;
      continue;
    }
    /** @type {Upload} */
    const item = { file, path, sent: 0, state: "waiting", message: "", row: null };
    mine.items.push(item);
    taken.push(item);
    if (!readable) refuse(item, "not a kind of file we read");
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
