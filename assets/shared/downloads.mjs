/* Saving what is on the page: charts as PNG, SVG or CSV, drawings as PNG or SVG, tables as CSV. */
import { clientside, notify, register } from "./dash.mjs";
import { closest, find } from "./dom.mjs";
import { gridApi } from "./grid.mjs";
import { DATASET_PICKER } from "./ids.mjs";
import { pngOf, save } from "./save.mjs";

/** Addresses of drawings that the server makes, by the name of what they show: `drawings.timeline = () => address`.
 * @type {Record<string, () => string | null>} */
export const drawings = {};

const dataset = () => {
  const picker = find(DATASET_PICKER);
  return (picker && picker.value) || "motionscape";
};

/** @param {any} value */
const cell = (value) => {
  const text = value === null || value === undefined ? "" : String(value);
  return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
};

// Plotly may hold numbers as {dtype, bdata}; its calculated copy has plain arrays.
/** @param {any} values */
const plain = (values) => (values && values._inputArray) || values || [];

/**
 * A row for each point: name of the series, x, y and, where there is one, z.
 * @param {any} plot
 */
function table(plot) {
  const layout = plot._fullLayout;
  /** @param {string} axis @param {string} other */
  const title = (axis, other) => (layout[axis] && layout[axis].title && layout[axis].title.text) || other;
  const rows = [["series", title("xaxis", "x"), title("yaxis", "y"), "value"]];
  for (const trace of plot._fullData) {
    if (trace.visible === false || trace.hoverinfo === "skip") continue;
    const x = plain(trace.x), y = plain(trace.y), z = trace.z;
    const name = trace.name || "";
    if (z) for (let j = 0; j < z.length; j++) for (let i = 0; i < z[j].length; i++) rows.push([name, x[i] ?? i, y[j] ?? j, z[j][i]]);
    else for (let i = 0; i < Math.max(x.length, y.length); i++) rows.push([name, x[i] ?? i, y[i], ""]);
  }
  if (rows.every((row, i) => i === 0 || row[3] === "")) for (const row of rows) row.pop();
  return rows.map((row) => row.map(cell).join(",")).join("\n") + "\n";
}

/** @param {string} target @param {string} kind @param {string} name */
function chart(target, kind, name) {
  const box = find(target);
  const plot = box && (box.classList.contains("js-plotly-plot") ? box : box.querySelector(".js-plotly-plot"));
  if (!plot) return;
  if (kind === "csv") save(table(plot), name + ".csv");
  else window.Plotly.downloadImage(plot, { format: kind, filename: name, scale: kind === "png" ? 2 : 1 });
}

/**
 * A drawing that the server makes; as a picture at twice its size.
 * @param {string} target
 * @param {string} kind
 * @param {string} name
 */
async function drawing(target, kind, name) {
  const address = drawings[target]();
  if (address) await savePicture(address, kind, name);
}

/**
 * Save the drawing at an address of the server, as "svg" or "png".
 * @param {string} address
 * @param {string} kind
 * @param {string} name
 */
export async function savePicture(address, kind, name) {
  const answer = await fetch(address).catch(() => null);
  if (!answer || !answer.ok) {
    notify("The picture was not saved", "The server did not make it; reload the page and try again.");
    return;
  }
  const text = await answer.text();
  if (kind === "svg") return save(text, name + ".svg", "image/svg+xml");
  const png = await pngOf(text);
  if (png) save(png, name + ".png", "image/png");
}
register("downloads", {
  /** @param {{ address?: string } | null} ready */
  fetch(ready) {
    if (ready && ready.address) {
      const link = document.createElement("a");
      link.href = ready.address;
      link.download = "";
      link.click();
    }
    return clientside.no_update;
  },
});

document.addEventListener("click", async (event) => {
  const button = closest(event, "[data-save]");
  if (!button) return;
  const { save: what, target = "", kind = "" } = button.dataset;
  const name = `${dataset()} ${button.dataset.name}`;
  if (what === "chart") chart(target, kind, name);
  else if (what === "drawing") drawing(target, kind, name);
  else {
    const api = await gridApi(target);
    const columns = api && api.getColumns().map((/** @type {any} */ column) => column.getColId()).filter((/** @type {string} */ id) => !["strip", "key"].includes(id));
    if (api) api.exportDataAsCsv({ fileName: name + ".csv", columnKeys: columns });
  }
});
