// Adding and changing blocks: their forms, and what happens where two people change the same one.
import { element } from "../shared/dom.mjs";
import { ask, Refused } from "../shared/server.mjs";
import { button, openForm, openWindow } from "../shared/dialogs.mjs";
import { kindOf, known, shown } from "./state.mjs";
/** @import { Field } from "../shared/types.d.ts" */
/** @import { BlockData, Board, Kind, Settings } from "./types.d.ts" */

/** @typedef {(board: Board) => void} Take takes over what the server gave back */

/** The settings of the view that a kind of block depends on. @param {Kind | undefined} kind */
const viewOf = (kind) => Object.fromEntries(Object.entries(shown.view).filter(([key, text]) => text && kind?.keys.includes(key)));

/** Choose the kind of a new block. @param {Board} board @param {number} row @param {Take} take */
export function addBlock(board, row, take) {
  const kinds = known.listing?.kinds ?? [];
  const dialog = openWindow("Add a block", element("div", "boards-kinds", ...kinds.map((kind) => button(kind.label, () => {
    dialog.close();
    fillIn(board, kind, row, take);
  }))), element("p", "muted", "A block takes over the settings of the page as they are now; a Stage loop plays what is selected."));
}

/** @param {Board} board @param {Kind} kind @param {number} row @param {Take} take */
function fillIn(board, kind, row, take) {
  /** @type {Settings} */
  const settings = { title: kind.kind === "text" || kind.kind === "numbers" ? "" : kind.label, view: viewOf(kind), options: {} };
  if (kind.kind === "stage") settings.options = { selection: JSON.stringify(shown.selection) };
  const [w, h] = kind.size;
  /** @param {Settings} filled */
  const add = async (filled) => take(await ask(`boards/${board.id}`, { action: "add", block: { kind: kind.kind, x: 0, y: row, w, h, settings: filled } }));
  if (!["text", "view"].includes(kind.kind)) return add(settings);
  return openForm(`Add: ${kind.label}`, fieldsOf(board, kind.kind, settings), "Add", (values) => add(settingsOf(settings, values)));
}

/** @param {Board} board @param {BlockData} block @param {Take} take */
export function editBlock(board, block, take) {
  openForm("Change the block", fieldsOf(board, block.kind, block.settings), "Save", async (values) => {
    const settings = settingsOf(block.settings, values);
    try {
      take(await saveBlock(board, block, settings));
    } catch (error) {
      if (!(error instanceof Refused) || !error.answer.conflict) throw error;
      tellConflict(board, block, settings, error.answer, take);
    }
  });
}

/** @param {Board} board @param {BlockData} block @param {Settings} settings @param {number} [version] */
const saveBlock = (board, { id, kind, version: own }, settings, version = own) =>
  ask(`boards/${board.id}`, { action: "change", version, block: { id, kind, settings } });

/**
 * Both versions side by side: one of them is chosen, neither is lost without a word.
 * @param {Board} board
 * @param {BlockData} block
 * @param {Settings} mine
 * @param {{ error: string, theirs: BlockData | null, author: string }} conflict
 * @param {Take} take
 */
export function tellConflict(board, block, mine, { error, theirs, author }, take) {
  /** @param {string} title @param {string} text @param {HTMLElement} choice */
  const column = (title, text, choice) => element("div", "boards-version", element("h3", "", title), element("pre", "", text), choice);
  const dialog = openWindow("Someone was faster", element("p", "", error), element("div", "boards-versions",
    column("Yours", wordsOf(mine), theirs
      ? button("Save mine over it", async () => {
        take(await saveBlock(board, block, mine, theirs.version));
        dialog.close();
      }, "primary")
      : button("Add mine again", async () => {
        take(await ask(`boards/${board.id}`, { action: "add", block: { ...block, settings: mine } }));
        dialog.close();
      }, "primary")),
    column(theirs ? `Of ${author || "someone else"}` : "Removed", theirs ? wordsOf(theirs.settings) : "The block is no longer on the board.", button("Keep theirs", () => dialog.close())),
  ));
  dialog.classList.add("boards-conflict");
}

/** A block's settings as people read them. @param {Settings} settings */
const wordsOf = ({ title, note, dataset, view, options }) => [
  ["Title", title], ["Note", note], ["Dataset", dataset],
  ...Object.entries(view ?? {}), ...Object.entries(options ?? {}),
].filter(([, value]) => value).map(([name, value]) => `${name}: ${value}`).join("\n");

/** @param {Board} board @param {string} kind @param {Settings} settings @returns {Field[]} */
function fieldsOf(board, kind, { title = "", dataset = "", view = {}, options = {} }) {
  /** @type {Field[]} */
  const fields = [{ name: "title", label: "Title", value: title }];
  if (kind === "text") return [...fields, { name: "option-markdown", label: "Text", kind: "text", value: options.markdown ?? "", hint: "Markdown: ## heading, **bold**, - list, [words](address)" }];
  if (kind === "view") {
    return [...fields, { name: "option-view", label: "Saved view", kind: "choice", value: options.view ?? "", choices: (known.listing?.views ?? []).map(({ id, title: name }) => [id, name]) }];
  }
  fields.push({ name: "dataset", label: "Dataset", kind: "choice", value: dataset, choices: [["", "that of the board"], ...board.datasets.map((/** @type {string} */ name) => /** @type {[string, string]} */ ([name, name]))] });
  if (kindOf(kind)?.keys.length) fields.push({ name: "view", label: "Settings", value: Object.entries(view).map(([key, text]) => `${key}=${text}`).join("; "), hint: `As in links, such as kappa=200; gamma=2. Known: ${kindOf(kind)?.keys.join(", ")}` });
  for (const [name, hint] of Object.entries(kindOf(kind)?.options ?? {})) {
    if (kind === "stage") fields.push({ name: `option-${name}`, label: "What plays", kind: "choice", value: options[name] ?? "", choices: playable(options[name]) });
    else fields.push({ name: `option-${name}`, label: name[0].toUpperCase() + name.slice(1), value: options[name] ?? "", hint });
  }
  return fields;
}

/** What it plays, or what is selected now. @param {string | undefined} own @returns {[string, string][]} */
function playable(own) {
  const now = JSON.stringify(shown.selection);
  /** @type {[string, string][]} */
  const choices = own ? [[own, `as it is: ${own}`]] : [];
  return now === "{}" || now === own ? choices : [...choices, [now, `what is selected now: ${now}`]];
}

/** @param {Settings} before @param {Record<string, string>} values @returns {Settings} */
function settingsOf(before, values) {
  const options = Object.entries(values).filter(([name]) => name.startsWith("option-")).map(([name, value]) => [name.slice(7), value]);
  const settings = { ...before, title: values.title ?? before.title ?? "", options: { ...before.options, ...Object.fromEntries(options) } };
  if (values.dataset !== undefined) settings.dataset = values.dataset;
  if (values.view !== undefined) settings.view = Object.fromEntries(values.view.split(";").map((pair) => pair.split("=").map((part) => part.trim())).filter(([key, text]) => key && text));
  delete settings.pinned; // what it shows now is what it was made with from now on
  return settings;
}
