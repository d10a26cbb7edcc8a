// What the stores that name what one sees hold.

export type { Selection } from "./ids.mjs";

/** The store "view": what a page shows, key by key, as the link has it. */
export type View = Record<string, string>;
