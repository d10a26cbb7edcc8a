// Labels and motifs of every clip over time.
import { drawRows, legend } from "../blocks/rows.mjs";
import { motifsIn } from "../blocks/selection.mjs";
import { clock } from "../shared/words.mjs";
/** @import { Draw, Segment, TracksContent } from "../blocks/types.d.ts" */

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
    return { clip: row.clip, fps: row.fps, brief: row.brief, seconds: row.seconds, lanes: [labels, motions].filter((lane) => lane.length) };
  });
  const lit = drawRows(place, tracks);
  if (content.actions.length) place.append(legend(content.actions, content.colours));
  let [wanted, clip] = ["", /** @type {string | undefined} */ (undefined)];
  /** @type {Set<string>} */
  let keys = new Set();
  /** @type {Set<string> | null} */
  let among = null;
  /** @type {Segment[]} */
  let motion = [];
  const show = () => lit(wanted ? new Set([...keys, `label ${wanted}`]) : keys, motion, clip, among);
  return {
    motion: (selection) => motionsOf(content, motifsIn(selection), selection.motion),
    light(selection, named) {
      motion = named;
      keys = new Set([...motifsIn(selection)].map((motif) => `motif ${motif}`));
      ({ clip } = selection);
      show();
    },
    narrow(label, clips) {
      [wanted, among] = [label, clips];
      show();
    },
  };
}

/**
 * The motions of motifs, or the one with a number; undefined where there are none.
 * @param {TracksContent} content
 * @param {Set<number>} motifs
 * @param {number} [wanted]
 * @returns {Segment[] | undefined}
 */
function motionsOf({ rows }, motifs, wanted) {
  const found = rows.flatMap(({ clip, fps, motions }) => motions
    .filter(([, , motif, number]) => motifs.has(motif) && (wanted === undefined || wanted === number))
    .map(([start, end]) => /** @type {Segment} */ ([clip, Math.round(start * fps), Math.round(end * fps)])));
  return found.length ? found : undefined;
}
