/* The map as a picture: the heatmap as Plotly draws it, and over it everything that was chosen, in one SVG or PNG. */
import { allWithin, closest, svgElement, within } from "../shared/dom.mjs";
import { pngOf, save } from "../shared/save.mjs";
import { state } from "./state.mjs";

const LOOK = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "font", "text-anchor"];

/**
 * A copy of what lies over the map, its look written into it: a file knows no style sheets.
 * @param {SVGElement} source
 */
function copied(source) {
  const copy = /** @type {SVGElement} */ (source.cloneNode(true));
  const from = [source, ...allWithin(source, "*")], to = [copy, ...allWithin(copy, "*")];
  from.forEach((node, k) => {
    const style = getComputedStyle(node);
    for (const name of LOOK) if (style.getPropertyValue(name)) to[k].style.setProperty(name, style.getPropertyValue(name));
    to[k].setAttribute("vector-effect", "non-scaling-stroke");
  });
  copy.querySelector(".map-layer-cursor")?.remove();
  return copy;
}

async function drawing() {
  const { overlay } = state, plot = within(overlay.box, ".js-plotly-plot");
  const { width, height } = plot.getBoundingClientRect();
  const address = await window.Plotly.toImage(plot, { format: "svg", width, height });
  const text = decodeURIComponent(address.slice(address.indexOf(",") + 1));
  const page = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  const ground = getComputedStyle(document.documentElement).getPropertyValue("--surface");
  page.prepend(svgElement("rect", { width: "100%", height: "100%", fill: ground.trim() }));
  page.append(copied(overlay.view));
  return new XMLSerializer().serializeToString(page);
}

document.addEventListener("click", async (event) => {
  const button = closest(event, "[data-map-save]");
  if (!button || !state.map) return;
  const made = await drawing(), name = `${state.known.dataset} map`;
  if (button.dataset.mapSave === "svg") save(made, `${name}.svg`, "image/svg+xml");
  else save(await pngOf(made), `${name}.png`);
});
