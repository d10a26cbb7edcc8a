/* Names people gave: on the boxes of the graph; and the search over names, tags, notes and labels. */
import { clientside, register } from "../shared/dash.mjs";
import { gridApi } from "../shared/grid.mjs";
import { graphReady } from "./graph.mjs";
import * as ids from "./ids.mjs";

const LONGEST = 26;

/** @param {string} text */
const short = (text) => (text.length > LONGEST ? text.slice(0, LONGEST - 1) + "…" : text);

register("names", {
  /** @param {Record<string, string[]> | null} names */
  async draw(names) {
    const cy = await graphReady();
    if (!cy) return clientside.no_update;
    cy.batch(() => cy.nodes("[motif >= 0]").forEach((node) => {
      if (node.data("plain") === undefined) node.data("plain", node.data("label"));
      const [name] = (names || {})[node.data("motif")] || [];
      const label = name ? `${short(name)} · ${node.data("plain").split(" · ").pop()}` : node.data("plain");
      if (node.data("label") !== label) node.data("label", label);
    }));
    return clientside.no_update;
  },
  // Rows that do not match leave the table, their boxes fade in the graph.
  /** @param {string | null} text @param {Record<string, any>[] | null} rows */
  async search(text, rows) {
    const words = (text || "").toLowerCase().split(/\s+/).filter(Boolean);
    const api = await gridApi(ids.MOTIF_TABLE);
    if (api) api.setGridOption("quickFilterText", text || "");
    const cy = await graphReady(3);
    if (!cy) return clientside.no_update;
    /** @param {Record<string, any>} row */
    const fits = (row) => {
      const all = ["id", "name", "tags", "note", "label"].map((field) => row[field] ?? "").join(" ").toLowerCase();
      return words.every((word) => all.includes(word));
    };
    const matching = new Set((rows || []).filter(fits).map((row) => "m" + row.id));
    cy.batch(() => cy.nodes("[motif >= 0]").forEach((node) => { node.toggleClass("unmatched", words.length > 0 && !matching.has(node.id())); }));
    return clientside.no_update;
  },
});
