/* The Library's table of clips: names open the Clip page, boxes choose clips, a click elsewhere plays (shell/selecting.mjs). */
import { changeView, clientside, openPage, register, setStore } from "../shared/dash.mjs";
import { allWithin, closest } from "../shared/dom.mjs";
import { cellRenderers, gridApi, reactElement } from "../shared/grid.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { REPORT_TABLE } from "./ids.mjs";
/** @import { View, ViewKey } from "../shared/types.d.ts" */

/** @type {Record<string, string>} */
const WORDS = { ok: "read without remarks", warning: "warnings", error: "not read" };
/** @type {Record<string, string>} */
const ICONS = { ok: "check", warning: "warning", error: "error" };

cellRenderers.ClipLink = (props) =>
  props.value
    ? reactElement("a", { className: "clip-link ellipsis", href: props.data.href, tabIndex: -1, "data-clip": props.value, draggable: false }, props.value)
    : null;
cellRenderers.Mark = (props) =>
  props.value
    ? reactElement("span", { className: "verdict verdict-mark verdict-" + props.value, role: "img", "aria-label": WORDS[props.value], title: (props.data && props.data.messages) || WORDS[props.value] },
        reactElement("span", { className: "icon icon-" + ICONS[props.value], style: { width: 14, height: 14 }, "aria-hidden": "true" }))
    : null;

// Like dcc.Link: another page without loading the app again. What is shown there is the selection.
/** @param {string | undefined} clip */
function open(clip) {
  setStore(SELECTION, { clip });
  openPage("/clip");
}
document.addEventListener("click", (event) => {
  const link = closest(event, "a.clip-link");
  if (!link || event.button || event.metaKey || event.ctrlKey || event.shiftKey || event.altKey) return;
  event.preventDefault();
  event.stopPropagation();
  open(link.dataset.clip);
}, true);
document.addEventListener("keydown", (event) => {
  const cell = event.key === "Enter" && closest(event, ".ag-cell[col-id='clip']");
  const link = cell && allWithin(cell, "a.clip-link")[0];
  if (!link) return;
  event.preventDefault();
  event.stopPropagation();
  open(link.dataset.clip);
}, true);

// Which tab is open, and which files of the report are listed, stands in the store "view", and so in the link.
/** The first choices; they need no words in the link. @type {View} */
const USUAL = { tab: "clips", files: "all" };
/** What the store had the controls show last: that is no choice of a person. @type {View} */
let set = {};
register("library", {
  /** @param {string} tab @param {string} files @param {View | null} view */
  look(tab, files, view) {
    /** @type {View} */
    const change = {};
    for (const [key, value] of /** @type {[ViewKey, string][]} */ ([["tab", tab], ["files", files]])) {
      const wanted = value === USUAL[key] ? "" : value || "";
      if (value && value !== set[key] && (view?.[key] || "") !== wanted) change[key] = wanted;
    }
    set = {};
    if (Object.keys(change).length) changeView(change);
    return clientside.no_update;
  },
  /** @param {View | null} view @param {{ value: string }[] | null} choices */
  show(view, choices) {
    const wanted = { ...USUAL, ...view };
    const known = (choices || []).some((choice) => choice.value === wanted.files);
    set = { tab: wanted.tab === "report" ? "report" : "clips", files: known ? wanted.files : "all" };
    return [set.tab, set.files];
  },
  /** @param {string | null} shown @param {any[] | null} rows */
  filter(shown, rows) {
    if (!rows) { // they stay on the server, which is asked anew
      gridApi(REPORT_TABLE).then((api) => api?.purgeInfiniteCache?.());
      return clientside.no_update;
    }
    if (!shown || shown === "all") return rows || [];
    return (rows || []).filter((row) => shown === "added" ? row.added : row.verdict === shown);
  },
});
