// What the stores that name what one sees hold.

/** What a person has chosen, as the store "selection" has it. */
export interface Selection {
  motif?: number | string;
  motion?: number | string;
  motifs?: string;
  edge?: string;
  transition?: number | string;
  action?: number | string;
  segment?: number | string;
  clip?: string;
  start?: number;
  end?: number;
  as?: string;
}

/** The store "view": what a page shows, key by key, as the link has it. */
export type View = Record<string, string>;
