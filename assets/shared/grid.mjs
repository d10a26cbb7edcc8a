// Tables (AG Grid): functions and cell renderers that the server's column definitions name.

/** Functions by name, for "function" values of column definitions. */
export const gridFunctions = (window.dashAgGridFunctions ||= {});

/** React components by name, for `cellRenderer`. */
export const cellRenderers = (window.dashAgGridComponentFunctions ||= {});

/**
 * A React element; React is loaded by Dash after this script.
 * @param {...any} parts
 */
export const reactElement = (...parts) => window.React.createElement(...parts);

/**
 * The API of the table with an id; null where the page has none (any more).
 * @param {string} id
 */
export async function gridApi(id) {
  const api = await window.dash_ag_grid.getApiAsync(id).catch(() => null);
  return api && !api.isDestroyed() ? api : null;
}
