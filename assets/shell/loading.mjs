// Heavy component libraries and Plotly are loaded when they are first needed; what the page brought along (layout, list
// of callbacks) is not asked for again. What a page says of them is written by webapp/shell/loading.py.
import { closest, find } from "../shared/dom.mjs";
import { FIRST_DEPENDENCIES, FIRST_LAYOUT, LOADING } from "../shared/ids.mjs";

/** @typedef {{ source: string, components: string[] }} Suite */

/** @type {{ suites?: Record<string, Suite>, plotly?: string, pages?: Record<string, string[]> }} */
const { suites = {}, plotly = "", pages = {} } = JSON.parse(find(LOADING)?.textContent || "{}");

/** The scripts that the page of an address begins with. @param {string} pathname */
const scriptsOf = (pathname) => pages[pathname.split("/").pop() || "library"] || [];

/** Calls `act` when the browser has nothing better to do. @param {() => void} act */
function whenIdle(act) {
  if (window.requestIdleCallback) window.requestIdleCallback(act, { timeout: 2000 });
  else setTimeout(act, 500);
}

/** Answers from the page for the two requests that Dash's renderer makes when it starts. */
function answerFirstRequests() {
  const answers = new Map([
    ["_dash-layout", find(FIRST_LAYOUT)?.textContent],
    ["_dash-dependencies", find(FIRST_DEPENDENCIES)?.textContent],
  ]);
  const send = window.fetch;
  window.fetch = (address, options) => {
    const name = String(address).split("/").pop() ?? "";
    const text = answers.get(name);
    if (!text) return send.call(window, address, options);
    answers.delete(name);
    if (!answers.size) window.fetch = send;
    return Promise.resolve(new Response(text, { headers: { "Content-Type": "application/json" } }));
  };
}

/** @param {string} source */
function loadScript(source) {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = source;
    script.onload = resolve;
    script.onerror = () => reject(new Error(`${source} could not be loaded`));
    document.head.append(script);
  });
}

/**
 * Takes a library's place in `window[namespace]`; its components load the library when they are first drawn, and those
 * that cannot be seen yet are drawn after all others.
 * @param {string} namespace
 * @param {Suite} suite
 */
function standIn(namespace, { source, components }) {
  /** @type {Record<string, any> | null} */
  let library = null;
  /** @type {() => void} */
  let arrive;
  /** @type {Promise<void>} */
  const arrived = new Promise((resolve) => { arrive = resolve; });
  /** @type {Promise<unknown> | null} */
  let loading = null;
  const load = () => (loading ||= loadScript(source)).then(() => arrived);
  /** @type {Record<string, any>} */
  const suite = { getApiAsync: (/** @type {any[]} */ ...parts) => arrived.then(() => library?.getApiAsync(...parts)) };
  Object.defineProperty(window, namespace, {
    get: () => suite,
    set: (value) => {
      if (value === suite) return; // dash_ag_grid writes window.dash_ag_grid = window.dash_ag_grid || {}
      library = value;
      delete library?.Cytoscape?.defaultProps?.wheelSensitivity; // Cytoscape warns of any value, its own default too
      arrive();
    },
  });
  for (const name of components) suite[name] = component(name);

  /** @param {string} name */
  function component(name) {
    const { createElement, lazy, Suspense, useLayoutEffect, useRef, useState } = window.React;
    const Loaded = lazy(() => load().then(() => ({ default: library?.[name] })));
    const Component = (/** @type {object} */ props) => {
      const place = useRef(null);
      const [wanted, setWanted] = useState(false);
      useLayoutEffect(() => {
        if (place.current?.offsetParent) setWanted(true);
        else whenIdle(() => setWanted(true)); // it lies behind a tab
      }, []);
      if (!wanted) return createElement("div", { ref: place });
      return createElement(Suspense, { fallback: null }, createElement(Loaded, props));
    };
    // Dash's protocol for components that come later: callbacks about them wait until this is true.
    const ready = () => library?.[name]._dashprivate_isLazyComponentReady ?? true;
    Object.defineProperty(Component, "_dashprivate_isLazyComponentReady", {
      get: () => (library ? ready() : arrived.then(ready)),
    });
    return Component;
  }
}

/**
 * Plotly, which dcc.Graph waits for as `window.Plotly`: at once where the page begins with a chart, and otherwise, where
 * a chart lies behind a tab, when the browser has nothing better to do.
 */
function plotlyLater() {
  /** @type {unknown} */
  let library = null;
  /** @type {Promise<unknown> | null} */
  let loading = null;
  /** @type {() => Promise<void>} */
  const turn = () => new Promise((resolve) => {
    if (scriptsOf(location.pathname).includes(plotly)) resolve();
    else whenIdle(resolve);
  });
  Object.defineProperty(window, "Plotly", {
    get: () => library || (loading ||= turn().then(() => loadScript(plotly)).then(() => library)),
    set: (value) => { library = value; },
  });
}

/** Fetches what a page will need while the pointer or the focus is on its link. @param {Event} event */
function fetchAhead(event) {
  const link = /** @type {HTMLAnchorElement | null} */ (/** @type {Element | null} */ (closest(event, "a.nav-link")));
  for (const address of link ? scriptsOf(link.pathname) : []) {
    if (document.head.querySelector(`link[href="${address}"]`)) continue;
    document.head.append(Object.assign(document.createElement("link"), { rel: "preload", as: "script", href: address }));
  }
}

answerFirstRequests();
for (const [namespace, suite] of Object.entries(suites)) standIn(namespace, suite);
if (plotly) plotlyLater();
for (const kind of ["pointerover", "focusin"]) document.addEventListener(kind, fetchAhead, { passive: true });
