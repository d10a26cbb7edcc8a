/* The Search page: what its parts share, and the one place where the store "search-found" is drawn. */
import { clientside, register } from "../shared/dash.mjs";
import { closest, find, within } from "../shared/dom.mjs";
import { URL as PAGE_URL } from "../shared/ids.mjs";
import { drawBody } from "./body.mjs";
import { drawHits, playHits } from "./hits.mjs";
import * as ids from "./ids.mjs";
import { drawOptions } from "./options.mjs";
import { drawSources } from "./sources.mjs";
import { changeSearch, escapeName, now, remember } from "./state.mjs";
/** @import { Body, ClipList, Found, MotifQuery, Weights } from "./types.d.ts" */
/** @import { Selection, View } from "../shared/types.d.ts" */

register("search", {
  /**
   * @param {Found | null} found
   * @param {View | null} view
   * @param {ClipList | null} clips
   * @param {MotifQuery[] | null} motifs
   * @param {string} scheme
   * @param {Record<string, Weights>} presets
   * @param {Body | null} body
   * @param {any[]} engines
   * @param {any} key
   * @param {Selection | null} selection
   */
  draw(found, view, clips, motifs, scheme, presets, body, engines, key, selection) {
    if (!find(ids.SEARCH_SOURCES) || !body) return clientside.no_update;
    Object.assign(now, { found, view: view || {}, clips, motifs: motifs || [], scheme, presets, body, engines, key, selection: selection || {} });
    const page = within(document, ".search-page");
    page.dataset.look = now.view.look || "search";
    page.classList.toggle("without-dataset", !clips);
    const fits = found && clips && found.inputs && found.inputs.dataset === clips.dataset;
    if (!fits) now.found = /** @type {any} */ (null);
    drawSources();
    drawBody();
    drawOptions();
    drawHits();
    playHits();
    return clientside.no_update;
  },
});

// "More like this" on any page: data-similar holds {clip, start, end} and, where it is another, the dataset
document.addEventListener("click", (event) => {
  const button = closest(event, "[data-similar]");
  if (!button || button.disabled) return;
  const { clip, start, end, dataset } = JSON.parse(button.dataset.similar ?? "{}");
  const query = [escapeName(clip), `${start}-${end}`, ...(dataset ? [escapeName(dataset)] : [])].join(":");
  remember();
  changeSearch({ query, look: "" });
  if (!location.pathname.endsWith("/search")) clientside.set_props(PAGE_URL, { pathname: "/search", search: "" });
  else within(document, ".page").scrollTo({ top: 0, behavior: "smooth" });
});
