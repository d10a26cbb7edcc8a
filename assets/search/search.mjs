/* The Search page: what its parts share, and the one place where the store "search-found" is drawn. */
import { clientside, register } from "../shared/dash.mjs";
import { drawBody } from "./body.mjs";
import { drawHits, playHits } from "./hits.mjs";
import { drawOptions } from "./options.mjs";
import { drawSources } from "./sources.mjs";
import { changeSearch, escapeName, now, remember } from "./state.mjs";

register("search", {
  draw(found, view, clips, motifs, scheme, presets, body, engines, key, selection) {
    if (!document.getElementById("search-sources") || !body) return clientside.no_update;
    Object.assign(now, { found, view: view || {}, clips, motifs: motifs || [], scheme, presets, body, engines, key, selection: selection || {} });
    const page = document.querySelector(".search-page");
    page.dataset.look = now.view.look || "search";
    page.classList.toggle("without-dataset", !clips);
    const fits = found && clips && found.asked && found.asked.dataset === clips.dataset;
    if (!fits) now.found = null;
    drawSources();
    drawBody();
    drawOptions();
    drawHits();
    playHits();
    return clientside.no_update;
  },
});

// "More like this", wherever it stands: data-similar holds {clip, start, end} and, where it is another, the dataset
document.addEventListener("click", (event) => {
  const button = event.target.closest && event.target.closest("[data-similar]");
  if (!button || button.disabled) return;
  const { clip, start, end, dataset } = JSON.parse(button.dataset.similar);
  const query = [escapeName(clip), `${start}-${end}`, ...(dataset ? [escapeName(dataset)] : [])].join(":");
  remember();
  changeSearch({ query, look: "" });
  if (!location.pathname.endsWith("/search")) clientside.set_props("url", { pathname: "/search", search: "" });
  else document.querySelector(".page").scrollTo({ top: 0, behavior: "smooth" });
});
