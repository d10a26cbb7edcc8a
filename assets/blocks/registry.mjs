// What draws blocks, by kind. Pages offer theirs in report/blocks.mjs; boards and reports ask here.
import { element } from "../shared/dom.mjs";
/** @import { Context, Draw, Drawn } from "./types.d.ts" */

/** @type {Record<string, Draw>} */
const offered = {};

/** @param {Record<string, Draw>} blocks */
export const offer = (blocks) => Object.assign(offered, blocks);

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
  if (Object.hasOwn(offered, kind)) return offered[kind](place, content, context);
  place.append(element("p", "muted", `This version cannot show a block of the kind “${kind}”.`));
  return {};
}
