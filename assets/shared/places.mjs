// Where Ctrl+K looks: rooms add what they know.
import { allWithin } from "./dom.mjs";

/**
 * Something that can be opened by its name. about: what it is. opens: id of a folded part of the page, opened as well.
 * @typedef {{ name: string, about: string, address: string, opens?: string, act?: () => void }} Place
 */

/** @type {((text: string) => Promise<Place[]> | Place[])[]} */
const sources = [() => allWithin(document, ".nav-link").map((link) => ({ name: link.textContent ?? "", about: "page", address: link.getAttribute("href") ?? "/" }))];

/** Let Ctrl+K look here too; `find` gets what was typed. @param {(text: string) => Promise<Place[]> | Place[]} find */
export const addPlaces = (find) => { sources.push(find); };

/**
 * What all sources know, those that match first by how their names begin; a source that fails has nothing.
 * @param {string} text
 */
export async function findPlaces(text) {
  const found = await Promise.all(sources.map(async (find) => {
    try { return await find(text); } catch { return []; }
  }));
  return matching(found.flat(), text);
}

/**
 * The places in whose names or descriptions all words stand; first those that are called so, or whose names begin so.
 * @param {Place[]} places
 * @param {string} text
 */
export function matching(places, text) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const found = places.filter(({ name, about }) => words.every((word) => `${name} ${about}`.toLowerCase().includes(word)));
  const wanted = words.join(" ");
  /** How far a name is from what was typed. @param {Place} place */
  const distance = ({ name }) => {
    const called = name.toLowerCase();
    return [called === wanted, called.startsWith(wanted), called.startsWith(words[0] ?? ""), true].indexOf(true);
  };
  return found.sort((a, b) => distance(a) - distance(b));
}
