// A block on a board: its head, what it shows, and how it is kept up to date.
import { drawBlock } from "../blocks/registry.mjs";
import { element } from "../shared/dom.mjs";
import { percent } from "../shared/words.mjs";
import { ask } from "../shared/server.mjs";
import { button, iconButton } from "../shared/dialogs.mjs";
import { take } from "./ahead.mjs";
import { kindOf, shown } from "./state.mjs";
/** @import { Context, Drawn } from "../blocks/types.d.ts" */
/** @import { BlockAnswer, BlockData } from "./types.d.ts" */

const POLL = 1500; // milliseconds between two looks at a job

/**
 * @typedef {object} CardActions
 * @property {(card: Card, anchor: Element) => void} menu
 * @property {(card: Card) => void} comment
 * @property {(card: Card) => void} renew
 * @property {(card: Card) => void} drawn called when its content has been drawn
 */

export class Card {
  /**
   * @param {string} board
   * @param {BlockData} block
   * @param {boolean} still
   * @param {Context} context
   * @param {CardActions} actions
   */
  constructor(board, block, still, context, actions) {
    this.board = board;
    this.still = still;
    this.last = "";
    this.block = block;
    this.context = context;
    this.actions = actions;
    /** @type {Drawn} */
    this.drawn = {};
    this.mark = "";
    this.waiting = 0;
    this.title = element("h3", "board-title ellipsis");
    this.badge = iconButton("note", "Comments", () => actions.comment(this));
    this.note = element("div", "board-note");
    this.body = element("div", "board-body");
    const more = iconButton("dots", "More", () => actions.menu(this, more));
    this.head = element("header", "board-head", this.title, this.badge, still ? null : more);
    this.head.tabIndex = still ? -1 : 0;
    this.item = element("div", "grid-stack-item", element("section", "grid-stack-item-content board-block", this.head, this.note, this.body));
    this.item.dataset.block = block.id;
    this.item.dataset.kind = block.kind;
    this.body.append(element("div", "muted board-empty", "Loading …"));
    this.show(block);
  }

  /** Whether numbers of motifs and actions mean the same in it as in the selection: the page has its settings. */
  get isSame() {
    const view = this.block.settings.view ?? {};
    return (kindOf(this.block.kind)?.keys ?? []).every((key) => (view[key] ?? "") === (shown.view[key] ?? ""));
  }

  /** What it is called: its title, or what its kind is called. */
  get name() {
    return this.block.settings.title || kindOf(this.block.kind)?.label || this.block.kind;
  }

  /** Take over a block as it is now; its content is asked for again where that may be another. @param {BlockData} block */
  show(block) {
    const mark = JSON.stringify([block.kind, block.settings, block.data, block.dataset]);
    this.block = block;
    this.title.textContent = block.settings.title ?? "";
    this.head.classList.toggle("board-head-bare", !block.settings.title);
    this.head.setAttribute("aria-label", `${this.name}. Arrow keys move it, with shift they resize it.`);
    if (mark === this.mark) return;
    this.mark = mark;
    this.load();
  }

  /** @param {number} open @param {number} all */
  count(open, all) {
    this.badge.dataset.count = open ? String(open) : "";
    this.badge.classList.toggle("board-quiet", !all);
  }

  async load() {
    clearTimeout(this.waiting);
    const mark = this.mark;
    /** @type {BlockAnswer} */
    let answer;
    try {
      answer = await take(`boards/${this.board}/blocks/${this.block.id}`);
    } catch (error) {
      answer = { state: "broken", content: null, words: error instanceof Error ? error.message : String(error), job: null };
    }
    if (mark !== this.mark) return; // it has become another meanwhile
    this.fill(answer);
  }

  /** @param {BlockAnswer} answer */
  fill(answer) {
    const { state, content, words, job } = answer;
    this.item.dataset.state = state;
    this.note.replaceChildren();
    const computes = state === "missing" && !job && !this.still && kindOf(this.block.kind)?.computes;
    if (content === null) this.clear(element("div", "muted board-empty", words, computes ? button("Compute", () => this.compute()) : null));
    else if (JSON.stringify(content) !== this.last) this.draw(content);
    if (state === "changed") this.note.append(words, this.still ? "" : button("Recompute", () => this.actions.renew(this)));
    else if (state === "gone") this.note.append(words);
    else if (computes && content !== null) this.note.append(words, button("Compute", () => this.compute()));
    if (job?.state === "failed") this.note.append(job.error);
    else if (job) {
      this.note.append(`Computing: ${percent(job.fraction)}`);
      this.waiting = window.setTimeout(() => this.load(), POLL);
    }
  }

  async compute() {
    await ask(`boards/${this.board}/blocks/${this.block.id}/compute`, {}).catch((error) => this.note.replaceChildren(error.message));
    await this.load();
  }

  /** @param {any} content */
  draw(content) {
    this.clear();
    this.last = JSON.stringify(content);
    const place = element("div", "board-content");
    this.body.append(place);
    this.drawn = drawBlock(place, this.block.kind, content, this.context);
    this.actions.drawn(this);
  }

  /** @param {...Node} parts */
  clear(...parts) {
    this.drawn.close?.();
    this.drawn = {};
    this.last = "";
    this.body.replaceChildren(...parts);
  }

  close() {
    clearTimeout(this.waiting);
    this.drawn.close?.();
    this.mark = "closed";
  }
}
