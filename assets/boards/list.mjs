// The page without an open board: boards, templates to begin with, and saved views.
import { take } from "./ahead.mjs";
import { changeView, openPage } from "../shared/dash.mjs";
import { element, svgElement, withAttributes } from "../shared/dom.mjs";
import { ask } from "../shared/server.mjs";
import { ago, button, iconButton, openForm, openMenu, openWindow, say } from "../shared/dialogs.mjs";
import { renewPicture } from "./picture.mjs";
import { openReport } from "./reports.mjs";
import { known, shown } from "./state.mjs";
/** @import { BoardEntry, Change, Listing, Shape, ViewEntry } from "./types.d.ts" */

const COLOURS = { graph: 0, motifs: 0, matrix: 0, map: 1, overview: 2, tracks: 2, actions: 3, sweep: 4, hits: 5, stage: 6 };

/** Ask for everything that can be listed. @returns {Promise<Listing>} */
export async function refresh() {
  known.listing = await take("boards");
  return /** @type {Listing} */ (known.listing);
}

/** @param {HTMLElement} place */
export async function showList(place) {
  const listing = await refresh();
  const search = withAttributes(element("input", "boards-search"), { type: "search", placeholder: "Search boards and views", "aria-label": "Search boards and views" });
  const [boards, views] = [element("div", "boards-cards"), element("div", "boards-cards")];
  const again = async () => {
    await refresh();
    fill();
  };
  const fill = () => {
    const { boards: all, views: saved } = /** @type {Listing} */ (known.listing);
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    /** @param {(string | undefined)[]} texts */
    const found = (texts) => words.every((word) => texts.join(" ").toLowerCase().includes(word));
    const [some, more] = [all.filter((board) => found([board.title, board.note, board.author, board.dataset])), saved.filter((one) => found([one.title, one.note, one.author, ...one.tags]))];
    boards.replaceChildren(...some.map((board) => boardCard(board, again)), ...(some.length ? [] : [all.length ? empty("No board is called so.") : beginning()]));
    views.replaceChildren(...more.map((one) => viewCard(one, again)), ...(more.length ? [] : [empty(saved.length ? "No view is called so." : "Save a view with “Save view” at the top, on any page.")]));
  };
  search.addEventListener("input", fill);
  fill();
  const { damaged } = listing;
  place.replaceChildren(
    element("div", "boards-bar", element("h2", "", "Boards"), search, shown.dataset ? button(`Report of ${shown.dataset}`, () => openReport(shown.dataset, null)) : null, button("New board", openGallery, "primary for-editors")),
    ...(damaged.length ? [element("p", "boards-warning", `${damaged.length} saved ${damaged.length > 1 ? "things are" : "thing is"} damaged and not listed: ${damaged.join(", ")}.`)] : []),
    boards,
    element("h2", "", "Saved views"),
    views,
  );
}

/** Where there is no board yet: what one is, and what to begin with. */
const beginning = () => element("section", "boards-beginning",
  element("h3", "", "Look at motion together"),
  element("p", "muted", "A board shows graphs, maps, tables and motion side by side. Everyone who has its link open sees what the others change."),
  element("div", "boards-cards for-editors", ...templateCards(() => undefined)));

/** @param {string} words */
const empty = (words) => element("p", "muted", words);

/** @param {BoardEntry} board @param {() => Promise<void>} again */
function boardCard(board, again) {
  const open = button("", () => changeView({ board: board.id, screen: "" }), "boards-open");
  open.append(drawShape(board.shape), element("strong", "ellipsis", board.title));
  const about = [board.dataset, board.author, ago(board.updated)].filter(Boolean).join(" · ");
  const more = iconButton("dots", `More for ${board.title}`, () => openMenu(more, [
    ["Rename", () => renameBoard(board, again)],
    ["Duplicate", () => change(board.id, { action: "duplicate" }).then(again)],
    ["History", () => showHistory(`boards/${board.id}`, board.title, (version) => change(board.id, { action: "restore", version }).then(again))],
    ["Delete", () => deleteBoard(board, again)],
  ]));
  more.classList.add("for-editors");
  return element("article", "boards-card", open, element("div", "boards-card-foot", element("span", "muted ellipsis", about), more));
}

/** @param {string} id @param {Record<string, any>} body */
const change = (id, body) => ask(`boards/${id}`, body).catch((error) => say(error.message));

/** @param {{ id: string, title: string, note: string }} board @param {() => unknown} again */
export const renameBoard = (board, again) => openForm("Rename the board", [
  { name: "title", label: "Title", value: board.title }, { name: "note", label: "Note", kind: "text", value: board.note },
], "Save", (values) => ask(`boards/${board.id}`, { action: "rename", ...values }).then(again));

/** @param {{ id: string, title: string }} board @param {() => unknown} again */
export async function deleteBoard(board, again) {
  if (!(await change(board.id, { action: "delete" }))) return;
  again();
  say(`“${board.title}” was deleted.`, () => change(board.id, { action: "undelete" }).then(again));
}

/** @param {ViewEntry} saved @param {() => Promise<void>} again */
function viewCard(saved, again) {
  const picture = withAttributes(element("img", "boards-picture"), { src: saved.picture, alt: "", loading: "lazy" });
  picture.addEventListener("error", () => picture.replaceWith(element("div", "boards-picture boards-no-picture", new URL(saved.address, location.href).pathname.slice(1))));
  const open = button("", () => {
    followLink(saved.address);
    renewPicture(saved.id, saved.address);
  }, "boards-open");
  open.append(picture, element("strong", "ellipsis", saved.title));
  if (saved.note) open.title = saved.note;
  const about = [saved.author, ago(saved.updated), ...saved.tags.map((tag) => `#${tag}`)].filter(Boolean).join(" · ");
  /** @param {Record<string, any>} body */
  const act = (body) => ask(`views/${saved.id}`, body).then(again, (error) => say(error.message));
  const more = iconButton("dots", `More for ${saved.title}`, () => openMenu(more, [
    ["Edit", () => openForm("Edit the saved view", viewFields(saved), "Save", (values) => ask("views", { id: saved.id, version: saved.version, address: saved.address, ...values, tags: tagsOf(values.tags) }).then(again))],
    ["Versions", () => showHistory(`views/${saved.id}`, saved.title, (version) => act({ action: "restore", version }))],
    ["Delete", async () => {
      await act({ action: "delete" });
      say(`“${saved.title}” was deleted.`, () => act({ action: "undelete" }));
    }],
  ]));
  more.classList.add("for-editors");
  return element("article", "boards-card", open, element("div", "boards-card-foot", element("span", "muted ellipsis", about), more));
}

/** The fields of a saved view. @param {Partial<ViewEntry>} saved @returns {import("../shared/types.d.ts").Field[]} */
export const viewFields = (saved) => [
  { name: "title", label: "Title", value: saved.title ?? "" },
  { name: "note", label: "Note", kind: "text", value: saved.note ?? "" },
  { name: "tags", label: "Tags", value: (saved.tags ?? []).join(", "), hint: "separated by commas" },
];

/** @param {string} text */
export const tagsOf = (text) => text.split(",").map((tag) => tag.trim()).filter(Boolean);

/** Open a link of the app as a click on the navigation would. @param {string} address */
export const followLink = (address) => openPage(address);

/**
 * Who saved what when; any version can come back.
 * @param {string} path
 * @param {string} title
 * @param {(version: number) => unknown} restore
 */
export async function showHistory(path, title, restore) {
  const { history } = await ask(`${path}/history`);
  const dialog = openWindow(`History of ${title}`, element("ol", "boards-history", ...history.map((/** @type {Change} */ entry, /** @type {number} */ k) => element("li", "",
    element("span", "", `Version ${entry.version}: ${entry.what}`),
    element("span", "muted", [entry.author, ago(entry.saved)].filter(Boolean).join(", ")),
    k ? button("Restore", () => {
      dialog.close();
      restore(entry.version);
    }) : element("span", "muted", "present"),
  ))));
}

/** Boards to begin with. */
export function openGallery() {
  const dialog = openWindow("New board", element("div", "boards-cards", ...templateCards(() => dialog.close())));
}

/** Templates as cards; a click asks for a title and makes a board. @param {() => void} chosen called first */
function templateCards(chosen) {
  const { templates } = /** @type {Listing} */ (known.listing);
  return templates.map((template) => {
    const card = button("", () => {
      chosen();
      openForm(`New board: ${template.title}`, [{ name: "title", label: "Title", value: template.name === "empty" ? "" : `${shown.dataset}: ${template.title.toLowerCase()}` }], "Make it", async ({ title }) => {
        const board = await ask("boards", { template: template.name, title, dataset: shown.dataset });
        changeView({ board: board.id, screen: "" });
      });
    }, "boards-open boards-card");
    card.append(drawShape(template.shape), element("strong", "", template.title), element("span", "muted", template.words));
    return card;
  });
}

/** A board as its blocks lie. @param {Shape} shape */
function drawShape(shape) {
  const height = Math.max(6, ...shape.map(([, y, , h]) => y + h));
  const svg = svgElement("svg", { class: "boards-shape", viewBox: `0 0 12 ${height}`, preserveAspectRatio: "none", "aria-hidden": "true" });
  for (const [x, y, w, h, kind] of shape) {
    svg.append(svgElement("rect", { x: x + 0.1, y: y + 0.15, width: w - 0.2, height: h - 0.3, rx: 0.15, class: `boards-shade-${COLOURS[/** @type {keyof typeof COLOURS} */ (kind)] ?? 7}` }));
  }
  return svg;
}
