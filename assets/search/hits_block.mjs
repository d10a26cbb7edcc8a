// The hits of a search, best first.
import { isFaint } from "../blocks/rows.mjs";
import { isIn, isMostly } from "../blocks/selection.mjs";
import { tableOf, tableRow } from "../blocks/table.mjs";
import { element } from "../shared/dom.mjs";
/** @import { Draw } from "../blocks/types.d.ts" */

/** @typedef {{ clip: string, start: number, end: number, seconds: number, score: number, label: string, strip: string }} HitRow */

/** @type {Draw<{ query: string, hits: HitRow[] }>} */
export function drawHits(place, { query, hits }, context) {
  const rows = hits.map(({ clip, start, end, seconds, score, label, strip }) => tableRow(
    [clip, seconds.toFixed(1), score.toFixed(2), `${start} to ${end}`, label], strip, `Play ${clip}, frames ${start} to ${end}`,
    () => context.select({ clip, start, end }, { title: `${clip}, ${start} to ${end}`, items: [{ clip, start, end, label: clip }] }),
  ));
  place.append(element("p", "muted", `Like ${query}`), tableOf(["Clip", "Seconds", "Score", "Frames", "Mostly", "Motion"], rows, hits.length ? "" : "Nothing is like it."));
  return {
    light: (_selection, motion) => hits.forEach(({ clip, start, end }, k) => rows[k].classList.toggle("chosen", isIn([clip, start, end], motion))),
    narrow: (label, among) => hits.forEach((hit, k) => rows[k].classList.toggle("faint", isFaint(among, hit.clip) || (Boolean(label) && !isMostly(hit.label, label)))),
  };
}
