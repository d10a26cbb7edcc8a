// The facts of a dataset, and its clips.
import { isFaint } from "../blocks/rows.mjs";
import { tableOf, tableRow } from "../blocks/table.mjs";
import { element } from "../shared/dom.mjs";
import { clock, plural } from "../shared/words.mjs";
/** @import { Draw, OverviewContent } from "../blocks/types.d.ts" */

/** @type {Draw<OverviewContent>} */
export function drawOverview(place, { facts, clips, more }, context) {
  place.append(element("dl", "block-facts", ...facts.map(([name, value]) =>
    element("div", "", element("dt", "", name), element("dd", "number", value)))));
  const rows = clips.map((clip) => tableRow(
    [clip.name, clock(clip.seconds), `${clip.frames.toLocaleString("en")}`, `${clip.fps}`, clip.labels + (clip.verdict === "ok" ? "" : ` (${clip.verdict})`)],
    clip.strip, `Play ${clip.name}`,
    () => context.select({ clip: clip.name }, { title: clip.name, items: [{ clip: clip.name, start: 0, end: clip.frames, label: clip.name }] }),
  ));
  place.append(tableOf(["Clip", "Duration", "Frames", "Rate", "Labels", "Motion"], rows, more ? `${plural(more, "more clip")} not listed.` : ""));
  return {
    light(_selection, motion) {
      const chosen = new Set(motion.map(([clip]) => clip));
      clips.forEach(({ name }, k) => rows[k].classList.toggle("chosen", chosen.has(name)));
    },
    narrow: (label, among) => clips.forEach(({ name, labels }, k) => rows[k].classList.toggle("faint", isFaint(among, name) || (Boolean(label) && !labels.split(", ").includes(label)))),
  };
}
