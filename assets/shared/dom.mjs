// Finds and makes elements of the page.

/** @typedef {Node | string | number | null | undefined} Child */

/**
 * Elements that are found have the type of input fields, which have most members: the caller knows what it looks for.
 * @typedef {HTMLInputElement} Found
 */

/** The element with an id; null where the page has none. @param {string} id */
export const find = (id) => /** @type {Found | null} */ (document.getElementById(id));

/**
 * The element with an id, which must be there. Throws where it is not.
 * @param {string} id
 */
export function need(id) {
  const node = find(id);
  if (!node) throw new Error(`The page has no element "${id}".`);
  return node;
}

/**
 * The first element within `root` that matches, which must be there. Throws where there is none.
 * @param {ParentNode} root
 * @param {string} selector
 */
export function within(root, selector) {
  const node = root.querySelector(selector);
  if (!node) throw new Error(`Nothing matches "${selector}".`);
  return /** @type {Found} */ (node);
}

/**
 * All elements within `root` that match, in order.
 * @param {ParentNode} root
 * @param {string} selector
 * @returns {Found[]}
 */
export const allWithin = (root, selector) => Array.from(root.querySelectorAll(selector));

/**
 * The nearest element, from `node` outwards, that matches and must be there. Throws where there is none.
 * @param {Element} node
 * @param {string} selector
 */
export function around(node, selector) {
  const found = node.closest(selector);
  if (!found) throw new Error(`Nothing around it matches "${selector}".`);
  return /** @type {Found} */ (found);
}

/** The elements directly within another. @param {Element} node */
export const childrenOf = (node) => /** @type {Found[]} */ (Array.from(node.children));

/** The element an event came from, as a field, for handlers that read its value. @param {{ target: any }} event */
export const targetOf = (event) => /** @type {Found} */ (event.target);

/** Whether the element an event came from has a class. @param {{ target: any }} event @param {string} name */
export const hasClass = (event, name) => event.target?.classList?.contains(name) ?? false;

/**
 * The nearest element, from the one an event came from outwards, that matches; null where there is none.
 * @param {{ target: any }} event
 * @param {string} selector
 * @returns {Found | null}
 */
export const closest = (event, selector) => event.target?.closest?.(selector) ?? null;

/**
 * A new element; children that are null, undefined or empty text are left out.
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {string} [className]
 * @param {...Child} children
 */
export function element(name, className = "", ...children) {
  const node = document.createElement(name);
  if (className) node.className = className;
  for (const child of children) if (child !== null && child !== undefined && child !== "") node.append(/** @type {Node} */ (child));
  return node;
}

/**
 * The same node, with attributes.
 * @template {Element} Kind
 * @param {Kind} node
 * @param {Record<string, string | number>} attributes
 */
export function withAttributes(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
  return node;
}

/**
 * A new SVG element.
 * @template {keyof SVGElementTagNameMap} Name
 * @param {Name} name
 * @param {Record<string, string | number>} [attributes]
 * @param {...(Node | string)} children
 */
export function svgElement(name, attributes = {}, ...children) {
  const node = withAttributes(document.createElementNS("http://www.w3.org/2000/svg", name), attributes);
  node.append(...children);
  return node;
}

/** An icon of icons.css, hidden from screen readers. @param {string} symbol */
export function icon(symbol, size = 14) {
  const node = element("span", `icon icon-${symbol}`);
  node.style.width = node.style.height = `${size}px`;
  node.setAttribute("aria-hidden", "true");
  return node;
}

/**
 * What draws on a canvas. Throws where the browser cannot.
 * @param {HTMLCanvasElement} canvas
 * @param {CanvasRenderingContext2DSettings} [settings]
 */
export function context2d(canvas, settings) {
  const context = canvas.getContext("2d", settings);
  if (!context) throw new Error("This browser cannot draw on a canvas.");
  return context;
}

/**
 * Make a link point to an address, or be disabled where there is none.
 * @param {string} id
 * @param {string | false | null | undefined} address
 */
export function setLink(id, address) {
  const link = need(id);
  if (address) link.setAttribute("href", address);
  else link.removeAttribute("href");
  link.classList.toggle("disabled", !address);
  link.setAttribute("aria-disabled", String(!address));
}

/** Call a function when all of the page's own text has been read: at once, where it has. @param {() => void} start */
export function whenParsed(start) {
  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
  else start();
}
