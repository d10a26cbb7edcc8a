/* A walk in the graph: its boxes and arrows, the box that plays, dead ends, and further links as dashed arrows. */
import { graphReady } from "./graph.mjs";
import { walking } from "./walk_state.mjs";
/** @import { Cytoscape, Walk, WalkSteps } from "./types.d.ts" */

const watched = new WeakSet();

/** @param {Cytoscape} cy @param {WalkSteps} steps */
function watch(cy, steps) {
  if (watched.has(cy)) return;
  watched.add(cy);
  // the same box may be clicked twice in a row: it is then twice on the path
  cy.on("tap", "node", (event) => walking.on && steps.add(event.target.data("motif")));
  cy.on("tap", "edge", (event) => {
    if (!walking.on) return;
    steps.follow(event.target.source().data("motif"), event.target.target().data("motif"));
  });
}

/** @param {[number, number]} link */
const further = ([source, target]) => ({
  group: "edges", classes: "further", selectable: false,
  data: { id: `w${source}-${target}`, source: `m${source}`, target: `m${target}`, width: 2.5 },
});

let turn = 0;
/**
 * Mark the walk in the graph, or nothing where no walk is made.
 * @param {Partial<Walk>} data
 * @param {boolean} on
 * @param {WalkSteps} steps
 */
export async function markWalk(data, on, steps) {
  const mine = ++turn;
  const cy = await graphReady(on ? 100 : 1);
  if (!cy || mine !== turn) return;
  watch(cy, steps);
  const links = new Set((data.path || []).slice(1).map((motif, i) => `${data.path?.[i]}-${motif}`));
  const wanted = on ? (data.further || []).filter(([a, b]) => cy.getElementById(`m${a}`).nonempty() && cy.getElementById(`m${b}`).nonempty()) : [];
  const kept = new Set(wanted.map(([a, b]) => `w${a}-${b}`));
  cy.batch(() => {
    cy.edges(".further").filter((edge) => !kept.has(edge.id())).remove();
    cy.add(wanted.filter(([a, b]) => cy.getElementById(`w${a}-${b}`).empty()).map(further));
    cy.nodes().forEach((node) => {
      node.toggleClass("walked", on && (data.path || []).includes(node.data("motif")));
      node.toggleClass("dead-end", on && (data.dead || []).includes(node.data("motif")));
    });
    cy.edges().forEach((edge) => { edge.toggleClass("walked", on && links.has(edge.id().slice(1))); });
    if (!on) cy.nodes(".lit").removeClass("lit");
  });
}

/**
 * The box whose motif plays; none where it is null.
 * @param {number | null} motif
 */
export async function lightMotif(motif) {
  const cy = await graphReady(1);
  if (!cy) return;
  cy.batch(() => {
    cy.nodes(".lit").removeClass("lit");
    if (motif !== null) cy.getElementById(`m${motif}`).addClass("lit");
  });
}
