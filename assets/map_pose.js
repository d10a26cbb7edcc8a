/* A posture shaped by hand: joints are dragged in three views, bones keep their lengths, and the nearest node follows. */
(function () {
  "use strict";
  const parts = (window.motionscapeMapParts ||= {});
  // what a drag in a view does: [right, down] of the screen as directions of the body
  const AXES = { front: [[1, 0, 0], [0, -1, 0]], side: [[0, 0, 1], [0, -1, 0]], top: [[1, 0, 0], [0, 0, 1]] };
  const BOX = [-1, -1.05, 2, 2.1];
  let edited = null; // {map, posture, start, key, joint}

  /** Joints from the end of a limb (or the trunk) up to where it is fixed: the dragged one first. */
  function chainOf(map, joint) {
    const chain = [joint];
    const trunk = (j) => j < 0 || /^(chest|spine|neck|head)$|_(clavicle|shoulder|hip)$/.test(map.roles[j]);
    const inTrunk = trunk(joint);
    for (let j = map.parents[joint]; ; j = map.parents[j]) {
      chain.push(j);
      if (j < 0 || (!inTrunk && trunk(j))) return chain;
    }
  }

  /** Move a joint towards a place: the chain bends (FABRIK), its end stays; what hangs on a bone turns with it. */
  function drag(map, posture, joint, goal) {
    const chain = chainOf(map, joint);
    const at = chain.map((j) => [...parts.jointOf(posture, j)]);
    const bones = chain.slice(0, -1).map((j) => map.lengths[j]);
    const fixed = [...at[at.length - 1]];
    const toward = (from, to, length, otherwise) => {
      let way = to.map((v, k) => v - from[k]), size = Math.hypot(...way);
      if (size < 1e-9) [way, size] = [otherwise, Math.hypot(...otherwise) || 1];
      return from.map((v, k) => v + (length * way[k]) / size);
    };
    const before = at.map((point) => [...point]);
    for (let round = 0; round < 12; round++) {
      at[0] = [...goal];
      for (let k = 1; k < at.length; k++) at[k] = toward(at[k - 1], at[k], bones[k - 1], [0, 1, 0]);
      at[at.length - 1] = [...fixed];
      for (let k = at.length - 2; k >= 0; k--) at[k] = toward(at[k + 1], at[k], bones[k], [0, 1, 0]);
    }
    const moved = Float64Array.from(posture);
    const turns = new Map(); // joint -> how its bone has turned
    chain.slice(0, -1).forEach((j, k) => {
      at[k].forEach((v, d) => (moved[3 * j + d] = v));
      turns.set(j, turn(before[k].map((v, d) => v - before[k + 1][d]), at[k].map((v, d) => v - at[k + 1][d])));
    });
    map.parents.forEach((parent, j) => { // parents come first: a joint off the chain hangs on a moved one
      if (turns.has(j) || !turns.has(parent)) return;
      turns.set(j, turns.get(parent));
      const bone = turns.get(parent)([0, 1, 2].map((d) => posture[3 * j + d] - posture[3 * parent + d]));
      bone.forEach((v, d) => (moved[3 * j + d] = moved[3 * parent + d] + v));
    });
    return map.withBones(moved);
  }

  /** The smallest rotation that takes one direction to another, as a function of vectors (Rodrigues). */
  function turn(from, to) {
    const unit = (v) => v.map((x) => x / (Math.hypot(...v) || 1));
    const [a, b] = [unit(from), unit(to)];
    const axis = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const scale = 1 / Math.max(1 + cosine, 1e-6);
    return (v) => {
      const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
      const once = cross(axis, v), twice = cross(axis, once);
      return v.map((x, k) => x + once[k] + scale * twice[k]);
    };
  }

  const NAMES = (role, name) => (role || name).replace(/_/g, " ");
  const element = (name, className, text) => {
    const made = document.createElement(name);
    if (className) made.className = className;
    if (text !== undefined) made.textContent = text;
    return made;
  };

  function dialog() {
    let box = document.getElementById("map-editor");
    if (box) return box;
    box = element("dialog", "map-editor card");
    box.id = "map-editor";
    box.setAttribute("aria-labelledby", "map-editor-title");
    const title = element("h2", "", "Shape a posture");
    title.id = "map-editor-title";
    const hint = element("p", "muted", "Drag a joint in any view, or choose one and use the arrow keys; bones keep their lengths.");
    const views = element("div", "map-editor-views");
    for (const view of Object.keys(AXES)) {
      const figure = element("figure", "map-view");
      figure.dataset.view = view;
      figure.append(parts.svgElement("svg", { viewBox: BOX.join(" "), class: "map-picture map-editor-picture" }), element("figcaption", "muted", view));
      views.append(figure);
    }
    const said = element("div", "map-editor-said number muted");
    said.setAttribute("role", "status");
    const foot = element("div", "map-editor-foot");
    const nearest = element("div", "map-editor-nearest");
    const actions = element("div", "map-editor-actions");
    for (const [label, action, main] of [["Cancel", "cancel"], ["As it was", "reset"], ["Use as key", "use", true]]) {
      const button = element("button", main ? "map-button main" : "map-button", label);
      button.type = "button";
      button.dataset.editor = action;
      actions.append(button);
    }
    foot.append(nearest, said, actions);
    box.append(title, hint, views, foot);
    document.getElementById("shell").append(box);
    listen(box);
    return box;
  }

  function listen(box) {
    let held = null;
    const place = (svg, event) => {
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      return [x, y];
    };
    box.addEventListener("pointerdown", (event) => {
      const handle = event.target.closest(".map-joint");
      if (!handle) return;
      const svg = handle.ownerSVGElement;
      held = { svg, joint: Number(handle.dataset.joint), view: svg.parentNode.dataset.view, from: place(svg, event) };
      held.start = parts.jointOf(edited.posture, held.joint);
      edited.joint = held.joint;
      svg.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    box.addEventListener("pointermove", (event) => {
      if (!held) return;
      const [x, y] = place(held.svg, event), [right, down] = AXES[held.view];
      move(held.joint, held.start.map((v, k) => v + (x - held.from[0]) * right[k] + (y - held.from[1]) * down[k]));
    });
    box.addEventListener("pointerup", () => { held = null; });
    box.addEventListener("keydown", (event) => {
      const handle = event.target.closest(".map-joint");
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!handle || !step) return;
      event.preventDefault();
      event.stopPropagation();
      const view = handle.ownerSVGElement.parentNode.dataset.view, joint = Number(handle.dataset.joint);
      const [right, down] = AXES[view], from = parts.jointOf(edited.posture, joint);
      move(joint, from.map((v, k) => v + 0.04 * (step[0] * right[k] + step[1] * down[k])));
      box.querySelector(`[data-view="${view}"] .map-joint[data-joint="${joint}"]`)?.focus();
    });
    box.addEventListener("click", (event) => {
      const action = event.target.closest("[data-editor]")?.dataset.editor;
      if (action === "cancel") box.close();
      if (action === "reset") {
        edited.posture = edited.start;
        draw();
      }
      if (action === "use") {
        const { node, key } = edited, { keys } = window.motionscapeMap.state;
        box.close();
        window.motionscapeMap.setKeys(key < 0 ? [...keys, node] : keys.map((old, k) => (k === key ? node : old)));
      }
    });
  }

  function move(joint, goal) {
    edited.posture = drag(edited.map, edited.posture, joint, goal);
    draw();
  }

  function draw() {
    const { map, posture } = edited, box = dialog();
    for (const figure of box.querySelectorAll("[data-view]")) {
      const svg = figure.querySelector("svg"), see = parts.VIEWS[figure.dataset.view];
      const handles = map.parents.map((_, j) => {
        const [x, y] = see(parts.jointOf(posture, j));
        const handle = parts.svgElement("circle", { cx: x.toFixed(3), cy: y.toFixed(3), r: 0.045, class: "map-joint", tabindex: "0", role: "button", "data-joint": j });
        handle.setAttribute("aria-label", `${NAMES(map.roles[j], map.joints[j])}, ${figure.dataset.view}`);
        const title = parts.svgElement("title");
        title.textContent = NAMES(map.roles[j], map.joints[j]);
        handle.append(title);
        return handle;
      });
      svg.replaceChildren(parts.drawFigure(map, posture, figure.dataset.view), ...handles);
    }
    const { node, distance } = map.nearest(posture);
    Object.assign(edited, { node, distance });
    const far = distance > 2.5 * map.usual;
    box.querySelector(".map-editor-said").textContent = `Nearest posture on the map: ${distance.toFixed(2)} m away${far ? ", so nothing there is like this" : ""}`;
    box.querySelector(".map-editor-nearest").replaceChildren(parts.figurePicture(map, map.posture(node), "icon"));
    window.motionscapeMap.overlay.squares("cursor", [node]);
  }

  /** Open the editor on the posture of a node; the result replaces key number `key`, or is added where that is -1. */
  parts.editPosture = (node, key) => {
    const { map } = window.motionscapeMap.state;
    const posture = map.posture(node);
    edited = { map, posture, start: posture, key, joint: -1 };
    dialog();
    draw();
    dialog().showModal();
  };
  parts.dragJoint = drag;
  parts.edited = () => edited;
})();
