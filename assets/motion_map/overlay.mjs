/* What lies over the heatmap: where keys reach, numbered keys, paths, dots, the cursor. Drawn in node units. */
import { childrenOf, svgElement } from "../shared/dom.mjs";
/** @import { MapData } from "./data.mjs" */
/** @import { Dot, OverlayActions, Point } from "./types.d.ts" */

const LAYERS = ["lit", "region", "reach", "paths", "drawn", "dots", "keys", "cursor"];
const JUMP = 3; // nodes between two frames
const HELP = "Map of postures. Arrow keys move the cursor, Enter adds the posture under it as a key, "
  + "Backspace takes the last key away.";

export class Overlay {
  /** @param {HTMLElement} box @param {OverlayActions} on */
  constructor(box, on) {
    this.box = box;
    this.on = on; // {hover(node), choose(node), undo(), path(points)}
    this.cursor = -1;
    this.svg = svgElement("svg", { class: "map-overlay", tabindex: "0", role: "application", "aria-label": HELP });
    this.view = svgElement("svg", { preserveAspectRatio: "none", overflow: "visible" });
    /** @type {Record<string, SVGGElement>} */
    this.layers = {};
    /** @type {MapData} */
    this.map = /** @type {any} */ (null); // until one has come
    this.scale = 0; // pixels a node
    this.drawn = "";
    for (const name of LAYERS) this.view.append((this.layers[name] = svgElement("g", { class: `map-layer-${name}` })));
    this.svg.append(this.view);
    box.append(this.svg);
    this.listen();
  }

  /** The heatmap, as Plotly has it. @returns {any} */
  get plot() { return this.box.querySelector(".js-plotly-plot"); }

  /**
   * Lie exactly over the heatmap.
   * @param {MapData} map
   */
  fit(map) {
    const layout = this.plot?._fullLayout;
    if (!layout?.xaxis || !map) return;
    const { xaxis: x, yaxis: y } = layout;
    const place = { x: x._offset, y: y._offset, width: x._length, height: y._length, viewBox: `-0.5 -0.5 ${map.nx} ${map.ny}` };
    for (const [key, value] of Object.entries(place)) this.view.setAttribute(key, value);
    this.scale = x._length / map.nx; // pixels a node
  }

  /**
   * [x, y] in node units of a pointer event; null where it is not over the map.
   * @param {PointerEvent | MouseEvent} event
   */
  at(event) {
    const matrix = this.map && this.view.getScreenCTM();
    if (!matrix) return null;
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.layers.cursor.getScreenCTM()?.inverse());
    return x >= -0.5 && y >= -0.5 && x < this.map.nx - 0.5 && y < this.map.ny - 0.5 ? [x, y] : null;
  }

  /** @param {PointerEvent | MouseEvent} event */
  node(event) {
    const at = this.at(event);
    return at ? this.map.index(Math.round(at[0]), Math.round(at[1])) : -1;
  }

  listen() {
    /** @type {Point[] | null} */
    let drawing = null;
    this.svg.addEventListener("pointermove", (event) => {
      const node = this.node(event);
      if (drawing) {
        const at = this.at(event), last = drawing[drawing.length - 1];
        if (at && Math.hypot(at[0] - last[0], at[1] - last[1]) > 0.4) drawing.push(at);
        this.drawPath(drawing);
      }
      if (node >= 0 && node !== this.cursor) this.move(node);
    });
    this.svg.addEventListener("pointerdown", (event) => {
      const at = this.at(event);
      if (!at || !this.on.draws()) return;
      drawing = [at];
      this.svg.setPointerCapture(event.pointerId);
    });
    this.svg.addEventListener("pointerup", () => {
      if (drawing && drawing.length > 2) this.on.path(drawing);
      drawing = null;
    });
    this.svg.addEventListener("click", (event) => {
      const node = this.node(event);
      if (node >= 0 && !this.on.draws()) this.on.choose(node);
    });
    this.svg.addEventListener("pointerleave", () => !drawing && this.on.leave());
    this.svg.addEventListener("keydown", (event) => this.key(event));
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (!this.map || event.ctrlKey || event.metaKey || event.altKey) return;
    /** @type {Record<string, number[]>} */
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    /** @param {number} value @param {number} n */
    const limit = (value, n) => Math.min(Math.max(value, 0), n - 1);
    const [x, y] = this.cursor < 0 ? this.map.icons[0] : this.map.place(this.cursor);
    if (steps[event.key]) {
      const far = event.shiftKey ? 5 : 1;
      const [a, b] = this.cursor < 0 ? [0, 0] : steps[event.key];
      this.move(this.map.index(limit(x + far * a, this.map.nx), limit(y + far * b, this.map.ny)));
    } else if (event.key === "Enter" || event.key === " ") {
      if (this.cursor >= 0) this.on.choose(this.cursor);
    } else if (event.key === "Backspace" || event.key === "Delete") this.on.undo();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** @param {number} node */
  move(node) {
    this.cursor = node;
    this.squares("cursor", node < 0 ? [] : [node]);
    if (node >= 0) this.on.hover(node);
  }

  /**
   * Fill a layer with the squares of nodes, as one path.
   * @param {string} layer
   * @param {number[]} nodes
   */
  squares(layer, nodes) {
    if (!this.map) return;
    const d = nodes.map((node) => { const [x, y] = this.map.place(node); return `M${x - 0.5} ${y - 0.5}h1v1h-1z`; }).join("");
    this.layers[layer].replaceChildren(...(d ? [svgElement("path", { d, class: `map-${layer}` })] : []));
  }

  /**
   * Nodes of every key: [{node, nodes}], numbered.
   * @param {{ node: number, nodes: number[] }[]} keys
   */
  drawKeys(keys) {
    const every = new Set(keys.flatMap((key) => key.nodes));
    this.squares("reach", [...every]);
    const size = Math.max(0.5, 9 / (this.scale || 18)); // at least 9 pixels
    this.layers.keys.replaceChildren(...keys.map(({ node }, k) => {
      const [x, y] = this.map.place(node);
      const mark = svgElement("g", { class: "map-key", transform: `translate(${x} ${y}) scale(${size.toFixed(3)})` });
      const label = svgElement("text", { y: 0.36, "text-anchor": "middle" });
      label.textContent = String(k + 1);
      mark.append(svgElement("circle", { r: 0.9 }), label);
      return mark;
    }));
  }

  /**
   * Ways over the map: [{points, colour}], the first drawn last; jumps over a fold of the map are thin and dotted.
   * @param {{ points: Point[], colour: string }[]} paths
   */
  drawPaths(paths) {
    this.layers.paths.replaceChildren(...[...paths].reverse().flatMap(({ points, colour }) => {
      /** @type {string[][]} */
      const [ways, jumps] = [[], []];
      points.slice(1).forEach((point, k) => {
        const far = Math.hypot(point[0] - points[k][0], point[1] - points[k][1]) > JUMP;
        (far ? jumps : ways).push(`M${points[k]}L${point}`);
      });
      /** @param {string[]} d @param {string} name */
      const made = (d, name) => svgElement("path", { d: d.join(""), class: `map-path ${name}`, style: `--tone: ${colour}` });
      return [made(jumps, "map-jump"), made(ways, "map-way")];
    }));
  }

  /** @param {Point[]} points */
  drawPath(points) {
    const line = points?.length > 1
      ? [svgElement("polyline", { points: points.map((p) => p.map((v) => v.toFixed(2)).join(",")).join(" "), class: "map-drawn" })]
      : [];
    this.layers.drawn.replaceChildren(...line);
  }

  /**
   * Where the playing figures are: [{x, y, colour}].
   * @param {Dot[]} dots
   */
  drawDots(dots) {
    const layer = this.layers.dots;
    while (layer.childElementCount > dots.length) layer.lastChild?.remove();
    while (layer.childElementCount < dots.length) layer.append(svgElement("circle", { class: "map-dot" }));
    dots.forEach(({ x, y, colour }, k) => {
      const dot = childrenOf(layer)[k];
      dot.setAttribute("cx", String(x));
      dot.setAttribute("cy", String(y));
      dot.setAttribute("r", String(Math.max(0.3, 5.5 / (this.scale || 18))));
      dot.style.setProperty("--tone", colour);
    });
  }
}
