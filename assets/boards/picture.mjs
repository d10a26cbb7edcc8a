// Small pictures of what is shown, for saved views.
import { allWithin, context2d, find } from "../shared/dom.mjs";
import { PAGE } from "../shared/ids.mjs";
import { ask } from "../shared/server.mjs";
import { STAGE_CANVAS } from "../stage/ids.mjs";

const [WIDTH, HEIGHT, BESIDE] = [360, 220, 130]; // pixels; how much of the width the Stage has
const SETTLED = 3000; // milliseconds after a view was opened until its picture is taken anew

/** Take the picture of a saved view anew, once it is shown. @param {string} id @param {string} address */
export function renewPicture(id, address) {
  window.setTimeout(async () => {
    if (location.pathname !== new URL(address, location.href).pathname || document.visibilityState !== "visible") return;
    const picture = await pictureOfPage().catch(() => "");
    if (picture) await ask(`views/${id}`, { action: "picture", picture }).catch(() => undefined); // viewers may not
  }, SETTLED);
}

/** The largest drawings of the page and the Stage, as a small JPEG. */
export async function pictureOfPage() {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [WIDTH, HEIGHT];
  const context = context2d(canvas);
  context.fillStyle = getComputedStyle(document.body).backgroundColor;
  context.fillRect(0, 0, WIDTH, HEIGHT);
  const page = find(PAGE);
  const main = page ? largest(page) : null;
  const stage = /** @type {HTMLCanvasElement | null} */ (/** @type {unknown} */ (find(STAGE_CANVAS)));
  const beside = main ? BESIDE : WIDTH; // a page of tables has no drawing: the Stage alone
  const width = stage ? WIDTH - beside : WIDTH;
  if (main) {
    const box = main.getBoundingClientRect();
    const scale = Math.min(width / box.width, HEIGHT / box.height);
    for (const part of allWithin(main, "canvas, svg")) await draw(context, part, box, scale, (width - box.width * scale) / 2, (HEIGHT - box.height * scale) / 2);
  }
  if (stage?.width) {
    const scale = Math.max(beside / stage.width, HEIGHT / stage.height); // its middle, cut to the shape of the place
    const [wide, high] = [beside / scale, HEIGHT / scale];
    context.drawImage(stage, (stage.width - wide) / 2, (stage.height - high) / 2, wide, high, WIDTH - beside, 0, beside, HEIGHT);
  }
  return canvas.toDataURL("image/jpeg", 0.72);
}

/** The parent of the largest drawing that can be seen. @param {Element} page */
function largest(page) {
  const area = (/** @type {Element} */ node) => {
    const { width, height } = node.getBoundingClientRect();
    return width * height;
  };
  const drawings = allWithin(page, "canvas, svg").sort((a, b) => area(b) - area(a));
  return drawings.length && area(drawings[0]) > 10_000 ? drawings[0].parentElement : null;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Element} part
 * @param {DOMRect} frame
 * @param {number} scale
 * @param {number} left
 * @param {number} top
 */
async function draw(context, part, frame, scale, left, top) {
  const box = part.getBoundingClientRect();
  if (!box.width || !box.height) return;
  /** @type {CanvasImageSource} */
  let image;
  if (part instanceof HTMLCanvasElement) {
    if (!part.width || !part.height) return;
    image = part;
  } else {
    const copy = /** @type {Element} */ (part.cloneNode(true));
    copy.setAttribute("width", String(box.width));
    copy.setAttribute("height", String(box.height));
    const text = new XMLSerializer().serializeToString(copy);
    image = new Image();
    image.src = `data:image/svg+xml;utf8,${encodeURIComponent(text)}`;
    await image.decode();
  }
  context.drawImage(image, left + (box.left - frame.left) * scale, top + (box.top - frame.top) * scale, box.width * scale, box.height * scale);
}
