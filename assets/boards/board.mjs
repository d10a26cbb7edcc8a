// An open board: its bar, its grid of blocks, and what others change on it meanwhile.
import { changeView, setStore } from "../shared/dash.mjs";
import { element, withAttributes } from "../shared/dom.mjs";
import { DATASET_CHOICE, SELECTION } from "../shared/ids.mjs";
import { lightBlocks } from "../blocks/selection.mjs";
import { Figure } from "../stage/figure.mjs";
import { MotionCache } from "../stage/motion.mjs";
import { ask, Refused } from "../shared/server.mjs";
import { take } from "./ahead.mjs";
import { Card } from "./card.mjs";
import { Comments, countOf, wordsOf } from "./comments.mjs";
import { button, iconButton, openMenu, openWindow, say } from "../shared/dialogs.mjs";
import { addBlock, editBlock } from "./edit.mjs";
import { Grid, gridstack } from "./grid.mjs";
import { deleteBoard, refresh, renameBoard, showHistory } from "./list.mjs";
import { openReport } from "./reports.mjs";
import { isDark, kindOf, known, shown } from "./state.mjs";
/** @import { Context } from "../blocks/types.d.ts" */
/** @import { Selection } from "../shared/types.d.ts" */
/** @import { Board, BlockData } from "./types.d.ts" */

const EVERY = 1000; // milliseconds between two questions whether the board has changed
const SETTLED = 350; // milliseconds after the last move until it is saved
const motions = new MotionCache();

export class OpenBoard {
  /** @param {HTMLElement} place @param {string} id @param {string} look "read", "present" or "" */
  constructor(place, id, look) {
    this.place = place;
    this.id = id;
    this.look = look;
    /** @type {Map<string, Card>} */
    this.cards = new Map();
    this.comments = new Comments(() => this.update(true));
    this.mark = "";
    this.closed = false;
    this.timer = 0;
    this.moving = 0;
    this.lighting = 0;
    /** @type {Board | null} */
    this.board = null;
    /** @type {Grid | null} */
    this.grid = null;
    this.warning = element("p", "boards-warning");
    this.warning.setAttribute("role", "alert");
    this.warning.hidden = true;
    this.note = element("p", "muted boards-note");
    this.stale = element("div", "boards-stale");
    this.bar = element("div", "boards-bar");
    this.barMark = "";
    /** @type {HTMLElement | undefined} */
    this.area = undefined;
    /** Of each dataset the clips of the group that the board is narrowed to. @type {Record<string, Set<string>> | null} */
    this.among = null;
    this.filterMark = "";
  }

  get still() {
    return this.look !== "" || !this.board?.may_edit;
  }

  async open() {
    let board;
    try {
      const all = [take(`boards/${this.id}`), known.listing ? null : refresh(), gridstack()]; // at once
      board = /** @type {Board} */ ((await Promise.all(all))[0]);
    } catch (error) {
      return this.fail(error);
    }
    this.board = board;
    this.mark = board.etag ?? "";
    const area = element("div", "grid-stack boards-grid");
    this.place.replaceChildren(element("div", "boards-open-board", element("div", "boards-main", this.bar, this.note, this.warning, this.stale, area), this.comments.node));
    this.grid = await Grid.open(area, this.still, (places) => this.moved(places));
    if (this.closed) return undefined;
    this.area = area;
    this.show(board);
    if (board.filters.dataset && board.filters.dataset !== shown.dataset && board.datasets.includes(board.filters.dataset)) {
      setStore(DATASET_CHOICE, { dataset: board.filters.dataset, at: Date.now() });
    }
    this.poll();
    return undefined;
  }

  close() {
    this.closed = true;
    clearTimeout(this.timer);
    cancelAnimationFrame(this.lighting);
    for (const card of this.cards.values()) card.close();
  }

  /** @param {unknown} error */
  fail(error) {
    const words = error instanceof Error ? error.message : String(error);
    this.place.replaceChildren(element("div", "empty-state", element("h2", "", "This board cannot be shown"), element("p", "muted", words), button("All boards", () => changeView({ board: "", screen: "" }))));
  }

  poll() {
    this.timer = window.setTimeout(async () => {
      if (this.closed || !this.place.isConnected) return this.close();
      if (document.visibilityState === "visible") await this.update();
      return this.poll();
    }, EVERY);
  }

  /** Ask whether the board has changed. @param {boolean} [surely] */
  async update(surely) {
    try {
      const board = await ask(`boards/${this.id}`, undefined, surely ? "" : this.mark);
      this.warn("");
      if (board && !this.closed) {
        this.mark = board.etag ?? "";
        this.show(board);
      }
    } catch (error) {
      if (error instanceof Refused && error.status === 404) this.warn("This board has been deleted, or its link renewed. What you see is its last state.");
      else this.warn(`${error instanceof Error ? error.message : error} Trying again; what you change now is not saved.`);
    }
  }

  /** @param {string} words */
  warn(words) {
    this.warning.hidden = !words;
    this.warning.textContent = words;
  }

  /** @param {Board} board */
  show(board) {
    if (this.moving && this.board) board = { ...board, blocks: board.blocks.map((block) => ({ ...block, ...placeOf(this.board, block.id) })) };
    this.board = board;
    this.showBar(board);
    this.showFilters(board);
    this.note.textContent = board.note;
    const ids = new Set(board.blocks.map(({ id }) => id));
    this.grid?.together(() => {
      for (const [id, card] of this.cards) if (!ids.has(id)) this.drop(id, card);
      for (const block of board.blocks) this.put(block);
    });
    this.grid?.place(board.blocks.map((block) => [/** @type {Card} */ (this.cards.get(block.id)).item, block]));
    for (const [id, card] of this.cards) {
      const [open, all] = countOf(board.comments, id);
      card.count(open, all);
    }
    this.showStale(board);
    this.comments.show(board);
  }

  /** @param {BlockData} block */
  put(block) {
    const card = this.cards.get(block.id);
    if (card?.block.kind === block.kind) return card.show(block);
    if (card) this.drop(block.id, card);
    const fresh = new Card(this.id, block, this.still, this.contextOf(block), {
      menu: (one, anchor) => this.menu(one, anchor),
      comment: (one) => this.comments.open(/** @type {Board} */ (this.board), one.block.id, one.name),
      renew: (one) => this.change({ action: "renew", block: one.block.id }).then(() => one.compute()),
      drawn: (one) => {
        this.narrowOne(one);
        this.light();
      },
    });
    fresh.head.addEventListener("keydown", (event) => {
      if (event.target === fresh.head) this.grid?.key(fresh.item, event);
    });
    this.cards.set(block.id, fresh);
    this.area?.append(fresh.item);
    this.grid?.add(fresh.item, block);
    return undefined;
  }

  /** @param {string} id @param {Card} card */
  drop(id, card) {
    card.close();
    this.cards.delete(id);
    this.grid?.remove(card.item);
  }

  /** What a block may ask of the page. @param {BlockData} block @returns {Context} */
  contextOf(block) {
    const now = () => this.cards.get(block.id)?.block ?? block;
    return {
      opens: true,
      dark: isDark,
      select: (selection) => this.select(now(), selection),
      figures: async (items, request) => {
        const found = await motions.load("/api", request ?? { dataset: now().dataset, items }, items);
        return found.flatMap((motion, k) => (motion instanceof Error ? [] : [new Figure(items[k], motion, k)]));
      },
    };
  }

  /** Select something as the block shows it: with its dataset and its settings. @param {BlockData} block @param {Selection} selection */
  select(block, selection) {
    if (block.dataset && block.dataset !== shown.dataset) setStore(DATASET_CHOICE, { dataset: block.dataset, at: Date.now() });
    const keys = kindOf(block.kind)?.keys ?? [];
    const view = block.settings.view ?? {};
    if (kindOf(block.kind)?.computes) changeView(Object.fromEntries(keys.map((key) => [key, view[key] ?? ""])));
    setStore(SELECTION, selection);
  }

  /** Show what is selected in all blocks; several changes at once are shown once. */
  light() {
    this.lighting ||= requestAnimationFrame(() => {
      this.lighting = 0;
      const cards = [...this.cards.values()];
      lightBlocks(cards.filter(({ block }) => block.dataset === shown.dataset).map((card) => ({ drawn: card.drawn, same: card.isSame })), shown.selection);
      lightBlocks(cards.filter(({ block }) => block.dataset !== shown.dataset).map((card) => ({ drawn: card.drawn, same: false })), {});
      for (const { drawn } of cards) drawn.settle?.(shown.view);
    });
  }

  recolour() {
    for (const card of this.cards.values()) card.drawn.recolour?.();
  }

  reload() {
    for (const card of this.cards.values()) card.load();
  }

  /** @param {Board} board */
  showBar(board) {
    const mark = JSON.stringify([board.title, board.filters, board.datasets, board.groups, board.comments.length, wordsOf(board.comments), this.still, this.look]);
    if (mark === this.barMark) return;
    this.barMark = mark;
    const title = element("h2", "ellipsis", board.title);
    const more = iconButton("dots", "More", () => openMenu(more, this.boardMenu()));
    const parts = [iconButton("left", "All boards", () => changeView({ board: "", screen: "" })), title, ...(this.look === "present" ? [] : [this.datasetPicker(board), ...this.groupPicker(board), this.labelField(board)])];
    if (!this.still) parts.push(button("Add block", () => addBlock(/** @type {Board} */ (this.board), this.grid?.bottom() ?? 0, (made) => this.take(made)), "primary"));
    if (this.look !== "present") parts.push(button(wordsOf(board.comments), () => this.comments.open(/** @type {Board} */ (this.board), "", "The whole board")), button("Share board", () => this.share()));
    parts.push(button(this.look === "present" ? "Leave" : "Present", () => this.present()));
    if (!this.still) parts.push(more);
    this.bar.replaceChildren(...parts);
  }

  /** @param {Board} board */
  datasetPicker(board) {
    const names = [...new Set(["", board.filters.dataset ?? "", ...board.datasets])];
    const picker = withAttributes(element("select", "boards-select", ...names.map((name) => withAttributes(element("option", "", name || "no dataset"), { value: name }))), { "aria-label": "Dataset of the board" });
    picker.value = board.filters.dataset ?? "";
    picker.disabled = this.still;
    picker.addEventListener("change", () => this.filter({ dataset: picker.value }));
    return picker;
  }

  /** @param {Board} board */
  labelField(board) {
    const field = withAttributes(element("input", "boards-label"), { placeholder: "Label", "aria-label": "Narrow the board to a label", type: "search" });
    field.value = board.filters.label ?? "";
    field.addEventListener("change", () => this.filter({ label: field.value.trim() }));
    return field;
  }

  /** Narrow the board to clips with a value of a property. @param {Board} board */
  groupPicker(board) {
    const now = board.filters.group ?? "";
    if (!board.groups.length && !now) return [];
    const offered = board.groups.map(([column, values]) => withAttributes(element("optgroup", "", ...values.map((value) => withAttributes(element("option", "", value), { value: `${column}=${value}` }))), { label: column }));
    const offers = board.groups.some(([column, values]) => values.some((value) => `${column}=${value}` === now));
    const picker = withAttributes(element("select", "boards-select", withAttributes(element("option", "", "all clips"), { value: "" }), ...(now && !offers ? [withAttributes(element("option", "", `${now} (gone)`), { value: now })] : []), ...offered), { "aria-label": "Narrow the board to a group of clips" });
    picker.value = now;
    picker.addEventListener("change", () => this.filter({ group: picker.value }));
    return [picker];
  }

  /** Change some filters: for all, or where the board may not be changed for oneself alone. @param {Board["filters"]} some */
  filter(some) {
    const board = /** @type {Board} */ (this.board);
    const filters = { ...board.filters, ...some };
    if (this.still) this.show({ ...board, filters });
    else this.change({ action: "filter", filters });
  }

  /** Fade what the filters leave out; the clips of a group are asked for where they may be others. @param {Board} board */
  async showFilters(board) {
    const mark = JSON.stringify([board.filters, board.groups, board.blocks.map(({ dataset }) => dataset)]);
    if (mark === this.filterMark) return;
    this.filterMark = mark;
    const group = board.filters.group ?? "";
    this.narrow(); // the label at once
    const answer = group ? await ask(`boards/${this.id}/group?of=${encodeURIComponent(group)}`).catch((error) => this.warn(error.message)) : null;
    if (this.filterMark !== mark) return;
    this.among = answer ? Object.fromEntries(Object.entries(/** @type {Record<string, string[]>} */ (answer.clips)).map(([name, clips]) => [name, new Set(clips)])) : null;
    this.narrow();
  }

  narrow() {
    for (const card of this.cards.values()) this.narrowOne(card);
  }

  /** @param {Card} card */
  narrowOne(card) {
    card.drawn.narrow?.(this.board?.filters.label ?? "", this.among ? this.among[card.block.dataset] ?? new Set() : null);
  }

  /** @param {Board} board */
  showStale(board) {
    const changed = board.blocks.filter((block) => block.data === "changed");
    this.stale.replaceChildren(...(changed.length ? [
      element("span", "", `The data of ${changed.length === 1 ? "a block has" : `${changed.length} blocks has`} changed since ${changed.length === 1 ? "it was" : "they were"} made.`),
      this.still ? "" : button("Recompute all", () => this.change({ action: "renew" }).then(() => {
        for (const card of this.cards.values()) if (kindOf(card.block.kind)?.computes) card.compute();
      })),
    ] : []));
  }

  /** Change the board; what the server gives back is shown. @param {Record<string, any>} body */
  async change(body) {
    try {
      this.take(await ask(`boards/${this.id}`, body));
    } catch (error) {
      say(error instanceof Error ? error.message : String(error));
      await this.update(true);
    }
  }

  /** @param {Board} board */
  take(board) {
    this.mark = ""; // whatever else has changed meanwhile comes with the next question
    this.show(board);
  }

  /** @param {Record<string, number[]>} places */
  moved(places) {
    clearTimeout(this.moving);
    if (this.board) this.board = { ...this.board, blocks: this.board.blocks.map((block) => ({ ...block, ...asPlace(places[block.id]) })) };
    this.moving = window.setTimeout(async () => {
      this.moving = 0;
      await this.change({ action: "move", places });
    }, SETTLED);
  }

  /** @param {Card} card @param {Element} anchor */
  menu(card, anchor) {
    const { block } = card;
    openMenu(anchor, [
      ["Change", () => editBlock(/** @type {Board} */ (this.board), card.block, (board) => this.take(board))],
      ["Duplicate", () => this.change({ action: "add", block: { ...block, id: "", y: block.y + block.h } })],
      ["Comment", () => this.comments.open(/** @type {Board} */ (this.board), block.id, card.name)],
      ["Remove", () => this.remove(block, card.name)],
    ]);
  }

  /** @param {BlockData} block @param {string} name */
  async remove(block, name) {
    await this.change({ action: "remove", block: block.id, version: block.version });
    if (!this.cards.has(block.id)) say(`“${name}” was removed.`, () => this.change({ action: "add", block }));
  }

  /** @returns {[string, () => void][]} */
  boardMenu() {
    const board = /** @type {Board} */ (this.board);
    return [
      ["Rename", () => renameBoard(board, () => this.update(true))],
      ["Duplicate", async () => {
        const copy = await ask(`boards/${this.id}`, { action: "duplicate" });
        changeView({ board: copy.id });
      }],
      ["Report", () => openReport(board.filters.dataset || shown.dataset, board)],
      ["History", () => showHistory(`boards/${this.id}`, board.title, (version) => this.change({ action: "restore", version }))],
      ["Delete", () => deleteBoard(board, () => changeView({ board: "", screen: "" }))],
    ];
  }

  share() {
    const { links } = /** @type {Board} */ (this.board);
    /** @param {string} name @param {string} words @param {string} address */
    const row = (name, words, address) => {
      const field = withAttributes(element("input"), { readonly: "", "aria-label": name });
      field.value = location.origin + address;
      return element("label", "boards-field", element("span", "", name), field, element("small", "muted", words));
    };
    /** @type {HTMLElement[]} */
    const parts = [row("To look at", "Whoever has it sees this board and nothing else.", links.read)];
    if (links.edit) {
      parts.push(row("To change", "Whoever has it can change this board as well.", links.edit));
      parts.push(button("Renew the links", () => this.change({ action: "renew-links" }).then(() => say("The links that were given away open this board no more."))));
    }
    const dialog = openWindow("Share this board", element("div", "boards-form", ...parts));
    dialog.querySelector("input")?.select();
  }

  async present() {
    const leaving = this.look === "present";
    if (leaving && document.fullscreenElement) await document.exitFullscreen().catch(() => {});
    if (!leaving) await document.documentElement.requestFullscreen?.().catch(() => {}); // without it, it fills the window
    changeView({ screen: leaving ? "" : "present" });
  }
}

/** @param {number[] | undefined} place */
const asPlace = (place) => (place ? { x: place[0], y: place[1], w: place[2], h: place[3] } : {});

/** Where a block lies on a board that was moved here and is not saved yet. @param {Board | null} board @param {string} id */
function placeOf(board, id) {
  const block = board?.blocks.find((one) => one.id === id);
  return block ? { x: block.x, y: block.y, w: block.w, h: block.h } : {};
}
