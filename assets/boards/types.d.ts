// What the server says of boards, saved views and comments: see webapp/features/boards/documents.py.

export interface BlockData {
  id: string;
  kind: string;
  x: number;
  y: number;
  w: number;
  h: number;
  settings: Settings;
  version: number;
  author: string;
  data: "not pinned" | "unchanged" | "changed" | "gone";
  dataset: string;
}

export interface Settings {
  title?: string;
  note?: string;
  dataset?: string;
  view?: Record<string, string>;
  options?: Record<string, string>;
  pinned?: { dataset: string; fingerprint: string; key: string };
}

export interface CommentData {
  id: string;
  block: string;
  text: string;
  author: string;
  created: number;
  version: number;
  mentions: string[];
  resolved: boolean;
  parent: string | null;
  /** Where in a clip: see webapp/features/boards/discussion.py. */
  frame?: number;
  seconds?: number;
}

/** What is said about a motif or the moments of a clip. */
export interface Discussion {
  place: string;
  title: string;
  moments: boolean;
  comments: CommentData[];
  me: string;
  names: string[];
}

export interface Board {
  id: string;
  title: string;
  note: string;
  version: number;
  author: string;
  updated: number;
  filters: { dataset?: string; label?: string; group?: string };
  /** Properties of clips of the dataset of the board, each with its values. */
  groups: [string, string[]][];
  blocks: BlockData[];
  comments: CommentData[];
  may_edit: boolean;
  me: string;
  datasets: string[];
  links: { read: string; edit?: string };
  names: string[];
  mark?: string;
  etag?: string;
}

/** x, y, width, height and kind of a block, for the small drawing of a board. */
export type Shape = [number, number, number, number, string][];

export interface Kind {
  kind: string;
  label: string;
  symbol: string;
  size: [number, number];
  options: Record<string, string>;
  keys: string[];
  computes: boolean;
}

export interface ViewEntry {
  id: string;
  title: string;
  note: string;
  tags: string[];
  address: string;
  author: string;
  updated: number;
  version: number;
  picture: string;
}

export interface BoardEntry {
  id: string;
  title: string;
  note: string;
  author: string;
  updated: number;
  version: number;
  dataset: string;
  shape: Shape;
}

export interface Listing {
  boards: BoardEntry[];
  views: ViewEntry[];
  damaged: string[];
  templates: { name: string; title: string; words: string; shape: Shape }[];
  kinds: Kind[];
}

/** What a block shows: see webapp/features/boards/contents.py. */
export interface BlockAnswer {
  state: "current" | "changed" | "gone" | "missing" | "broken";
  content: any;
  words: string;
  job: { id: number; state: string; fraction: number; error: string } | null;
}

export interface Change {
  version: number;
  author: string;
  saved: number;
  what: string;
}
