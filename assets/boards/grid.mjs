// The grid of a board: gridstack, fetched when the first board opens, moved by pointer and by keyboard.
import { element, withAttributes } from "../shared/dom.mjs";
/** @import { BlockData } from "./types.d.ts" */

const COLUMNS = 12;
const ROW = 64; // pixels
const NARROW = 620; // pixels of width below which all blocks stand in one column

/** @type {Promise<any> | null} */
let library = null;

/** Gridstack: its script and its style sheet. */
export function gridstack() {
  library ??= new Promise((resolve, reject) => {
    document.head.append(withAttributes(element("link"), { rel: "stylesheet", href: "/assets/vendor/gridstack.css" }));
    const script = element("script");
    script.src = "/assets/vendor/gridstack.js";
    script.onload = () => resolve(/** @type {any} */ (globalThis).GridStack);
    script.onerror = () => {
      library = null;
      reject(new Error("The grid could not be loaded; reload the page."));
    };
    document.head.append(script);
  });
  return library;
}

export class Grid {
  /**
   * @param {HTMLElement} place
   * @param {boolean} still nothing may be moved
   * @param {(places: Record<string, number[]>) => void} moved
   */
  static async open(place, still, moved) {
    const GridStack = await gridstack();
    return new Grid(GridStack, place, still, moved);
  }

  /** @param {any} GridStack @param {HTMLElement} place @param {boolean} still @param {(places: Record<string, number[]>) => void} moved */
  constructor(GridStack, place, still, moved) {
    this.quiet = 0; // changes that do not come from a person
    this.grid = GridStack.init({
      column: COLUMNS, cellHeight: ROW, margin: 6, float: false, animate: false, staticGrid: still, handle: ".board-head",
      columnOpts: { breakpoints: [{ w: NARROW, c: 1 }] }, resizable: { handles: "e,se,s,sw,w" },
    }, place);
    this.grid.on("change", () => {
      if (!this.quiet && this.grid.getColumn() === COLUMNS) moved(this.places());
    });
  }

  /** @returns {Record<string, number[]>} */
  places() {
    return Object.fromEntries(this.grid.engine.nodes.map((/** @type {any} */ { el, x, y, w, h }) => [el.dataset.block, [x, y, w, h]]));
  }

  /** @param {() => void} change */
  silently(change) {
    this.quiet += 1;
    change();
    this.quiet -= 1;
  }

  /** Several changes, after which the grid is laid out once. @param {() => void} changes */
  together(changes) {
    this.silently(() => {
      this.grid.batchUpdate();
      changes();
      this.grid.batchUpdate(false);
    });
  }

  /** @param {HTMLElement} item @param {BlockData} block */
  add(item, { x, y, w, h }) {
    this.silently(() => this.grid.makeWidget(item, { x, y, w, h, minW: 2, minH: 2 }));
  }

  /** @param {HTMLElement} item */
  remove(item) {
    this.silently(() => this.grid.removeWidget(item));
  }

  /** Put blocks where others have put them. @param {[HTMLElement, BlockData][]} items */
  place(items) {
    if (this.grid.getColumn() !== COLUMNS || document.querySelector(".ui-draggable-dragging, .ui-resizable-resizing")) return;
    const now = this.places();
    this.together(() => {
      for (const [item, { id, x, y, w, h }] of items) {
        if (JSON.stringify(now[id]) !== JSON.stringify([x, y, w, h])) this.grid.update(item, { x, y, w, h });
      }
    });
  }

  /**
   * Arrow keys move a block, with shift they resize it.
   * @param {HTMLElement} item
   * @param {KeyboardEvent} event
   */
  key(item, event) {
    /** @type {Record<string, number[]>} */
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const step = steps[event.key];
    const node = this.grid.engine.nodes.find((/** @type {any} */ one) => one.el === item);
    if (!step || !node || this.grid.opts.staticGrid) return;
    event.preventDefault();
    const { x, y, w, h } = node;
    if (event.shiftKey) this.grid.update(item, { w: Math.min(Math.max(w + step[0], 2), COLUMNS - x), h: Math.max(h + step[1], 2) });
    else {
      // downwards a block trades places with what lies below it
      this.grid.update(item, { x: Math.min(Math.max(x + step[0], 0), COLUMNS - w), y: Math.max(y + step[1] * (step[1] > 0 ? h : 1), 0) });
    }
  }

  /** The first free row below all blocks. */
  bottom() {
    return this.grid.engine.getRow();
  }

  close() {
    this.grid.destroy(false);
  }
}
