/* An uploaded recording as the query: sent by PUT to the upload route, read by a job. */
import { setStore } from "../shared/dash.mjs";
import { allWithin, element, find, within } from "../shared/dom.mjs";
import * as ids from "./ids.mjs";

const HEADERS = { "X-Motionscape": "upload" };
const status = () => find(ids.SEARCH_UPLOAD_STATUS);
/** @type {XMLHttpRequest | null} */
let sending = null;
let turn = 0; // the request that sends, and how often files were chosen: the last choice counts

const suffixes = () => (within(document, ".search-choose").dataset.suffixes ?? "").split(",").filter((one) => one !== ".csv");

/** @param {string} words @param {string} [kind] */
function say(words, kind = "muted") {
  const box = document.querySelector(".search-sending") || element("span", "search-sending");
  box.className = `search-sending ${kind}`;
  box.textContent = words;
  if (!box.isConnected) status()?.before(box);
}
const quiet = () => allWithin(document, ".search-sending").forEach((one) => one.remove());

/** @param {string} token @param {File} file @param {(share: number) => void} tell */
function put(token, file, tell) {
  return /** @type {Promise<void>} */ (new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    sending = request;
    request.open("PUT", `/api/uploads/${token}/${encodeURIComponent(file.name)}`);
    request.setRequestHeader("X-Motionscape", "upload");
    request.setRequestHeader("Content-Type", "application/octet-stream");
    request.upload.onprogress = (event) => tell(event.loaded / Math.max(event.total, 1));
    request.onloadend = () => {
      if (request.status === 200) return resolve();
      let message = request.status ? "The server refused the file." : "The connection broke; try again.";
      try { message = JSON.parse(request.responseText).error || message; } catch { /* no JSON: keep our words */ }
      return reject(new Error(message));
    };
    request.send(file);
  }));
}

/**
 * Sends the files of one recording and asks for it to be read.
 * @param {File[]} files
 */
async function send(files) {
  if (!files.length) return;
  const mine = ++turn;
  if (sending) sending.abort();
  setStore(ids.SEARCH_UPLOAD, null);
  const wrong = files.find((file) => !suffixes().some((suffix) => file.name.toLowerCase().endsWith(suffix)));
  if (wrong) return say(`${wrong.name} is not a kind of file we read: choose BVH, or AMC together with its ASF.`, "error-text");
  let token = null;
  const still = () => { if (mine !== turn) throw new Error("Other files were chosen meanwhile."); };
  try {
    const answer = await fetch("/api/uploads", { method: "POST", headers: HEADERS }).catch(() => null);
    if (!answer?.ok) throw new Error("The server cannot take files now; try again in a moment.");
    ({ token } = await answer.json());
    for (const file of files) {
      still();
      await put(token, file, (share) => mine === turn && say(`Sending ${file.name}: ${Math.round(100 * share)} %`));
    }
    still();
    sending = null;
    quiet();
    const main = files.find((file) => !/\.asf(\.gz)?$/i.test(file.name)) || files[0];
    setStore(ids.SEARCH_UPLOAD, { token, name: main.name });
  } catch (error) {
    if (token) fetch(`/api/uploads/${token}`, { method: "DELETE", headers: HEADERS }).catch(() => {});
    if (mine !== turn) return;
    sending = null;
    say(error instanceof Error ? error.message : String(error), "error-text");
  }
}

export const chooseRecording = () => {
  const chooser = document.createElement("input");
  chooser.type = "file";
  chooser.multiple = true;
  chooser.accept = suffixes().join(",");
  chooser.onchange = () => send([...(chooser.files ?? [])]);
  chooser.click();
};

document.addEventListener("drop", (event) => {
  const files = event.dataTransfer && [...event.dataTransfer.files];
  if (!files || !files.length || !document.querySelector(".search-query")) return;
  event.preventDefault();
  send(files);
});
