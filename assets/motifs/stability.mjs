/* Stability of motifs: rings in the graph, a column of the table, a sentence for the chosen one. */
import { clientside, register } from "../shared/dash.mjs";
import { find } from "../shared/dom.mjs";
import { gridApi, gridFunctions } from "../shared/grid.mjs";
import { percent } from "../shared/words.mjs";
import { graphReady } from "./graph.mjs";
import * as ids from "./ids.mjs";
/** @import { Cytoscape, GraphElements, Stability } from "./types.d.ts" */
/** @import { Selection } from "../shared/types.d.ts" */

/** @type {Stability | null} */
let shown = null;

/** @param {number | string | undefined} motif */
const of = (motif) => shown?.motifs[motif ?? ""];

/** @param {GraphElements} node */
function rate(node) {
  const shares = of(node.data("motif"));
  if (!shares) return;
  const label = `${node.data("label")} · ${percent(shares.overall)}`;
  if (node.data("rated") !== label) node.data({ rated: label, stability: shares.overall });
  node.addClass("rated");
}

// A box may get another label later: the name someone gives it.
const watched = new WeakSet();
/** @param {Cytoscape} cy */
function watch(cy) {
  if (watched.has(cy)) return;
  watched.add(cy);
  cy.on("data", "node[motif >= 0]", (event) => rate(event.target));
}

/** @param {number | string | undefined} motif */
function words(motif) {
  const shares = of(motif);
  if (!shares) return "Choose a box to see how it fared.";
  /** @type {["noise" | "seed" | "parameters", string][]} */
  const kinds = [["noise", "with noise"], ["seed", "from other seeds"], ["parameters", "with settings a step away"]];
  const each = kinds.filter(([kind]) => kind in shares).map(([kind, name]) => `${percent(shares[kind] ?? 0)} ${name}`);
  return `Motif ${motif}: ${percent(shares.overall)}, kept in ${shares.kept} of ${shown?.repeats} repeats (${each.join(", ")}).`;
}

gridFunctions.stabilityOf = (params) => (params.data && of(params.data.id)?.overall) ?? null;

register("stability", {
  /** @param {Stability | null} data @param {unknown} _elements @param {Selection | null} selection */
  async draw(data, _elements, selection) {
    shown = data || null;
    const legend = find(ids.STABILITY_LEGEND);
    if (legend) legend.classList.toggle("hidden", !shown);
    const place = find(ids.STABILITY_WORDS);
    if (place && shown) place.textContent = words((selection || {}).motif);
    const cy = await graphReady();
    if (!cy) return clientside.no_update;
    watch(cy);
    cy.batch(() => {
      if (shown) cy.nodes("[motif >= 0]").forEach(rate);
      else cy.nodes(".rated").removeClass("rated");
    });
    return clientside.no_update;
  },
  /** @param {Stability | null} data */
  async list(data) {
    shown = data || null;
    const api = await gridApi(ids.MOTIF_TABLE);
    if (!api) return clientside.no_update;
    api.setColumnsVisible(["stability"], Boolean(shown));
    api.refreshCells({ columns: ["stability"], force: true });
    return clientside.no_update;
  },
});
