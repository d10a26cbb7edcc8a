// Blocks of the boards page itself: text, a Stage loop, a saved view.
import { Player } from "../blocks/player.mjs";
import { element, withAttributes } from "../shared/dom.mjs";
/** @import { Draw } from "../blocks/types.d.ts" */
/** @import { StageRequest } from "../stage/types.d.ts" */

/** @type {Draw<{ html: string }>} */
export function drawText(place, { html }) {
  const text = element("div", "block-text");
  text.innerHTML = html; // made from Markdown by the server, which lets no HTML through
  place.append(text);
  return {};
}

/** @type {Draw<{ request: StageRequest }>} */
export function drawStage(place, { request }, context) {
  const canvas = element("canvas", "block-canvas");
  canvas.tabIndex = 0;
  canvas.setAttribute("aria-label", `${request.title ?? "Motion"}: drag to turn, space to stop`);
  place.append(canvas);
  const player = new Player(canvas);
  player.layout = request.layout === "side" ? "side" : "overlay";
  context.figures(request.items, request).then((figures) => {
    if (figures.length) player.show(figures);
    else place.replaceChildren(element("p", "muted", "The motion that plays here is not there."));
  });
  return { recolour: () => player.recolour(), close: () => player.close() };
}

/** @type {Draw<{ title: string, note: string, tags: string[], address: string, author: string, picture: string }>} */
export function drawView(place, { title, note, tags, address, author, picture }, context) {
  const image = picture ? withAttributes(element("img", "block-view-picture"), { src: picture, alt: `Picture of ${title}` }) : null;
  const link = context.opens ? withAttributes(element("a", "text-link", title), { href: address }) : element("strong", "", title);
  place.append(element("div", "block-view", image, link, note && element("p", "", note), element("p", "muted", [author, ...tags.map((tag) => `#${tag}`)].filter(Boolean).join(" · "))));
  return {};
}
