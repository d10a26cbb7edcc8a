/* A point of a sweep, in a chart or in the table, opens its result on the Motifs page. */
import { clientside, openPage, register, setStore } from "../shared/dash.mjs";
import { closest, need } from "../shared/dom.mjs";
import { cellRenderers, reactElement } from "../shared/grid.mjs";
import { PAGE, SELECTION, VIEW_CHANGE } from "../shared/ids.mjs";
import { changeOfSettings } from "../shared/settings.mjs";
import * as ids from "./ids.mjs";

// Like dcc.Link: another page without loading the app again. The link's settings become those that are shown.
/** @param {string} address */
function open(address) {
  const { pathname, searchParams } = new URL(address, location.origin);
  setStore(SELECTION, {});
  openPage(pathname, { [VIEW_CHANGE]: changeOfSettings("motifs", Object.fromEntries(searchParams)) });
  need(PAGE).scrollTo(0, 0);
}

/** @param {MouseEvent} event */
const plain = (event) => !(event.button || event.metaKey || event.ctrlKey || event.shiftKey || event.altKey);

cellRenderers.PointLink = (props) =>
  props.data ? reactElement("a", { className: "text-link point-link", href: props.data.href, tabIndex: -1 }, props.value) : null;

document.addEventListener("click", (event) => {
  const link = closest(event, "a.point-link");
  if (!link || !plain(event)) return;
  event.preventDefault();
  event.stopPropagation();
  open(/** @type {any} */ (link).href);
}, true);

// In the table Enter opens the row's result, whichever cell has the focus.
document.addEventListener("keydown", (event) => {
  const row = event.key === "Enter" && closest(event, `#${ids.SWEEP_TABLE} .ag-row`);
  const link = row && row.querySelector("a.point-link");
  if (!link) return;
  event.preventDefault();
  event.stopPropagation();
  open(/** @type {any} */ (link).href);
}, true);

register("sweeps", {
  /** @param {{ points?: { customdata?: any }[] } | null} click */
  open(click) {
    const address = click && click.points && click.points[0] && click.points[0].customdata;
    if (typeof address === "string" && address) open(address);
    return clientside.no_update;
  },
});
