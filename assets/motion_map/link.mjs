// Keys, pace and numbers of the Map page as its link has them.
/** @import { MapData } from "./data.mjs" */
/** @import { Pace } from "./types.d.ts" */
/** @import { View } from "../shared/types.d.ts" */

const MOST_KEYS = 20;
const WAYS = ["forward", "backward", "left", "right"];

/** Nodes as a link has them: "3-4,5-6". @param {number[]} keys @param {MapData} map */
export const writeKeys = (keys, map) => keys.map((node) => map.place(node).join("-")).join(",");

/** Nodes of a link; what is not on the map is left out. @param {string | undefined} text @param {MapData} map */
export function readKeys(text, map) {
  const nodes = [];
  for (const word of String(text || "").split(",")) {
    const match = /^(\d+)-(\d+)$/.exec(word);
    if (match && Number(match[1]) < map.nx && Number(match[2]) < map.ny) nodes.push(map.index(Number(match[1]), Number(match[2])));
  }
  return nodes.slice(0, MOST_KEYS);
}

/** A number of a link that is not negative, or another one. @param {string | undefined} text @param {number} otherwise */
export const readNumber = (text, otherwise) => (/^\d+(\.\d+)?$/.test(text ?? "") ? Number(text) : otherwise);

/** How fast and where to hits may travel; null where any way will do. @param {View} view @returns {Pace | null} */
export function paceOf(view) {
  const [low, high] = String(view.pace || "").split("-").map((word) => readNumber(word, NaN));
  const way = WAYS.includes(view.way ?? "") ? view.way : "any";
  const [slowest, fastest] = Number.isFinite(low) && Number.isFinite(high) && low <= high ? [low, high] : [0, Infinity];
  return way === "any" && slowest === 0 && fastest === Infinity ? null : { slowest, fastest, way };
}
