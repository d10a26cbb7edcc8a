/* The Search page: what its parts share, and the one place where the store "search-found" is drawn. */
(function () {
  "use strict";
  const clientside = (window.dash_clientside = window.dash_clientside || {});
  const parts = (window.motionscapeSearch = window.motionscapeSearch || {});

  // what is shown now; the parts read it and never keep a copy
  const now = (parts.now = { found: null, view: {}, clips: null, motifs: [], scheme: "light", presets: {}, body: null, engines: [], key: null });

  parts.set = (store, data) => clientside.set_props(store, { data });
  /** Changes what is searched for; a hit of another search is none of this one. */
  parts.change = (values) => parts.set("view-change", { hit: "", ...values });

  parts.element = (name, className, ...children) => {
    const made = document.createElement(name);
    if (className) made.className = className;
    made.append(...children.filter((child) => child !== null && child !== undefined));
    return made;
  };
  parts.icon = (symbol, size = 14) => {
    const made = parts.element("span", "icon icon-" + symbol);
    made.style.width = made.style.height = size + "px";
    made.setAttribute("aria-hidden", "true");
    return made;
  };
  parts.clock = (seconds) => {
    const tenths = Math.round(seconds * 10);
    return `${Math.floor(tenths / 600)}:${((tenths % 600) / 10).toFixed(1).padStart(4, "0")}`;
  };

  // ---- links: as webapp/queries.py writes them ----
  const bytes = new TextEncoder();
  parts.escape = (name) => [...name].map((c) => (/[-0-9A-Za-z._ ]/.test(c) ? c
    : [...bytes.encode(c)].map((byte) => "~" + byte.toString(16).padStart(2, "0")).join(""))).join("");

  /** The fewest nodes of the body's hierarchy with exactly these leaves. */
  parts.nodesOf = (leaves) => {
    const wanted = new Set(leaves);
    const found = [];
    const left = new Set(leaves);
    for (const [node, below] of Object.entries(now.body.nodes)) { // parents come before children
      if (below.every((leaf) => wanted.has(leaf)) && below.some((leaf) => left.has(leaf))) {
        found.push(node);
        below.forEach((leaf) => left.delete(leaf));
      }
    }
    return found;
  };
  parts.words = (leaves) => parts.nodesOf(leaves).map((node) => now.body.words[node]).join(", ");

  parts.writeQuery = (pieces) => pieces.filter((piece) => piece.leaves.length).map((piece) => [
    ...(piece.leaves.length === now.body.leaves.length ? [] : [parts.nodesOf(piece.leaves).join("+")]),
    parts.escape(piece.clip), `${piece.start}-${piece.end}`, ...(piece.dataset ? [parts.escape(piece.dataset)] : []),
  ].join(":")).join(",");

  /** The pieces that are shown, free to be changed. */
  parts.pieces = () => ((now.found && now.found.pieces) || []).map((piece) => ({ ...piece, leaves: [...piece.leaves] }));

  parts.ask = (pieces, more = {}) => {
    const query = parts.writeQuery(pieces);
    if (query !== (now.view.query || "")) parts.remember();
    parts.change({ query, ...more });
  };

  // ---- back to what was looked for before ----
  const before = [];
  parts.remember = () => {
    const { query, parts: weights } = now.view;
    if (query && (!before.length || before.at(-1).query !== query)) before.push({ query, parts: weights || "" });
    if (before.length > 30) before.shift();
  };
  parts.back = () => {
    while (before.length) {
      const last = before.pop();
      if (last.query !== now.view.query) return parts.change(last);
    }
    return undefined;
  };
  parts.canGoBack = () => before.some((one) => one.query !== now.view.query);

  /** The part of the address that says which search it is, with a hit or without. */
  parts.address = (hit) => {
    const pairs = new URLSearchParams({ dataset: now.clips.dataset, v: now.clips.version.slice(0, 8) });
    for (const [key, value] of Object.entries(now.view)) {
      if (["query", "parts"].includes(key) || key.startsWith("search-")) pairs.set(key, value);
    }
    if (hit) pairs.set("hit", hit);
    return pairs.toString();
  };

  clientside.search = {
    draw(found, view, clips, motifs, scheme, presets, body, engines, key, selection) {
      if (!document.getElementById("search-sources") || !body) return clientside.no_update;
      Object.assign(now, { found, view: view || {}, clips, motifs: motifs || [], scheme, presets, body, engines, key, selection: selection || {} });
      const page = document.querySelector(".search-page");
      page.dataset.look = now.view.look || "search";
      page.classList.toggle("without-dataset", !clips);
      const fits = found && clips && found.asked && found.asked.dataset === clips.dataset;
      if (!fits) now.found = null;
      parts.drawSources();
      parts.drawBody();
      parts.drawOptions();
      parts.drawHits();
      parts.play();
      return clientside.no_update;
    },
  };

  // "More like this", wherever it stands: data-similar holds {clip, start, end} and, where it is another, the dataset
  document.addEventListener("click", (event) => {
    const button = event.target.closest && event.target.closest("[data-similar]");
    if (!button || button.disabled) return;
    const { clip, start, end, dataset } = JSON.parse(button.dataset.similar);
    const query = [parts.escape(clip), `${start}-${end}`, ...(dataset ? [parts.escape(dataset)] : [])].join(":");
    parts.remember();
    parts.change({ query, look: "" });
    if (!location.pathname.endsWith("/search")) clientside.set_props("url", { pathname: "/search", search: "" });
    else document.querySelector(".page").scrollTo({ top: 0, behavior: "smooth" });
  });
})();
