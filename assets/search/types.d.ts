// What the server tells the Search page (webapp/features/search).
import type { StageRequest } from "../stage/types.d.ts";

/** Weights of parts of the body, by part. */
export type Weights = Record<string, number>;

/** Some frames of a clip and the parts of the body that it gives to the query. */
export interface QueryPiece {
  clip: string;
  dataset: string;
  start: number;
  end: number;
  leaves: string[];
}

/** The same as the server has it. */
export interface ShownPiece extends QueryPiece {
  frames: number;
  fps: number;
  version: string;
  source: string;
  colour: string;
  gives: string;
  labels: [start: number, end: number, action: string][];
}

export interface Hit {
  name: string;
  rank: number;
  clip: string;
  start: number;
  end: number;
  score: number;
  when: string;
  label?: string;
  strip: string;
}

/** What was searched for. */
export interface SearchRequest {
  dataset: string;
  query: string;
  parts: string;
  route?: string;
  label?: string;
  named?: string;
  lasting?: string;
}

/** The query and its hits, or why there are none. */
export interface Found {
  error?: string;
  doubt?: string;
  asked: SearchRequest;
  pieces: ShownPiece[];
  hits: Hit[];
  total: number;
  level: string;
  milliseconds: number;
  request: StageRequest;
}

/** Likeness of the parts of the body over the query's time: -1 or percent. */
export interface Strip {
  rows: number[][];
  means: (number | null)[];
}

/** Why a hit is one. */
export interface Reason {
  strip: Strip;
  request: StageRequest;
}

export interface ClipList {
  dataset: string;
  version: string;
  clips: [name: string, frames: number, ...rest: any[]][];
  actions: string[];
}

/** The parts of the body: leaves, the nodes above them, and their names. */
export interface Body {
  leaves: string[];
  nodes: Record<string, string[]>;
  words: Record<string, string>;
}

export interface MotifQuery {
  name: string;
  motions: number;
  query: string;
}

export interface Engine {
  method: string;
  label: string;
  ready: boolean;
}

/** A pair to be rated, or a duel to be decided. */
export interface Question {
  query: string;
  hit?: string;
  left?: string;
  right?: string;
  value: number | string | null;
  request: StageRequest;
}

export interface Study {
  error?: string;
  asked: any[];
  queries: { name: string; clip: string; when: string; strip: string }[];
  engines: Engine[];
  pairs: Question[];
  duels: Question[];
}

export interface Person {
  id?: string;
  name?: string;
}

/** A range that is being dragged on the pictures of a piece. */
export interface Drag {
  index: number;
  track: HTMLElement;
  at: number;
  piece: ShownPiece;
  mode: string;
  moved: boolean;
  id: number;
  label?: string;
  start: number;
  end: number;
}

export interface HitRow extends HTMLElement {
  strip?: Strip;
}
