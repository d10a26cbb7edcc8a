/* Four other ways for the chosen part of a new routine: side by side on the Stage, one to choose. */
import { changeView } from "../shared/dash.mjs";
import { element, find } from "../shared/dom.mjs";
import { plural } from "../shared/words.mjs";
import { player } from "../stage/player.mjs";
import { composition, goTo } from "./compose.mjs";
import * as ids from "./ids.mjs";
import { actionOf, isFresh, paintAction, state } from "./state.mjs";
/** @import { OtherWay, OtherWays } from "./types.d.ts" */
/** @import { View, ViewKey } from "../shared/types.d.ts" */
/** @import { StageRequest } from "../stage/types.d.ts" */

const LETTERS = "ABCDEFGH";
let playing = "";

/** Keys of the link that say which routine, which part of it, and which others. @type {ViewKey[]} */
const KEYS = ["sentence", "pick", "up", "alt"];

/** @param {OtherWays | null} data @param {View} view */
const matches = (data, view) => KEYS.every((key) => (data?.inputs?.[key] || "") === (view[key] || ""));

/** @param {OtherWays} data @returns {StageRequest} */
function request(data) {
  return {
    dataset: data.others[0].name, title: `${plural(data.others.length, "other way")} for ${data.part}`, layout: "side", sync: "start",
    items: data.others.map((other, i) => ({
      dataset: other.name, clip: other.clip, start: other.start, end: other.stop, label: LETTERS[i], colours: other.bands,
    })),
  };
}

/** @param {OtherWay} other @param {number} i */
function card(other, i) {
  const box = element("section", "other-card");
  const head = element("div", "other-head");
  head.append(element("b", "", LETTERS[i]), element("span", "muted number", `${plural(other.end - other.first, "action")}, ${other.seconds.toFixed(1)} s`));
  const use = element("button", "walk-button", "Use this");
  use.type = "button";
  use.setAttribute("aria-label", `Use ${LETTERS[i]}`);
  use.addEventListener("click", () => goTo(other.code));
  head.append(element("span", "spacer"), use);
  const chips = element("div", "way-parts");
  chips.append(...other.actions.slice(other.first, other.end).map((id) => {
    const chip = element("span", "action-chip plain-chip", actionOf(id).short);
    paintAction(chip, actionOf(id));
    chip.title = actionOf(id).name;
    return chip;
  }));
  if (other.first === other.end) chips.append(element("span", "muted", "left out"));
  box.append(head, chips);
  return box;
}

/** @param {OtherWays | null} data @param {View} view */
export const drawOthers = (data, view) => {
  const box = find(ids.COMPOSE_OTHERS);
  if (!box) return;
  const wanted = view.show === "compose" && view.alt;
  box.classList.toggle("hidden", !wanted);
  if (!wanted) {
    if (playing && view.show === "compose" && composition().ready) composition().play();
    playing = "";
    return;
  }
  const shown = data !== null && matches(data, view) ? data : null;
  if (!isFresh(box, [shown, state.data.names])) return;
  const head = element("div", "other-title");
  head.append(element("h3", "", shown?.others ? `Other ways for ${shown.part}` : "Other ways"));
  const close = element("button", "walk-button", "Keep it as it is");
  close.type = "button";
  close.addEventListener("click", () => changeView({ alt: "" }));
  const again = element("button", "walk-button", "Another four");
  again.type = "button";
  again.disabled = !shown;
  again.addEventListener("click", () => changeView({ alt: String(Number(view.alt) + 1) }));
  const replay = element("button", "walk-button", "Play again");
  replay.type = "button";
  replay.disabled = !shown?.others?.length;
  replay.addEventListener("click", () => shown && player.show(request(shown))?.then(() => player.play()));
  head.append(element("span", "spacer"), replay, again, close);
  const body = element("div", "other-cards");
  if (!shown) body.append(element("p", "muted", "Making four other ways …"));
  else if (shown.error || !shown.others.length) body.append(element("p", "muted", shown.error || "There is no other way for this part; choose a larger one."));
  else body.append(...shown.others.map(card));
  box.replaceChildren(head, body);
  const stamp = shown?.others?.length ? JSON.stringify(shown.inputs) : "";
  if (!shown || !stamp || stamp === playing) return;
  playing = stamp;
  player.show(request(shown));
};
