// Boards and saved views, for Ctrl+K.
import { addPlaces } from "../shared/places.mjs";
import { refresh } from "./list.mjs";

const FRESH = 5000; // milliseconds for which a list is not asked for again, while someone types
/** @type {ReturnType<typeof refresh> | null} */
let listing = null;
let asked = 0;

addPlaces(async () => {
  if (!listing || performance.now() - asked > FRESH) [listing, asked] = [refresh(), performance.now()];
  const { boards, views } = await listing;
  return [
    ...boards.map(({ id, title, note }) => ({ name: title, about: `board ${note}`.trim(), address: `/boards?board=${id}` })),
    ...views.map(({ title, note, tags, address }) => ({ name: title, about: ["view", note, ...tags.map((tag) => `#${tag}`)].filter(Boolean).join(" "), address })),
  ];
});
