// Clips as rows of coloured stretches over time: labels and motifs, or the string of actions.
import { element, svgElement } from "../shared/dom.mjs";
import { clock } from "../shared/words.mjs";
import { motifsIn } from "./motifs.mjs";
import { asButton, tipOn } from "./tip.mjs";
/** @import { ActionsContent, Draw, Stretch, Track, TracksContent } from "./types.d.ts" */

const [LANE, GAP] = [14, 3];

/** @type {Draw<TracksContent>} */
export function drawTracks(place, content, context) {
  const tracks = content.rows.map((row) => {
    /** @param {number} from @param {number} to */
    const choose = (from, to) => () => {
      const [start, end] = [Math.round(from * row.fps), Math.round(to * row.fps)];
      context.select({ clip: row.clip, start, end }, { title: row.clip, items: [{ clip: row.clip, start, end, label: row.clip }] });
    };
    const labels = row.labels.map(([start, end, action]) => ({
      start, end, colour: content.colours[action], text: content.actions[action], key: `label ${content.actions[action]}`,
      tip: `${content.actions[action]}, ${clock(start)} to ${clock(end)}`, choose: choose(start, end),
    }));
    const motions = row.motions.map(([start, end, motif, number]) => ({
      start, end, colour: content.motifs[motif].colour, text: String(motif), key: `motif ${motif}`,
      tip: `${content.motifs[motif].name}, motion ${number + 1}, ${clock(start)} to ${clock(end)}`,
      choose: () => context.select({ motif, motion: number }, {
        title: `${content.motifs[motif].name}, motion ${number + 1}`,
        items: [{ clip: row.clip, start: Math.round(start * row.fps), end: Math.round(end * row.fps), label: row.clip }],
      }),
    }));
    return { clip: row.clip, brief: row.brief, seconds: row.seconds, lanes: [labels, motions].filter((lane) => lane.length) };
  });
  const lit = drawRows(place, tracks);
  if (content.actions.length) place.append(legend(content.actions, content.colours));
  return { light: (selection) => lit(new Set([...motifsIn(selection)].map((motif) => `motif ${motif}`)), selection.clip) };
}

/** @type {Draw<ActionsContent>} */
export function drawActions(place, content, context) {
  const tracks = content.rows.map((row) => ({
    clip: row.clip, brief: row.brief, seconds: row.seconds,
    lanes: [row.pieces.map(([start, end, id, number]) => {
      const action = content.actions[id];
      return {
        start, end, colour: action.colour, ink: action.ink, text: action.short, key: `action ${id}`,
        tip: `${action.name}, ${clock(start)} to ${clock(end)} (${action.count} in all)`,
        choose: () => context.select({ action: id }, {
          title: action.name,
          items: action.segments.map(([clip, from, to]) => ({ clip, start: from, end: to, label: `${clip}, ${number + 1}` })),
        }),
      };
    })],
  }));
  const lit = drawRows(place, tracks);
  return { light: (selection) => lit(new Set(selection.action === undefined ? [] : [`action ${selection.action}`]), selection.clip) };
}

/** What the colours of labels mean; the first rows of every clip. @param {string[]} names @param {string[]} colours */
function legend(names, colours) {
  return element("div", "block-legend", ...names.map((name, k) => {
    const key = element("span", "block-key", name);
    key.style.setProperty("--colour", colours[k]);
    return key;
  }));
}

/**
 * Rows with names; gives what lights stretches by their keys, and a row.
 * @param {HTMLElement} place
 * @param {Track[]} tracks
 */
function drawRows(place, tracks) {
  const longest = Math.max(...tracks.map(({ seconds }) => seconds), 1e-9);
  /** @type {[Stretch, SVGElement][]} */
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
        drawn.push([stretch, node]);
        svg.append(node);
      }
    });
    const name = element("span", "block-row-name ellipsis", track.brief);
    name.title = track.clip;
    return { clip: track.clip, node: element("div", "block-row", name, svg, element("span", "block-row-end number", clock(track.seconds))) };
  });
  place.append(element("div", "block-rows", ...rows.map(({ node }) => node)));
  /** @param {Set<string>} keys @param {string | undefined} clip */
  return (keys, clip) => {
    const some = drawn.some(([{ key }]) => keys.has(key));
    for (const [{ key }, node] of drawn) node.classList.toggle("faint", some && !keys.has(key));
    for (const row of rows) row.node.classList.toggle("chosen", row.clip === clip);
  };
}
