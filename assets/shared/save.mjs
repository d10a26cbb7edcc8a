// Files that the browser saves.
import { context2d } from "./dom.mjs";

/**
 * Save a blob, or text of a type, under a name.
 * @param {Blob | string} content
 * @param {string} name
 * @param {string} [type]
 */
export function save(content, name, type = "text/csv") {
  const blob = content instanceof Blob ? content : new Blob([content], { type });
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/**
 * An SVG text as a PNG blob, at up to `scale` times its size and at most `highest` pixels high.
 * @param {string} svg
 * @param {number} [scale]
 * @param {number} [highest]
 */
export async function pngOf(svg, scale = 2, highest = 16000) {
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  await image.decode();
  const by = Math.min(scale, highest / image.height);
  const canvas = document.createElement("canvas");
  canvas.width = Math.round(image.width * by);
  canvas.height = Math.round(image.height * by);
  context2d(canvas).drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(image.src);
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}
