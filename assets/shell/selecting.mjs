/* Buttons and table rows that put a value into a store. */
import { changeView, clientside, register, setStore } from "../shared/dash.mjs";
import { allWithin, closest, find } from "../shared/dom.mjs";
import { cellRenderers, gridApi, gridFunctions, reactElement } from "../shared/grid.mjs";
import { SELECTION, URL as PAGE_URL } from "../shared/ids.mjs";
import { ahead } from "../stage/ahead.mjs";
/** @import { Selection } from "../shared/types.d.ts" */

/** @param {string} store @param {any} value @param {string | boolean | undefined} stamp */
const put = (store, value, stamp) => {
  if (store === SELECTION) ahead.play(value);
  setStore(store, stamp ? { ...value, at: Date.now() } : value);
};

document.addEventListener("click", (event) => {
  const button = closest(event, "[data-store]");
  if (!button || button.disabled) return;
  put(button.dataset.store ?? "", JSON.parse(button.dataset.value ?? "{}"), button.dataset.stamp);
  if (button.dataset.page) clientside.set_props(PAGE_URL, { pathname: button.dataset.page, search: "" });
});

// tables: a click or Enter on a row selects what the row stands for
gridFunctions.chooseRow = (params) => {
  const at = params.event && params.event.type === "click" && params.event.target;
  if (at && at.closest && at.closest(".choice-cell")) return; // its box was meant
  if (params.data && params.data.view) changeView(params.data.view);
  if (params.data && params.data.selection) put(SELECTION, params.data.selection, false);
};
gridFunctions.leaveTable = () => false; // the browser goes to what comes after the table
gridFunctions.chooseRowByKey = (params) => {
  if (params.event && params.event.key === "Enter") gridFunctions.chooseRow(params);
};

cellRenderers.Filmstrip = (props) =>
  props.value
    ? reactElement("img", { className: "filmstrip", src: props.value, alt: "", loading: "lazy", decoding: "async", draggable: false })
    : null;
/** @type {Record<string, string>} */
const MARKS = { ok: "check", warning: "warning", error: "error" };
cellRenderers.Verdict = (props) =>
  props.value
    ? reactElement("span", { className: "verdict verdict-" + props.value, title: (props.data && props.data.messages) || undefined },
        reactElement("span", { className: "icon icon-" + MARKS[props.value], style: { width: 14, height: 14 }, "aria-hidden": "true" }),
        props.value === "error" ? "not read" : props.value)
    : null;

// The row of what is selected is marked in every table, wherever it was selected. Rows come and go as one scrolls, so
// a class rule marks new ones; those that are there are marked directly (redrawing them would lose the focus).
const KEYS = ["clip", "motif", "edge"];
/** @param {any} a @param {any} b */
const same = (a, b) => Boolean(a && b) && KEYS.some((key) => key in a) && KEYS.every((key) => String(a[key] ?? "") === String(b[key] ?? ""));
/** @type {Selection | null} */
let chosen = null;
/** @param {Selection | null | undefined} own */
const among = (own) => own?.motif !== undefined && Boolean(chosen?.motifs?.split("-").includes(String(own.motif)));
gridFunctions.isChosen = (params) => same(params.data && params.data.selection, chosen) || among(params.data && params.data.selection);

register("tables", {
  /** @param {Selection | null} selection @param {unknown} rows @param {string} id */
  async mark(selection, rows, id) {
    chosen = selection;
    const api = await gridApi(id);
    const box = find(id);
    if (!api || !box) return clientside.no_update; // it has gone with its page
    api.forEachNode((/** @type {any} */ node) => { if (gridFunctions.isChosen(node)) api.ensureNodeVisible(node); });
    for (const row of allWithin(box, ".ag-row")) {
      const node = api.getRowNode(row.getAttribute("row-id"));
      row.classList.toggle("row-chosen", Boolean(node) && gridFunctions.isChosen(node));
    }
    return clientside.no_update;
  },
});
