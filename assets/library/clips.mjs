/* The Library's table of clips: names open the Clip page, boxes choose clips, a click elsewhere plays (actions.js). */
import { changeView, clientside, openPage, register, setStore } from "../shared/dash.mjs";
import { cellRenderers, reactElement } from "../shared/grid.mjs";

const WORDS = { ok: "read without remarks", warning: "warnings", error: "not read" };
const ICONS = { ok: "check", warning: "warning", error: "error" };

cellRenderers.ClipLink = (props) =>
  props.value
    ? reactElement("a", { className: "clip-link ellipsis", href: props.data.href, tabIndex: -1, "data-clip": props.value, draggable: false }, props.value)
    : null;
cellRenderers.Mark = (props) =>
  props.value
    ? reactElement("span", { className: "verdict verdict-mark verdict-" + props.value, role: "img", "aria-label": WORDS[props.value], title: (props.data && props.data.messages) || WORDS[props.value] },
        reactElement("span", { className: "icon icon-" + ICONS[props.value], style: { width: 14, height: 14 }, "aria-hidden": "true" }))
    : null;

// Like dcc.Link: another page without loading the app again. What is shown there is the selection.
function open(clip) {
  setStore("selection", { clip });
  openPage("/clip");
}
document.addEventListener("click", (event) => {
  const link = event.target.closest && event.target.closest("a.clip-link");
  if (!link || event.button || event.metaKey || event.ctrlKey || event.shiftKey || event.altKey) return;
  event.preventDefault();
  event.stopPropagation();
  open(link.dataset.clip);
}, true);
document.addEventListener("keydown", (event) => {
  const cell = event.key === "Enter" && event.target.closest && event.target.closest(".ag-cell[col-id='clip']");
  const link = cell && cell.querySelector("a.clip-link");
  if (!link) return;
  event.preventDefault();
  event.stopPropagation();
  open(link.dataset.clip);
}, true);

// Which tab and which files of the report one looks at stand in the store "view", and so in the link.
const noted = { tab: "clips", files: "all" }; // these are where one starts, and need no words in the link
let set = {}; // what was last shown because the store says so: nobody has chosen that here
register("library", {
  look(tab, files, view) {
    const change = {};
    for (const [key, value] of Object.entries({ tab, files })) {
      const wanted = value === noted[key] ? "" : value || "";
      if (value && value !== set[key] && ((view || {})[key] || "") !== wanted) change[key] = wanted;
    }
    set = {};
    if (Object.keys(change).length) changeView(change);
    return clientside.no_update;
  },
  show(view, choices) {
    const wanted = { ...noted, ...view };
    const known = (choices || []).some((choice) => choice.value === wanted.files);
    set = { tab: wanted.tab === "report" ? "report" : "clips", files: known ? wanted.files : "all" };
    return [set.tab, set.files];
  },
  filter(shown, rows) {
    if (!shown || shown === "all") return rows || [];
    return (rows || []).filter((row) => shown === "added" ? row.added : row.verdict === shown);
  },
});
