// The blocks of boards and reports, by kind: what each draws of its content.
import { element } from "../shared/dom.mjs";
import { drawGraph } from "./graph.mjs";
import { drawMap } from "./map.mjs";
import { drawMatrix } from "./matrix.mjs";
import { drawMotifs, drawNumbers, drawOverview, drawText } from "./plain.mjs";
import { drawSweep } from "./sweep.mjs";
import { drawActions, drawTracks } from "./tracks.mjs";
/** @import { Context, Draw, Drawn } from "./types.d.ts" */

/** @type {Record<string, Draw>} */
const DRAW = {
  overview: drawOverview, tracks: drawTracks, graph: drawGraph, motifs: drawMotifs, matrix: drawMatrix, numbers: drawNumbers,
  map: drawMap, actions: drawActions, sweep: drawSweep, text: drawText,
};

/**
 * Draw a block into a place; a kind that this version does not know says so.
 * @param {HTMLElement} place
 * @param {string} kind
 * @param {any} content
 * @param {Context} context
 * @returns {Drawn}
 */
export function drawBlock(place, kind, content, context) {
  place.classList.add("block", `block-of-${kind}`);
  if (DRAW[kind]) return DRAW[kind](place, content, context);
  place.append(element("p", "muted", `This version cannot show a block of the kind “${kind}”.`));
  return {};
}
