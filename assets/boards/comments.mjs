// What people say about a board and its blocks: open or resolved, with answers and mentions.
import { element, withAttributes } from "../shared/dom.mjs";
import { plural } from "../shared/words.mjs";
import { ask, person } from "../shared/server.mjs";
import { ago, button, iconButton } from "../shared/dialogs.mjs";
/** @import { Board, CommentData } from "./types.d.ts" */

/**
 * How many comments of a block are open, and how many there are.
 * @param {CommentData[]} comments
 * @param {string} block
 */
export function countOf(comments, block) {
  const own = comments.filter((comment) => comment.block === block && !comment.parent);
  return [own.filter((comment) => !comment.resolved).length, own.length];
}

export class Comments {
  /** @param {() => Promise<unknown>} again asks for the board anew */
  constructor(again) {
    this.again = again;
    this.node = element("aside", "boards-comments");
    this.node.setAttribute("aria-label", "Comments");
    this.node.hidden = true;
    this.node.addEventListener("keydown", (event) => event.key === "Escape" && this.close()); // what is written stays
    this.block = "";
    this.title = "";
    this.last = "";
    /** @type {Board | null} */
    this.board = null;
  }

  /** @param {Board} board @param {string} block @param {string} title */
  open(board, block, title) {
    Object.assign(this, { block, title });
    this.node.hidden = false;
    this.last = "";
    this.show(board);
    this.node.querySelector("textarea")?.focus();
  }

  close() {
    this.node.hidden = true;
  }

  /** Draw what has been said, unless nothing has changed or someone is writing an answer. @param {Board} board */
  show(board) {
    this.board = board;
    const own = board.comments.filter((comment) => comment.block === this.block);
    const mark = JSON.stringify(own);
    if (this.node.hidden || mark === this.last) return;
    const draft = this.node.querySelector("textarea")?.value ?? "";
    this.last = mark;
    const threads = own.filter((comment) => !comment.parent).sort((a, b) => Number(a.resolved) - Number(b.resolved) || b.created - a.created);
    this.node.replaceChildren(
      element("div", "boards-bar", element("h3", "ellipsis", this.title), iconButton("close", "Close the comments", () => this.close())),
      this.form("Say something; @name tells someone", "Comment", (text) => this.send({ action: "add", text, place: this.place() }), draft),
      ...threads.map((comment) => this.thread(comment, own.filter((answer) => answer.parent === comment.id))),
      threads.length ? "" : element("p", "muted", "Nobody has said anything yet."),
    );
  }

  place() {
    return this.block ? `board:${this.board?.id}/block:${this.block}` : `board:${this.board?.id}`;
  }

  /** @param {CommentData} comment @param {CommentData[]} answers */
  thread(comment, answers) {
    const act = comment.resolved ? "reopen" : "resolve";
    const folded = comment.resolved;
    const node = element("article", `boards-comment${folded ? " resolved" : ""}`, this.said(comment), ...answers.map((answer) => this.said(answer)));
    const actions = element("div", "boards-comment-actions",
      button(folded ? "Reopen" : "Resolve", () => this.send({ action: act, id: comment.id })),
      folded ? null : button("Answer", () => {
        actions.replaceWith(this.form("Answer", "Answer", (text) => this.send({ action: "add", text, place: this.place(), parent: comment.id })));
        node.querySelector("textarea")?.focus();
      }));
    node.append(actions);
    return node;
  }

  /** @param {CommentData} comment */
  said({ author, created, text, resolved }) {
    const words = text.split(/(@[\w][\w.-]*)/).map((part) => (part.startsWith("@") ? element("mark", "boards-mention", part) : part));
    return element("div", "boards-said", element("div", "muted", `${author || "Someone"}, ${ago(created)}${resolved ? ", resolved" : ""}`), element("p", "", ...words));
  }

  /** @param {string} hint @param {string} action @param {(text: string) => Promise<void>} send @param {string} [draft] */
  form(hint, action, send, draft = "") {
    const text = withAttributes(element("textarea"), { rows: 2, placeholder: hint, "aria-label": hint });
    text.value = draft;
    const names = element("div", "boards-names");
    text.addEventListener("input", () => this.offer(text, names));
    const problem = element("p", "form-problem");
    const form = element("form", "boards-form", text, names, problem, element("button", "boards-button primary", action));
    form.addEventListener("submit", async (event) => {
      event.preventDefault();
      const said = text.value;
      text.value = "";
      await send(said).catch((error) => {
        text.value = said;
        problem.textContent = error.message;
      });
    });
    return form;
  }

  /** Names to mention, while one types after an @. @param {HTMLTextAreaElement} text @param {HTMLElement} names */
  offer(text, names) {
    const begun = /@([\w.-]*)$/.exec(text.value.slice(0, text.selectionStart));
    const known = begun ? (this.board?.names ?? []).filter((name) => name.toLowerCase().startsWith(begun[1].toLowerCase())).slice(0, 5) : [];
    names.replaceChildren(...known.map((name) => button(`@${name}`, () => {
      const at = text.selectionStart;
      text.setRangeText(`@${name.replace(/\s+/g, ".")} `, at - (begun?.[0].length ?? 0), at, "end");
      names.replaceChildren();
      text.focus();
    })));
  }

  /** @param {Record<string, any>} body */
  async send(body) {
    if (body.action === "add" && !this.board?.me && !person.name) person.name = window.prompt("Your name, for the others:") ?? "";
    await ask("comments", body);
    await this.again();
  }
}

/** @param {CommentData[]} comments */
export const wordsOf = (comments) => {
  const open = comments.filter((comment) => !comment.resolved && !comment.parent).length;
  return open ? plural(open, "open comment") : "Comments";
};
