// Every clip as a string of actions.
import { drawRows } from "../blocks/rows.mjs";
import { isMostly } from "../blocks/selection.mjs";
import { clock } from "../shared/words.mjs";
/** @import { ActionsContent, Draw, Segment } from "../blocks/types.d.ts" */

/** @type {Draw<ActionsContent>} */
export function drawActions(place, content, context) {
  const tracks = content.rows.map((row) => ({
    clip: row.clip, fps: row.fps, brief: row.brief, seconds: row.seconds,
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
  let [label, clip] = ["", /** @type {string | undefined} */ (undefined)];
  /** @type {Set<string>} */
  let keys = new Set();
  /** @type {Segment[]} */
  let motion = [];
  /** @type {Set<string> | null} */
  let among = null;
  const show = () => {
    const wanted = label ? content.actions.filter((action) => isMostly(action.label, label)).map(({ id }) => `action ${id}`) : [];
    lit(new Set([...keys, ...wanted]), motion, clip, among);
  };
  return {
    motion: ({ action }) => content.actions.find(({ id }) => id === action)?.segments,
    light(selection, named) {
      keys = new Set(selection.action === undefined ? [] : [`action ${selection.action}`]);
      motion = named;
      ({ clip } = selection);
      show();
    },
    narrow(wanted, clips) {
      [label, among] = [wanted, clips];
      show();
    },
  };
}
