// Properties of clips: shown, read from a table or from names with a preview, set by hand for clips that were chosen.
import { clientside, register } from "../shared/dash.mjs";
import { button, iconButton, openWindow, say } from "../shared/dialogs.mjs";
import { closest, element, withAttributes } from "../shared/dom.mjs";
import { ask } from "../shared/server.mjs";
import { plural } from "../shared/words.mjs";
/** @import { ClipsOf } from "./ids.mjs" */
/** @import { ClipProperties, ColumnOfClips } from "./types.d.ts" */

const SETTLED = 300; // milliseconds after the last letter until a preview is asked for
const SHOWN = 6; // values of a column that are named
const KINDS = ["text", "number", "date"];

document.addEventListener("click", (event) => {
  const { properties } = closest(event, "[data-properties]")?.dataset ?? {};
  if (properties) new Dialog(properties, []).open();
});

register("properties", {
  /** @param {ClipsOf | null} chosen */
  open(chosen) {
    if (chosen) new Dialog(chosen.dataset, chosen.clips ?? []).open();
    return clientside.no_update;
  },
});

class Dialog {
  /** @param {string} dataset @param {string[]} clips those that were chosen */
  constructor(dataset, clips) {
    this.dataset = dataset;
    this.clips = clips;
    this.path = `properties/${encodeURIComponent(dataset)}`;
    this.columns = element("div", "properties-columns");
    this.preview = element("div", "properties-preview");
    this.preview.setAttribute("aria-live", "polite");
    this.waiting = 0;
    this.first = "";
  }

  async open() {
    const file = withAttributes(element("a", "boards-button", "Save as CSV"), { href: `/api/${this.path}/csv`, download: "" });
    const ways = element("div", "properties-ways for-editors");
    this.dialog = openWindow(`Properties of clips of ${this.dataset}`, this.columns, ways, this.preview,
      element("div", "boards-actions", file, button("Close", () => this.dialog?.close())));
    try {
      this.show(await ask(this.path));
    } catch (error) {
      this.refuse(error);
      return;
    }
    ways.append(this.byHand(), this.fromNames(), this.fromTable());
    /** @type {HTMLElement | null} */ (ways.querySelector("input, textarea"))?.focus();
  }

  /** @param {ClipProperties} known */
  show({ columns, clips, first }) {
    this.first = first;
    const rows = columns.map((column) => this.row(column, clips));
    const heads = ["Property", "Kind", "Values", "Missing", ""].map((head) => element("th", "", head));
    this.columns.replaceChildren(rows.length
      ? element("table", "properties-table", element("thead", "", element("tr", "", ...heads)), element("tbody", "", ...rows))
      : element("p", "muted", `Nothing is known yet of its ${plural(clips, "clip")}: who moves, in which condition, in which session. Groups are compared and boards narrowed by such properties.`));
  }

  /** @param {ColumnOfClips} column @param {number} clips */
  row({ name, kind, values, distinct, missing }, clips) {
    const picker = withAttributes(element("select", "boards-select for-editors", ...KINDS.map((one) => withAttributes(element("option", "", one), { value: one }))), { "aria-label": `Kind of ${name}` });
    picker.value = kind;
    picker.addEventListener("change", () => this.change({ action: "kind", column: name, kind: picker.value }));
    const some = values.slice(0, SHOWN).map(([value, count]) => `${value} (${count})`).join(", ");
    const remove = iconButton("trash", `Remove ${name}`, () => this.change({ action: "remove", column: name }));
    remove.classList.add("for-editors");
    return element("tr", "", element("td", "", name), element("td", "", picker), element("td", "", distinct > SHOWN ? `${some} and ${distinct - SHOWN} more` : some),
      element("td", "number", missing ? `${missing} of ${clips}` : "none"), element("td", "", remove));
  }

  byHand() {
    const [name, value] = [this.input("Property", "subject"), this.input("Value", "Ana")];
    const body = () => ({ action: "set", column: name.value, value: value.value, clips: this.clips });
    const form = this.way(`For ${this.clips.length === 1 ? this.clips[0] : plural(this.clips.length, "chosen clip")}`,
      this.clips.length ? "An empty value takes it away." : "Choose clips in the table of the Library by their boxes, then “Properties”.", [name, value], body);
    if (!this.clips.length) for (const control of form.querySelectorAll("input, button")) control.toggleAttribute("disabled", true);
    return form;
  }

  fromNames() {
    const pattern = this.input("Pattern of the names", "{subject}_{condition}_{take}");
    return this.way("From names of clips", `Names in braces become properties, * is anything. The first name is ${this.first}.`, [pattern], () => ({ action: "names", pattern: pattern.value }));
  }

  fromTable() {
    const table = withAttributes(element("textarea"), { rows: 4, placeholder: "clip,subject,condition", "aria-label": "Table as CSV" });
    const file = withAttributes(element("input"), { type: "file", accept: ".csv,.tsv,.txt", "aria-label": "CSV file" });
    file.addEventListener("change", async () => {
      table.value = (await file.files?.[0]?.text()) ?? "";
      table.dispatchEvent(new Event("input", { bubbles: true }));
    });
    return this.way("From a table", "CSV whose column “clip” names the clips; choose a file or paste it.", [file, table], () => ({ action: "table", table: table.value }));
  }

  /** @param {string} name @param {string} hint */
  input(name, hint) {
    return withAttributes(element("input"), { placeholder: hint, "aria-label": name });
  }

  /**
   * A way to set properties: what it would do is shown while one types.
   * @param {string} title @param {string} hint @param {HTMLElement[]} controls @param {() => Record<string, any>} body
   */
  way(title, hint, controls, body) {
    const form = element("form", "boards-form properties-way", element("h3", "", title), element("small", "muted", hint), ...controls, element("button", "boards-button primary", "Keep"));
    form.addEventListener("input", () => {
      clearTimeout(this.waiting);
      this.waiting = window.setTimeout(() => this.change({ ...body(), preview: true }), SETTLED);
    });
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      clearTimeout(this.waiting);
      this.change(body());
    });
    return form;
  }

  /** @param {Record<string, any>} body */
  async change(body) {
    try {
      const made = await ask(this.path, body);
      this.show(made);
      this.tell(made, body.preview);
      if (body.preview) return;
      say("Properties kept.", async () => {
        this.show(await ask(this.path, { action: "restore", version: made.before }));
        this.preview.replaceChildren();
      });
    } catch (error) {
      this.refuse(error);
    }
  }

  /** @param {ClipProperties} made @param {boolean} preview */
  tell({ remarks = [], rows = [] }, preview) {
    const names = rows.length ? Object.keys(rows[0]) : [];
    this.preview.replaceChildren(
      element("p", preview ? "properties-draft" : "muted", preview ? "Preview: nothing is kept yet." : "Kept."),
      ...remarks.map((words) => element("p", "muted", words)),
      rows.length ? element("table", "properties-table", element("thead", "", element("tr", "", ...names.map((name) => element("th", "", name)))),
        element("tbody", "", ...rows.map((row) => element("tr", "", ...names.map((name) => element("td", "", row[name] ?? "")))))) : "",
    );
  }

  /** @param {unknown} error */
  refuse(error) {
    const problem = element("p", "form-problem", error instanceof Error ? error.message : String(error));
    problem.setAttribute("role", "alert");
    this.preview.replaceChildren(problem);
  }
}
