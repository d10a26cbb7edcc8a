// Which keys of the store "view" are settings, as the server says.

/** @type {Record<string, string[]>} Name of the settings, such as "motifs" -> their keys. */
let keysOf = {};

/** @param {Record<string, string[]>} keys */
export function setSettingsKeys(keys) {
  keysOf = keys;
}

/**
 * What to put into the store "view-change" for settings of a link: those it does not name go back to their defaults.
 * @param {string} name of the settings
 * @param {Record<string, string>} values
 */
export const changeOfSettings = (name, values) => Object.fromEntries((keysOf[name] || []).map((key) => [key, values[key] ?? ""]));
