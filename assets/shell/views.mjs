/* Pages with several views: a segmented control per key, one panel of each key shown. */
import { changeView, clientside, register } from "../shared/dash.mjs";

const keyOf = (id) => id.split("-").pop();

register("views", {
  // The control was used: the choice goes into the store; the first choice is the default and leaves the address.
  chosen(value, view) {
    const key = keyOf(clientside.callback_context.inputs_list[0].id);
    const first = document.querySelector(`.view-panel[data-key="${key}"]`);
    const wanted = first && first.dataset.value === value ? "" : value;
    if (value && ((view || {})[key] || "") !== wanted) changeView({ [key]: wanted });
    return clientside.no_update;
  },
  // The store changed, or the page came: control and panels follow.
  show(view, id) {
    const key = keyOf(id);
    const panels = [...document.querySelectorAll(`.view-panel[data-key="${key}"]`)];
    if (!panels.length) return clientside.no_update;
    const wanted = (view || {})[key];
    const shown = panels.find((panel) => panel.dataset.value === wanted) || panels[0];
    for (const panel of panels) panel.classList.toggle("hidden", panel !== shown);
    return shown.dataset.value;
  },
});
