// What the server tells the Search page (webapp/features/search).
import type { StageRequest } from "../stage/types.d.ts";
import type { Body, Clips as ClipList, Engine, HitRow as Hit, MotifChoice as MotifQuery, Person, PieceRow as ShownPiece, Question, Study as SentStudy } from "./ids.mjs";
export type { Body, ClipList, Engine, Hit, MotifQuery, Person, ShownPiece, Question };

export type Study = Required<Omit<SentStudy, "error">> & Pick<SentStudy, "error">;

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
