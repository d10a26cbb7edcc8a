/* The blend space of a motif: what is chosen and its weights, in the link and on the Stage. blend_controls.js draws. */
import { changeView, clientside, register, setStore } from "../shared/dash.mjs";
import { find } from "../shared/dom.mjs";
import { player } from "../stage/player.mjs";
import { drawControls, updateControls } from "./blend_controls.mjs";

const OURS = "~blend~";
const WAIT = 300; // milliseconds without a change before the weights go into the link
const SOURCE = { light: "#9aa5b4", dark: "#7c8797" };

let now = null; // {data, body, chosen: motions, values: weights 0 to 1, sources, written: text in the link}
let seen; // what was shown last: the link's weights are those of the motif that is shown first
let writing = 0;

const motionOf = (motion) => now.data.bodies[now.body].motions.find((one) => one.motion === motion);
const sum = (values) => values.reduce((total, value) => total + value, 0);

/** Shares of the chosen motions, of sum 1; all alike where no motion has any weight. */
function shares() {
  const total = sum(now.values);
  return now.values.map((value) => (total > 0 ? value / total : 1 / now.values.length));
}

const rounded = (value) => String(Math.round(value * 100) / 100);
const pairs = (motions, values) => motions.map((motion, i) => `${motion}:${rounded(values[i])}`).join(",");

/** Weights as the link has them; nothing for what one sees at first. */
function linkText() {
  const { data, body, chosen, values } = now;
  const first = body === 0 && chosen.join() === data.bodies[0].chosen.join() && values.every((v) => v === values[0]);
  return first ? "" : pairs(chosen, values);
}

function read(text) {
  const found = [...(text || "").matchAll(/(\d+):([\d.]+)/g)].map(([, motion, value]) => [Number(motion), Math.min(Number(value) || 0, 1)]);
  const body = now.data.bodies.findIndex(({ motions }) => found.length > 1 && found.every(([k]) => motions.some((one) => one.motion === k)));
  if (body < 0) return false;
  const kept = found.slice(0, now.data.most);
  Object.assign(now, { body, chosen: kept.map(([k]) => k), values: kept.map(([, v]) => v), written: text });
  return true;
}

function start(body) {
  const chosen = [...now.data.bodies[body].chosen];
  Object.assign(now, { body, chosen, values: chosen.map(() => even(chosen.length)) });
}

const even = (n) => (n > 3 ? 0.5 : 1 / n);

/** Value at `x` of a curve through rising xs; straight between them. */
function interpolate(x, xs, ys) {
  let k = 1;
  while (k < xs.length - 1 && xs[k] < x) k++;
  const part = (x - xs[k - 1]) / Math.max(xs[k] - xs[k - 1], 1e-9);
  return ys[k - 1] + (ys[k] - ys[k - 1]) * Math.min(Math.max(part, 0), 1);
}

/** For each frame of the mixture the frames of its sources beside it, so that they move in step. */
function inStep(used) {
  const knots = used[0].one.seconds.map((_, i) => i);
  const times = knots.map((i) => sum(used.map(({ one, share }) => share * one.seconds[i])));
  const fps = Math.max(...used.map(({ one }) => one.fps));
  const n = Math.round(times.at(-1) * fps) + 1;
  const at = Array.from({ length: n }, (_, j) => interpolate((j / Math.max(n - 1, 1)) * times.at(-1), times, knots));
  const own = ({ one }) => at.map((u) => Math.min(Math.round(interpolate(u, knots, one.seconds) * one.fps * 100) / 100, one.end - one.start - 1));
  return { mixture: at.map((_, j) => j), sources: used.map(own) };
}

function mixtureName() {
  const used = shares().map((share, i) => [now.chosen[i], share]).filter(([, share]) => rounded(share) !== "0");
  used.sort(([a], [b]) => a - b);
  return `${OURS}${now.data.key}~${now.data.motif}~${pairs(used.map(([k]) => k), used.map(([, share]) => share))}`;
}

function request() {
  const { data } = now;
  const made = { dataset: mixtureName(), clip: "blend", label: "Mixture" };
  const title = `${data.title}: mixture of ${shares().filter((share) => rounded(share) !== "0").length}`;
  if (!now.sources) return { dataset: data.dataset, items: [made], layout: "overlay", sync: "warp", title };
  const used = shares().map((share, i) => ({ share, one: motionOf(now.chosen[i]) })).filter(({ share }) => rounded(share) !== "0");
  const warps = inStep(used);
  const colour = SOURCE[document.documentElement.dataset.mantineColorScheme] || SOURCE.light;
  const items = used.map(({ one }, i) => ({
    clip: one.clip, start: one.start, end: one.end, label: `Motion ${one.motion + 1}`, version: data.version, colour, warp: warps.sources[i],
  }));
  return { dataset: data.dataset, items: [{ ...made, warp: warps.mixture }, ...items], layout: "overlay", sync: "warp", title };
}

const onStage = () => Boolean(player.frameOf(0)?.dataset?.startsWith(OURS));

/** Play the mixture: from its start where something else was shown, else in place of the one before. */
function play() {
  const asked = request();
  if (onStage()) player.replace(asked);
  else player.show(asked);
  const link = find("blend-bvh");
  if (link) link.href = `/api/bvh/${encodeURIComponent(mixtureName())}/blend`;
}

function write() {
  clearTimeout(writing);
  writing = setTimeout(() => {
    if (!now) return;
    now.written = linkText();
    changeView({ weights: now.written });
  }, WAIT);
}

/** Weights changed by hand: numbers follow at once, the Stage as fast as it can, the link when the hand rests. */
function changed() {
  updateControls(now, shares());
  play();
  write();
}

/** Another choice of motions: the controls are drawn anew. */
function chooseAgain(body, chosen, values) {
  Object.assign(now, { body, chosen, values });
  show();
  write();
}

const actions = {
  mean: () => now.values.fill(even(now.values.length)),
  random() {
    const drawn = now.values.map(() => -Math.log(Math.max(Math.random(), 1e-9)));
    const scale = now.values.length > 3 ? Math.max(...drawn) : sum(drawn);
    now.values = drawn.map((value) => Math.round((value / scale) * 100) / 100);
  },
  sources() {
    now.sources = !now.sources;
  },
};

/** What the controls may do. */
const hands = {
  set(values) {
    now.values = values;
    changed();
  },
  body(number) {
    start(number);
    chooseAgain(now.body, now.chosen, now.values);
  },
  add(motion) {
    const chosen = [...now.chosen, motion];
    chooseAgain(now.body, chosen, chosen.map(() => even(chosen.length)));
  },
  remove(motion) {
    const chosen = now.chosen.filter((one) => one !== motion);
    chooseAgain(now.body, chosen, chosen.map(() => even(chosen.length)));
  },
};

document.addEventListener("click", (event) => {
  const button = event.target.closest && event.target.closest("[data-blend]");
  if (!button || !now) return;
  const action = button.dataset.blend;
  if (action === "middles") return player.show(now.data.middles);
  actions[action]();
  if (action === "sources") button.setAttribute("aria-pressed", String(now.sources));
  changed();
});

function show(quiet) {
  const { data } = now;
  find("blend-title").textContent = data.title;
  const body = data.bodies[now.body];
  find("blend-count").textContent = `${now.chosen.length} of ${data.total} motions`;
  const others = data.total - body.motions.length;
  find("blend-note").textContent = others
    ? `${others} of its ${data.total} motions are of other bodies; only motions of one body can be mixed.` : "";
  drawControls(find("blend-controls"), now, shares(), hands);
  if (!quiet) play();
}

function message(text) {
  find("blend-hint").textContent = text;
  find("blend-hint").classList.toggle("hidden", !text);
  find("blend-panel").classList.toggle("hidden", Boolean(text));
}

/** On the way out the motif plays as it is elsewhere. */
function leave(selection) {
  if (now && onStage() && selection) setStore("selection", { ...selection });
  now = null;
}

/** The mixture of a motif that has just come; `linked`: the link's weights may be its own. */
function begin(data, view, selection, linked) {
  now = { data, body: 0, chosen: [], values: [], sources: false, written: "" };
  start(0);
  if (linked && view.weights) read(view.weights);
  else if (view.weights) changeView({ weights: "" });
  const stills = !seen && new URLSearchParams(location.search).get("layout") === "pose"; // so says the link
  show(stills || (selection && selection.motion !== undefined));
  if (stills) player.show(data.middles);
  document.querySelector("[data-blend='sources']").setAttribute("aria-pressed", "false");
}

/** What is there to mix, or why there is nothing. */
function take(data, view, selection) {
  const name = `${data.key} ${data.motif}`;
  const linked = !seen || seen === name;
  if (data.motif === undefined || data.motif === null) {
    now = null;
    message("Choose a motif to mix its motions.");
  } else if (!data.bodies || !data.bodies.length) {
    now = null;
    message("No two motions of this motif are of one body, so there is nothing to mix.");
    if (data.together && seen !== name) player.show(data.together);
  } else {
    message("");
    if (!now || `${now.data.key} ${now.data.motif}` !== name) begin(data, view, selection, linked);
    else if (!find("blend-controls").childElementCount) show(true); // the page came anew
    else if ((view.weights || "") !== now.written && read(view.weights)) show();
  }
  seen = name;
}

register("blend", {
  draw(data, view, _id, selection) {
    if (!view || view.side !== "blend") {
      leave(selection);
      return clientside.no_update;
    }
    if (!data || !find("blend-panel")) return clientside.no_update;
    take(data, view, selection);
    return clientside.no_update;
  },
});
