// A drawing that can be dragged and zoomed: by pointer, wheel, buttons and arrow keys.
import { element } from "../shared/dom.mjs";
import { clamp } from "../shared/numbers.mjs";

const [CLOSEST, STEP] = [12, 1.3];

/**
 * Let an SVG be explored; `whole` is its box: [x, y, width, height].
 * @param {SVGSVGElement} svg
 * @param {number[]} whole
 */
export function panZoom(svg, whole) {
  let [x, y, width, height] = whole;
  const show = () => svg.setAttribute("viewBox", `${x} ${y} ${width} ${height}`);
  const scale = () => Math.min(svg.clientWidth / width, svg.clientHeight / height) || 1;

  /** @param {number} factor @param {number} px @param {number} py */
  function zoom(factor, px = 0.5, py = 0.5) {
    const next = clamp(width / factor, whole[2] / CLOSEST, whole[2] * 1.5);
    const real = width / next;
    x += px * (width - next);
    y += py * (height - height / real);
    [width, height] = [next, height / real];
    show();
  }
  const reset = () => {
    [x, y, width, height] = whole;
    show();
  };
  /** @param {number} dx @param {number} dy */
  function move(dx, dy) {
    x = clamp(x - dx / scale(), whole[0] - width / 2, whole[0] + whole[2] - width / 2);
    y = clamp(y - dy / scale(), whole[1] - height / 2, whole[1] + whole[3] - height / 2);
    show();
  }

  svg.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && !svg.matches(":focus-within, :focus")) return; // the page scrolls
    event.preventDefault();
    const box = svg.getBoundingClientRect();
    zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15, (event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
  }, { passive: false });
  /** @type {{ x: number, y: number, moved: boolean } | null} */
  let drag = null;
  svg.addEventListener("pointerdown", (event) => {
    if (event.button === 0) drag = { x: event.clientX, y: event.clientY, moved: false };
  });
  svg.addEventListener("pointermove", (event) => {
    if (!drag || !(event.buttons & 1)) return;
    const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
    if (!drag.moved && Math.hypot(dx, dy) < 4) return;
    if (!drag.moved) svg.setPointerCapture(event.pointerId);
    drag = { x: event.clientX, y: event.clientY, moved: true };
    move(dx, dy);
  });
  svg.addEventListener("click", (event) => {
    if (drag?.moved) event.stopPropagation(); // the end of a drag is no click
    drag = null;
  }, { capture: true });
  svg.addEventListener("dblclick", reset);
  svg.addEventListener("keydown", (event) => {
    /** @type {Record<string, () => void>} */
    const keys = {
      ArrowLeft: () => move(40, 0), ArrowRight: () => move(-40, 0), ArrowUp: () => move(0, 40), ArrowDown: () => move(0, -40),
      "+": () => zoom(STEP), "=": () => zoom(STEP), "-": () => zoom(1 / STEP), 0: reset,
    };
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    keys[event.key]();
  });
  show();
  return zoomButtons(zoom, reset);
}

/** @param {(factor: number) => void} zoom @param {() => void} reset */
function zoomButtons(zoom, reset) {
  /** @type {[string, string, () => void][]} */
  const kinds = [["+", "Closer", () => zoom(STEP)], ["−", "Further", () => zoom(1 / STEP)], ["⤢", "Show all", reset]];
  return element("div", "block-zoom", ...kinds.map(([sign, name, act]) => {
    const button = element("button", "", sign);
    button.type = "button";
    button.title = name;
    button.setAttribute("aria-label", name);
    button.addEventListener("click", act);
    return button;
  }));
}
