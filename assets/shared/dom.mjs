// Elements of the page, made in one line.

/** A new element; children that are null, undefined or empty text are left out. */
export function element(name, className = "", ...children) {
  const node = document.createElement(name);
  if (className) node.className = className;
  node.append(...children.filter((child) => child !== null && child !== undefined && child !== ""));
  return node;
}

/** The same node, with attributes. */
export function withAttributes(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  return node;
}

const SVG = "http://www.w3.org/2000/svg";

/** A new SVG element. */
export function svgElement(name, attributes = {}, ...children) {
  const node = withAttributes(document.createElementNS(SVG, name), attributes);
  node.append(...children);
  return node;
}

/** An icon of icons.css, hidden from screen readers. */
export function icon(symbol, size = 14) {
  const node = element("span", `icon icon-${symbol}`);
  node.style.width = node.style.height = `${size}px`;
  node.setAttribute("aria-hidden", "true");
  return node;
}

export const find = (id) => document.getElementById(id);

/** Make a link point to an address, or be disabled where there is none. */
export function setLink(id, address) {
  const link = find(id);
  if (address) link.setAttribute("href", address);
  else link.removeAttribute("href");
  link.classList.toggle("disabled", !address);
  link.setAttribute("aria-disabled", String(!address));
}

/** Call a function when all of the page's own text has been read: at once, where it has. */
export function whenParsed(start) {
  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
  else start();
}
