// Names in little room: what all have in common is left out, and the middle before both ends.
/** @import { Figure } from "./figure.mjs" */

const WORTH_LEAVING_OUT = 8; // letters

/**
 * Beginning and end of a long name: clips of one session differ at either.
 * @param {string} text
 * @param {number} most
 */
export function shorten(text, most) {
  const kept = Math.floor((most - 1) / 2);
  return text.length > most ? `${text.slice(0, most - 1 - kept).trimEnd()}…${text.slice(-kept).trimStart()}` : text;
}

/**
 * Letters that all names begin with, up to the last separator among them.
 * @param {string[]} names
 */
function sharedBeginning(names) {
  let n = 0;
  while (n < names[0].length && names.every((name) => name[n] === names[0][n])) n++;
  return names[0].slice(0, n).replace(/[^\s_\-/.:]*$/, "");
}

/**
 * Give each figure a `name` for where there is little room: its label without what all labels begin with; where
 * several have the same, with the second at which the motion starts in its clip. And a `brief` one for hardly any room:
 * that second, or the last part of the name.
 * @param {Figure[]} figures
 */
export function nameFigures(figures) {
  if (!figures.length) return;
  const labels = figures.map((figure) => figure.label);
  const alike = new Set(labels).size === 1 && labels.length > 1;
  const shared = alike ? labels[0] : labels.length > 1 ? sharedBeginning(labels) : "";
  const from = alike || shared.length >= WORTH_LEAVING_OUT ? shared.length : 0;
  for (const figure of figures) {
    const { label, header, ownFps } = figure;
    const rest = alike ? "" : label.length > from ? label.slice(from) : label;
    const again = labels.filter((other) => other === label).length > 1;
    const second = `${(header.start / ownFps).toFixed(1)} s`;
    figure.name = again ? `${rest} ${second}`.trim() : rest;
    figure.brief = again ? second : rest.split(/[\s_\-/.:]+/).filter(Boolean).pop() ?? rest;
  }
}
