/* The options of a search: engine, kind of hits, path, filters. Written once, then kept in step with the view. */
import { around, closest, element, find, need, targetOf, within } from "../shared/dom.mjs";
import * as ids from "./ids.mjs";
import { changeSearch, now } from "./state.mjs";

let waiting = 0;

/** @param {string} value @param {string} words */
const option = (value, words) => Object.assign(element("option", "", words), { value });

/** @param {string} words @param {string} of @param {...Node} controls */
function labelled(words, of, ...controls) {
  const label = element("label", "search-label", words);
  label.htmlFor = of;
  return element("div", "search-option", label, ...controls);
}

/** @param {string} id @param {Record<string, any>} attributes */
function input(id, attributes) {
  return Object.assign(element("input", "search-text"), { id, autocomplete: "off", ...attributes });
}

/** @param {HTMLElement} box */
function build(box) {
  const engine = element("select", "search-select", ...now.engines.map(({ value, label }) => option(value, label)));
  engine.id = ids.SEARCH_ENGINE;
  const level = element("select", "search-select", option("clip", "Whole clips"), option("interval", "Moments of clips"));
  level.id = ids.SEARCH_LEVEL;
  const route = Object.assign(element("input", "search-route"), { id: ids.SEARCH_ROUTE, type: "range", min: 0, max: 100, step: 5 });
  const says = element("span", "search-route-says number");
  const label = element("select", "search-select");
  label.id = ids.SEARCH_LABEL;
  const shortest = input(ids.SEARCH_SHORTEST, { type: "number", min: 0, step: 0.1, placeholder: "from" });
  const longest = input(ids.SEARCH_LONGEST, { type: "number", min: 0, step: 0.1, placeholder: "any" });
  longest.setAttribute("aria-label", "At most this many seconds");
  const path = labelled("Path counts", ids.SEARCH_ROUTE, route, says);
  path.title = "How much the way over the ground counts: turning left or right, forwards or backwards";
  box.replaceChildren(
    labelled("Engine", ids.SEARCH_ENGINE, engine),
    labelled("Hits are", ids.SEARCH_LEVEL, level),
    path,
    labelled("Label", ids.SEARCH_LABEL, label),
    labelled("Name has", ids.SEARCH_NAMED, input(ids.SEARCH_NAMED, { type: "search", placeholder: "any clip" })),
    labelled("Seconds", ids.SEARCH_SHORTEST, shortest, element("span", "muted", "to"), longest),
  );
}

export const drawOptions = () => {
  const box = find(ids.SEARCH_OPTIONS);
  if (!box) return;
  if (!box.firstChild) build(box);
  const { view, found, clips } = now;
  const actions = (clips && clips.actions) || [];
  const label = need(ids.SEARCH_LABEL);
  const mark = JSON.stringify(actions);
  if (label.dataset.mark !== mark) {
    label.dataset.mark = mark;
    label.replaceChildren(option("", "any"), ...actions.map((action) => option(action, action)));
  }
  around(label, ".search-option").classList.toggle("hidden", !actions.length);
  const [shortest, longest] = (view.lasting || "-").split("-");
  const values = {
    [ids.SEARCH_ENGINE]: view["search-method"] || "bounded-edit", [ids.SEARCH_LEVEL]: view.level || (found && found.level) || "clip",
    [ids.SEARCH_ROUTE]: view.route || "0", [ids.SEARCH_LABEL]: view.label || "", [ids.SEARCH_NAMED]: view.named || "",
    [ids.SEARCH_SHORTEST]: shortest, [ids.SEARCH_LONGEST]: longest,
  };
  if (!waiting) for (const [id, value] of Object.entries(values)) if (find(id) !== document.activeElement || need(id).tagName === "SELECT") need(id).value = value;
  sayRoute();
  fold();
};

// ---- all of what counts can be folded away: where there is little room it is, once there is a query ----
/** @type {boolean | null} */
let folded = null;
function fold() {
  const [button, box] = [need(ids.SEARCH_COUNTS), need(ids.SEARCH_WANTED)];
  const little = button.clientWidth < 780;
  const closed = folded ?? (little && Boolean(now.view.query));
  button.setAttribute("aria-expanded", String(!closed));
  box.classList.toggle("hidden", closed);
  /** @param {string} id */
  const chosen = (id) => /** @type {any} */ (need(id)).selectedOptions[0]?.textContent;
  const { view } = now;
  const summary = [find(ids.SEARCH_PRESET) && chosen(ids.SEARCH_PRESET), chosen(ids.SEARCH_ENGINE), chosen(ids.SEARCH_LEVEL),
    view.route && `path ${view.route} %`, view.label, view.named && `“${view.named}”`, view.lasting && `${view.lasting} s`];
  need(ids.SEARCH_COUNTS_SAYS).textContent = summary.filter(Boolean).join(" · ");
}
document.addEventListener("click", (event) => {
  const button = closest(event, `#${ids.SEARCH_COUNTS}`);
  if (!button) return;
  folded = button.getAttribute("aria-expanded") === "true";
  fold();
});

function sayRoute() {
  const { value, style } = need(ids.SEARCH_ROUTE);
  style.setProperty("--share", `${value}%`);
  within(document, ".search-route-says").textContent = `${value} %`;
}

function lasting() {
  const [low, high] = [ids.SEARCH_SHORTEST, ids.SEARCH_LONGEST].map((id) => need(id).value.trim());
  return low || high ? `${low}-${high}` : "";
}

/** @param {string} id */
function take(id) {
  const value = find(id) ? need(id).value : "";
  if (id === ids.SEARCH_ENGINE) changeSearch({ "search-method": value === "bounded-edit" ? "" : value });
  else if (id === ids.SEARCH_LEVEL) changeSearch({ level: value, top: "" });
  else if (id === ids.SEARCH_ROUTE) changeSearch({ route: value === "0" ? "" : value });
  else if (id === ids.SEARCH_LABEL) changeSearch({ label: value, top: "" });
  else if (id === ids.SEARCH_NAMED) changeSearch({ named: value.trim(), top: "" });
  else changeSearch({ lasting: lasting(), top: "" });
}

/** @param {HTMLElement} target */
const mine = (target) => target.closest && target.closest(`#${ids.SEARCH_OPTIONS}`);
document.addEventListener("change", (event) => { if (mine(targetOf(event)) && targetOf(event).tagName === "SELECT") take(targetOf(event).id); });
document.addEventListener("input", (event) => {
  if (!mine(targetOf(event)) || targetOf(event).tagName === "SELECT") return;
  if (targetOf(event).id === ids.SEARCH_ROUTE) sayRoute();
  clearTimeout(waiting);
  const { id } = targetOf(event);
  waiting = setTimeout(() => {
    waiting = 0;
    take(id);
  }, 220);
});
