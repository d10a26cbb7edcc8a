// Every clip as a string of actions.
import { drawRows } from "../blocks/rows.mjs";
import { clock } from "../shared/words.mjs";
/** @import { ActionsContent, Draw } from "../blocks/types.d.ts" */

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
  /** @type {[Set<string>, string | undefined, Set<string> | null]} */
  let [keys, clip, among] = [new Set(), undefined, null];
  return {
    light(selection) {
      keys = new Set(selection.action === undefined ? [] : [`action ${selection.action}`]);
      ({ clip } = selection);
      lit(keys, clip, among);
    },
    narrow(_label, clips) {
      among = clips;
      lit(keys, clip, among);
    },
  };
}
