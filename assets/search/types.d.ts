// What the Search page makes of what the server tells (webapp/features/search/names.py), and its own shapes.
import type { Complete } from "../shared/types.d.ts";
import type { Found as SentFound, PieceRow as ShownPiece, Strip, Study as SentStudy } from "./ids.mjs";
export type { Body, Clips as ClipList, Engine, HitRow as Hit, MotifChoice as MotifQuery, Person, Question, Reason, ReceivedAnswers } from "./ids.mjs";
export type { ShownPiece, Strip };

export type Study = Complete<SentStudy, "error">;

/** The query and its hits; none of it is there where there is no query. */
export type Found = Complete<SentFound, "error" | "doubt">;

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
