/* The frame: state into the URL, theme to the canvases, the splitter, the share button. */
import { clientside, notify, register, setStore } from "../shared/dash.mjs";
import { find, whenParsed } from "../shared/dom.mjs";
import { player } from "../stage/player.mjs";

const WIDTH_KEY = "motionscape-stage-width";

const put = (pairs, values) => {
  for (const [key, value] of Object.entries(values || {})) {
    if (value !== null && value !== undefined && value !== "") pairs.set(key, String(value));
  }
};

const shown = { dataset: null, parameters: {}, selection: {}, view: {}, keys: {}, chosen: "{}", stage: {} };
let handled = false; // the view was turned by hand: then it is worth a place in the link

const page = (pathname) => (pathname || location.pathname).replace(/\//g, "") || "library";

function writeAddress() {
  if (!shown.dataset) return clientside.no_update;
  const pairs = new URLSearchParams();
  put(pairs, { dataset: shown.dataset });
  put(pairs, shown.parameters);
  for (const key of shown.keys[page()] || []) put(pairs, { [key]: (shown.view || {})[key] });
  put(pairs, shown.selection);
  if (shown.chosen !== "{}" || (shown.view || {}).walk || (shown.view || {}).sentence) put(pairs, shown.stage);
  const address = location.pathname + "?" + pairs.toString().replace(/%2C/g, ",").replace(/%3A/g, ":");
  if (address !== location.pathname + location.search) history.replaceState(history.state, "", address);
  return address;
}

// The Stage tells now and then what one sees; the moment counts only where it stands still.
window.addEventListener("stage-state", (event) => {
  const { time, playing, speed, layout, camera } = event.detail;
  shown.stage = {
    time: playing ? "" : time,
    speed: speed === 1 ? "" : speed,
    layout: layout === "overlay" ? "" : layout,
    camera: handled ? [camera.yaw, camera.pitch, camera.distance, ...camera.pan, camera.follow ? 1 : 0].join(",") : "",
  };
  writeAddress();
});
for (const kind of ["wheel", "pointerdown", "keydown"]) {
  document.addEventListener(kind, (event) => { if (event.target.id === "stage-canvas") handled = true; }, { passive: true, capture: true });
}

register("shell", {
  // Everything that names what one sees goes into the address, without a new entry in the history.
  address(pathname, dataset, parameters, selection, view, keys) {
    const chosen = JSON.stringify(selection || {});
    if (shown.dataset && (chosen !== shown.chosen || dataset !== shown.dataset)) {
      shown.stage = {};
      handled = false;
    }
    Object.assign(shown, { dataset, parameters, selection, view, keys, chosen });
    return writeAddress();
  },
  // What a page shows is changed key by key.
  change(change, view) {
    const next = { ...(view || {}) };
    for (const [key, value] of Object.entries(change || {})) {
      if (key === "at") continue;
      if (value === null || value === "") delete next[key];
      else next[key] = String(value);
    }
    if (JSON.stringify(next) !== JSON.stringify(view || {})) setStore("view", next);
    return clientside.no_update;
  },
  // What a link says of the Stage; it is taken up when the motion has arrived.
  restore(stage) {
    if (!stage || !Object.keys(stage).length) return clientside.no_update;
    shown.stage = stage;
    const state = {};
    if (stage.time) Object.assign(state, { time: Number(stage.time), playing: false });
    if (stage.speed) state.speed = Number(stage.speed);
    if (stage.layout) state.layout = stage.layout;
    if (stage.camera) {
      handled = true;
      const [yaw, pitch, distance, x, y, z, follow] = stage.camera.split(",").map(Number);
      state.camera = { yaw, pitch, distance, pan: [x, y, z], follow: follow !== 0 };
    }
    player.restore(state);
    return clientside.no_update;
  },
  choose(choice, cleared) {
    if (!choice) return clientside.no_update;
    if (choice.dataset !== shown.dataset) {
      setStore("selection", {});
      setStore("view-change", Object.fromEntries((cleared || []).map((key) => [key, ""])));
      setStore("stage-request", { dataset: choice.dataset, items: [] });
      setStore("dataset", choice.dataset);
    }
    return clientside.no_update;
  },
  pick(value, dataset) {
    if (value && value !== dataset) setStore("dataset-choice", { dataset: value, at: Date.now() });
    return clientside.no_update;
  },
  // One link is the current page's.
  current(pathname) {
    for (const link of document.querySelectorAll(".nav-link")) {
      if (link.id === "nav-" + page(pathname)) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    return clientside.no_update;
  },
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

// Buttons that carry a text to copy (webapp/components/actions.py).
document.addEventListener("click", async (event) => {
  const button = event.target.closest && event.target.closest("[data-copy]");
  if (!button) return;
  const done = await copy(button.dataset.copy);
  if (done) notify("Copied", "Paste it where you want to run it.", "accent");
  else notify("Could not copy", button.dataset.copy);
});

function watchTheme() {
  const root = document.documentElement;
  let last = null;
  const tell = () => {
    const scheme = root.dataset.mantineColorScheme;
    if ((scheme !== "dark" && scheme !== "light") || scheme === last || !clientside.set_props || !find("shell")) return;
    last = scheme;
    setStore("theme", scheme);
  };
  new MutationObserver(tell).observe(root, { attributes: true, attributeFilter: ["data-mantine-color-scheme"] });
  tell();
}

function setStageWidth(pixels) {
  const width = Math.round(Math.min(Math.max(pixels, 320), innerWidth - 84 - 367));
  document.documentElement.style.setProperty("--stage-width", width + "px");
  return width;
}

function remember(width) {
  try { localStorage.setItem(WIDTH_KEY, width); } catch { /* private mode: then it is not remembered */ }
}

function watchSplitter() {
  let dragging = null;
  const width = () => document.querySelector(".stage-panel").getBoundingClientRect().width;
  document.addEventListener("pointerdown", (event) => {
    if (!event.target.classList || !event.target.classList.contains("splitter")) return;
    dragging = event.target;
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
    if (!event.target.classList || !event.target.classList.contains("splitter")) return;
    const step = { ArrowLeft: 32, ArrowRight: -32 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    remember(setStageWidth(width() + step));
  });
  let stored = null;
  try { stored = Number(localStorage.getItem(WIDTH_KEY)); } catch { /* nothing is remembered */ }
  if (stored > 0) setStageWidth(stored);
}

function start() {
  watchTheme();
  watchSplitter();
  // the theme may be settled before Dash can take it
  const again = setInterval(() => {
    if (!clientside.set_props || !find("shell")) return;
    clearInterval(again);
    setStore("theme", document.documentElement.dataset.mantineColorScheme || "light");
  }, 100);
}
whenParsed(start);
