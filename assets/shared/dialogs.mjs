// Small windows: forms, questions, lists to choose from, and the line that offers to undo.
import { element, icon, targetOf, withAttributes } from "./dom.mjs";
/** @import { Child } from "./dom.mjs" */
/** @import { Field } from "./types.d.ts" */

/** @param {string} name @param {() => void} act @param {string} [className] */
export function button(name, act, className = "") {
  const node = element("button", `boards-button ${className}`.trim(), name);
  node.type = "button";
  node.addEventListener("click", act);
  return node;
}

/** A button with an icon alone. @param {string} symbol @param {string} name @param {() => void} act */
export function iconButton(symbol, name, act) {
  const node = button("", act, "boards-icon");
  node.append(icon(symbol, 16));
  node.title = name;
  node.setAttribute("aria-label", name);
  return node;
}

/**
 * A window in front of the page; gives it and what closes it.
 * @param {string} title
 * @param {...Child} parts
 */
export function openWindow(title, ...parts) {
  const dialog = element("dialog", "boards-dialog", element("h2", "", title), ...parts);
  dialog.setAttribute("aria-label", title);
  dialog.addEventListener("close", () => dialog.remove());
  dialog.addEventListener("click", (event) => {
    if (targetOf(event) === /** @type {unknown} */ (dialog)) dialog.close(); // beside it
  });
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}

/**
 * A form; `save` gets the values and may throw an Error, whose words are shown and keep the window open.
 * @param {string} title
 * @param {Field[]} fields
 * @param {string} action
 * @param {(values: Record<string, string>) => Promise<unknown>} save
 */
export function openForm(title, fields, action, save) {
  const problem = element("p", "form-problem");
  problem.setAttribute("role", "alert");
  const form = element("form", "boards-form", ...fields.map(fieldOf), problem);
  const send = element("button", "boards-button primary", action);
  const dialog = openWindow(title, form);
  form.append(element("div", "boards-actions", button("Cancel", () => dialog.close()), send));
  form.addEventListener("submit", async (event) => {
    event.preventDefault();
    send.disabled = true;
    try {
      await save(Object.fromEntries([...new FormData(form)].map(([name, value]) => [name, String(value)])));
      dialog.close();
    } catch (error) {
      problem.textContent = error instanceof Error ? error.message : String(error);
    }
    send.disabled = false;
  });
  /** @type {HTMLElement | null} */ (form.querySelector("input, textarea, select"))?.focus();
  return dialog;
}

/** @param {Field} field */
function fieldOf({ name, label, value = "", kind = "line", choices = [], hint = "" }) {
  /** @type {HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement} */
  let control;
  if (kind === "choice") {
    control = element("select", "", ...choices.map(([key, words]) => withAttributes(element("option", "", words), { value: key })));
  } else control = kind === "text" ? withAttributes(element("textarea"), { rows: 7 }) : element("input");
  control.name = name;
  control.value = value;
  return element("label", "boards-field", element("span", "", label), control, hint && element("small", "muted", hint));
}

/**
 * A menu below a button.
 * @param {Element} anchor
 * @param {[string, () => void][]} entries
 */
export function openMenu(anchor, entries) {
  const menu = element("div", "boards-menu", ...entries.map(([name, act]) => {
    const entry = button(name, () => {
      close();
      act();
    });
    entry.setAttribute("role", "menuitem");
    return entry;
  }));
  menu.setAttribute("role", "menu");
  const { left, right, bottom } = anchor.getBoundingClientRect();
  const stop = new AbortController();
  const close = () => {
    stop.abort();
    menu.remove();
  };
  (document.fullscreenElement ?? document.body).append(menu);
  menu.style.top = `${Math.min(bottom + 4, innerHeight - menu.offsetHeight - 8)}px`;
  menu.style.left = `${Math.max(8, Math.min(left, right - menu.offsetWidth, innerWidth - menu.offsetWidth - 8))}px`;
  const leave = (/** @type {Event} */ event) => {
    if (!menu.contains(/** @type {Node} */ (event.target))) close();
  };
  document.addEventListener("pointerdown", leave, { signal: stop.signal, capture: true });
  menu.addEventListener("keydown", (event) => {
    const at = [...menu.children].indexOf(/** @type {Element} */ (document.activeElement));
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === "Escape") close();
    else if (step) /** @type {HTMLElement} */ (menu.children[(at + step + entries.length) % entries.length]).focus();
  });
  /** @type {HTMLElement} */ (menu.firstElementChild).focus();
}

/** @type {HTMLElement | null} */
let line = null;

/**
 * Say what was done, with a way back for some seconds.
 * @param {string} words
 * @param {() => void} [undo]
 */
export function say(words, undo) {
  line?.remove();
  const shown = element("div", "boards-toast", element("span", "", words), undo ? button("Undo", () => {
    shown.remove();
    undo();
  }) : null);
  shown.setAttribute("role", "status");
  line = shown;
  // in the window that is open, for everything beside it cannot be clicked
  (document.querySelector("dialog[open]") ?? document.fullscreenElement ?? document.body).append(shown);
  setTimeout(() => shown.remove(), undo ? 12_000 : 4000);
}

/** How long ago a moment (seconds since 1970) was. @param {number} moment */
export function ago(moment) {
  const minutes = Math.max(0, (Date.now() / 1000 - moment) / 60);
  if (minutes < 1) return "just now";
  if (minutes < 60) return `${Math.floor(minutes)} min ago`;
  return minutes < 1440 ? `${Math.floor(minutes / 60)} h ago` : new Date(moment * 1000).toLocaleDateString("en-CA");
}
