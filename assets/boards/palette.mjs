// Ctrl+K: pages, boards and saved views by a few letters of their names.
import { allWithin, element, withAttributes } from "../shared/dom.mjs";
import { openWindow } from "../shared/dialogs.mjs";
import { followLink, refresh } from "./list.mjs";

const MOST = 12;

/** @typedef {{ name: string, about: string, address: string }} Place */

document.addEventListener("keydown", (event) => {
  if (event.key.toLowerCase() !== "k" || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey) return;
  if (document.querySelector("dialog[open]")) return;
  event.preventDefault();
  openPalette();
});

async function openPalette() {
  /** @type {Place[]} */
  let places = allWithin(document, ".nav-link").map((link) => ({ name: link.textContent ?? "", about: "page", address: link.getAttribute("href") ?? "/" }));
  const field = withAttributes(element("input"), { type: "search", placeholder: "A page, a board or a saved view", "aria-label": "Go to", autocomplete: "off" });
  const list = element("div", "boards-found");
  const dialog = openWindow("Go to", element("div", "boards-form", field, list));
  /** @param {string} address */
  const go = (address) => {
    dialog.close();
    followLink(address);
  };
  const show = () => {
    const found = matching(places, field.value).slice(0, MOST);
    list.replaceChildren(...found.map(({ name, about, address }) => {
      const entry = element("button", "boards-button", element("span", "ellipsis", name), element("span", "muted ellipsis", about));
      entry.type = "button";
      entry.addEventListener("click", () => go(address));
      return entry;
    }), found.length ? "" : element("p", "muted", "Nothing is called so."));
  };
  field.addEventListener("input", show);
  dialog.addEventListener("keydown", (event) => {
    const entries = allWithin(list, "button");
    const at = entries.indexOf(/** @type {any} */ (document.activeElement));
    if (event.key === "Enter" && at < 0) entries[0]?.click();
    else if (event.key === "ArrowDown") entries[Math.min(at + 1, entries.length - 1)]?.focus();
    else if (event.key === "ArrowUp") (at > 0 ? entries[at - 1] : field).focus();
    else return;
    event.preventDefault();
  });
  show();
  field.focus();
  const { boards, views } = await refresh().catch(() => ({ boards: [], views: [] }));
  places = [
    ...boards.map(({ id, title, note }) => ({ name: title, about: `board ${note}`.trim(), address: `/boards?board=${id}` })),
    ...views.map(({ title, note, tags, address }) => ({ name: title, about: ["view", note, ...tags.map((tag) => `#${tag}`)].filter(Boolean).join(" "), address })),
    ...places,
  ];
  show();
}

/**
 * The places in whose names or descriptions all words stand; where a name begins so, first.
 * @param {Place[]} places
 * @param {string} text
 */
export function matching(places, text) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const found = places.filter(({ name, about }) => words.every((word) => `${name} ${about}`.toLowerCase().includes(word)));
  const begins = (/** @type {Place} */ { name }) => Number(words.length > 0 && name.toLowerCase().startsWith(words[0]));
  return found.sort((a, b) => begins(b) - begins(a));
}
