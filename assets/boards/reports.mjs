// A report as a file: its size is said before it is saved.
import { closest, element } from "../shared/dom.mjs";
import { percent } from "../shared/words.mjs";
import { ask } from "../shared/server.mjs";
import { button, openWindow } from "../shared/dialogs.mjs";

const POLL = 500; // milliseconds between two questions how far it is

/** @typedef {{ key: string, ready: boolean, words: string, fraction: number, error: string, size: number, left_out: string[], motion: string }} Progress */

/**
 * Ask which form a report should have, and write it.
 * @param {string} dataset
 * @param {{ id: string, title: string } | null} board
 */
export function openReport(dataset, board) {
  const place = element("div", "boards-form");
  const dialog = openWindow(board ? `Report of ${board.title}` : `Report of ${dataset}`, element("p", "muted",
    "One file that opens without Motionscape and without a network. Its figures play, its graph and map can be explored."), place);
  /** @param {string} form */
  const begin = (form) => write(dialog, place, dataset, board?.id ?? "", form);
  place.append(element("div", "boards-actions", button("As PDF", () => begin("pdf")), button("As HTML", () => begin("html"), "primary")));
}

// the menu of a dataset in the Library
document.addEventListener("click", (event) => {
  const { report } = closest(event, "[data-report]")?.dataset ?? {};
  if (report) openReport(report, null);
});

/** @param {HTMLDialogElement} dialog @param {HTMLElement} place @param {string} dataset @param {string} board @param {string} form */
async function write(dialog, place, dataset, board, form) {
  const address = `report/${encodeURIComponent(dataset)}`;
  let again = "&again=yes";
  while (dialog.open) {
    /** @type {Progress} */
    const state = await ask(`${address}?form=${form}&board=${board}${again}`).catch((error) => ({ error: error.message }));
    again = "";
    if (state.error) {
      place.replaceChildren(element("p", "form-problem", state.error), element("div", "boards-actions", button("Close", () => dialog.close())));
      return;
    }
    if (state.ready) {
      const link = element("a", "boards-button primary", `Save ${(state.size / 1e6).toFixed(1)} MB`);
      link.href = `/api/${address}/${state.key}`;
      link.download = "";
      place.replaceChildren(element("p", "", state.motion), ...state.left_out.map((words) => element("p", "muted", `Left out: ${words}`)), element("div", "boards-actions", link));
      link.focus();
      return;
    }
    const bar = element("progress", "boards-progress");
    bar.value = state.fraction;
    place.replaceChildren(element("p", "", `Writing: ${state.words}, ${percent(state.fraction)}`), bar);
    await new Promise((resolve) => setTimeout(resolve, POLL));
  }
}
