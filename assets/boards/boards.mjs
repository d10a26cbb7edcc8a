// The Boards page: the list, or the board that the link names.
import { clientside, register } from "../shared/dash.mjs";
import { element, find } from "../shared/dom.mjs";
import { SHELL } from "../shared/ids.mjs";
import { OpenBoard } from "./board.mjs";
import { BOARDS_PLACE } from "./ids.mjs";
import { showList } from "./list.mjs";
import { isDark, shown } from "./state.mjs";
import "./places.mjs";
import "./save_view.mjs";
/** @import { Selection, View } from "../shared/types.d.ts" */

/** @type {OpenBoard | null} */
let open = null;
/** @type {{ place: HTMLElement | null, board: string, look: string, dark: boolean, ended: string }} */
let last = { place: null, board: "", look: "", dark: false, ended: "" };

register("boards", {
  // Called whenever something of what is shown changes, while the page is there.
  /** @param {View | null} view @param {string | null} dataset @param {Selection | null} selection @param {string} _theme @param {string | null} ended */
  show(view, dataset, selection, _theme, ended) {
    Object.assign(shown, { view: view ?? {}, dataset: dataset ?? "", selection: selection ?? {} });
    const place = find(BOARDS_PLACE);
    if (!place) return clientside.no_update;
    const now = { place, board: view?.board ?? "", look: view?.screen ?? "", dark: isDark(), ended: ended ?? "" };
    const before = last;
    last = now;
    document.getElementById(SHELL)?.classList.toggle("presenting", now.look === "present" && now.board !== "");
    if (now.place !== before.place || now.board !== before.board || now.look !== before.look) {
      open?.close();
      open = null;
      if (now.board) {
        open = new OpenBoard(place, now.board, now.look);
        open.open();
      } else showList(place).catch((error) => place.replaceChildren(element("p", "boards-warning", error.message)));
    } else if (now.ended !== before.ended) open?.reload();
    if (now.dark !== before.dark) requestAnimationFrame(() => open?.recolour());
    open?.light();
    return clientside.no_update;
  },
});

// a board that fills the screen is left when one goes to another page, and with Escape
new MutationObserver(() => {
  if (find(BOARDS_PLACE)) return;
  document.getElementById(SHELL)?.classList.remove("presenting");
  open?.close();
  open = null;
  last = { ...last, place: null };
}).observe(document.documentElement, { childList: true, subtree: true });
