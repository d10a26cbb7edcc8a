/* Trees that the server drew (webapp/features/grammar/figures/parse_tree.py): put into the page, lit while they play, saved as pictures. */
import { allWithin, closest } from "../shared/dom.mjs";
import { savePicture } from "../shared/downloads.mjs";
import { isFresh, state } from "./state.mjs";
/** @import { TreeBox, TreeNode } from "./types.d.ts" */

/**
 * Put a tree into its box; `choose({path, first, end, leaf})` is called for a click, Enter or Space on a node.
 * @param {TreeBox} box
 * @param {string | null} svg
 * @param {(node: TreeNode) => void} choose
 */
export const showTree = (box, svg, choose) => {
  box.choose = choose;
  if (isFresh(box, svg || "")) {
    const left = box.scrollLeft;
    const focused = closest({ target: document.activeElement }, ".tree-node");
    const path = focused && box.contains(focused) ? focused.dataset.path : null;
    box.innerHTML = svg || ""; // our own drawing, names escaped
    box.scrollLeft = left;
    const nodes = allWithin(box, ".tree-node");
    const first = nodes.find((node) => node.dataset.path === path) || nodes[0];
    first?.setAttribute("tabindex", "0");
    if (path !== null) first?.focus({ preventScroll: true });
  }
  if (box.watched) return;
  box.watched = true;
  box.addEventListener("click", (event) => act(box, closest(event, ".tree-node")));
  box.addEventListener("keydown", (event) => {
    const node = closest(event, ".tree-node");
    if (!node) return;
    if (event.key === "Enter" || event.key === " ") act(box, node);
    else if (!move(box, node, event.key)) return;
    event.preventDefault();
    event.stopPropagation();
  });
};

/** @param {TreeBox} box @param {HTMLElement | null} node */
function act(box, node) {
  if (!node) return;
  focus(box, node);
  const { path = "", first, end } = node.dataset;
  box.choose?.({ path, first: Number(first), end: Number(end), leaf: node.classList.contains("tree-leaf") });
}

/** @param {HTMLElement} box @param {HTMLElement} node */
function focus(box, node) {
  for (const other of allWithin(box, '.tree-node[tabindex="0"]')) other.setAttribute("tabindex", "-1");
  node.setAttribute("tabindex", "0");
  node.focus();
}

/**
 * Up to the phrase above, down to its first part, left and right among its parts.
 * @param {HTMLElement} box
 * @param {HTMLElement} node
 * @param {string} key
 */
function move(box, node, key) {
  const at = node.dataset.path ?? "";
  const cut = at.lastIndexOf(".");
  const above = at === "" ? null : cut < 0 ? "" : at.slice(0, cut);
  /** @param {string} path */
  const inside = (path) => allWithin(box, ".tree-node").filter((one) => {
    const own = one.dataset.path ?? "";
    if (own === "" || own === path) return false;
    const parent = own.includes(".") ? own.slice(0, own.lastIndexOf(".")) : "";
    return parent === path;
  });
  const siblings = above === null ? [node] : inside(above);
  const number = siblings.indexOf(node);
  /** @type {Record<string, () => HTMLElement | null | undefined>} */
  const ways = {
    ArrowUp: () => above === null ? null : allWithin(box, ".tree-node").find((one) => one.dataset.path === above),
    ArrowDown: () => inside(at)[0],
    ArrowLeft: () => siblings[number - 1],
    ArrowRight: () => siblings[number + 1],
  };
  const next = ways[key];
  if (!next) return false;
  const found = next();
  if (found) focus(box, found);
  return true;
}

/**
 * The action that plays now, by its number; none where it is -1.
 * @param {TreeBox | null} box
 * @param {number} number
 */
export const lightTree = (box, number) => {
  if (!box || box.lit === number) return;
  box.lit = number;
  for (const leaf of allWithin(box, ".tree-leaf")) {
    const here = Number(leaf.dataset.first) === number;
    leaf.classList.toggle("lit", here);
    if (!here) continue;
    const [outer, inner] = [box.getBoundingClientRect(), leaf.getBoundingClientRect()];
    if (inner.left < outer.left || inner.right > outer.right) box.scrollLeft += inner.left - outer.left - 40;
  }
};

// The same drawing as a picture: painted by the browser at twice its size.
document.addEventListener("click", (event) => {
  const button = closest(event, ".tree-png");
  const link = button && /** @type {HTMLAnchorElement | null} */ (document.getElementById(button.dataset.link ?? ""));
  if (link?.href) savePicture(link.href, "png", `${state.data.dataset || "motionscape"} tree`);
});
