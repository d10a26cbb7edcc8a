// A sweep: one figure at a time over the first setting, a line for each value of the second.
import { element, svgElement } from "../shared/dom.mjs";
import { tipOn } from "../blocks/tip.mjs";
/** @import { Draw, SweepContent } from "../blocks/types.d.ts" */

const SERIES = ["#3b6abf", "#d2762b", "#3a9b7a", "#a45fc0", "#c2486a", "#7f8a2e", "#2f95b0", "#8c6d53"];
const [WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM] = [640, 300, 52, 12, 12, 44];

/** @type {Draw<SweepContent>} */
export function drawSweep(place, content) {
  const picker = element("select", "block-select", ...content.measures.map(([key, name]) => {
    const option = element("option", "", name);
    option.value = key;
    return option;
  }));
  picker.setAttribute("aria-label", "What the chart shows");
  const chart = element("div", "block-chart");
  /** @type {Record<string, string>} */
  let view = {};
  const show = () => chart.replaceChildren(lines(content, picker.value, view));
  picker.addEventListener("change", show);
  show();
  place.append(element("div", "block-chart-head", picker, content.series.length > 1 ? legend(content.series) : null), chart);
  return {
    settle(now) {
      const other = (content.keys ?? []).some((key) => (now[key] ?? "") !== (view[key] ?? ""));
      view = now;
      if (other) show();
    },
  };
}

/** Whether a place of the chart has the settings of a view. @param {SweepContent} content @param {number} series @param {number} k @param {Record<string, string>} view */
function isAt({ keys = [], settings }, series, k, view) {
  const own = settings?.[series]?.[k];
  return own !== undefined && keys.every((key) => (own[key] ?? "") === (view[key] ?? ""));
}

/** @param {string[]} series */
function legend(series) {
  return element("span", "block-legend", ...series.map((name, k) => {
    const key = element("span", "block-key", name);
    key.style.setProperty("--colour", SERIES[k % SERIES.length]);
    return key;
  }));
}

/** @param {SweepContent} content @param {string} measure @param {Record<string, string>} view whose settings are marked */
function lines(content, measure, view) {
  const { x, series, measures, figures } = content;
  const [, name, unit, digits] = measures.find(([key]) => key === measure) ?? measures[0];
  const rows = figures[measure];
  const values = rows.flat().flatMap((cell) => cell ?? []);
  const [low, high] = range(Math.min(...values), Math.max(...values));
  const n = x.values.length;
  /** @param {number} k */
  const across = (k) => LEFT + ((k + 0.5) / n) * (WIDTH - LEFT - RIGHT);
  /** @param {number} value */
  const up = (value) => HEIGHT - BOTTOM - ((value - low) / (high - low)) * (HEIGHT - TOP - BOTTOM);
  const svg = svgElement("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "block-lines", role: "img", "aria-label": `${name} over ${x.name}` });
  for (const value of ticks(low, high)) {
    svg.append(svgElement("path", { d: `M${LEFT} ${up(value)}H${WIDTH - RIGHT}`, class: "block-grid" }),
      svgElement("text", { x: LEFT - 6, y: up(value) + 4, "text-anchor": "end" }, String(Number(value.toPrecision(6)))));
  }
  x.values.forEach((value, k) => svg.append(svgElement("text", { x: across(k), y: HEIGHT - BOTTOM + 17, "text-anchor": "middle" }, value)));
  svg.append(svgElement("text", { x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 6, "text-anchor": "middle" }, x.name));
  rows.forEach((row, s) => {
    const colour = SERIES[s % SERIES.length];
    const there = row.flatMap((cell, k) => (cell ? [[k, cell[0]]] : []));
    svg.append(svgElement("path", { d: there.map(([k, value], i) => `${i ? "L" : "M"}${across(k)} ${up(value)}`).join(""), stroke: colour, class: "block-line-of" }));
    row.forEach((cell, k) => {
      if (!cell) return;
      svg.append(svgElement("path", { d: `M${across(k)} ${up(cell[1])}V${up(cell[2])}`, stroke: colour, class: "block-spread" }));
      const dot = svgElement("circle", { cx: across(k), cy: up(cell[0]), r: 4.5, fill: colour, tabindex: 0 });
      const here = isAt(content, s, k, view);
      if (here) svg.append(svgElement("circle", { cx: across(k), cy: up(cell[0]), r: 9, class: "block-here" }));
      const words = cell.map((value) => value.toFixed(digits));
      tipOn(dot, () => [`${name}: ${words[0]}${unit && ` ${unit}`}`, `${x.name} ${x.values[k]}${series[s] && `, ${series[s]}`}`, words[1] === words[2] ? "" : `${words[1]} to ${words[2]} over the seeds`, here ? "The settings of this page" : ""]);
      svg.append(dot);
    });
  });
  return svg;
}

/** Limits with some air, also where all values are one. @param {number} low @param {number} high */
function range(low, high) {
  const air = 0.08 * (high - low) || Math.abs(high) * 0.1 || 1;
  return [low >= 0 ? Math.max(0, low - air) : low - air, high + air];
}

/** About five round values. @param {number} low @param {number} high */
function ticks(low, high) {
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5, 10].find((k) => k * power >= rough) ?? 10) * power;
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, k) => (first + k) * step);
}
