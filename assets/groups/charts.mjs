// Charts of a comparison: effects in order, what follows what, curves with their bands.
import { asButton, tipOn } from "../blocks/tip.mjs";
import { element, svgElement } from "../shared/dom.mjs";
/** @import { Curve, OnMap, Row } from "./types.d.ts" */

const MEASURES = { share: "share of time", rate: "how often", duration: "how long", mean: "", probability: "" };
const [WIDTH, HEIGHT] = [340, 150];
const [LEFT, RIGHT, TOP, BOTTOM] = [40, 8, 8, 22];
const COLOURS = ["var(--group-a)", "var(--group-b)"];

/** What a row is of, in words. @param {Row} row */
export const nameOf = (row) => [row.name, MEASURES[/** @type {keyof typeof MEASURES} */ (row.measure)]].filter(Boolean).join(", ");

/** @param {number | null | undefined} value */
export const figure = (value) => value === null || value === undefined ? "" : Math.abs(value) > 1e8 ? "∞"
  : Math.abs(value) >= 100 ? value.toFixed(0) : Math.abs(value) >= 10 ? value.toFixed(1) : value.toFixed(2);

/** @param {number | null} p */
export const chance = (p) => p === null ? "" : p < 0.001 ? "< .001" : p.toFixed(3).replace(/^0/, "");

/** All there is to know of a row, as lines. @param {Row} row */
const factsOf = (row) => [
  nameOf(row),
  `${row.groups[0]}: ${figure(row.means[0])} ${row.unit} (${row.n[0]})`,
  `${row.groups[1]}: ${figure(row.means[1])} ${row.unit} (${row.n[1]})`,
  `difference ${figure(row.difference)}, 95 % from ${figure(row.interval[0])} to ${figure(row.interval[1])}`,
  `effect ${figure(row.effect)}, p ${chance(row.p)}, corrected ${chance(row.q)}`,
];

/**
 * Rows as a table with their effects as bars, the largest first.
 * @param {Row[]} rows
 * @param {(row: Row) => void} play
 */
export function effectChart(rows, play) {
  const most = Math.max(1, ...rows.map((row) => Math.min(Math.abs(row.effect ?? 0), 4)));
  const lines = rows.map((row) => {
    const share = Math.min(Math.abs(row.effect ?? 0), 4) / most;
    const bar = element("span", "groups-bar");
    bar.style.setProperty("--share", String(share));
    bar.dataset.side = (row.effect ?? 0) < 0 ? "less" : "more";
    const line = element("tr", row.significant ? "" : "faint",
      element("td", "groups-name", nameOf(row)),
      element("td", "groups-effect", bar),
      element("td", "number", figure(row.effect)),
      element("td", "number", `${figure(row.means[0])} → ${figure(row.means[1])} ${row.unit}`),
      element("td", "number", chance(row.q)));
    tipOn(line, () => factsOf(row));
    return row.examples ? asButton(line, `Play examples: ${nameOf(row)}`, () => play(row)) : line;
  });
  const heads = ["What", "Effect", "", "Means", "Corrected p"].map((head, k) => element("th", k > 1 ? "number" : "", head));
  return element("div", "groups-table", element("table", "", element("thead", "", element("tr", "", ...heads)), element("tbody", "", ...lines)));
}

/**
 * What follows what, as a matrix of differences: rows lead to columns.
 * @param {Row[]} rows
 * @param {(row: Row) => void} play
 */
export function transitionMatrix(rows, play) {
  const ids = [...new Set(rows.flatMap((row) => row.id.split(">")))].sort((a, b) => a.localeCompare(b, undefined, { numeric: true }));
  const names = namesOf(rows);
  const at = new Map(ids.map((id, k) => [id, k]));
  const size = 14;
  const svg = svgElement("svg", { class: "groups-matrix", viewBox: `-26 -26 ${ids.length * size + 28} ${ids.length * size + 28}`, role: "img", "aria-label": "Differences of what follows what" });
  for (const row of rows) {
    const [source, target] = row.id.split(">").map((id) => /** @type {number} */ (at.get(id)));
    const cell = svgElement("rect", { x: target * size, y: source * size, width: size - 1, height: size - 1, rx: 2, class: `groups-cell${row.significant ? " certain" : ""}` });
    cell.style.fill = (row.difference ?? 0) < 0 ? COLOURS[0] : COLOURS[1];
    cell.style.fillOpacity = String(Math.min(1, 0.06 + Math.abs(row.difference ?? 0)));
    tipOn(cell, () => factsOf(row));
    if (row.examples) asButton(cell, `Play examples: ${row.name}`, () => play(row));
    svg.append(cell);
  }
  const step = Math.ceil(ids.length / 24);
  ids.forEach((id, k) => {
    if (k % step) return;
    for (const [x, y, anchor] of /** @type {[number, number, string][]} */ ([[-4, k * size + 10, "end"], [k * size + 6, -5, "middle"]])) {
      const text = svgElement("text", { x, y, "text-anchor": anchor, class: "groups-tick" });
      text.textContent = id.slice(0, 4);
      tipOn(text, () => [names.get(id) ?? id]);
      svg.append(text);
    }
  });
  return svg;
}

/**
 * The same as a graph: what is more often the way in the second group, and what in the first; certain arrows are marked.
 * @param {Row[]} rows
 * @param {(row: Row) => void} play
 */
export function differenceGraph(rows, play) {
  const strong = rows.filter((row) => Math.abs(row.difference ?? 0) >= 0.1).sort((a, b) => Number(b.significant) - Number(a.significant) || Math.abs(b.difference ?? 0) - Math.abs(a.difference ?? 0)).slice(0, 60);
  const ids = [...new Set(strong.flatMap((row) => row.id.split(">")))];
  const names = namesOf(rows);
  const radius = 150;
  const place = new Map(ids.map((id, k) => [id, [radius * Math.sin((2 * Math.PI * k) / ids.length), -radius * Math.cos((2 * Math.PI * k) / ids.length)]]));
  const svg = svgElement("svg", { class: "groups-graph", viewBox: "-190 -180 380 360", role: "img", "aria-label": "Difference graph" });
  for (const row of strong) {
    const [[x, y], [u, v]] = row.id.split(">").map((id) => /** @type {number[]} */ (place.get(id)));
    const bend = 0.18;
    const path = x === u && y === v
      ? `M${x} ${y} c${x * 0.25 - y * 0.12} ${y * 0.25 + x * 0.12} ${x * 0.25 + y * 0.12} ${y * 0.25 - x * 0.12} 0 0`
      : `M${x} ${y} Q${(x + u) / 2 - (v - y) * bend} ${(y + v) / 2 + (u - x) * bend} ${u} ${v}`;
    const line = svgElement("path", { d: path, class: `groups-way${row.significant ? " certain" : ""}` });
    line.style.stroke = (row.difference ?? 0) < 0 ? COLOURS[0] : COLOURS[1];
    line.style.strokeWidth = String(1 + 7 * Math.abs(row.difference ?? 0));
    tipOn(line, () => factsOf(row));
    if (row.examples) asButton(line, `Play examples: ${row.name}`, () => play(row));
    svg.append(line);
  }
  for (const [id, [x, y]] of place) {
    const node = svgElement("g", { transform: `translate(${x} ${y})` }, svgElement("circle", { r: 13, class: "groups-node" }));
    const text = svgElement("text", { "text-anchor": "middle", y: 4, class: "groups-tick" });
    text.textContent = id.slice(0, 4);
    node.append(text);
    tipOn(node, () => [names.get(id) ?? id]);
    svg.append(node);
  }
  return svg;
}

/** @param {Row[]} rows @returns {Map<string, string>} */
function namesOf(rows) {
  const names = new Map();
  for (const row of rows) {
    const [source, target] = row.id.split(">");
    const [a, ...b] = row.name.split(" to ");
    if (b.length === 1) names.set(source, a).set(target, b[0]);
  }
  return names;
}

/** Where on the motion map the groups are more often; what differs beyond chance is outlined. @param {OnMap} found */
export function mapChart({ groups, grid: [across, down], difference, clusters }) {
  const size = 10;
  const most = Math.max(1e-9, ...difference.map(Math.abs));
  const svg = svgElement("svg", { class: "groups-map", viewBox: `0 0 ${across * size} ${down * size}`, role: "img", "aria-label": "Differences on the motion map" });
  const certain = new Map(clusters.flatMap(({ nodes, p }) => nodes.map(([i, j]) => [i * down + j, p])));
  difference.forEach((value, k) => {
    const [i, j] = [Math.floor(k / down), k % down];
    const cell = svgElement("rect", { x: i * size, y: j * size, width: size, height: size, class: `groups-cell${certain.has(k) ? " certain" : ""}` });
    cell.style.fill = value < 0 ? COLOURS[0] : COLOURS[1];
    cell.style.fillOpacity = String(Math.abs(value) / most);
    tipOn(cell, () => [`${value > 0 ? groups[1] : groups[0]} is here ${figure(Math.abs(value))} % of the time more`, ...(certain.has(k) ? [`p ${chance(certain.get(k) ?? null)} over the whole map`] : [])]);
    svg.append(cell);
  });
  return svg;
}

/** Means and bands of a curve in two groups, with the stretches where they differ. @param {Curve} curve */
export function curveChart({ curve, unit, groups, n, means, spreads, clusters, q }) {
  const all = means.flatMap((mean, g) => mean.flatMap((value, k) => [value - spreads[g][k], value + spreads[g][k]]));
  const [low, high] = [Math.min(...all), Math.max(...all)];
  const x = (/** @type {number} */ share) => LEFT + (share / 100) * (WIDTH - LEFT - RIGHT);
  const y = (/** @type {number} */ value) => TOP + ((high - value) / (high - low || 1)) * (HEIGHT - TOP - BOTTOM);
  const svg = svgElement("svg", { class: "groups-curve", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": `${curve} of ${groups.join(" and ")}` });
  for (const { start, end, p } of clusters) {
    const mark = svgElement("rect", { x: x(start), y: TOP, width: Math.max(x(end) - x(start), 1.5), height: HEIGHT - TOP - BOTTOM, class: "groups-cluster" });
    tipOn(mark, () => [`${start.toFixed(0)} to ${end.toFixed(0)} %: p ${chance(p)}`]);
    svg.append(mark);
  }
  means.forEach((mean, g) => {
    const above = mean.map((value, k) => `${x(k)},${y(value + spreads[g][k])}`);
    const below = mean.map((value, k) => `${x(k)},${y(value - spreads[g][k])}`).reverse();
    const band = svgElement("polygon", { points: [...above, ...below].join(" "), class: "groups-band" });
    const line = svgElement("polyline", { points: mean.map((value, k) => `${x(k)},${y(value)}`).join(" "), class: "groups-mean" });
    band.style.fill = line.style.stroke = COLOURS[g];
    svg.append(band, line);
  });
  for (const [px, py, words, anchor] of /** @type {[number, number, string, string][]} */ ([
    [LEFT - 4, TOP + 9, `${figure(high)}`, "end"], [LEFT - 4, HEIGHT - BOTTOM, `${figure(low)}`, "end"],
    [LEFT, HEIGHT - 7, "0 %", "start"], [WIDTH - RIGHT, HEIGHT - 7, "100 %", "end"],
  ])) {
    const text = svgElement("text", { x: px, y: py, "text-anchor": anchor, class: "groups-tick" });
    text.textContent = words;
    svg.append(text);
  }
  return element("figure", "groups-figure", svg, element("figcaption", "", `${curve} (${unit}), `, element("span", "muted", `${n[0]} and ${n[1]}, corrected p ${chance(q)}`)));
}
