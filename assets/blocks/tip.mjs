// One small box of text that follows the pointer, for everything in blocks that can be pointed at.
import { element } from "../shared/dom.mjs";

/** @type {HTMLElement | null} */
let box = null;

function tipBox() {
  if (!box || !box.isConnected) {
    box = element("div", "block-tip");
    box.setAttribute("role", "tooltip");
    box.hidden = true;
    document.body.append(box);
  }
  return box;
}

/**
 * Show lines of text, or a drawing, beside the pointer.
 * @param {{ clientX: number, clientY: number }} at
 * @param {...(string | Node)} parts
 */
export function showTip(at, ...parts) {
  const tip = tipBox();
  tip.replaceChildren(...parts.map((part) => (typeof part === "string" ? element("div", "", part) : part)));
  tip.hidden = false;
  const { offsetWidth: width, offsetHeight: height } = tip;
  tip.style.left = `${Math.max(4, Math.min(at.clientX + 14, innerWidth - width - 8))}px`;
  tip.style.top = `${at.clientY + 18 + height > innerHeight ? Math.max(4, at.clientY - height - 10) : at.clientY + 18}px`;
}

export function hideTip() {
  if (box) box.hidden = true;
}

/**
 * Show a tip while the pointer or the focus is on an element.
 * @template {Element} Kind
 * @param {Kind} node
 * @param {() => (string | Node)[]} parts
 */
export function tipOn(node, parts) {
  node.addEventListener("pointermove", (event) => showTip(/** @type {PointerEvent} */ (event), ...parts()));
  node.addEventListener("pointerleave", hideTip);
  node.addEventListener("focus", () => {
    const { left, bottom } = node.getBoundingClientRect();
    if (node.matches(":focus-visible")) showTip({ clientX: left, clientY: bottom - 12 }, ...parts());
  });
  node.addEventListener("blur", hideTip);
  return node;
}

/**
 * Make an element a button for pointer and keyboard.
 * @template {Element} Kind
 * @param {Kind} node
 * @param {string} name
 * @param {(event: Event) => void} act
 */
export function asButton(node, name, act) {
  node.setAttribute("role", "button");
  node.setAttribute("tabindex", "0");
  node.setAttribute("aria-label", name);
  node.addEventListener("click", act);
  node.addEventListener("keydown", (event) => {
    const { key } = /** @type {KeyboardEvent} */ (event);
    if (key !== "Enter" && key !== " ") return;
    event.preventDefault();
    act(event);
  });
  return node;
}
