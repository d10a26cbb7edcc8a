// The strip that shows which parts match when.
import { context2d } from "../shared/dom.mjs";
import { counts } from "./body.mjs";
import { now } from "./state.mjs";
/** @import { Strip } from "./types.d.ts" */

/**
 * Cells from dull (nothing alike) to full colour (equal); parts that do not count are pale.
 * @param {HTMLCanvasElement} canvas
 * @param {Strip} strip
 */
export function paintStrip(canvas, strip) {
  const ratio = Math.min(window.devicePixelRatio || 1, 2);
  const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((size) => Math.max(1, Math.round(size * ratio)));
  canvas.width = width;
  canvas.height = height;
  const context = context2d(canvas);
  const style = getComputedStyle(canvas);
  const [full, dull] = [style.getPropertyValue("--strip-full").trim(), style.getPropertyValue("--strip-dull").trim()];
  const rows = strip.rows.length;
  strip.rows.forEach((cells, r) => {
    const strength = counts(now.body.leaves[r]) ? 1 : 0.3;
    const [top, bottom] = [Math.round((r * height) / rows), Math.round(((r + 1) * height) / rows) - Math.max(1, Math.round(ratio / 2))];
    cells.forEach((value, c) => {
      if (value < 0) return;
      const [left, right] = [Math.floor((c * width) / cells.length), Math.floor(((c + 1) * width) / cells.length)];
      context.globalAlpha = strength;
      context.fillStyle = dull;
      context.fillRect(left, top, right - left, bottom - top);
      context.globalAlpha = strength * (value / 100) ** 1.5;
      context.fillStyle = full;
      context.fillRect(left, top, right - left, bottom - top);
    });
  });
}

/** @param {Element} row */
export const canvasOf = (row) => /** @type {HTMLCanvasElement} */ (row.querySelector("canvas"));
