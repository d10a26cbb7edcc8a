/* Buttons and table rows that put a value into a store. */
(function () {
  "use strict";
  const put = (store, value, stamp) =>
    window.dash_clientside.set_props(store, { data: stamp ? { ...value, at: Date.now() } : value });

  document.addEventListener("click", (event) => {
    const button = event.target.closest && event.target.closest("[data-store]");
    if (!button || button.disabled) return;
    put(button.dataset.store, JSON.parse(button.dataset.value), button.dataset.stamp);
  });

  // tables: a click or Enter on a row selects what the row stands for
  const grid = (window.dashAgGridFunctions = window.dashAgGridFunctions || {});
  grid.chooseRow = (params) => {
    if (params.data && params.data.selection) put("selection", params.data.selection, false);
  };
  grid.chooseRowByKey = (params) => {
    if (params.event && params.event.key === "Enter") grid.chooseRow(params);
  };

  const parts = (window.dashAgGridComponentFunctions = window.dashAgGridComponentFunctions || {});
  const element = (...args) => window.React.createElement(...args);
  parts.Filmstrip = (props) =>
    props.value
      ? element("img", { className: "filmstrip", src: props.value, alt: "", loading: "lazy", decoding: "async", draggable: false })
      : null;
  const MARKS = { ok: "check", warning: "warning", error: "error" };
  parts.Verdict = (props) =>
    props.value
      ? element("span", { className: "verdict verdict-" + props.value, title: (props.data && props.data.messages) || undefined },
          element("span", { className: "icon icon-" + MARKS[props.value], style: { width: 14, height: 14 }, "aria-hidden": "true" }),
          props.value === "error" ? "not read" : props.value)
      : null;

  // the row of what is selected is marked in every table, wherever it was selected
  const same = (a, b) => a && b && ["clip", "motif", "edge"].every((key) => String(a[key] ?? "") === String(b[key] ?? ""));
  const clientside = (window.dash_clientside = window.dash_clientside || {});
  clientside.tables = {
    async mark(selection, rows, id) {
      try {
        const api = await window.dash_ag_grid.getApiAsync(id);
        api.forEachNode((node) => {
          const chosen = same(node.data && node.data.selection, selection);
          if (node.isSelected() !== chosen) node.setSelected(chosen);
          if (chosen) api.ensureNodeVisible(node);
        });
      } catch { /* the table has gone with its page */ }
      return clientside.no_update;
    },
  };
})();
