// Own line drawings for the buttons: 20 x 20, drawn with the text's colour.

/** @param {string} d */
const line = (d) => `<path d="${d}" fill="none" stroke="currentColor" stroke-width="1.6" stroke-linecap="round" stroke-linejoin="round"/>`;
/** @param {string} d */
const solid = (d) => `<path d="${d}" fill="currentColor"/>`;
/** @param {number} x @param {number} y @param {number} r @param {number} [alpha] */
const dot = (x, y, r, alpha = 1) => `<circle cx="${x}" cy="${y}" r="${r}" fill="currentColor" opacity="${alpha}"/>`;
/** @param {number} x @param {number} [alpha] */
const body = (x, alpha = 1) => `<g opacity="${alpha}">${dot(x, 4.6, 1.8)}${line(`M${x} 7.4V12M${x} 12L${x - 2} 16.6M${x} 12L${x + 2} 16.6M${x - 2.6} 9.2H${x + 2.6}`)}</g>`;

/** @type {Record<string, string>} */
const ICONS = {
  play: solid("M6.5 4.2v11.6c0 .6.7 1 1.2.6l8.4-5.8c.4-.3.4-.9 0-1.2L7.7 3.6c-.5-.4-1.2 0-1.2.6z"),
  pause: solid("M5.6 4h2.6c.4 0 .6.2.6.6v10.8c0 .4-.2.6-.6.6H5.6c-.4 0-.6-.2-.6-.6V4.6c0-.4.2-.6.6-.6zM11.8 4h2.6c.4 0 .6.2.6.6v10.8c0 .4-.2.6-.6.6h-2.6c-.4 0-.6-.2-.6-.6V4.6c0-.4.2-.6.6-.6z"),
  back: line("M6 5v10M14 5.5L8.5 10l5.5 4.5z"),
  forward: line("M14 5v10M6 5.5l5.5 4.5L6 14.5z"),
  slower: line("M5.5 10h9"),
  faster: line("M5.5 10h9M10 5.5v9"),
  loop: line("M4 9.5V9a3 3 0 013-3h8.5M13 3.5L15.5 6 13 8.5M16 10.5v.5a3 3 0 01-3 3H4.5M7 16.5L4.5 14 7 11.5"),
  bounce: line("M3.5 10h13M6.5 7l-3 3 3 3M13.5 7l3 3-3 3"),
  once: line("M3.5 10H14M11 7l3 3-3 3M16.5 5.5v9"),
  ghosts: body(13.5) + body(9.4, 0.55) + body(5.6, 0.28),
  trails: line("M3 15c3.5 0 2.8-7 6.4-7 2.8 0 2.4 4.4 5 4.4") + dot(15.8, 12.2, 1.9),
  follow: dot(10, 10, 2.2) + line("M3.5 7V5A1.5 1.5 0 015 3.5h2M13 3.5h2A1.5 1.5 0 0116.5 5v2M16.5 13v2a1.5 1.5 0 01-1.5 1.5h-2M7 16.5H5A1.5 1.5 0 013.5 15v-2"),
  overlay: body(11.4) + body(8.4, 0.5),
  side: body(5.6) + body(14.4),
  pose: line("M2.5 9h15M2.5 17.5h15") + [3.2, 11.7].map((y) => [5, 10, 15].map((x) => dot(x, y, 1.2) + line(`M${x} ${y + 2.2}v2.2`)).join("")).join(""),
  warp: line("M3.5 5.5h13M3.5 14.5h13M6 5.5L5 14.5M10 5.5l1.5 9M14 5.5l1 9"),
  reset: line("M4 9.2L10 4l6 5.2M5.6 8.2v7.3h3.2v-4h2.4v4h3.2V8.2"),
  help: line("M7.4 7.6a2.6 2.6 0 115 1c-.5 1.2-2.3 1.4-2.3 3.2") + dot(10.1, 15, 1),
};

/** @param {string} name */
export const iconMarkup = (name) => `<svg viewBox="0 0 20 20" width="20" height="20" aria-hidden="true" focusable="false">${ICONS[name] || ""}</svg>`;
