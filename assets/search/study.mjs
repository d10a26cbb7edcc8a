/* Do people agree? Pairs and duels on the Stage, answered by keys; the browser does not know which engine found what. */
import { changeView, clientside, register, setStore } from "../shared/dash.mjs";
import { childrenOf, closest, element, find, icon, need, targetOf } from "../shared/dom.mjs";
import { SELECTION, STAGE_REQUEST } from "../shared/ids.mjs";
import { player } from "../stage/player.mjs";
import * as ids from "./ids.mjs";
/** @import { Person, Question, ReceivedAnswers, Study } from "./types.d.ts" */
/** @import { Child } from "../shared/dom.mjs" */
/** @import { View } from "../shared/types.d.ts" */

const SCALE = ["completely different", "", "", "", "", "", "", "", "", "identical"];
const CHOICES = { left: ["A", "#3a9b7a", "A"], same: ["No difference", "", "S"], right: ["B", "#d2762b", "B"] };
/** @type {Record<string, string>} */
const VALUES = { A: "left", S: "same", B: "right" };

/** @type {Study} */
let data = /** @type {any} */ (null); // until it has come
/** @type {View} */
let view = {};
/** @type {Record<string, number>} */
const at = { rate: 0, vote: 0 }; // number of the pair that is shown
let shown = ""; // what is on the Stage

const mode = () => (view.study === "vote" ? "vote" : view.study === "results" ? "results" : "rate");
// Every person has an order of pairs of their own: no pair is shown until it has come.
const awaited = () => data.inputs.person !== (person.name || person.id);
const rows = () => (awaited() ? [] : (mode() === "vote" ? data.duels : data.pairs) || []);
const visible = () => Boolean(find(ids.STUDY_SETUP)?.offsetParent) && data && !data.error;
/** @param {Child | Child[]} words @param {string} name @param {string} [className] */
const button = (words, name, className = "search-button") => {
  const made = element("button", className, ...[words].flat());
  made.type = "button";
  made.dataset.study = name;
  return made;
};

// ---- the setup: queries, engines, the person's name ----
function setup() {
  const queries = data.queries.map(({ name, clip, when, strip }) => {
    const picture = element("img", "study-strip");
    Object.assign(picture, { src: strip, alt: "", draggable: false });
    const away = button(icon("close", 12), "remove", "search-tool");
    away.dataset.name = name;
    away.title = `Leave ${clip} out`;
    away.setAttribute("aria-label", away.title);
    return element("div", "study-query", picture, element("span", "study-query-words", element("b", "ellipsis", clip), element("span", "muted", when)), away);
  });
  const engines = data.engines.map(({ method, label, ready }) => {
    if (ready) return element("span", "study-engine", icon("check", 13), label);
    const build = button(`Build ${label}`, "build");
    build.dataset.method = method;
    build.title = "Its index has not been built yet; then it takes part";
    return build;
  });
  const name = element("input", "search-text");
  Object.assign(name, { id: ids.STUDY_NAME, placeholder: "optional", maxLength: 60, value: person.name || "", autocomplete: "off" });
  const label = element("label", "search-label", "Your name");
  label.htmlFor = ids.STUDY_NAME;
  const add = button([icon("plus", 13), "The query of the search"], "add");
  add.disabled = !whole();
  add.title = whole() ? "" : "Choose a query of this dataset, for the whole body, under Search first";
  need(ids.STUDY_SETUP).replaceChildren(
    element("div", "study-line", element("span", "search-label", "Queries"), ...queries, add, button([icon("dice", 15), "Draw three"], "draw")),
    element("div", "study-line", element("span", "search-label", "Engines"), ...engines),
    element("div", "study-line", label, name),
  );
}

/** The query of the search, where it can be one of the study's. */
function whole() {
  const text = view.query || "";
  return text && !text.includes(",") && text.split(":").length === 2 ? text : "";
}

// ---- the pairs ----
/** @param {string} words */
function nothing(words) {
  return element("p", "muted study-nothing", words);
}

function draw() {
  const which = mode();
  if (which === "results") return;
  const box = need(which === "vote" ? ids.STUDY_VOTE : ids.STUDY_RATE);
  const all = rows();
  if (awaited()) return box.replaceChildren(nothing(`Fetching the pairs for ${person.name || "you"} …`));
  if (!data.queries.length) return box.replaceChildren(nothing("Choose queries above: the one of the search, or three drawn by chance."));
  if (!all.length) {
    const built = data.engines.filter((engine) => engine.ready).length;
    return box.replaceChildren(nothing(!built ? "Build the index of at least one engine first."
      : which === "vote" ? "There are too few hits to compare." : "The engines found nothing for these queries."));
  }
  at[which] = Math.min(at[which], all.length - 1);
  const row = all[at[which]];
  const done = all.filter((one) => one.value).length;
  const bar = element("div", "job-progress", element("div"));
  childrenOf(bar)[0].style.width = `${(100 * done) / all.length}%`;
  const walk = element("div", "study-walk", move("Back", -1, "back"), element("span", "muted number", `${at[which] + 1} of ${all.length}, ${done} answered`), move("Skip", 1, "next"));
  box.replaceChildren(
    element("div", "study-progress", bar),
    element("h2", "study-question", which === "vote" ? "Which is more like the query: A or B?" : "How alike are the two motions on the Stage?"),
    which === "vote" ? choices(row) : scale(row),
    walk,
    ...(done === all.length ? [element("p", "study-thanks", "All pairs are answered. Thank you! Results shows what came of it.")] : []),
  );
  play(row);
  return undefined;
}

/** @param {string} words @param {number} by @param {string} symbol */
function move(words, by, symbol) {
  const made = button([icon(symbol, 13), words], "move");
  made.dataset.by = String(by);
  return made;
}

/** @param {Question} row */
function scale(row) {
  const buttons = SCALE.map((words, k) => {
    const one = button([element("b", "", String(k + 1)), element("span", "", words)], "answer", "study-value");
    one.dataset.value = String(k + 1);
    one.setAttribute("aria-label", `${k + 1}${words ? `: ${words}` : ""}`);
    one.setAttribute("aria-pressed", String(row.value === k + 1));
    return one;
  });
  const keys = element("p", "muted study-keys", "Keys 1 to 9, and 0 for 10; Backspace goes back, N skips.");
  return element("div", "", element("div", "study-scale", ...buttons), keys);
}

/** @param {Question} row */
function choices(row) {
  const buttons = Object.entries(CHOICES).map(([value, [words, colour, key]]) => {
    const dot = element("span", "study-dot");
    dot.style.background = colour;
    const one = button([...(colour ? [dot] : []), element("b", "", words), element("kbd", "", key)], "answer", "study-choice");
    one.dataset.value = value;
    one.setAttribute("aria-pressed", String(row.value === value));
    return one;
  });
  return element("div", "study-choices", ...buttons);
}

/** @param {Question} row */
function play(row) {
  const wanted = JSON.stringify([row.query, row.hit, row.left, row.right]);
  if (wanted === shown && player.status !== "empty") return;
  shown = wanted;
  setStore(SELECTION, {});
  setStore(STAGE_REQUEST, { ...row.request, at: wanted });
  const next = rows()[at[mode()] + 1];
  if (next) setTimeout(() => player.prefetch(next.request), 600);
}

/** @param {number | string} value */
function answer(value) {
  const which = mode();
  const row = rows()[at[which]];
  if (!row) return;
  row.value = value;
  given.set(nameOf(row), value);
  const message = which === "vote" ? { kind: "vote", query: row.query, left: row.left, right: row.right, choice: String(value) }
    : { kind: "rating", query: row.query, hit: row.hit, value: Number(value) };
  pending.push({ ...message, person: person.name || person.id, id: `${Date.now()} ${Math.random()}` });
  send();
  step(1);
}

/** Tells the server what it has not confirmed: one message at a time, as two under way may overtake each other. */
function send() {
  if (!pending.length || !find(ids.STUDY_RATE) || (sent && Date.now() - sent < PATIENCE)) return;
  sent = Date.now();
  setStore(ids.STUDY_ANSWER, { answers: [...pending], at: sent });
  setTimeout(send, PATIENCE); // where no answer came: the server was away
}

/** @param {number} by */
function step(by) {
  const which = mode();
  at[which] = Math.min(Math.max(at[which] + by, 0), Math.max(rows().length - 1, 0));
  draw();
}

// Answers given here, which data from the server may not contain yet.
const given = new Map();
/** @param {Question} row */
const nameOf = (row) => JSON.stringify([person.name || person.id, row.query, row.hit, row.left, row.right]);

/**
 * The question to continue with: the one shown before where the order is the same, else the first without an answer.
 * @param {number} number
 * @param {Question[]} before
 * @param {Question[]} all
 */
function place(number, before, all) {
  const same = before[number] && before.length === all.length && nameOf(before[number]) === nameOf(all[number]);
  return same ? number : Math.max(all.findIndex((row) => !row.value), 0);
}

const PATIENCE = 20000; // milliseconds
/** @type {ids.Answer[]} */
const pending = []; // answers the server has not confirmed
let sent = 0; // when the message under way was sent, 0 where none is

/** @type {Person} */
let person = {};
/** @param {Person | null} stored */
function takePerson(stored) {
  person = stored || {};
  if (!person.id) {
    person = { ...person, id: `someone-${Math.random().toString(36).slice(2, 8)}` };
    setStore(ids.STUDY_PERSON, person);
  }
}

register("study", {
  /** @param {ReceivedAnswers | null} answers */
  received(answers) {
    if (!answers?.received) return clientside.no_update;
    for (const id of answers.received) {
      const number = pending.findIndex((one) => one.id === id);
      if (number >= 0) pending.splice(number, 1);
    }
    sent = 0;
    send();
    return clientside.no_update;
  },
  /** @param {Study | null} found @param {View | null} seen @param {Person | null} stored */
  draw(found, seen, stored) {
    view = seen || {};
    if (!found || view.look !== "agree" || !find(ids.STUDY_SETUP)) {
      shown = "";
      return clientside.no_update;
    }
    if (!stored || !stored.id) takePerson(stored);
    else person = stored;
    const fresh = found !== data;
    const before = data && data.inputs.person === found.inputs.person ? data : null;
    data = found;
    if (data.error) {
      need(ids.STUDY_SETUP).replaceChildren(nothing(data.error));
      for (const id of [ids.STUDY_RATE, ids.STUDY_VOTE]) need(id).replaceChildren();
      return clientside.no_update;
    }
    if (fresh) for (const row of [...data.pairs, ...data.duels]) row.value = given.get(nameOf(row)) ?? row.value;
    if (fresh) for (const [which, all] of /** @type {["rate" | "vote", "pairs" | "duels"][]} */ ([["rate", "pairs"], ["vote", "duels"]])) at[which] = place(at[which], (before && before[all]) || [], data[all]);
    setup();
    draw();
    return clientside.no_update;
  },
});

// ---- clicks and keys ----
/** @type {Record<string, (button: HTMLElement) => void>} */
const ACTS = {
  add: () => asks([...data.queries.map((query) => query.name), whole()]),
  /** @param {HTMLElement} on */
  remove: (on) => asks(data.queries.map((query) => query.name).filter((name) => name !== on.dataset.name)),
  draw: () => setStore(ids.STUDY_WISH, { draw: 1 + Math.floor(Math.random() * 1e6) }),
  /** @param {HTMLElement} on */
  build: (on) => setStore(ids.STUDY_WISH, { build: on.dataset.method, at: Date.now() }),
  clear() {
    if (!window.confirm("Remove all ratings and votes about this dataset, of all people?")) return;
    given.clear();
    pending.length = 0;
    for (const row of [...data.pairs, ...data.duels]) row.value = null;
    setStore(ids.STUDY_WISH, { clear: true, at: Date.now() });
  },
  /** @param {HTMLElement} on */
  move: (on) => step(Number(on.dataset.by)),
  /** @param {HTMLElement} on */
  answer: (on) => answer(mode() === "vote" ? on.dataset.value ?? "" : Number(on.dataset.value)),
};
/** @param {string[]} names */
const asks = (names) => changeView({ asks: [...new Set(names.filter(Boolean))].join(",") });

document.addEventListener("click", (event) => {
  const on = closest(event, "[data-study]");
  if (on && !on.disabled) ACTS[on.dataset.study ?? ""](on);
});
document.addEventListener("change", (event) => {
  if (targetOf(event).id !== ids.STUDY_NAME) return;
  takePerson({ ...person, name: targetOf(event).value.trim() });
  setStore(ids.STUDY_PERSON, person);
  draw();
});

// Digits belong to the answers while pairs are shown, wherever the focus is but in a field.
document.addEventListener("keydown", (event) => {
  if (!visible() || mode() === "results" || !rows().length || event.ctrlKey || event.metaKey || event.altKey) return;
  if (closest(event, "input:not([type='radio']), textarea, select")) return;
  const key = event.key.toUpperCase();
  let done = true;
  if (mode() === "rate" && /^[0-9]$/.test(key)) answer(key === "0" ? 10 : Number(key));
  else if (mode() === "vote" && VALUES[key]) answer(VALUES[key]);
  else if (key === "BACKSPACE") step(-1);
  else if (key === "N") step(1);
  else done = false;
  if (!done) return;
  event.preventDefault();
  event.stopPropagation();
}, true);
