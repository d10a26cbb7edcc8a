/* Stability of motifs: rings in the graph, a column of the table, a sentence for the chosen one. */
import { clientside, register } from "../shared/dash.mjs";
import { gridApi, gridFunctions } from "../shared/grid.mjs";
import { percent } from "../shared/words.mjs";
import { graphReady } from "./graph.mjs";

let shown = null; // {repeats, motifs: id -> {overall, kept, noise, seed, parameters}}

const of = (motif) => (shown ? shown.motifs[motif] : undefined);

function rate(node) {
  const found = of(node.data("motif"));
  if (!found) return;
  const label = `${node.data("label")} · ${percent(found.overall)}`;
  if (node.data("rated") !== label) node.data({ rated: label, stability: found.overall });
  node.addClass("rated");
}

// A box may get another label later: the name someone gives it.
const watched = new WeakSet();
function watch(cy) {
  if (watched.has(cy)) return;
  watched.add(cy);
  cy.on("data", "node[motif >= 0]", (event) => rate(event.target));
}

function words(motif) {
  const found = of(motif);
  if (!found) return "Choose a box to see how it fared.";
  const kinds = [["noise", "with noise"], ["seed", "from other seeds"], ["parameters", "with settings a step away"]];
  const each = kinds.filter(([kind]) => kind in found).map(([kind, name]) => `${percent(found[kind])} ${name}`);
  return `Motif ${motif}: ${percent(found.overall)}, kept in ${found.kept} of ${shown.repeats} repeats (${each.join(", ")}).`;
}

gridFunctions.stabilityOf = (params) => (params.data && of(params.data.id)?.overall) ?? null;

register("stability", {
  async draw(data, _elements, selection) {
    shown = data || null;
    const legend = document.getElementById("stability-legend");
    if (legend) legend.classList.toggle("hidden", !shown);
    const place = document.getElementById("stability-words");
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
  async list(data) {
    shown = data || null;
    const api = await gridApi("motif-table");
    if (!api) return clientside.no_update;
    api.setColumnsVisible(["stability"], Boolean(shown));
    api.refreshCells({ columns: ["stability"], force: true });
    return clientside.no_update;
  },
});
