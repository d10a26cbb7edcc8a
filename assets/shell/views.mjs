/* Pages with several views: a segmented control per key, one panel of each key shown. */
import { changeView, clientside, register } from "../shared/dash.mjs";
import { allWithin } from "../shared/dom.mjs";
/** @import { View, ViewKey } from "../shared/types.d.ts" */

/** The key of the link that a control sets: the last word of its id. @param {string} id */
const keyOf = (id) => /** @type {ViewKey} */ (id.split("-").pop());

register("views", {
  // The control was used: the choice goes into the store; the first choice is the default and leaves the address.
  /** @param {string | null} value @param {View | null} view */
  chosen(value, view) {
    const key = keyOf(clientside.callback_context.inputs_list[0].id);
    const first = allWithin(document, `.view-panel[data-key="${key}"]`)[0];
    const wanted = first && first.dataset.value === value ? "" : value;
    if (value && (view?.[key] || "") !== wanted) changeView({ [key]: wanted });
    return clientside.no_update;
  },
  // The store changed, or the page came: control and panels follow.
  /** @param {View | null} view @param {string} id */
  show(view, id) {
    const key = keyOf(id);
    const panels = allWithin(document, `.view-panel[data-key="${key}"]`);
    if (!panels.length) return clientside.no_update;
    const wanted = view?.[key];
    const shown = panels.find((panel) => panel.dataset.value === wanted) || panels[0];
    for (const panel of panels) panel.classList.toggle("hidden", panel !== shown);
    return shown.dataset.value;
  },
});
