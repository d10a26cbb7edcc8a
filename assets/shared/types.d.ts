// Shapes that all parts of the front end use.

import type { PageView } from "./ids.mjs";
export type { Selection } from "./ids.mjs";

/** A key of the links of a page. */
export type ViewKey = keyof PageView;

/** Settings of methods, as the link has them: "map-grid" is the grid of the map. */
export type Settings = { [key: `${string}-${string}`]: string | undefined };

/** The store "view": what the pages show and the settings, text by key of the link. */
export type View = PageView & Settings;

/** Keys of the view that change; an empty value takes a key out. */
export type ViewChange = { [K in keyof View]?: string | number | boolean | null };

/** T where everything has come: only the keys K may be missing. */
export type Complete<T, K extends keyof T = never> = Required<Omit<T, K>> & Pick<T, K>;

/** A field of a form. */
export interface Field {
  name: string;
  label: string;
  value?: string;
  kind?: "line" | "text" | "choice";
  choices?: [string, string][];
  hint?: string;
}
