/* The motions of what is selected: plain elements, because each Dash component takes the browser milliseconds. */
import { clientside, register } from "../shared/dash.mjs";
import { childrenOf, element, find, icon } from "../shared/dom.mjs";
import { SELECTION } from "../shared/ids.mjs";
import * as ids from "./ids.mjs";
/** @import { MotionRow } from "./types.d.ts" */

/**
 * A button that puts its selection into the store (assets/shell/selecting.mjs): play mark, clip, time, key poses.
 * @param {MotionRow} motion
 */
function row({ clip, brief, when, strip, selection, chosen }) {
  const button = element("button", "motion-row" + (chosen ? " chosen" : ""));
  button.type = "button";
  button.title = `Play ${clip}, ${when}, alone`;
  button.dataset.store = SELECTION;
  button.dataset.value = JSON.stringify(selection);
  button.setAttribute("aria-pressed", String(chosen));
  const picture = element("img", "motion-strip");
  Object.assign(picture, { loading: "lazy", alt: "", draggable: false, src: strip });
  button.append(icon("play"), element("span", "ellipsis motion-clip", brief), element("span", "muted number motion-time", when), picture);
  return button;
}

register("motions", {
  /** @param {{ name?: string, rows?: MotionRow[], more?: number } | null} motions */
  list(motions) {
    const box = find(ids.MOTION_LIST);
    if (!box) return clientside.no_update; // its page is gone
    const { name = "", rows = [], more = 0 } = motions || {};
    const same = box.dataset.name === name;
    const top = same ? box.scrollTop : 0;
    const focused = same ? [...box.children].indexOf(/** @type {any} */ (document.activeElement)) : -1;
    box.dataset.name = name;
    box.replaceChildren(...rows.map(row));
    if (more) box.append(element("div", "muted selection-more", `and ${more} more`));
    box.scrollTop = top;
    if (focused >= 0) childrenOf(box)[focused]?.focus({ preventScroll: true });
    return clientside.no_update;
  },
});
