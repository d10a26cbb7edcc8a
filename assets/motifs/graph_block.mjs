// The motif graph: boxes wide for long motions and high for many, arrows for what follows what.
import { element, svgElement, withAttributes } from "../shared/dom.mjs";
import { motifsToLight, motionOf } from "../blocks/selection.mjs";
import { choose, factsOf, fits } from "./motif_blocks.mjs";
import { panZoom } from "../blocks/pan_zoom.mjs";
import { asButton, tipOn } from "../blocks/tip.mjs";
/** @import { Context, Draw, GraphContent, GraphMotif } from "../blocks/types.d.ts" */

const AIR = 46;

/** @type {Draw<GraphContent>} */
export function drawGraph(place, { motifs, edges }, context) {
  if (!motifs.length) {
    place.append(element("p", "muted", "No movement recurs with these settings."));
    return {};
  }
  const byId = new Map(motifs.map((motif) => [motif.id, motif]));
  const svg = svgElement("svg", { class: "block-graph", tabindex: 0, role: "group", "aria-label": "Motif graph" });
  svg.append(svgElement("defs", {}, svgElement("marker", {
    id: "block-arrow", viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 9, markerHeight: 9, orient: "auto", markerUnits: "userSpaceOnUse",
  }, svgElement("path", { d: "M0 0L8 4L0 8z", class: "block-arrow" }))));
  const ways = new Map();
  for (const [source, target, count, width] of edges) {
    const [from, to] = [byId.get(source), byId.get(target)];
    if (!from || !to) continue;
    const line = svgElement("path", { d: way(from, to), class: "block-edge", "stroke-width": width, "marker-end": "url(#block-arrow)" });
    tipOn(line, () => [`${from.name} to ${to.name}`, `${count} times`]);
    ways.set(line, [source, target]);
    svg.append(line);
  }
  const boxes = new Map(motifs.map((motif) => [motif.id, box(motif, context)]));
  svg.append(...boxes.values());
  place.append(svg, panZoom(svg, around(motifs)));
  return {
    narrow(label, among) {
      for (const motif of motifs) boxes.get(motif.id)?.classList.toggle("faint", !fits(motif, label, among));
    },
    motion: (selection) => motionOf(selection, motifs),
    light(selection, motion) {
      const chosen = motifsToLight(selection, motion, motifs);
      for (const [id, node] of boxes) node.classList.toggle("chosen", chosen.has(id));
      for (const [line, [source, target]] of ways) {
        const near = selection.edge ? selection.edge === `${source}-${target}` : chosen.has(source) || chosen.has(target);
        line.classList.toggle("near", near);
      }
      svg.classList.toggle("lit", chosen.size > 0 && motifs.some((motif) => chosen.has(motif.id)));
    },
  };
}

/** @param {GraphMotif} motif @param {Context} context */
function box(motif, context) {
  const [w, h] = motif.size;
  const side = 0.86 * Math.min(w, h);
  const node = svgElement("g", { class: "block-motif", transform: `translate(${motif.place[0]} ${motif.place[1]})` },
    svgElement("rect", { x: -w / 2, y: -h / 2, width: w, height: h, rx: 8, stroke: motif.part }));
  const picture = svgElement("g", {});
  picture.innerHTML = motif.icon; // drawn by our own server, all text in it escaped
  const icon = picture.firstElementChild;
  if (icon) withAttributes(icon, { x: -side / 2, y: -side / 2, width: side, height: side, "aria-hidden": "true" });
  node.append(picture, svgElement("text", { y: h / 2 + 15, "text-anchor": "middle" }, `${motif.id} · ${motif.count}×`));
  tipOn(node, () => factsOf(motif));
  return asButton(node, factsOf(motif).join(", "), () => choose(context, motif));
}

/** The path of an arrow, from edge to edge of the boxes; a loop above a box that follows itself. @param {GraphMotif} from @param {GraphMotif} to */
function way(from, to) {
  const [[x1, y1], [x2, y2]] = [from.place, to.place];
  if (from === to) {
    const [w, h] = from.size;
    return `M${x1 - w / 4} ${y1 - h / 2}C${x1 - w / 2} ${y1 - h / 2 - 36} ${x1 + w / 2} ${y1 - h / 2 - 36} ${x1 + w / 4} ${y1 - h / 2}`;
  }
  const [dx, dy] = [x2 - x1, y2 - y1];
  const length = Math.hypot(dx, dy) || 1;
  const bend = Math.min(26, 0.12 * length);
  const [mx, my] = [(x1 + x2) / 2 - (dy / length) * bend, (y1 + y2) / 2 + (dx / length) * bend];
  const [a, b] = [border(from, mx - x1, my - y1), border(to, mx - x2, my - y2)];
  return `M${a[0]} ${a[1]}Q${mx.toFixed(1)} ${my.toFixed(1)} ${b[0]} ${b[1]}`;
}

/** Where a line from the middle of a box leaves it. @param {GraphMotif} motif @param {number} dx @param {number} dy */
function border({ place: [x, y], size: [w, h] }, dx, dy) {
  const share = Math.min(w / 2 / Math.abs(dx || 1e-9), h / 2 / Math.abs(dy || 1e-9), 1);
  return [(x + dx * share).toFixed(1), (y + dy * share).toFixed(1)];
}

/** @param {GraphMotif[]} motifs */
function around(motifs) {
  const low = [0, 1].map((k) => Math.min(...motifs.map(({ place, size }) => place[k] - size[k] / 2)) - AIR);
  const high = [0, 1].map((k) => Math.max(...motifs.map(({ place, size }) => place[k] + size[k] / 2)) + AIR);
  return [low[0], low[1], high[0] - low[0], high[1] - low[1]];
}
