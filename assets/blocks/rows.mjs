// Clips as rows of coloured stretches over time.
import { element, svgElement } from "../shared/dom.mjs";
import { clock } from "../shared/words.mjs";
import { asButton, tipOn } from "./tip.mjs";
import { isIn } from "./selection.mjs";
/** @import { Segment, Stretch, Track } from "./types.d.ts" */

const [LANE, GAP] = [14, 3];

/** What colours mean. @param {string[]} names @param {string[]} colours */
export function legend(names, colours) {
  return element("div", "block-legend", ...names.map((name, k) => {
    const key = element("span", "block-key", name);
    key.style.setProperty("--colour", colours[k]);
    return key;
  }));
}

/** Whether a clip fades: it is not among some. @param {Set<string> | null} among @param {string} clip */
export const isFaint = (among, clip) => among !== null && !among.has(clip);

/**
 * Rows with names; gives what lights stretches by their keys or, where no key is given, those in some motion.
 * @param {HTMLElement} place
 * @param {Track[]} tracks
 */
export function drawRows(place, tracks) {
  const longest = Math.max(...tracks.map(({ seconds }) => seconds), 1e-9);
  /** @type {[Stretch, SVGElement, Segment][]} */
  const drawn = [];
  const rows = tracks.map((track) => {
    const height = Math.max(track.lanes.length, 1) * (LANE + GAP);
    const svg = svgElement("svg", { class: "block-track", viewBox: `0 0 1000 ${height}`, height, preserveAspectRatio: "none" });
    track.lanes.forEach((lane, row) => {
      for (const stretch of lane) {
        const [x, width] = [(1000 * stretch.start) / longest, (1000 * (stretch.end - stretch.start)) / longest];
        const node = svgElement("rect", { x, y: row * (LANE + GAP), width: Math.max(width - 0.6, 0.8), height: LANE, fill: stretch.colour, class: "block-stretch" });
        tipOn(node, () => [stretch.tip]);
        asButton(node, stretch.tip, stretch.choose);
        node.setAttribute("tabindex", "-1");
        drawn.push([stretch, node, [track.clip, stretch.start * track.fps, stretch.end * track.fps]]);
        svg.append(node);
      }
    });
    const name = element("span", "block-row-name ellipsis", track.brief);
    name.title = track.clip;
    return { clip: track.clip, node: element("div", "block-row", name, svg, element("span", "block-row-end number", clock(track.seconds))) };
  });
  place.append(element("div", "block-rows", ...rows.map(({ node }) => node)));
  /** @param {Set<string>} keys @param {Segment[]} motion @param {string | undefined} clip @param {Set<string> | null} among clips that do not fade */
  return (keys, motion, clip, among) => {
    const lit = drawn.map(([{ key }, , segment]) => (keys.size ? keys.has(key) : isIn(segment, motion)));
    const some = lit.includes(true);
    drawn.forEach(([, node], k) => node.classList.toggle("faint", some && !lit[k]));
    for (const row of rows) {
      row.node.classList.toggle("chosen", row.clip === clip);
      row.node.classList.toggle("faint", isFaint(among, row.clip));
    }
  };
}
