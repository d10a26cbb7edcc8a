/* The Grammar page: which part draws what and when, and the pieces all of them draw with. Loaded before grammar_*.js. */
(function () {
  "use strict";
  const clientside = (window.dash_clientside = window.dash_clientside || {});
  const parts = (window.motionscapeGrammar = window.motionscapeGrammar || {});

  parts.data = {}; // what the server said of the result that is shown (webapp/grammars.py)

  parts.element = (name, className, text) => {
    const made = document.createElement(name);
    if (className) made.className = className;
    if (text !== undefined) made.textContent = text;
    return made;
  };
  const { element } = parts;

  parts.find = (id) => document.getElementById(id);
  parts.action = (id) => (parts.data.actions || [])[id] || { id, name: `Action ${id}`, short: String(id), colour: "#8793a3", count: 0, seconds: 0 };
  parts.change = (values) => window.dash_clientside.set_props("view-change", { data: values });
  parts.plural = (n, one, more = one + "s") => `${n} ${n === 1 ? one : more}`;
  parts.clock = (seconds) => `${Math.floor(seconds / 60)}:${(seconds % 60).toFixed(1).padStart(4, "0")}`;

  parts.icon = (name, size = 14) => {
    const mark = element("span", `icon icon-${name}`);
    mark.style.width = mark.style.height = `${size}px`;
    mark.setAttribute("aria-hidden", "true");
    return mark;
  };

  /** A button that puts a selection into the store (assets/actions.js). */
  parts.plays = (button, selection) => {
    button.dataset.store = "selection";
    button.dataset.value = JSON.stringify(selection);
    return button;
  };

  parts.paint = (node, action) => {
    node.style.setProperty("--tone", action.colour);
    node.style.setProperty("--ink", action.ink || "#ffffff");
  };

  /** A coloured box with an action's name; a click plays all its occurrences. */
  parts.chip = (id) => {
    const action = parts.action(id);
    const button = parts.plays(element("button", "action-chip", action.short), { action: id });
    button.type = "button";
    if (action.hint) button.append(element("span", "action-hint-word", action.hint));
    parts.paint(button, action);
    button.title = `${action.name}: ${parts.plural(action.count, "time")}`;
    button.dataset.action = id;
    return button;
  };

  /** Keep what has the focus when a list is drawn anew. */
  parts.redraw = (box, children) => {
    const focused = [...box.querySelectorAll("button, input, [tabindex]")].indexOf(document.activeElement);
    const top = box.scrollTop;
    box.replaceChildren(...children);
    box.scrollTop = top;
    if (focused >= 0) [...box.querySelectorAll("button, input, [tabindex]")][focused]?.focus({ preventScroll: true });
  };

  /** Draw only where the data differ from what is there. */
  parts.fresh = (box, stamp) => {
    const text = typeof stamp === "string" ? stamp : JSON.stringify(stamp);
    if (box.drawnFrom === text) return false;
    box.drawnFrom = text;
    return true;
  };

  /** One thing of a row has the keyboard's focus at a time; arrows move it. */
  parts.arrows = (box, selector) => {
    box.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
      const at = event.target.closest?.(selector);
      if (!step || !at) return;
      const all = [...box.querySelectorAll(selector)];
      const next = all[all.indexOf(at) + step];
      event.preventDefault();
      event.stopPropagation();
      next?.focus();
    });
  };

  /** The query of a download: the result that is shown, and what of it. */
  parts.query = (view, more = {}) => {
    const pairs = new URLSearchParams({ dataset: parts.data.dataset || "" });
    for (const [key, value] of Object.entries(view || {})) if (key.startsWith("grammar-")) pairs.set(key, value);
    for (const [key, value] of Object.entries(more)) pairs.set(key, value);
    return pairs.toString();
  };

  clientside.grammar = {
    draw(data, selection, order, _place) {
      if (!data || !parts.find("grammar-string")) return clientside.no_update;
      parts.data = data;
      parts.drawString(data);
      parts.drawActions(data, order);
      parts.drawOccurrences(data, selection);
      parts.drawRules(data);
      parts.mark(selection);
      return clientside.no_update;
    },
    /** A point of a chart over the number of actions: its result comes on the page. */
    open(click) {
      const change = click?.points?.[0]?.customdata;
      if (typeof change === "string") parts.change(JSON.parse(change));
      return clientside.no_update;
    },
    routine(shown, data, view) {
      if (data) parts.data = data;
      parts.drawRoutines(shown, data, view || {});
      return clientside.no_update;
    },
    compose(made, view, data, selection) {
      if (data) parts.data = data;
      parts.drawCompose(made, view, selection);
      return clientside.no_update;
    },
    others(data, view) {
      parts.drawOthers(data, view || {});
      return clientside.no_update;
    },
  };
})();
