/* A posture shaped by hand: joints are dragged in three views, bones keep their lengths, and the nearest node follows. */
import { allWithin, closest, element, need, svgElement, within } from "../shared/dom.mjs";
import { SHELL } from "../shared/ids.mjs";
import { dragJoint } from "./bones.mjs";
import { drawFigure, figurePicture, jointOf, VIEWS } from "./figure.mjs";
import * as ids from "./ids.mjs";
import { state } from "./state.mjs";
/** @import { MapData } from "./data.mjs" */
/** @import { Point, Posture } from "./types.d.ts" */

// what a drag in a view does: [right, down] of the screen as directions of the body
/** @type {Record<string, [Point, Point]>} */
const AXES = { front: [[1, 0, 0], [0, -1, 0]], side: [[0, 0, 1], [0, -1, 0]], top: [[1, 0, 0], [0, 0, 1]] };
const BOX = [-1, -1.05, 2, 2.1];
/**
 * The posture that is edited, the original, and what is done with the result.
 * @type {{ map: MapData, posture: Posture, start: Posture, key: number, joint: number, change: (keys: number[]) => void, node: number, distance: number }}
 */
let edited;

/** Which of AXES a drawing shows. @param {Element} svg */
const viewOf = (svg) => /** @type {HTMLElement} */ (svg.parentNode).dataset.view ?? "front";

/** @param {string} role @param {string} name */
const NAMES = (role, name) => (role || name).replace(/_/g, " ");

function dialog() {
  const there = /** @type {HTMLDialogElement | null} */ (document.getElementById(ids.MAP_EDITOR));
  if (there) return there;
  const box = element("dialog", "map-editor card");
  box.id = ids.MAP_EDITOR;
  box.setAttribute("aria-labelledby", ids.MAP_EDITOR_TITLE);
  const title = element("h2", "", "Shape a posture");
  title.id = ids.MAP_EDITOR_TITLE;
  const hint = element("p", "muted", "Drag a joint in any view, or choose one and use the arrow keys; bones keep their lengths.");
  const views = element("div", "map-editor-views");
  for (const view of Object.keys(AXES)) {
    const figure = element("figure", "map-view");
    figure.dataset.view = view;
    figure.append(svgElement("svg", { viewBox: BOX.join(" "), class: "map-picture map-editor-picture" }), element("figcaption", "muted", view));
    views.append(figure);
  }
  const status = element("div", "map-editor-status number muted");
  status.setAttribute("role", "status");
  const foot = element("div", "map-editor-foot");
  const nearest = element("div", "map-editor-nearest");
  const actions = element("div", "map-editor-actions");
  for (const [label, action, main] of [["Cancel", "cancel", ""], ["As it was", "reset", ""], ["Use as key", "use", "main"]]) {
    const button = element("button", `map-button ${main}`.trim(), label);
    button.type = "button";
    button.dataset.editor = action;
    actions.append(button);
  }
  foot.append(nearest, status, actions);
  box.append(title, hint, views, foot);
  need(SHELL).append(box);
  listen(box);
  return box;
}

/** @param {HTMLDialogElement} box */
function listen(box) {
  /** @type {{ svg: SVGSVGElement, joint: number, view: string, from: number[], start: Point } | null} */
  let held = null;
  /** @param {SVGSVGElement} svg @param {PointerEvent} event */
  const place = (svg, event) => {
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()?.inverse());
    return [x, y];
  };
  box.addEventListener("pointerdown", (event) => {
    const handle = /** @type {SVGElement | null} */ (/** @type {Element | null} */ (closest(event, ".map-joint")));
    if (!handle) return;
    const svg = /** @type {SVGSVGElement} */ (handle.ownerSVGElement);
    const joint = Number(handle.dataset.joint);
    held = { svg, joint, view: viewOf(svg), from: place(svg, event), start: jointOf(edited.posture, joint) };
    edited.joint = joint;
    svg.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  box.addEventListener("pointermove", (event) => {
    if (!held) return;
    const { joint, start, from, svg, view } = held;
    const [x, y] = place(svg, event), [right, down] = AXES[view];
    move(joint, start.map((v, k) => v + (x - from[0]) * right[k] + (y - from[1]) * down[k]));
  });
  box.addEventListener("pointerup", () => { held = null; });
  box.addEventListener("keydown", (event) => {
    const handle = /** @type {SVGElement | null} */ (/** @type {Element | null} */ (closest(event, ".map-joint")));
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!handle || !step) return;
    event.preventDefault();
    event.stopPropagation();
    const view = viewOf(/** @type {SVGSVGElement} */ (handle.ownerSVGElement)), joint = Number(handle.dataset.joint);
    const [right, down] = AXES[view], from = jointOf(edited.posture, joint);
    move(joint, from.map((v, k) => v + 0.04 * (step[0] * right[k] + step[1] * down[k])));
    within(box, `[data-view="${view}"] .map-joint[data-joint="${joint}"]`).focus();
  });
  box.addEventListener("click", (event) => {
    const action = closest(event, "[data-editor]")?.dataset.editor;
    if (action === "cancel") box.close();
    if (action === "reset") {
      edited.posture = edited.start;
      draw();
    }
    if (action === "use") {
      const { node, key, change } = edited, { keys } = state;
      box.close();
      change(key < 0 ? [...keys, node] : keys.map((old, k) => (k === key ? node : old)));
    }
  });
}

/** @param {number} joint @param {Point} goal */
function move(joint, goal) {
  edited.posture = dragJoint(edited.map, edited.posture, joint, goal);
  draw();
}

function draw() {
  const { map, posture } = edited, box = dialog();
  for (const figure of allWithin(box, "[data-view]")) {
    const svg = within(figure, "svg"), view = figure.dataset.view ?? "", see = VIEWS[view];
    const handles = map.parents.map((_, j) => {
      const [x, y] = see(jointOf(posture, j));
      const handle = svgElement("circle", { cx: x.toFixed(3), cy: y.toFixed(3), r: 0.045, class: "map-joint", tabindex: "0", role: "button", "data-joint": j });
      handle.setAttribute("aria-label", `${NAMES(map.roles[j], map.joints[j])}, ${view}`);
      const title = svgElement("title");
      title.textContent = NAMES(map.roles[j], map.joints[j]);
      handle.append(title);
      return handle;
    });
    svg.replaceChildren(drawFigure(map, posture, view), ...handles);
  }
  const { node, distance } = map.nearest(posture);
  Object.assign(edited, { node, distance });
  const far = distance > 2.5 * map.usual;
  within(box, ".map-editor-status").textContent = `Nearest posture on the map: ${distance.toFixed(2)} m away${far ? ", so nothing there is like this" : ""}`;
  within(box, ".map-editor-nearest").replaceChildren(figurePicture(map, map.posture(node), "icon"));
  state.overlay.squares("cursor", [node]);
}

/**
 * Open the editor on a node's posture; `change(keys)` gets the keys with it in place of number `key`, or added where that is -1.
 * @param {number} node
 * @param {number} key
 * @param {(keys: number[]) => void} change
 */
export function editPosture(node, key, change) {
  const { map } = state;
  const posture = map.posture(node);
  edited = { map, posture, start: posture, key, change, joint: -1, node, distance: 0 };
  dialog();
  draw();
  dialog().showModal();
}

export const editedPosture = () => edited;
