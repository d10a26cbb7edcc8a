// Takes the first picture of a page away (webapp/shell/first_picture.py) when the page itself is drawn.
import { find } from "../shared/dom.mjs";
import { FIRST_PICTURE, PAGE } from "../shared/ids.mjs";

const PATIENCE = 15000; // milliseconds: then a page of which a part cannot be drawn is shown as it is
const DRAWN = ".ag-row, .ag-overlay-wrapper, .main-svg"; // what AG Grid and Plotly draw

/** Whether a library has drawn a component. @param {string} id */
function drawn(id) {
  const place = find(id);
  return place !== null && (place.dataset.drawn !== undefined || place.querySelector(DRAWN) !== null);
}

/** @param {HTMLElement} picture */
function watch(picture) {
  const awaited = (picture.dataset.until || "").split(" ").filter(Boolean);
  let wanted = true;
  const look = () => {
    const stands = find(PAGE)?.firstElementChild;
    if (stands && !picture.classList.contains("passed")) {
      picture.classList.add("passed"); // what is clicked now is the page, which is at the same places
      for (const kind of ["pointerdown", "keydown"]) document.addEventListener(kind, () => { wanted = false; }, { once: true });
    }
    if (wanted && performance.now() < PATIENCE && !(stands && awaited.every(drawn))) return requestAnimationFrame(look);
    requestAnimationFrame(() => picture.remove());
  };
  look();
}

const picture = find(FIRST_PICTURE);
if (picture) watch(picture);
