/* The motif graph: selection, faint rare edges, zoom and pictures. Classes change, elements never do. */
import { clientside, register, setStore } from "../shared/dash.mjs";
import { context2d, find } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import { save } from "../shared/save.mjs";
import { ahead } from "../stage/ahead.mjs";
import * as ids from "./ids.mjs";
import { walking } from "./walk_state.mjs";
/** @import { Cytoscape, GraphEvent } from "./types.d.ts" */
/** @import { Selection } from "../shared/types.d.ts" */

const ID = ids.MOTIF_GRAPH;
/** Pixels that an arrow key moves the graph. @type {Record<string, [number, number]>} */
const STEPS = { ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60] };

// Cytoscape is a property of its container, set a little after the component is drawn
/** @param {number} [tries] */
export async function graphReady(tries = 100) {
  for (let i = 0; i < tries; i++) {
    const box = /** @type {any} */ (find(ID));
    const cy = /** @type {Cytoscape | undefined} */ (box?._cyreg?.cy);
    if (cy && !cy.destroyed() && cy.elements().length) return cy;
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
  return null;
}

/** @param {Cytoscape} cy @param {Selection | null} selection */
function chosenIn(cy, selection) {
  if (!selection) return cy.collection();
  if (selection.motif !== undefined) return cy.getElementById("m" + selection.motif);
  if (selection.motifs !== undefined) return cy.nodes().filter((node) => selection.motifs?.split("-").includes(String(node.data("motif"))) ?? false);
  if (selection.edge !== undefined) return cy.getElementById("e" + selection.edge);
  return cy.collection();
}

/** @param {Cytoscape} element */
const selectionOf = (element) => (element.isNode() ? { motif: element.data("motif") } : { edge: element.data("edge") });

const watched = new WeakSet();
/** Which motifs a graph showed last. @type {WeakMap<Cytoscape, string>} */
const parts = new WeakMap();
/** The motif or the succession that was chosen last. @type {number | string | undefined} */
let sought;
/** @param {Cytoscape} cy */
function watch(cy) {
  if (watched.has(cy)) return;
  watched.add(cy);
  const box = cy.container();
  box.tabIndex = 0;
  box.setAttribute("role", "application");
  box.setAttribute("aria-label", "Motif graph. Arrow keys move, plus and minus zoom, 0 shows all. The table below lists the same motifs.");
  box.addEventListener("keydown", (event) => {
    const step = STEPS[event.key];
    if (step) cy.panBy({ x: step[0], y: step[1] });
    else if (event.key === "+" || event.key === "=") zoom(cy, 1.25);
    else if (event.key === "-") zoom(cy, 0.8);
    else if (event.key === "0") cy.fit(undefined, 26);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  let touched = false;
  cy.on("pan zoom", (event) => { if (event.target === cy && cy._byHand) touched = true; });
  box.addEventListener("wheel", () => { touched = true; }, { passive: true });
  box.addEventListener("pointerdown", () => { touched = true; });
  new ResizeObserver(() => {
    if (cy.destroyed()) return;
    cy.resize();
    if (!touched) cy.fit(undefined, 26);
  }).observe(box);
  cy.on("mouseover", "node, edge", (event) => {
    box.style.cursor = "pointer";
    event.target.addClass("pointed");
    readable(cy);
    ahead.prepare(selectionOf(event.target), true);
  });
  cy.on("mouseout", "node, edge", (event) => {
    box.style.cursor = "";
    event.target.removeClass("pointed");
    readable(cy);
    ahead.leave();
  });
  // "tapend" comes before "tap", and so before Dash's callbacks
  /** @type {GraphEvent | null} */
  let pressed = null;
  cy.on("tapstart", "node, edge", (event) => {
    pressed = event;
    ahead.prepare(selectionOf(event.target));
  });
  cy.on("tapend", "node, edge", (event) => {
    const [a, b] = [pressed?.renderedPosition, event.renderedPosition];
    const tapped = pressed?.target === event.target && a !== undefined && Math.hypot(a.x - b.x, a.y - b.y) < 6;
    if (tapped && !walking.on) ahead.play(selectionOf(event.target));
  });
  cy.on("zoom", () => cy.elements(".readable").data("letters", letters(cy)));
  const looks = new MutationObserver(() => (cy.destroyed() ? looks.disconnect() : rasterise(cy)));
  looks.observe(document.documentElement, { attributes: true, attributeFilter: ["data-mantine-color-scheme"] });
  cy.autoungrabify(true);
  cy.fit(undefined, 26);
}

// Far away most labels are too small to read; those that matter now keep their size on the screen.
/** @param {Cytoscape} cy */
const letters = (cy) => Math.max(12, 11 / cy.zoom());
/** @param {Cytoscape} cy */
function readable(cy) {
  const wanted = cy.elements(".pointed, .chosen, edge.near");
  cy.batch(() => {
    cy.elements(".readable").difference(wanted).removeClass("readable");
    wanted.data("letters", letters(cy)).addClass("readable");
  });
}

// A canvas redraws vector images at every repaint (a quarter of a second for a hundred), so they are made bitmaps once.
// Their addresses are short, because Cytoscape reads the whole address of an image with each change of a style.
const SHARPNESS = 3;
const drawn = new Map();
/** @param {string} address @param {number} width @param {number} height */
function pixels(address, width, height) {
  const key = `${width}x${height} ${address}`;
  if (!drawn.has(key)) {
    drawn.set(key, new Promise((resolve) => {
      const image = new Image();
      image.onload = () => {
        const scale = SHARPNESS * Math.min(width / image.width, height / image.height);
        const canvas = document.createElement("canvas");
        canvas.width = Math.max(1, Math.round(image.width * scale));
        canvas.height = Math.max(1, Math.round(image.height * scale));
        context2d(canvas).drawImage(image, 0, 0, canvas.width, canvas.height);
        canvas.toBlob((blob) => resolve(blob ? URL.createObjectURL(blob) : address));
      };
      image.onerror = () => resolve(address);
      image.src = address;
    }));
  }
  return drawn.get(key);
}

/** @param {Cytoscape} cy */
async function rasterise(cy) {
  const field = "icon_" + (document.documentElement.dataset.mantineColorScheme || "light");
  const vector = cy.nodes().filter((node) => (node.data(field) || "").startsWith("data:image/svg"));
  const images = await Promise.all(vector.map((node) => pixels(node.data(field), node.data("width"), node.data("height"))));
  if (cy.destroyed()) return;
  cy.batch(() => vector.forEach((node, i) => { node.data(field, images[i]); }));
  cy.container().dataset.drawn = "yes"; // for shell/first_picture.mjs
}

/** @param {Cytoscape} cy @param {number} factor */
function zoom(cy, factor) {
  const box = cy.container().getBoundingClientRect();
  cy.zoom({ level: cy.zoom() * factor, renderedPosition: { x: box.width / 2, y: box.height / 2 } });
}

let taps = 0;
register("graph", {
  /** @param {{ motif: number } | null} node @param {{ edge: string } | null} edge */
  async tapped(node, edge) {
    if (walking.on) return clientside.no_update;
    const which = clientside.callback_context.triggered.map((item) => item.prop_id).join(" ");
    const mine = ++taps;
    await ahead.settled(); // the Stage first, then everything else that depends on the selection
    if (mine !== taps) return clientside.no_update;
    if (which.includes("tapNodeData") && node) setStore(SELECTION, { motif: node.motif });
    else if (which.includes("tapEdgeData") && edge) setStore(SELECTION, { edge: edge.edge });
    return clientside.no_update;
  },
  /** @param {Selection | null} selection @param {number | null} threshold */
  async mark(selection, threshold) {
    const cy = await graphReady();
    if (!cy) return clientside.no_update;
    watch(cy);
    const part = cy.nodes().map((node) => node.id()).join(" ");
    if (parts.get(cy) !== part && parts.has(cy)) cy.fit(undefined, 26); // other motifs of a large graph are drawn now
    parts.set(cy, part);
    const choice = selection?.motif ?? selection?.edge;
    if (choice !== undefined && choice !== sought && chosenIn(cy, selection).empty() && find(ids.GRAPH_PART)) {
      setStore(ids.GRAPH_SOUGHT, { at: Date.now() }); // it is in a part that is not drawn
    }
    sought = choice;
    rasterise(cy);
    const label = find(ids.EDGE_FILTER_LABEL);
    if (label) label.textContent = `Transitions seen at least ${threshold || 1}×`;
    cy.batch(() => {
      cy.elements().removeClass("chosen near faded rare");
      const chosen = chosenIn(cy, selection);
      const near = chosen.length === 1 && chosen.isNode() ? chosen.closedNeighborhood() : chosen.union(chosen.connectedNodes());
      cy.edges().forEach((edge) => {
        if (edge.data("count") < (threshold || 1) && !near.contains(edge)) edge.addClass("rare");
      });
      if (chosen.nonempty()) {
        cy.elements().difference(near).addClass("faded");
        near.difference(chosen).addClass("near");
        chosen.addClass("chosen");
      }
      readable(cy);
    });
    return clientside.no_update;
  },
  /** @param {{ graph?: string } | null} request @param {string | null} dataset */
  async tool(request, dataset) {
    const cy = request && (await graphReady(10));
    if (!cy) return clientside.no_update;
    const background = getComputedStyle(document.documentElement).getPropertyValue("--surface").trim();
    const name = (dataset || "motifs") + "-graph";
    if (request.graph === "in") zoom(cy, 1.3);
    else if (request.graph === "out") zoom(cy, 1 / 1.3);
    else if (request.graph === "fit") cy.animate({ fit: { padding: 26 }, duration: 200 });
    else if (request.graph === "png") save(await cy.png({ output: "blob-promise", full: true, scale: 2, bg: background, maxWidth: 8000, maxHeight: 8000 }), name + ".png");
    return clientside.no_update;
  },
});
