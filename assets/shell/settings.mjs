/* The settings of a page among what it shows: other views change without the form being drawn anew. */
import { changeView, clientside, register } from "../shared/dash.mjs";
import { setSettingsKeys } from "../shared/settings.mjs";
/** @import { View } from "../shared/types.d.ts" */

/**
 * A setting that is a list of names: all of them, the usual ones, and its key in the view.
 * @typedef {{ names: string[], usual: string, key: string }} ListSetting
 */

/** @param {string} text @param {ListSetting} of */
const inOrder = (text, of) => of.names.filter((name) => text.split(",").includes(name));

register("settings", {
  // Those keys of the view that are settings of the page; its store is called PAGE-settings.
  /** @param {View | null} view @param {View | null} current @param {string} id @param {Record<string, string[]>} keys */
  pick(view, current, id, keys) {
    setSettingsKeys(keys);
    const mine = keys[id.slice(0, -"-settings".length)] || [];
    const own = Object.entries(view || {}).filter(([key]) => mine.includes(key)).sort();
    const next = Object.fromEntries(own);
    return current && JSON.stringify(next) === JSON.stringify(current) ? clientside.no_update : next;
  },
  // Chips for a setting that is a list: here and not on the server, whose answer to one click would undo the next.
  /** @param {Record<string, string> | null} view @param {ListSetting} of */
  list(view, of) {
    return inOrder((view || {})[of.key] || of.usual, of);
  },
  /** @param {string[] | null} chosen @param {Record<string, string> | null} view @param {ListSetting} of */
  listed(chosen, view, of) {
    const wanted = inOrder((chosen || []).join(","), of).join(",");
    const there = (view || {})[of.key] || of.usual;
    if (wanted && wanted !== there) changeView({ [of.key]: wanted === of.usual ? "" : wanted });
    return clientside.no_update;
  },
});
