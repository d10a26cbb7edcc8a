/* The settings of a page among what it shows: other views change without the form being drawn anew. */
(function () {
  "use strict";
  const clientside = (window.dash_clientside = window.dash_clientside || {});
  clientside.settings = {
    // Those keys of the view that are settings of the page; its store is called PAGE-settings.
    pick(view, current, id) {
      const page = id.slice(0, -"settings".length);
      const own = Object.entries(view || {}).filter(([key]) => key.startsWith(page)).sort();
      const next = Object.fromEntries(own);
      return current && JSON.stringify(next) === JSON.stringify(current) ? clientside.no_update : next;
    },
  };
})();
