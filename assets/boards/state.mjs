// What the page knows of what is shown around it.
/** @import { Selection } from "../shared/types.d.ts" */
/** @import { Kind, Listing } from "./types.d.ts" */

/** The stores of the app, as the page was last told. */
export const shown = {
  /** @type {Record<string, string>} */
  view: {},
  dataset: "",
  /** @type {Selection} */
  selection: {},
};

/** @type {{ listing: Listing | null }} */
export const known = { listing: null };

/** @param {string} kind @returns {Kind | undefined} */
export const kindOf = (kind) => known.listing?.kinds.find((one) => one.kind === kind);

export const isDark = () => document.documentElement.dataset.mantineColorScheme === "dark";
