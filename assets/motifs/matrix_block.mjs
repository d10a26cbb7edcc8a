// What follows what, as a table of squares: rows lead to columns.
import { element, svgElement } from "../shared/dom.mjs";
import { motifsToLight, motionOf } from "../blocks/selection.mjs";
import { asButton, tipOn } from "../blocks/tip.mjs";
import { choose, fits } from "./motif_blocks.mjs";
/** @import { Draw, MatrixContent } from "../blocks/types.d.ts" */

/** @type {Draw<MatrixContent>} */
export function drawMatrix(place, { motifs, cells }, context) {
  const n = motifs.length;
  if (!n) {
    place.append(element("p", "muted", "No movement recurs with these settings."));
    return {};
  }
  const most = Math.max(...cells.map(([, , count]) => count), 1);
  const svg = svgElement("svg", { class: "block-matrix", viewBox: `-3 -3 ${n + 3.5} ${n + 3.5}`, role: "group", "aria-label": "What follows what" });
  svg.append(svgElement("rect", { x: 0, y: 0, width: n, height: n, class: "block-ground" }));
  const bars = motifs.flatMap((_, k) => [
    svgElement("rect", { x: 0, y: k, width: n, height: 1, class: "block-line" }),
    svgElement("rect", { x: k, y: 0, width: 1, height: n, class: "block-line" }),
  ]);
  svg.append(...bars);
  /** @type {SVGElement[]} */
  const squares = [];
  /** @type {SVGElement[][]} */
  const heads = motifs.map(() => []);
  for (const [row, column, count] of cells) {
    const cell = svgElement("rect", { x: column + 0.06, y: row + 0.06, width: 0.88, height: 0.88, class: "block-cell", "fill-opacity": 0.25 + 0.75 * Math.sqrt(count / most) });
    tipOn(cell, () => [`${motifs[row].name} to ${motifs[column].name}`, `${count} times`]);
    cell.addEventListener("click", () => context.select({ edge: `${motifs[row].id}-${motifs[column].id}` }));
    squares.push(cell);
    svg.append(cell);
  }
  motifs.forEach((motif, k) => {
    for (const across of [false, true]) {
      const at = across ? { x: k + 0.5, y: -0.35, "text-anchor": "middle" } : { x: -0.35, y: k + 0.72, "text-anchor": "end" };
      const name = svgElement("text", { ...at, class: "block-head", style: `fill: ${motif.colour}` }, String(motif.id));
      tipOn(name, () => [motif.name]);
      heads[k].push(name);
      svg.append(across ? name : asButton(name, motif.name, () => choose(context, motif)));
      if (across) name.addEventListener("click", () => choose(context, motif));
    }
  });
  place.append(svg);
  return {
    motion: (selection) => motionOf(selection, motifs),
    narrow(label, among) {
      const fit = motifs.map((motif) => fits(motif, label, among));
      heads.forEach((names, k) => names.forEach((name) => name.classList.toggle("faint", !fit[k])));
      cells.forEach(([row, column], k) => squares[k].classList.toggle("faint", !(fit[row] && fit[column])));
    },
    light(selection, motion) {
      const chosen = motifsToLight(selection, motion, motifs);
      cells.forEach(([row, column], k) => squares[k].classList.toggle("chosen", selection.edge === `${motifs[row].id}-${motifs[column].id}`));
      motifs.forEach((motif, k) => {
        bars[2 * k].classList.toggle("chosen", chosen.has(motif.id));
        bars[2 * k + 1].classList.toggle("chosen", chosen.has(motif.id));
      });
    },
  };
}
