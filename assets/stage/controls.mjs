// Buttons, scrub bar, pointer and keyboard: everything a person does to the stage.
import { allWithin, closest, within } from "../shared/dom.mjs";
import { css } from "./colours.mjs";
import { iconMarkup } from "./icons.mjs";
import { shorten } from "./names.mjs";
/** @import { Figure } from "./figure.mjs" */
/** @import { Stage } from "./stage.mjs" */

/** @type {Record<string, string>} */
const LOOP_WORDS = { loop: "Repeat", bounce: "Back and forth", once: "Play once" };
/** @type {Record<string, string>} */
const TRAIL_WORDS = { off: "Trails off", root: "Trail of the body", limbs: "Trails of hands and feet" };

/**
 * What each button and key does. A `say` is shown for a moment and read to screen readers.
 * @param {Stage} stage
 */
function makeActions(stage) {
  const { clock, camera, traces } = stage;
  /** @param {string} text */
  const say = (text) => stage.messages.say(text);
  return {
    play: () => (clock.playing ? stage.pause() : stage.play()),
    back: () => stage.step(-1),
    forward: () => stage.step(1),
    start: () => stage.seek(0),
    end: () => stage.seek(clock.duration),
    slower: () => (clock.changeSpeed(-1), say(`Speed ${clock.speed}×`)),
    faster: () => (clock.changeSpeed(1), say(`Speed ${clock.speed}×`)),
    speed: () => ((clock.speed = 1), say("Speed 1×")),
    loop: () => (clock.nextLoop(), say(LOOP_WORDS[clock.loop])),
    ghosts: () => ((traces.ghosts = !traces.ghosts), say(traces.ghosts ? "Ghosts on" : "Ghosts off")),
    trails: () => (traces.nextTrails(), say(TRAIL_WORDS[traces.trails])),
    follow: () => ((camera.follow = !camera.follow), say(camera.follow ? "Camera follows" : "Camera stands still")),
    overlay: () => stage.setLayout("overlay"),
    side: () => stage.setLayout("side"),
    pose: () => stage.setLayout("pose"),
    warp: () => stage.setSync(stage.sync === "warp" ? "start" : "warp"),
    reset: () => stage.resetCamera(),
    help: () => stage.messages.toggleHelp(),
    retry: () => stage.requests.show(stage.request ?? null),
  };
}

/** @type {Record<string, string>} */
const KEYS = {
  " ": "play", k: "play", Home: "start", End: "end", "+": "faster", "=": "faster", "-": "slower", _: "slower", 0: "speed",
  l: "loop", g: "ghosts", t: "trails", f: "follow", r: "reset", 1: "overlay", 2: "side", 3: "pose", s: "warp", "?": "help",
  ArrowLeft: "back", ArrowRight: "forward",
};
/** @type {Record<string, [number, number]>} */
const ORBIT = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, 0.08], ArrowDown: [0, -0.08] };

/** @param {Stage} stage @param {Record<string, () => void>} actions @param {KeyboardEvent} event */
function onKey(stage, actions, event) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
  const button = closest(event, "button");
  if (button && (event.key === " " || event.key === "Enter")) return;
  if (event.key === "Escape" && stage.messages.toggleHelp(false)) return;
  const orbit = event.shiftKey && ORBIT[event.key];
  const action = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (orbit) stage.camera.orbit(...orbit);
  else if (event.key === "ArrowUp") stage.camera.zoom(0.9);
  else if (event.key === "ArrowDown") stage.camera.zoom(1 / 0.9);
  else if (event.key === "PageUp") stage.step(-10);
  else if (event.key === "PageDown") stage.step(10);
  else if (action) actions[action]();
  else return;
  event.preventDefault();
  stage.touch(true);
}

/**
 * Drag orbits; with shift, another button or two fingers it pans; wheel and pinch zoom.
 * @param {Stage} stage
 * @param {HTMLCanvasElement} canvas
 */
function watchPointer(stage, canvas) {
  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };
  canvas.addEventListener("pointerdown", (event) => {
    pointers.set(event.pointerId, event);
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add("ms-grabbing");
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return stage.pointAt(event.offsetX, event.offsetY);
    const pinch = pointers.size === 2 ? spread() : 0;
    const [dx, dy] = [event.clientX - before.clientX, event.clientY - before.clientY];
    pointers.set(event.pointerId, event);
    const pan = pinch || event.shiftKey || event.buttons & 6;
    if (pan) stage.camera.shift(dx / Math.max(pointers.size, 1), dy / Math.max(pointers.size, 1), canvas.clientHeight);
    else stage.camera.orbit(0.0075 * dx, 0.0075 * dy);
    if (pinch) stage.camera.zoom(pinch / Math.max(spread(), 1));
    stage.touch(true);
  });
  /** @param {PointerEvent} event */
  const release = (event) => {
    pointers.delete(event.pointerId);
    if (!pointers.size) canvas.classList.remove("ms-grabbing");
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", () => stage.resetCamera());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    stage.camera.zoom(Math.exp(Math.min(Math.max(event.deltaY, -120), 120) * 0.0016));
    stage.touch(true);
  }, { passive: false });
}

/**
 * Dragging along a bar seeks; the clock waits meanwhile.
 * @param {Stage} stage
 * @param {HTMLElement} bar
 */
function watchSeeking(stage, bar) {
  let resume = false;
  /** @param {PointerEvent} event */
  const seek = (event) => {
    const box = bar.getBoundingClientRect();
    stage.seek(stage.clock.duration * Math.min(Math.max((event.clientX - box.left) / box.width, 0), 1));
  };
  bar.addEventListener("pointerdown", (event) => {
    bar.setPointerCapture(event.pointerId);
    resume = stage.clock.playing;
    stage.clock.playing = false;
    seek(event);
  });
  bar.addEventListener("pointermove", (event) => bar.hasPointerCapture(event.pointerId) && seek(event));
  const release = () => {
    if (resume) stage.play();
    resume = false;
    stage.touch(true);
  };
  bar.addEventListener("pointerup", release);
  bar.addEventListener("pointercancel", release);
}

const CHIP_LETTERS = 20;

/**
 * What the colours of a single figure mean.
 * @param {string} side
 */
function legend(side) {
  const entry = document.createElement("span");
  entry.className = `ms-legend ms-legend-${side}`;
  entry.textContent = side;
  return entry;
}

export class Controls {
  /** @param {Stage} stage @param {HTMLElement} root */
  constructor(stage, root) {
    this.stage = stage;
    this.root = root;
    /** @type {Record<string, () => void>} */
    this.actions = makeActions(stage);
    this.listed = "";
    this.shown = "";
    this.scrub = this.find(".ms-scrub");
    for (const button of allWithin(root, "[data-icon]")) button.innerHTML = iconMarkup(button.dataset.icon ?? "");
    root.addEventListener("click", (event) => this.press(event));
    root.addEventListener("keydown", (event) => onKey(stage, this.actions, event));
    watchPointer(stage, stage.scene.canvas);
    watchSeeking(stage, this.scrub);
    watchSeeking(stage, this.find(".ms-bands"));
    watchSeeking(stage, this.find(".ms-warp-rows"));
    this.find(".ms-warp-rows").addEventListener("pointermove", (event) => {
      this.find(".ms-warp-rows").title = stage.warpStrip.describe(event);
    });
  }

  /** The part of the controls that matches. @param {string} selector */
  find(selector) {
    return within(this.root, selector);
  }

  /** @param {Event} event */
  press(event) {
    const button = closest(event, "[data-action]");
    if (!button || button.disabled) return;
    this.actions[button.dataset.action ?? ""]?.();
    this.stage.touch(true);
  }

  /** Chips that name the figures and hide or show them; pointing at one makes it stand out. */
  listFigures() {
    const { figures } = this.stage;
    const list = this.find(".ms-figures");
    const names = JSON.stringify(figures.map((figure) => [figure.label, figure.visible, figure.item.colour, figure.header.start]));
    if (names === this.listed) return; // a chip that is pointed at stays
    this.listed = names;
    list.replaceChildren(...(figures.length > 1 ? figures.map((figure, k) => this.chip(figure, k)) : []));
    if (figures.length === 1 && !figures[0].item.colour) list.append(legend("left"), legend("right"));
  }

  /** @param {Figure} figure @param {number} k */
  chip(figure, k) {
    const chip = document.createElement("button");
    chip.type = "button";
    chip.className = "ms-chip";
    chip.title = `${figure.label}, frames ${figure.header.start} to ${figure.header.end}: click to hide or show`;
    chip.setAttribute("aria-pressed", String(figure.visible));
    const colour = document.createElement("span");
    colour.className = "ms-chip-colour";
    const name = document.createElement("span");
    name.className = "ms-chip-name";
    name.textContent = shorten(figure.name, CHIP_LETTERS);
    chip.append(colour, name);
    chip.addEventListener("click", () => {
      const { visible } = this.stage.figures[k];
      this.stage.setVisible(k, !visible);
      chip.setAttribute("aria-pressed", String(!visible));
    });
    chip.addEventListener("pointerenter", () => this.stage.highlight(k));
    chip.addEventListener("pointerleave", () => this.stage.highlight(-1));
    return chip;
  }

  colourChips() {
    allWithin(this.root, ".ms-chip-colour").forEach((swatch, k) => {
      const figure = this.stage.figures[k];
      if (figure) swatch.style.background = css(figure.colours[2]);
    });
  }

  /** Bring all buttons in line with the state; cheap enough after every action, not for every frame. */
  update() {
    const { stage } = this;
    const { clock, traces, camera } = stage;
    /** @param {string} action @param {string | null} icon @param {string | null} label @param {boolean} [pressed] */
    const show = (action, icon, label, pressed) => {
      const button = this.find(`.ms-tool[data-action="${action}"]`);
      if (icon && button.dataset.icon !== icon) button.innerHTML = iconMarkup((button.dataset.icon = icon));
      if (label) {
        button.setAttribute("aria-label", label);
        button.dataset.tip = `${label}${button.dataset.key ? `  ·  ${button.dataset.key}` : ""}`;
      }
      if (pressed !== undefined) button.setAttribute("aria-pressed", String(pressed));
    };
    show("play", clock.playing ? "pause" : "play", clock.playing ? "Pause" : "Play");
    show("loop", clock.loop, LOOP_WORDS[clock.loop]);
    show("ghosts", null, null, traces.ghosts);
    show("trails", null, TRAIL_WORDS[traces.trails], traces.trails !== "off");
    show("follow", null, null, camera.follow);
    show("overlay", null, null, stage.layout === "overlay");
    show("side", null, null, stage.layout === "side");
    show("pose", null, null, stage.layout === "pose");
    show("warp", null, null, stage.timeline.warped);
    this.find('[data-action="speed"]').textContent = `${clock.speed}×`;
    const many = stage.figures.length > 1;
    this.find(".ms-arrangement").hidden = !many;
    this.find('.ms-tool[data-action="warp"]').disabled = !stage.figures.some((figure) => figure.warp);
    this.find(".ms-controls").inert = stage.status !== "ready";
  }

  /**
   * For every frame: the scrub bar and the clock face.
   * @param {string} text
   */
  tick(text) {
    const { clock } = this.stage;
    const share = clock.duration > 0 ? clock.time / clock.duration : 0;
    this.scrub.style.setProperty("--share", share.toFixed(4));
    this.stage.warpStrip.place(share);
    this.stage.bands.place(share);
    if (text === this.shown) return;
    this.shown = text;
    this.find(".ms-readout").textContent = text;
    if (clock.playing) return; // a screen reader should not hear every frame
    this.scrub.setAttribute("aria-valuemax", clock.duration.toFixed(2));
    this.scrub.setAttribute("aria-valuenow", clock.time.toFixed(2));
    this.scrub.setAttribute("aria-valuetext", text);
  }
}
