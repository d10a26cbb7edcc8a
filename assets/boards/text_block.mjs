// Text, written in Markdown.
import { element } from "../shared/dom.mjs";
/** @import { Draw } from "../blocks/types.d.ts" */

/** @type {Draw<{ html: string }>} */
export function drawText(place, { html }) {
  const text = element("div", "block-text");
  text.innerHTML = html; // made from Markdown by the server, which lets no HTML through
  place.append(text);
  return {};
}
