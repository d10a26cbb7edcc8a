/* The body editor: a skeleton from the front and from the side, and a row for each part of the body. */
import { clientside, register, setStore } from "../shared/dash.mjs";
import { closest, element, find, svgElement, targetOf } from "../shared/dom.mjs";
import { save } from "../shared/save.mjs";
import * as ids from "./ids.mjs";
/** @import { BodyPosture, BodyRig, BodyRigs, BodySaid } from "./ids.mjs" */

const VIEWS = /** @type {const} */ (["front", "side"]);
const KINDS = [["", "Find out"], ["human", "A person"], ["partial", "Part of a person"], ["other", "No person: an animal, a prop"]];

/** What is edited: the rigs, the posture that is drawn, what is said of each rig and was said before each step, the part
 * that is chosen.
 * @type {{ rigs: BodyRigs | null, posture: BodyPosture | null, draft: BodySaid[], before: BodySaid[][], part: string }} */
const edited = { rigs: null, posture: null, draft: [], before: [], part: "pelvis" };

/** @returns {[BodyRig, BodySaid] | null} */
function current() {
  const number = edited.posture?.rig ?? 0;
  const rig = edited.rigs?.rigs[number];
  return rig ? [rig, edited.draft[number]] : null;
}

/** The joint of a part, null where it has none. @param {BodyRig} rig @param {BodySaid} said @param {string} part */
const jointOf = (rig, said, part) => (part in said.joints ? said.joints[part] : rig.joints[part] ?? null);

/** What is said of each rig before anyone changes it; of an animal, what is suggested.
 * @param {BodyRigs} rigs @returns {BodySaid[]} */
const untouched = (rigs) =>
  rigs.rigs.map((rig) => ({ changed: false, joints: { ...rig.suggested, ...rig.said }, body: rig.said_body }));

/** Says that a part is this joint, or none; another part that was this joint has none from now on.
 * @param {string} part @param {string | null} joint */
function assign(part, joint) {
  const here = current();
  if (!here || !edited.rigs) return;
  const [rig, said] = here;
  if (jointOf(rig, said, part) === joint) return;
  remember();
  for (const other of edited.rigs.parts) {
    if (joint !== null && other !== part && jointOf(rig, said, other) === joint) said.joints[other] = null;
  }
  said.joints[part] = joint;
  said.changed = true;
  tell();
}

const remember = () => { edited.before.push(structuredClone(edited.draft)); };

function tell() {
  setStore(ids.BODY_DRAFT, { dataset: edited.rigs?.dataset ?? "", rigs: edited.draft });
  draw();
}

/** @param {string} part */
const words = (part) => (part[0].toUpperCase() + part.slice(1)).replace("_", " ");
/** @param {string} part */
const sideOf = (part) => (part.includes("_") ? part.split("_")[0] : "centre");

/** @param {BodyRig} rig @param {BodySaid} said @param {number[][]} places @param {string} view */
function drawing(rig, said, places, view) {
  const svg = svgElement("svg", { viewBox: "0 0 100 150", class: "body-drawing", role: "img", "aria-label": `Skeleton, ${view}` });
  rig.parents.forEach((parent, j) => {
    if (parent < 0) return;
    const [[x1, y1], [x2, y2]] = [places[parent], places[j]];
    svg.append(svgElement("line", { x1, y1, x2, y2, class: "body-bone" }));
  });
  /** @type {Record<string, string>} */
  const partOf = {};
  for (const part of edited.rigs?.parts ?? []) {
    const joint = jointOf(rig, said, part);
    if (joint !== null) partOf[joint] = part;
  }
  /** Later is drawn above: seen from its left, the left side. @param {number} j */
  const rank = (j) => {
    const part = partOf[rig.names[j]];
    return part === undefined ? 0 : part === edited.part ? 3 : view === "side" && sideOf(part) === "left" ? 2 : 1;
  };
  const order = rig.names.map((_, j) => j).sort((a, b) => rank(a) - rank(b));
  for (const j of order) {
    if (rig.ends[j]) continue;
    const name = rig.names[j];
    const part = partOf[name];
    const chosen = part !== undefined && part === edited.part;
    const looks = `body-joint ${part ? `known side-${sideOf(part)}` : ""} ${chosen ? "chosen" : ""}`;
    const spot = svgElement("circle", { cx: places[j][0], cy: places[j][1], r: chosen ? 2.8 : part ? 2 : 1.3, class: looks, "data-joint": name });
    spot.append(svgElement("title", {}, part ? `${name}: ${words(part).toLowerCase()}` : name));
    svg.append(spot);
  }
  const caption = element("figcaption", "muted", view === "front" ? "From the front" : "From its left");
  const figure = element("figure", "body-view");
  figure.append(svg, caption);
  return figure;
}

/** @param {[string, string][] | string[][]} options @param {string} value @param {string} label */
function select(options, value, label) {
  const made = element("select", "body-select");
  made.setAttribute("aria-label", label);
  for (const [key, text] of options) {
    const option = element("option", "", text);
    option.value = key;
    made.append(option);
  }
  made.value = value;
  return made;
}

/** @param {BodyRig} rig @param {BodySaid} said */
function list(rig, said) {
  const rows = element("div", "body-parts");
  const kind = element("div", "body-part body-kind");
  const is = (KINDS.find(([key]) => key === rig.body) ?? KINDS[3])[1].toLowerCase();
  const found = KINDS.map(([key, text]) => [key, key || rig.said_body ? text : `${text} (${is})`]);
  const kinds = select(found, said.body ?? "", "Kind of body");
  kinds.dataset.kind = "yes";
  kind.append(element("span", "body-name", "Kind of body"), kinds);
  rows.append(kind);
  if (Object.keys(rig.suggested).length && !said.changed) {
    const take = element("button", "body-take", "Take these suggestions");
    take.type = "button";
    take.dataset.body = "take";
    rows.append(take);
  }
  const joints = rig.names.filter((_, j) => !rig.ends[j]).map((name) => [name, name]);
  for (const part of edited.rigs?.parts ?? []) {
    const row = element("div", `body-part side-${sideOf(part)}` + (part === edited.part ? " chosen" : ""));
    row.dataset.part = part;
    const button = element("button", "body-name", words(part));
    button.type = "button";
    button.setAttribute("aria-pressed", String(part === edited.part));
    row.append(button, select([["", "none"], ...joints], jointOf(rig, said, part) ?? "", words(part)));
    rows.append(row);
  }
  return rows;
}

function draw() {
  const box = find(ids.BODY_EDITOR);
  const here = current();
  if (!box || !here || !edited.posture) return;
  const [rig, said] = here;
  const posture = edited.posture;
  if (posture.front.length !== rig.names.length) return;
  const label = find(ids.BODY_FRAME_LABEL);
  if (label) label.textContent = posture.frame < 0 ? "Rest pose" : `Frame ${posture.frame} of ${posture.clip}`;
  const scrolled = box.querySelector(".body-parts")?.scrollTop ?? 0;
  const focused = closest({ target: document.activeElement }, ".body-part[data-part]");
  const drawings = element("div", "body-drawings");
  drawings.append(...VIEWS.map((view) => drawing(rig, said, posture[view], view)));
  const rows = list(rig, said);
  box.replaceChildren(drawings, rows);
  rows.scrollTop = scrolled;
  if (focused) /** @type {HTMLElement | null} */ (rows.querySelector(`[data-part="${edited.part}"] select`))?.focus();
}

document.addEventListener("click", (event) => {
  if (dragged) return void (dragged = false); // the end of a drag is no click
  const joint = closest(event, ".body-joint");
  if (joint) return assign(edited.part, joint.dataset.joint ?? null);
  const action = closest(event, "[data-body]")?.dataset.body;
  if (action === "import") open();
  if (action === "export") exportAll();
  if (action === "take") {
    const here = current();
    if (here) {
      remember();
      here[1].changed = true;
      tell();
    }
  }
  if (action === "back") {
    edited.draft = edited.before.pop() ?? edited.draft;
    tell();
  }
  if (action === "reset" && edited.rigs) {
    remember();
    edited.draft = untouched(edited.rigs);
    tell();
  }
});
for (const kind of ["focusin", "click"]) {
  document.addEventListener(kind, (event) => {
    const part = closest(event, ".body-part[data-part]")?.dataset.part;
    if (!part || part === edited.part) return;
    edited.part = part;
    light();
  });
}
document.addEventListener("change", (event) => {
  const control = targetOf(event);
  const row = closest(event, ".body-part");
  const here = current();
  if (!row || !here) return;
  if (row.dataset.part) {
    edited.part = row.dataset.part;
    return assign(edited.part, control.value || null);
  }
  remember();
  Object.assign(here[1], { body: control.value || null, changed: true });
  tell();
});

/* Dragging: a part from the list, or from the joint that it is, onto another joint of a drawing. */
const FAR = 5; // pixels from which a press that moves is a drag
const NEAR = 26; // pixels within which a joint is taken
/** Whether the pointer was let go after a drag: the click that follows is none. */
let dragged = false;

/** The joint next to a place on the screen, null where none is near. @param {number} x @param {number} y */
function jointNear(x, y) {
  let nearest = null;
  let least = NEAR;
  for (const spot of document.querySelectorAll(".body-drawing circle")) {
    const box = spot.getBoundingClientRect();
    const away = Math.hypot(box.x + box.width / 2 - x, box.y + box.height / 2 - y);
    if (away < least) [nearest, least] = [spot, away];
  }
  return nearest;
}

/** The part that a press takes hold of. @param {Event} event */
function held(event) {
  const here = current();
  const joint = closest(event, ".body-joint.known")?.dataset.joint;
  if (here && joint) return edited.rigs?.parts.find((part) => jointOf(...here, part) === joint);
  return closest(event, "button.body-name") ? closest(event, ".body-part[data-part]")?.dataset.part : undefined;
}

document.addEventListener("pointerdown", (event) => {
  dragged = false;
  const part = event.button ? undefined : held(event);
  if (part) drag(part, event);
});

/** Follows the pointer until it is let go. @param {string} part @param {PointerEvent} start */
function drag(part, start) {
  const label = element("div", "body-dragged", words(part));
  /** @type {Element | null} */
  let target = null;
  /** @param {PointerEvent} event */
  const move = (event) => {
    if (!label.isConnected) {
      if (Math.hypot(event.x - start.x, event.y - start.y) < FAR) return;
      document.body.append(label);
      edited.part = part;
      light();
    }
    event.preventDefault();
    label.style.transform = `translate(${event.x + 12}px, ${event.y + 12}px)`;
    target?.classList.remove("target");
    target = jointNear(event.x, event.y);
    target?.classList.add("target");
  };
  /** @param {PointerEvent} event */
  const end = (event) => {
    for (const [kind, listener] of /** @type {const} */ ([["pointermove", move], ["pointerup", end], ["pointercancel", end]])) {
      document.removeEventListener(kind, /** @type {EventListener} */ (listener));
    }
    dragged = label.isConnected;
    label.remove();
    target?.classList.remove("target");
    if (dragged && target && event.type === "pointerup") assign(part, target.getAttribute("data-joint"));
  };
  document.addEventListener("pointermove", move);
  document.addEventListener("pointerup", end);
  document.addEventListener("pointercancel", end);
}

/** Lights the joint of the chosen part; an open list of joints stays open. */
function light() {
  const box = find(ids.BODY_EDITOR);
  const here = current();
  if (!box || !here) return;
  const joint = jointOf(...here, edited.part);
  for (const row of box.querySelectorAll(".body-part[data-part]")) {
    const chosen = row.getAttribute("data-part") === edited.part;
    row.classList.toggle("chosen", chosen);
    row.querySelector("button")?.setAttribute("aria-pressed", String(chosen));
  }
  for (const spot of box.querySelectorAll("circle")) {
    const chosen = spot.getAttribute("data-joint") === joint;
    spot.classList.toggle("chosen", chosen);
    spot.setAttribute("r", chosen ? "2.8" : spot.classList.contains("known") ? "2" : "1.3");
  }
}

function open() {
  const chooser = document.createElement("input");
  chooser.type = "file";
  chooser.accept = ".json,application/json";
  chooser.onchange = async () => {
    const file = chooser.files?.[0];
    if (file) setStore(ids.BODY_FILE, { text: await file.text(), at: Date.now() });
  };
  chooser.click();
}

function exportAll() {
  if (!edited.rigs) return;
  const { format, parts, rigs, dataset } = edited.rigs;
  const said = rigs.map((rig, k) => ({
    rig: rig.names,
    body: edited.draft[k].body,
    joints: Object.fromEntries(parts.map((part) => [part, jointOf(rig, edited.draft[k], part)])),
  }));
  save(JSON.stringify({ format, rigs: said }, null, 1) + "\n", `${dataset} bodies.json`, "application/json");
}

register("body", {
  /** @param {BodyRigs | null} rigs @param {BodyPosture | null} posture */
  show(rigs, posture) {
    if (rigs && rigs !== edited.rigs && JSON.stringify(rigs) !== JSON.stringify(edited.rigs)) {
      edited.rigs = rigs;
      edited.draft = untouched(rigs);
      edited.before = [];
      setStore(ids.BODY_DRAFT, null);
    }
    edited.posture = posture;
    draw();
    return clientside.no_update;
  },
  /** @param {import("./ids.mjs").BodyFilled | null} filled */
  fill(filled) {
    if (filled) remember();
    filled?.rigs.forEach((said, k) => {
      if (said && edited.draft[k]) edited.draft[k] = { changed: true, joints: said.joints, body: said.body };
    });
    if (filled) tell();
    return clientside.no_update;
  },
});
