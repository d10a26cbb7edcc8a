// What Dash gives to the browser: functions it may call, the stores it keeps, and its notices.
import { NOTICES, VIEW } from "./ids.mjs";
/** @import { StoreId } from "./ids.mjs" */
/** @import { ViewChange } from "./types.d.ts" */

/** Dash's own object: `set_props`, `no_update`, `callback_context`, and the functions of our callbacks by namespace. */
export const clientside = (globalThis.dash_clientside ||= /** @type {any} */ ({}));

/**
 * Let Dash call `functions` as ClientsideFunction(namespace, name).
 * @param {string} namespace
 * @param {Record<string, Function>} functions
 */
export function register(namespace, functions) {
  clientside[namespace] = functions;
}

/**
 * Put data into a dcc.Store.
 * @template T
 * @param {StoreId<T>} store
 * @param {T | null} data
 */
export const setStore = (store, data) => clientside.set_props(store, { data });

/**
 * Change keys of the store "view", and so of the link; an empty value takes the key away. The store has changed when
 * this returns: neither a second change nor the answer to an earlier one can come in between.
 * @param {ViewChange} values
 */
export function changeView(values) {
  const view = globalThis.dash_component_api.getLayout(VIEW).props.data || {};
  const next = { ...view };
  for (const [key, value] of Object.entries(values)) {
    if (value === null || value === undefined || value === "") delete next[key];
    else next[key] = String(value);
  }
  if (JSON.stringify(next) !== JSON.stringify(view)) setStore(VIEW, next);
}

/**
 * Show a notice in the header.
 * @param {string} title
 * @param {string} message
 * @param {string} [color]
 */
export function notify(title, message, color = "orange") {
  clientside.set_props(NOTICES, { sendNotifications: [{ action: "show", title, message, color }] });
}

/**
 * Open another page without loading the app again, as dcc.Link does; `stores` are its data by store.
 * @param {string} pathname
 * @param {Record<string, any>} [stores]
 */
export function openPage(pathname, stores = {}) {
  history.pushState({}, "", pathname);
  for (const [store, data] of Object.entries(stores)) setStore(store, data);
  window.dispatchEvent(new CustomEvent("_dashprivate_pushstate"));
}
