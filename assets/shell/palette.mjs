// Ctrl+K: pages, datasets, clips, motifs, actions, settings, boards and saved views by a few letters of their names.
import { openPage } from "../shared/dash.mjs";
import { openWindow } from "../shared/dialogs.mjs";
import { allWithin, element, find, withAttributes } from "../shared/dom.mjs";
import { SCHEME_TOGGLE, SHARE } from "../shared/ids.mjs";
import { addPlaces, findPlaces } from "../shared/places.mjs";
import { ask } from "../shared/server.mjs";
import { showKeys } from "./keys.mjs";
/** @import { Place } from "../shared/places.mjs" */

const MOST = 14;
const PATIENCE = 5000; // milliseconds that a page may take until what is folded can be opened

addPlaces(async (text) => {
  const link = encodeURIComponent(location.pathname + location.search);
  return /** @type {any} */ (await ask(`places?link=${link}&text=${encodeURIComponent(text)}`)).places;
});
/** @param {string} name @param {string} about @param {() => void} act */
const command = (name, about, act) => ({ name, about, address: "", act });
addPlaces(() => [
  command("Keyboard shortcuts", "?", showKeys),
  command("Light or dark", "command", () => find(SCHEME_TOGGLE)?.click()),
  command("Copy a link to this view", "command", () => find(SHARE)?.click()),
]);

document.addEventListener("keydown", (event) => {
  if (event.key.toLowerCase() !== "k" || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey) return;
  if (document.querySelector("dialog[open]")) return;
  event.preventDefault();
  openPalette();
});

function openPalette() {
  const field = withAttributes(element("input"), { type: "search", placeholder: "A page, a clip, a motif, a setting, a board ...", "aria-label": "Go to", autocomplete: "off" });
  const list = withAttributes(element("div", "boards-found"), { role: "group", "aria-label": "Found" });
  const dialog = openWindow("Go to", element("div", "boards-form", field, list));
  /** @param {Place} place */
  const go = (place) => {
    dialog.close();
    if (place.act) place.act();
    else openPage(place.address);
    if (place.opens) unfold(place.opens);
  };
  let asked = 0;
  const show = async () => {
    const number = ++asked;
    const found = (await findPlaces(field.value)).slice(0, MOST);
    if (number !== asked) return; // what was typed since is on its way
    list.replaceChildren(...found.map((place) => {
      const entry = element("button", "boards-button", element("span", "ellipsis", place.name), element("span", "muted ellipsis", place.about));
      entry.type = "button";
      entry.addEventListener("click", () => go(place));
      return entry;
    }), found.length ? "" : element("p", "muted", "Nothing is called so."));
  };
  let shown = Promise.resolve();
  field.addEventListener("input", () => { shown = show(); });
  dialog.addEventListener("keydown", (event) => {
    const entries = allWithin(list, "button");
    const at = entries.indexOf(/** @type {any} */ (document.activeElement));
    if (event.key === "Escape") dialog.close(); // a search field would be emptied first
    else if (event.key === "Enter" && at < 0) shown.then(() => allWithin(list, "button")[0]?.click()); // of what was typed last
    else if (event.key === "ArrowDown") entries[Math.min(at + 1, entries.length - 1)]?.focus();
    else if (event.key === "ArrowUp") (at > 0 ? entries[at - 1] : field).focus();
    else return;
    event.preventDefault();
  });
  field.focus();
  shown = show();
}

/** Open a folded part of the page when it has come. @param {string} id @param {number} [begun] */
function unfold(id, begun = performance.now()) {
  const head = find(id)?.querySelector("button[aria-expanded]");
  if (head) {
    if (head.getAttribute("aria-expanded") === "false") /** @type {HTMLElement} */ (head).click();
  } else if (performance.now() - begun < PATIENCE) requestAnimationFrame(() => unfold(id, begun));
}
