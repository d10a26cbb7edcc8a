// What opens a menu or a window is said of the button itself. Mantine says it of a box around the button, where screen
// readers do not look, and axe calls it wrong.
const SAID = ["aria-haspopup", "aria-expanded", "aria-controls"];

/** @param {Element} box */
function hand(box) {
  const button = box.querySelector("button");
  if (box.tagName !== "DIV" || box.hasAttribute("role") || !button) return;
  for (const name of SAID) {
    const value = box.getAttribute(name);
    if (value === null) continue;
    button.setAttribute(name, value);
    box.removeAttribute(name);
  }
}

new MutationObserver((changes) => {
  for (const { type, target, addedNodes } of changes) {
    if (type === "attributes") hand(/** @type {Element} */ (target));
    for (const node of addedNodes) {
      if (!(node instanceof Element)) continue;
      if (node.hasAttribute("aria-haspopup")) hand(node);
      for (const box of node.querySelectorAll("div[aria-haspopup]")) hand(box);
    }
  }
}).observe(document.documentElement, { subtree: true, childList: true, attributeFilter: ["aria-haspopup", "aria-expanded"] });
