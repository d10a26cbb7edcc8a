/* Uploading: files and whole folders, dropped or chosen, sent by PUT with progress; a few at a time. */
import { clientside, register, setStore } from "../shared/dash.mjs";
import { find } from "../shared/dom.mjs";

const HEADERS = { "X-Motionscape": "upload" };
const AT_ONCE = 3;
const SHOWN = 400; // rows; beyond these only problems get a row
let batch = null;

const limits = () => {
  const data = find("drop-zone").dataset;
  return {
    fileBytes: Number(data.fileBytes), totalBytes: Number(data.totalBytes), files: Number(data.files),
    suffixes: data.suffixes.split(" "),
  };
};
const words = (bytes) => bytes >= 2 ** 30 ? (bytes / 2 ** 30).toFixed(1) + " GB"
  : bytes >= 1e5 ? (bytes / 2 ** 20).toFixed(1) + " MB" : Math.max(1, Math.round(bytes / 1024)) + " kB";

function freshBatch() {
  return { token: null, items: [], sent: 0, bytes: 0, active: 0, queue: [], stopped: false, name: "", hidden: 0 };
}

/* ---- gathering files, also from folders ---- */
async function gather(transfer) {
  const entries = [...transfer.items].filter((item) => item.kind === "file").map((item) => item.webkitGetAsEntry && item.webkitGetAsEntry());
  if (!entries.some(Boolean)) return [...transfer.files].map((file) => ({ file, path: file.name }));
  const found = [];
  for (const entry of entries) if (entry) await walk(entry, "", found);
  return found;
}
async function walk(entry, folder, found) {
  if (found.length > 20000) return;
  if (entry.isFile) {
    const file = await new Promise((resolve) => entry.file(resolve, () => resolve(null)));
    if (file) found.push({ file, path: folder + entry.name });
    return;
  }
  const reader = entry.createReader();
  for (;;) {
    const some = await new Promise((resolve) => reader.readEntries(resolve, () => resolve([])));
    if (!some.length) return;
    for (const child of some) await walk(child, folder + entry.name + "/", found);
  }
}

/* ---- sending ---- */
async function add(files) {
  if (!files.length) return;
  if (!batch || batch.stopped) batch = freshBatch();
  const mine = batch;
  const { fileBytes, totalBytes, files: most, suffixes } = limits();
  const first = files[0].path.split("/");
  if (!mine.name) mine.name = first.length > 1 ? first[0] : files.length > 1 ? "Recordings" : first[0].replace(/\.(bvh|amc|asf|csv|zip)(\.gz)?$/i, "");
  let ignored = 0;
  for (const { file, path: given } of files) {
    const path = freePath(mine, file, given);
    if (!path) continue; // the very same file a second time
    const lower = path.toLowerCase();
    if (!suffixes.some((suffix) => lower.endsWith(suffix))) {
      if (files.length > 1 && !/\.(bvh|amc|asf|zip)/i.test(lower)) { ignored += 1; continue; }
    }
    const item = { file, path, sent: 0, state: "waiting", message: "", row: null };
    mine.items.push(item);
    if (!suffixes.some((suffix) => lower.endsWith(suffix))) refuse(item, "not a kind of file we read");
    else if (file.size > fileBytes) refuse(item, "too large: " + words(file.size) + "; a file may have " + words(fileBytes));
    else if (mine.queue.length + mine.sent >= most) refuse(item, "too many files: " + most + " at most");
    else if (mine.bytes + file.size > totalBytes) refuse(item, "too much altogether: " + words(totalBytes) + " at most");
    else { mine.bytes += file.size; mine.queue.push(item); }
    draw(mine, item);
  }
  mine.ignored = (mine.ignored || 0) + ignored;
  tell(mine);
  if (!mine.token) {
    try {
      const answer = await fetch("/api/uploads", { method: "POST", headers: HEADERS });
      if (!answer.ok) throw new Error();
      mine.token = (await answer.json()).token;
    } catch {
      for (const item of mine.queue.splice(0)) { refuse(item, "the server cannot be reached"); draw(mine, item); }
      tell(mine);
      return;
    }
  }
  while (mine.active < AT_ONCE && mine.queue.length) next(mine);
  tell(mine);
}
// Files of one name from two places do not overwrite one another: the second lies in a folder of its own.
function freePath(mine, file, path) {
  for (let k = 1; ; k++) {
    const tried = k === 1 ? path : k + "/" + path;
    const there = mine.items.find((item) => item.path === tried && item.state !== "error");
    if (!there) return tried;
    if (there.file.size === file.size && there.file.lastModified === file.lastModified) return null;
  }
}
function refuse(item, message) { item.state = "error"; item.message = message; }

function next(mine) {
  const item = mine.queue.shift();
  if (!item || mine.stopped) return;
  mine.active += 1;
  item.state = "sending";
  const request = new XMLHttpRequest();
  item.request = request;
  request.open("PUT", "/api/uploads/" + mine.token + "/" + item.path.split("/").map(encodeURIComponent).join("/"));
  request.setRequestHeader("X-Motionscape", "upload");
  request.setRequestHeader("Content-Type", "application/octet-stream");
  request.upload.onprogress = (event) => { item.sent = event.loaded; draw(mine, item); summary(mine); };
  request.onloadend = () => {
    mine.active -= 1;
    if (request.status === 200) { item.state = "ok"; item.sent = item.file.size; mine.sent += 1; }
    else {
      let message = request.status ? "the server refused it" : "the connection broke";
      try { message = JSON.parse(request.responseText).error || message; } catch { /* no JSON: keep our words */ }
      refuse(item, message);
    }
    draw(mine, item);
    while (mine.active < AT_ONCE && mine.queue.length && !mine.stopped) next(mine);
    tell(mine);
  };
  request.send(item.file);
}

/* ---- showing ---- */
function draw(mine, item) {
  const list = find("upload-list");
  if (!list || mine !== batch) return;
  if (!item.row) {
    if (list.childElementCount >= SHOWN && item.state !== "error") { return; }
    item.row = document.createElement("li");
    item.row.innerHTML = '<span class="upload-mark"></span><span class="upload-name ellipsis"></span><span class="upload-size number"></span><span class="upload-note"></span>';
    item.row.children[1].textContent = item.path;
    item.row.children[1].title = item.path;
    item.row.children[2].textContent = words(item.file.size);
    list.append(item.row);
  }
  item.row.className = "upload-" + item.state;
  const percent = item.file.size ? Math.round((100 * item.sent) / item.file.size) : 100;
  item.row.style.setProperty("--sent", (item.state === "sending" ? percent : 0) + "%");
  item.row.children[3].textContent = { waiting: "waiting", sending: percent + " %", ok: "received", error: item.message }[item.state];
}
function summary(mine) {
  const node = find("upload-summary");
  if (!node || mine !== batch) return;
  const sent = mine.items.reduce((sum, item) => sum + (item.state === "error" ? 0 : item.sent), 0);
  const bad = mine.items.filter((item) => item.state === "error").length;
  const busy = mine.active + mine.queue.length > 0;
  const sentences = [];
  if (mine.items.length) sentences.push(`${mine.sent} of ${mine.items.length - bad} files received, ${words(sent)}`);
  if (bad) sentences.push(`${bad} left out`);
  if (mine.ignored) sentences.push(`${mine.ignored} other file${mine.ignored > 1 ? "s" : ""} ignored`);
  node.textContent = sentences.join("; ");
  const bar = find("upload-bar");
  if (bar) bar.style.width = (mine.bytes ? Math.min(100, (100 * sent) / mine.bytes) : 0) + "%";
  find("upload-progress").classList.toggle("hidden", !busy);
}
function tell(mine) {
  summary(mine);
  const done = mine.active + mine.queue.length === 0;
  setStore("upload", { token: mine.token, received: mine.sent, done, name: mine.name, total: mine.items.length, ...kinds(mine) });
}
/* what has come, by its names: the dialog asks only what matters for it */
function kinds(mine) {
  const count = (pattern) => mine.items.filter((item) => item.state !== "error" && pattern.test(item.path)).length;
  const archives = count(/\.zip$/i);
  return { recordings: count(/\.(bvh|amc)(\.gz)?$/i) + archives, labels: count(/\.csv$/i), amc: count(/\.amc(\.gz)?$/i), archives };
}
function reset(discard) {
  if (batch) {
    batch.stopped = true;
    for (const item of batch.items) if (item.state === "sending") item.request.abort();
    if (discard && batch.token) fetch("/api/uploads/" + batch.token, { method: "DELETE", headers: HEADERS }).catch(() => {});
  }
  batch = null;
  const list = find("upload-list");
  if (list) list.replaceChildren();
  const node = find("upload-summary");
  if (node) node.textContent = "";
}

/* ---- listening: the elements come and go, so listen on the document ---- */
const carriesFiles = (event) => event.dataTransfer && [...event.dataTransfer.types].includes("Files");
let depth = 0;
document.addEventListener("dragenter", (event) => {
  if (!carriesFiles(event)) return;
  depth += 1;
  document.documentElement.classList.add("dragging-files");
});
document.addEventListener("dragleave", () => {
  depth = Math.max(0, depth - 1);
  if (!depth) document.documentElement.classList.remove("dragging-files");
});
document.addEventListener("dragover", (event) => { if (carriesFiles(event)) event.preventDefault(); });
document.addEventListener("drop", async (event) => {
  depth = 0;
  document.documentElement.classList.remove("dragging-files");
  if (!carriesFiles(event)) return;
  event.preventDefault();
  if (!find("drop-zone")) return;
  const card = event.target.closest && event.target.closest(".dataset-card");
  const files = await gather(event.dataTransfer);
  if (!find("upload-list") || !find("upload-list").offsetParent) {
    setStore("upload-into", { dataset: card ? card.dataset.dataset : "", at: Date.now() });
  }
  whenShown(() => add(files));
});
document.addEventListener("click", (event) => {
  const button = event.target.closest && event.target.closest("[data-chooses]");
  if (!button) return;
  const chooser = document.createElement("input");
  chooser.type = "file";
  chooser.multiple = true;
  chooser.webkitdirectory = button.dataset.chooses === "folder";
  chooser.onchange = () => add([...chooser.files].map((file) => ({ file, path: file.webkitRelativePath || file.name })));
  chooser.click();
});
function whenShown(then, tries = 60) {
  if (find("upload-list")) then();
  else if (tries) setTimeout(() => whenShown(then, tries - 1), 50);
}

register("upload", {
  // What is typed meanwhile stays.
  name: (suggested, typed) => suggested && (typed || suggested),
  // The dialog was closed: what was not imported is thrown away. After an import the files belong to the job.
  closed(opened, imported) {
    if (opened) return clientside.no_update;
    reset(!(batch && imported && imported === batch.token));
    return { token: null, received: 0, done: true, name: "", total: 0 };
  },
});
