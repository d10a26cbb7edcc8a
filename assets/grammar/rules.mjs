/* The rules in plain words: a routine is one of these ways, and so is each phrase it is made of. */
import { allWithin, closest, element, find, need } from "../shared/dom.mjs";
import { plural } from "../shared/words.mjs";
import * as ids from "./ids.mjs";
import { actionChip, isFresh, state } from "./state.mjs";
/** @import { GrammarData, Phrase, Way } from "./types.d.ts" */

const FIRST = 8; // ways shown at first
const open = new Set();

/** @param {string} id */
const named = (id) => (state.data.rules || []).find((phrase) => phrase.id === id);

/**
 * A phrase inside a way: a click leads to where it is spelled out.
 * @param {string} id
 */
export const phraseChip = (id) => {
  const phrase = named(id);
  const button = element("button", "phrase-chip", phrase ? phrase.name : id);
  button.type = "button";
  button.title = "Show what it may be";
  button.dataset.phrase = id;
  return button;
};

/** @param {Way} way @param {number} seen */
function way({ parts: symbols, count }, seen) {
  const line = element("li", "way");
  const bar = element("span", "way-bar");
  bar.style.setProperty("--share", String(seen ? count / seen : 0));
  const many = element("span", "number way-count", `${count}×`);
  many.title = `Taken ${plural(count, "time")} of ${seen}`;
  const body = element("span", "way-parts");
  body.append(...symbols.map((one) => (typeof one === "number" ? actionChip(one) : phraseChip(one))));
  if (!symbols.length) body.append(element("span", "muted", "nothing: it may be left out"));
  line.append(many, bar, body);
  return line;
}

/** @param {Phrase} phrase @param {boolean} start */
function card(phrase, start) {
  const box = element("section", "phrase-card");
  box.id = ids.PHRASE + phrase.id;
  box.tabIndex = -1;
  const head = element("div", "phrase-head");
  head.append(element("h3", "", start ? "A routine" : phrase.name));
  const kinds = phrase.ways.length === 1 ? "always goes like this" : `goes one of ${phrase.ways.length} ways`;
  head.append(element("span", "muted", `${kinds}, seen ${plural(phrase.seen, "time")}`));
  if (phrase.cyclic) {
    const mark = element("span", "phrase-cyclic", "can contain itself");
    mark.title = "New routines may go round it more than once";
    head.append(mark);
  }
  const list = element("ol", "ways");
  const shown = open.has(phrase.id) ? phrase.ways : phrase.ways.slice(0, FIRST);
  list.append(...shown.map((one) => way(one, phrase.seen)));
  box.append(head, list);
  if (phrase.ways.length > shown.length) {
    const more = element("button", "text-button", `Show ${phrase.ways.length - shown.length} more`);
    more.type = "button";
    more.addEventListener("click", () => {
      open.add(phrase.id);
      box.replaceWith(card(phrase, start));
      allWithin(need(ids.PHRASE + phrase.id), ".way")[FIRST]?.querySelector("button")?.focus();
    });
    box.append(more);
  }
  return box;
}

/** @param {GrammarData} data */
export const drawRules = (data) => {
  const box = find(ids.GRAMMAR_RULES);
  if (!box || !isFresh(box, [data.key, data.names])) return;
  open.clear();
  box.replaceChildren(...data.rules.map((phrase, number) => card(phrase, number === 0)));
};

document.addEventListener("click", (event) => {
  const chip = closest(event, ".phrase-chip");
  const phraseCard = chip && find(ids.PHRASE + chip.dataset.phrase);
  if (!phraseCard || !phraseCard.offsetParent) return;
  phraseCard.scrollIntoView({ block: "center", behavior: "smooth" });
  phraseCard.focus({ preventScroll: true });
  phraseCard.classList.add("shown");
  setTimeout(() => phraseCard.classList.remove("shown"), 1200);
});
