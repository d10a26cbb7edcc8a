/* The settings of a page among what it shows: other views change without the form being drawn anew. */
import { changeView, clientside, register } from "../shared/dash.mjs";

const inOrder = (text, of) => of.names.filter((name) => text.split(",").includes(name));

register("settings", {
  // Those keys of the view that are settings of the page; its store is called PAGE-settings.
  pick(view, current, id) {
    const page = id.slice(0, -"settings".length);
    const own = Object.entries(view || {}).filter(([key]) => key.startsWith(page)).sort();
    const next = Object.fromEntries(own);
    return current && JSON.stringify(next) === JSON.stringify(current) ? clientside.no_update : next;
  },
  // Chips for a setting that is a list: here and not on the server, whose answer to one click would undo the next.
  list(view, of) {
    return inOrder((view || {})[of.key] || of.usual, of);
  },
  listed(chosen, view, of) {
    const wanted = inOrder((chosen || []).join(","), of).join(",");
    const there = (view || {})[of.key] || of.usual;
    if (wanted && wanted !== there) changeView({ [of.key]: wanted === of.usual ? "" : wanted });
    return clientside.no_update;
  },
});
