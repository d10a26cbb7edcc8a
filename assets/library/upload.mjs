/* Uploading: files and whole folders, dropped or chosen, sent by PUT with progress; a few at a time. */
import { clientside, register, setStore } from "../shared/dash.mjs";
import { childrenOf, closest, find, need } from "../shared/dom.mjs";
import { leftOut, freshBatch, kinds, refuse, sizeInWords, takeFiles } from "./batch.mjs";
import * as ids from "./ids.mjs";
/** @import { Batch, FoundFile, Upload } from "./types.d.ts" */

const HEADERS = { "X-Motionscape": "upload" };
const AT_ONCE = 3;
const SHOWN = 400; // rows; beyond these only problems get a row
/** @type {Batch | null} */
let batch = null;

const limits = () => {
  const data = need(ids.DROP_ZONE).dataset;
  return {
    fileBytes: Number(data.fileBytes), totalBytes: Number(data.totalBytes), files: Number(data.files),
    suffixes: (data.suffixes ?? "").split(" "),
  };
};

/* ---- gathering files, also from folders ---- */
/** @param {DataTransfer} transfer */
async function gather(transfer) {
  const entries = [...transfer.items].filter((item) => item.kind === "file").map((item) => item.webkitGetAsEntry && item.webkitGetAsEntry());
  if (!entries.some(Boolean)) return [...transfer.files].map((file) => ({ file, path: file.name }));
  /** @type {FoundFile[]} */
  const files = [];
  for (const entry of entries) if (entry) await walk(entry, "", files);
  return files;
}
/** @param {any} entry @param {string} folder @param {FoundFile[]} files */
async function walk(entry, folder, files) {
  if (files.length > 20000) return;
  if (entry.isFile) {
    const file = await new Promise((resolve) => entry.file(resolve, () => resolve(null)));
    if (file) files.push({ file, path: folder + entry.name });
    return;
  }
  const reader = entry.createReader();
  for (;;) {
    const some = await new Promise((resolve) => reader.readEntries(resolve, () => resolve([])));
    if (!some.length) return;
    for (const child of some) await walk(child, folder + entry.name + "/", files);
  }
}

/* ---- sending ---- */
/** @param {FoundFile[]} files */
async function add(files) {
  if (!files.length) return;
  if (!batch || batch.stopped) batch = freshBatch();
  const mine = batch;
  for (const item of takeFiles(mine, files, limits())) draw(mine, item);
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

/** @param {Batch} mine */
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
    if (request.status === 200) {
      item.state = "ok"; item.sent = item.file.size; mine.sent += 1;
      try { item.recording = JSON.parse(request.responseText).recording; } catch { /* no JSON: its name alone counts */ }
    }
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
/** @param {Batch} mine @param {Upload} item */
function draw(mine, item) {
  const list = find(ids.UPLOAD_LIST);
  if (!list || mine !== batch) return;
  if (!item.row) {
    if (list.childElementCount >= SHOWN && item.state !== "error") { return; }
    item.row = document.createElement("li");
    item.row.innerHTML = '<span class="upload-mark"></span><span class="upload-name ellipsis"></span><span class="upload-size number"></span><span class="upload-note"></span>';
    item.row.children[1].textContent = item.path;
    childrenOf(item.row)[1].title = item.path;
    item.row.children[2].textContent = sizeInWords(item.file.size);
    list.append(item.row);
  }
  item.row.className = "upload-" + item.state;
  const percent = item.file.size ? Math.round((100 * item.sent) / item.file.size) : 100;
  item.row.style.setProperty("--sent", (item.state === "sending" ? percent : 0) + "%");
  item.row.children[3].textContent = { waiting: "waiting", sending: percent + " %", ok: "received", error: item.message }[item.state];
}
/** @param {Batch} mine */
function summary(mine) {
  const node = find(ids.UPLOAD_SUMMARY);
  if (!node || mine !== batch) return;
  const sent = mine.items.reduce((sum, item) => sum + (item.state === "error" ? 0 : item.sent), 0);
  const bad = mine.items.filter((item) => item.state === "error").length;
  const busy = mine.active + mine.queue.length > 0;
  const sentences = [];
  if (mine.items.length) sentences.push(`${mine.sent} of ${mine.items.length - bad} files received, ${sizeInWords(sent)}`);
  if (bad) sentences.push(`${bad} left out`);
  const ignored = leftOut(mine);
  if (ignored) sentences.push(ignored);
  node.textContent = sentences.join("; ");
  const bar = find(ids.UPLOAD_BAR);
  if (bar) bar.style.width = (mine.bytes ? Math.min(100, (100 * sent) / mine.bytes) : 0) + "%";
  need(ids.UPLOAD_PROGRESS).classList.toggle("hidden", !busy);
}
/** @param {Batch} mine */
function tell(mine) {
  summary(mine);
  const done = mine.active + mine.queue.length === 0;
  setStore(ids.UPLOAD, { token: mine.token, received: mine.sent, done, name: mine.name, total: mine.items.length, ...kinds(mine) });
}
/** @param {boolean} discard */
function reset(discard) {
  if (batch) {
    batch.stopped = true;
    for (const item of batch.items) if (item.state === "sending") item.request?.abort();
    if (discard && batch.token) fetch("/api/uploads/" + batch.token, { method: "DELETE", headers: HEADERS }).catch(() => {});
  }
  batch = null;
  const list = find(ids.UPLOAD_LIST);
  if (list) list.replaceChildren();
  const node = find(ids.UPLOAD_SUMMARY);
  if (node) node.textContent = "";
}

/* ---- listeners, on the document because the elements come and go ---- */
/** @param {DragEvent} event */
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
  if (!find(ids.DROP_ZONE)) return;
  const card = closest(event, ".dataset-card");
  const files = event.dataTransfer ? await gather(event.dataTransfer) : [];
  if (!find(ids.UPLOAD_LIST) || !need(ids.UPLOAD_LIST).offsetParent) {
    setStore(ids.UPLOAD_INTO, { dataset: card?.dataset.dataset ?? "", at: Date.now() });
  }
  whenShown(() => add(files));
});
document.addEventListener("click", (event) => {
  const button = closest(event, "[data-chooses]");
  if (!button) return;
  const chooser = document.createElement("input");
  chooser.type = "file";
  chooser.multiple = true;
  chooser.webkitdirectory = button.dataset.chooses === "folder";
  chooser.onchange = () => add([...(chooser.files ?? [])].map((file) => ({ file, path: file.webkitRelativePath || file.name })));
  chooser.click();
});
/** @param {() => void} then @param {number} [tries] */
function whenShown(then, tries = 60) {
  if (find(ids.UPLOAD_LIST)) then();
  else if (tries) setTimeout(() => whenShown(then, tries - 1), 50);
}

register("upload", {
  // What is typed meanwhile stays, and nothing comes between the letters of who types.
  /** @param {string | null} suggested @param {string | null} typed */
  name: (suggested, typed) =>
    suggested && document.activeElement?.id === ids.UPLOAD_NAME ? clientside.no_update : suggested && (typed || suggested),
  // The dialog was closed: what was not imported is thrown away. After an import the files belong to the job.
  /** @param {boolean} opened @param {string | null} imported */
  closed(opened, imported) {
    if (opened) return clientside.no_update;
    reset(!(batch && imported && imported === batch.token));
    return { token: null, received: 0, done: true, name: "", total: 0 };
  },
});
