// The Groups page: what is compared, the answer in words, and what it rests on.
import { changeView, clientside, register } from "../shared/dash.mjs";
import { button } from "../shared/dialogs.mjs";
import { element, find, withAttributes } from "../shared/dom.mjs";
import { ask } from "../shared/server.mjs";
import { percent, plural } from "../shared/words.mjs";
import { player } from "../stage/player.mjs";
import { curveChart, differenceGraph, effectChart, mapChart, nameOf, transitionMatrix } from "./charts.mjs";
import { GROUPS_PLACE } from "./ids.mjs";
/** @import { View } from "../shared/types.d.ts" */
/** @import { Answer, Choices, Comparison, Piece, Row } from "./types.d.ts" */

const POLL = 700; // milliseconds between two questions how far it is
const SHOWN = 24; // rows of the chart at first
const PARTS = /** @type {[string, string][]} */ ([["figure", "Gait and posture"], ["label", "Labels"], ["motif", "Motifs"], ["action", "Actions"], ["routine", "Routines"]]);

/** @type {{ dataset: string, view: Record<string, string>, mark: string, choices: Choices | null, place: HTMLElement | null }} */
const shown = { dataset: "", view: {}, mark: "", choices: null, place: null };
let timer = 0;

register("groups", {
  /** @param {View | null} view @param {string | null} dataset @param {string | null} ended */
  show(view, dataset, ended) {
    const place = find(GROUPS_PLACE);
    if (!place) return clientside.no_update;
    const mark = JSON.stringify([dataset, view, ended]);
    if (place === shown.place && mark === shown.mark) return clientside.no_update;
    const other = place !== shown.place || dataset !== shown.dataset;
    Object.assign(shown, { dataset: dataset ?? "", view: { ...view }, mark, place });
    draw(place, other).catch((error) => place.replaceChildren(element("p", "form-problem", error.message)));
    return clientside.no_update;
  },
});

/** @param {HTMLElement} place @param {boolean} other another dataset or a fresh page */
async function draw(place, other) {
  clearTimeout(timer);
  const { mark, dataset } = shown;
  if (!dataset) {
    place.replaceChildren(element("p", "muted", "Choose a dataset first."));
    return;
  }
  if (other || !shown.choices) shown.choices = await ask(`groups/${encodeURIComponent(dataset)}`);
  if (mark !== shown.mark) return;
  const choices = /** @type {Choices} */ (shown.choices);
  if (!choices.columns.length) {
    place.replaceChildren(nothingKnown(dataset));
    return;
  }
  const result = element("div", "groups-result");
  place.replaceChildren(form(choices), result);
  const { by, first, second } = shown.view;
  if (by && Boolean(first) === Boolean(second)) await look(result, mark);
  else if (by) result.append(element("p", "muted", "Choose the other group as well, or all for both."));
  else result.append(element("p", "muted", "Choose the property that makes the groups, such as condition or session."));
}

/** @param {string} dataset */
const nothingKnown = (dataset) => element("div", "empty-state", element("h2", "", "Nothing is known of the clips yet"),
  element("p", "muted", "Groups are made of properties of clips: who moves, in which condition, in which session. They come from a table, from the names of the clips, or by hand."),
  withAttributes(button("Properties of clips", () => undefined, "primary for-editors"), { "data-properties": dataset }));

/** @param {Choices} choices */
function form(choices) {
  const { view } = shown;
  const column = choices.columns.find(({ name }) => name === view.by);
  const values = /** @type {[string, string][]} */ ((column?.values ?? []).map(([value, count]) => [value, `${value} (${count})`]));
  const others = /** @type {[string, string][]} */ (choices.columns.filter(({ name }) => name !== view.by).map(({ name }) => [name, name]));
  return element("div", "card groups-form",
    pick("Groups by", "by", [["", "choose ..."], .../** @type {[string, string][]} */ (choices.columns.map(({ name }) => [name, name]))], { first: "", second: "" }),
    pick("First group", "first", [["", "all"], ...values]),
    pick("Second group", "second", [["", "all"], ...values]),
    pick("Who moves", "who", [["", choices.who && choices.who !== view.by ? choices.who : "found by name"], ...others, ["-", "not known: clips"]]),
    pick("Counted", "counted", [["", choices.labels ? "labels" : "motifs"], ["motifs", "motifs"], ["grammar", "actions"], ...(choices.labels ? /** @type {[string, string][]} */ ([["labels", "labels"]]) : [])]),
    pick("Paired", "paired", [["", "found by itself"], ["yes", "yes"], ["no", "no"]]));
}

/** @param {string} label @param {string} key @param {[string, string][]} choices @param {Record<string, string>} [also] */
function pick(label, key, choices, also = {}) {
  const now = shown.view[key] ?? "";
  const offered = choices.some(([value]) => value === now) ? choices : [...choices, /** @type {[string, string]} */ ([now, `${now} (gone)`])];
  const control = element("select", "boards-select", ...offered.map(([value, words]) => withAttributes(element("option", "", words), { value })));
  control.value = now;
  control.addEventListener("change", () => changeView({ ...also, [key]: control.value }));
  return element("label", "groups-field", element("span", "muted", label), control);
}

const query = () => new URLSearchParams(Object.entries(shown.view).filter(([, value]) => value)).toString();
const address = () => `groups/${encodeURIComponent(shown.dataset)}`;

/** Show how far the comparison is, until it is there. @param {HTMLElement} result @param {string} mark */
async function look(result, mark) {
  /** @type {Answer} */
  let answer;
  try {
    answer = await ask(`${address()}/comparison?${query()}`);
  } catch (error) {
    answer = { state: "failed", error: error instanceof Error ? error.message : String(error) };
  }
  if (mark !== shown.mark || !result.isConnected) return;
  const { state, document: made, stage = "", fraction = 0, error = "" } = answer;
  if (state === "ready" && made) {
    result.replaceChildren(...drawResult(made));
    return;
  }
  const begin = button("Compare", async () => {
    await ask(`${address()}/comparison`, Object.fromEntries(Object.entries(shown.view))).catch((problem) => result.prepend(element("p", "form-problem", problem.message)));
    look(result, mark);
  }, "primary for-editors");
  if (state === "running") {
    const bar = element("progress", "boards-progress");
    bar.value = fraction;
    result.replaceChildren(element("p", "muted", `${stage}, ${percent(fraction)}`), bar);
    timer = window.setTimeout(() => look(result, mark), POLL);
  } else if (state === "refused") result.replaceChildren(withAttributes(element("p", "groups-refused", error), { role: "alert" }));
  else if (state === "failed") result.replaceChildren(withAttributes(element("p", "form-problem", error), { role: "alert" }), begin);
  else result.replaceChildren(element("p", "muted", "This comparison has not been made yet."), begin);
}

/** @param {Comparison} made */
function* drawResult(made) {
  const { unit } = made;
  const rows = made.comparisons;
  const found = (/** @type {{ kind?: string, id?: string, measure?: string, text: string }} */ one) => rows.find((row) => row.kind === one.kind && row.id === one.id && row.measure === one.measure && (!row.words || one.text.toLowerCase().startsWith(row.groups[1].toLowerCase())));
  yield element("section", "card groups-answer",
    element("h2", "", "In words"),
    element("p", "groups-who", ...made.groups.map((group, k) => withAttributes(element("span", "groups-group", `${group.name}: ${plural(group.units, unit)}, ${group.minutes.toFixed(1)} min`), { "data-group": String(Math.min(k, 2)) }))),
    element("ul", "groups-words", ...made.words.map((one) => {
      const row = found(one);
      return element("li", "", row?.examples ? button(one.text, () => play(row), "groups-sentence") : one.text);
    })),
    ...made.remarks.map((remark) => element("p", "muted", remark)),
    element("p", "muted", `Test: ${made.test}, two-sided. Corrected: ${made.correction}. Effect: ${made.effect}. A click plays typical and extreme motion of both groups in step.`),
    element("p", "groups-files", ...[["csv", "Table (CSV)"], ["json", "Result (JSON)"], ["py", "Python"], ["sh", "Command"]].map(([kind, words]) => withAttributes(element("a", "boards-button", words), { href: `/api/${address()}/${kind}.file?${query()}`, download: "" }))));
  const pairs = [...new Set(rows.map((row) => row.groups.join(" → ")))];
  for (const pair of pairs) {
    const own = rows.filter((row) => row.groups.join(" → ") === pair);
    for (const [kind, title] of PARTS) {
      const some = own.filter((row) => row.kind === kind && row.effect !== null).sort((a, b) => Number(b.significant) - Number(a.significant) || Math.abs(b.effect ?? 0) - Math.abs(a.effect ?? 0));
      if (some.length) yield chartOf(`${title}, ${pair}`, some);
    }
    const ways = made.transitions.filter((row) => row.groups.join(" → ") === pair && row.difference !== null);
    if (ways.length) yield element("section", "card", element("h2", "", `What follows what, ${pair}`), element("p", "muted", "The stronger the colour, the larger the difference of the probability; outlined where it is beyond chance. Arrows: differences of at least 10 %."), element("div", "groups-pair", differenceGraph(ways, play), transitionMatrix(ways, play)));
    const place = (made.map ?? []).find((one) => one.groups.join(" → ") === pair);
    if (place) yield element("section", "card", element("h2", "", `Postures on the motion map, ${pair}`), element("p", "muted", place.clusters.length ? "Coloured by who is there more often; outlined where that is beyond chance." : "Coloured by who is there more often; nowhere beyond chance."), mapChart(place));
    const curves = made.curves.filter((curve) => curve.groups.join(" → ") === pair).sort((a, b) => a.q - b.q);
    if (curves.length) yield curvesOf(pair, curves);
  }
}

/** @param {string} title @param {Row[]} rows */
function chartOf(title, rows) {
  const section = element("section", "card", element("h2", "", title), effectChart(rows.slice(0, SHOWN), play));
  if (rows.length > SHOWN) {
    const more = button(`All ${rows.length}`, () => section.replaceChildren(element("h2", "", title), effectChart(rows, play)));
    section.append(more);
  }
  return section;
}

/** @param {string} pair @param {import("./types.d.ts").Curve[]} curves */
function curvesOf(pair, curves) {
  const items = [...new Set(curves.map(({ item }) => item))];
  const charts = element("div", "groups-curves");
  const choice = element("select", "boards-select", ...items.map((item) => withAttributes(element("option", "", /^\d+$/.test(item) ? `motif ${item}` : item), { value: item })));
  choice.setAttribute("aria-label", "Movement");
  const fill = () => charts.replaceChildren(...curves.filter(({ item }) => item === choice.value).map(curveChart));
  choice.addEventListener("change", fill);
  fill();
  return element("section", "card", element("h2", "", `Curves, ${pair}`), element("p", "muted", "Mean and standard deviation over subjects, from the beginning of the movement to its end; shaded where the curves differ beyond chance."), choice, charts);
}

/** Typical and extreme motion of both groups, in step. @param {Row} row */
function play(row) {
  const pieces = row.groups.flatMap((group) => /** @type {["typical", "extreme"]} */ (["typical", "extreme"]).map((kind) => ({ group, kind, piece: row.examples?.[group]?.[kind] ?? null })));
  const items = pieces.filter(({ piece }, k) => piece && pieces.findIndex((one) => String(one.piece) === String(piece)) === k).map(({ group, kind, piece }) => {
    const [clip, start, end] = /** @type {NonNullable<Piece>} */ (piece);
    return { clip, start, end, label: `${group}, ${kind}` };
  });
  if (items.length) player.show({ dataset: shown.dataset, title: nameOf(row), items, layout: "side", sync: "start" });
}
