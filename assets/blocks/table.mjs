// Tables of things that play when a row is clicked, each with a filmstrip.
import { element } from "../shared/dom.mjs";
import { asButton } from "./tip.mjs";

/** @param {string[]} cells @param {string} strip @param {string} name @param {() => void} act */
export function tableRow(cells, strip, name, act) {
  const picture = element("td", "block-strip");
  picture.innerHTML = strip; // drawn by our own server, its title escaped
  return asButton(element("tr", "", ...cells.map((cell, k) => element("td", k && k < 4 ? "number" : "", cell || " ")), picture), name, act);
}

/** @param {string[]} heads @param {HTMLTableRowElement[]} rows @param {string} note */
export function tableOf(heads, rows, note) {
  return element("div", "block-table", element("table", "", element("thead", "", element("tr", "", ...heads.map((head, k) => element("th", k && k < 4 ? "number" : "", head)))), element("tbody", "", ...rows)), note && element("p", "muted", note));
}
