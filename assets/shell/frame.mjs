/* The frame: state into the URL, theme to the canvases, the splitter, the share button. */
import { changeView, clientside, notify, register, setStore } from "../shared/dash.mjs";
import { allWithin, closest, find, hasClass, targetOf, whenParsed, within } from "../shared/dom.mjs";
import { DATASET, DATASET_CHOICE, NAV, SELECTION, SHELL, STAGE_REQUEST, THEME } from "../shared/ids.mjs";
import { STAGE_CANVAS } from "../stage/ids.mjs";
import { player } from "../stage/player.mjs";
import { addressOf, pageOf, stageOfLink, stateOfLink } from "./address.mjs";
/** @import { Selection, View, ViewChange } from "../shared/types.d.ts" */
/** @import { Shown } from "./address.mjs" */

const WIDTH_KEY = "motionscape-stage-width";

/** What the address says. @type {Shown} */
const shown = { dataset: null, selection: {}, view: {}, keys: {}, chosen: "{}", stage: {} };
let turnedByHand = false; // the view was turned by hand: then it is worth a place in the link

/** The link of what is shown, in the address line and for the store "address"; nothing while no data set is shown. */
function writeAddress() {
  if (!shown.dataset) return clientside.no_update;
  const address = addressOf(location.pathname, shown);
  if (address !== location.pathname + location.search) history.replaceState(history.state, "", address);
  return address;
}

// The Stage tells now and then what one sees; the moment counts only where it stands still.
window.addEventListener("stage-state", (event) => {
  shown.stage = stageOfLink(event.detail, turnedByHand);
  writeAddress();
});
for (const kind of ["wheel", "pointerdown", "keydown"]) {
  document.addEventListener(kind, (event) => { if (targetOf(event).id === STAGE_CANVAS) turnedByHand = true; }, { passive: true, capture: true });
}

register("shell", {
  // Everything that names what one sees goes into the address, without a new entry in the history.
  /**
   * @param {string} pathname
   * @param {string | null} dataset
   * @param {Selection | null} selection
   * @param {View | null} view
   * @param {Record<string, string[]>} keys
   */
  address(pathname, dataset, selection, view, keys) {
    const chosen = JSON.stringify(selection || {});
    if (shown.dataset && (chosen !== shown.chosen || dataset !== shown.dataset)) {
      shown.stage = {};
      turnedByHand = false;
    }
    Object.assign(shown, { dataset, selection, view, keys, chosen });
    return writeAddress();
  },
  // What the server changes of the view.
  /** @param {ViewChange & { at?: number } | null} change */
  change(change) {
    const keys = { ...change };
    delete keys.at; // it only tells equal changes apart
    changeView(keys);
    return clientside.no_update;
  },
  // What a link says of the Stage; it is taken up when the motion has arrived.
  /** @param {Record<string, string> | null} stage */
  restore(stage) {
    if (!stage || !Object.keys(stage).length) return clientside.no_update;
    shown.stage = stage;
    if (stage.camera) turnedByHand = true;
    player.restore(stateOfLink(stage));
    return clientside.no_update;
  },
  /** @param {{ dataset: string | null } | null} choice @param {string[] | null} cleared */
  choose(choice, cleared) {
    if (!choice) return clientside.no_update;
    if (choice.dataset !== shown.dataset) {
      setStore(SELECTION, {});
      changeView(Object.fromEntries((cleared || []).map((key) => [key, ""])));
      setStore(STAGE_REQUEST, { dataset: choice.dataset, items: [] });
      setStore(DATASET, choice.dataset);
    }
    return clientside.no_update;
  },
  /** @param {string | null} value @param {string | null} dataset */
  pick(value, dataset) {
    if (value && value !== dataset) setStore(DATASET_CHOICE, { dataset: value, at: Date.now() });
    return clientside.no_update;
  },
  // One link is the current page's.
  /** @param {string} pathname */
  current(pathname) {
    for (const link of allWithin(document, ".nav-link")) {
      if (link.id === NAV + pageOf(pathname)) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    return clientside.no_update;
  },
  /** @param {number | null} clicks */
  async share(clicks) {
    if (!clicks) return clientside.no_update;
    const done = await copy(location.href);
    return [{
      action: "show",
      title: done ? "Link copied" : "Could not copy the link",
      message: done ? "It opens this very view." : "Copy it from the address line.",
      color: done ? "accent" : "orange",
    }];
  },
});

/** @param {string} text */
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = document.createElement("textarea"); // the clipboard interface needs https or localhost
    field.value = text;
    field.style.position = "fixed";
    field.style.opacity = "0";
    document.body.append(field);
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    return done;
  }
}

// Buttons that carry a text to copy (webapp/shell/buttons.py).
document.addEventListener("click", async (event) => {
  const button = closest(event, "[data-copy]");
  if (!button) return;
  const done = await copy(button.dataset.copy ?? "");
  if (done) notify("Copied", "Paste it where you want to run it.", "accent");
  else notify("Could not copy", button.dataset.copy ?? "");
});

function watchTheme() {
  const root = document.documentElement;
  let last = "light"; // what the store begins with: webapp/shell/frame.py
  const ready = () => "set_props" in clientside && Boolean(find(SHELL));
  const tell = () => {
    const scheme = root.dataset.mantineColorScheme;
    if ((scheme !== "dark" && scheme !== "light") || scheme === last || !ready()) return;
    last = scheme;
    setStore(THEME, scheme);
  };
  new MutationObserver(tell).observe(root, { attributes: true, attributeFilter: ["data-mantine-color-scheme"] });
  const again = setInterval(() => { // the theme may be settled before Dash can take it
    if (!ready()) return;
    clearInterval(again);
    tell();
  }, 100);
}

/** @param {number} pixels */
function setStageWidth(pixels) {
  const width = Math.round(Math.min(Math.max(pixels, 320), innerWidth - 84 - 367));
  document.documentElement.style.setProperty("--stage-width", width + "px");
  document.querySelector(".splitter")?.setAttribute("aria-valuenow", String(Math.round((100 * width) / innerWidth)));
  return width;
}

/** @param {number} width */
function remember(width) {
  try { localStorage.setItem(WIDTH_KEY, String(width)); } catch { /* private mode: then it is not remembered */ }
}

function watchSplitter() {
  /** @type {HTMLElement | null} */
  let dragging = null;
  const width = () => within(document, ".stage-panel").getBoundingClientRect().width;
  document.addEventListener("pointerdown", (event) => {
    if (!hasClass(event, "splitter")) return;
    dragging = targetOf(event);
    dragging.classList.add("dragging");
    dragging.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  document.addEventListener("pointermove", (event) => {
    if (dragging) setStageWidth(innerWidth - event.clientX - 3);
  });
  document.addEventListener("pointerup", () => {
    if (!dragging) return;
    dragging.classList.remove("dragging");
    dragging = null;
    remember(width());
  });
  document.addEventListener("keydown", (event) => {
    if (!hasClass(event, "splitter")) return;
    const step = { ArrowLeft: 32, ArrowRight: -32 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    remember(setStageWidth(width() + step));
  });
  let stored = 0;
  try { stored = Number(localStorage.getItem(WIDTH_KEY)); } catch { /* nothing is remembered */ }
  if (stored > 0) setStageWidth(stored);
}

function start() {
  watchTheme();
  watchSplitter();
}
whenParsed(start);
