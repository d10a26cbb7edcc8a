// What the server tells the Grammar page (webapp/features/grammar).
import type { Span } from "../stage/types.d.ts";
import type { Action, GrammarData, Other as OtherWay, Part as ChosenPart, Phrase, Routine, RoutineData as ShownRoutine, Row as StringRow, Way } from "./ids.mjs";
export type { Action, GrammarData, OtherWay, ChosenPart, Phrase, Routine, ShownRoutine, StringRow, Way };

/** Seconds from and to, the action, and its number among the action's occurrences. */
export type Piece = StringRow["pieces"][number];

/** A node of a tree that was chosen. */
export interface TreeNode {
  path: string;
  first: number;
  end: number;
  leaf: boolean;
}

/** Which routine was asked for: sentence, pick, up, alt. */
export type RoutineKeys = Record<string, string | undefined>;

/** A new routine, or why there is none. */
export interface Composition {
  key: string;
  asked: RoutineKeys;
  error?: string;
  name?: string;
  clip: string;
  code: string;
  svg: string;
  actions: number[];
  spans: [number, number][];
  parents: string[];
  chosen?: ChosenPart;
  frames: number;
  seconds: number;
  novel: boolean;
  bands: Span[];
  skate?: [number, number, number];
  speeds: [string, string];
  jump: boolean;
  warnings?: string[];
  recipes?: Record<string, string>;
}

export interface OtherWays {
  asked: RoutineKeys;
  error?: string;
  part: string;
  others: OtherWay[];
}

/** A box that remembers what it was drawn from. */
export interface DrawnBox extends HTMLElement {
  drawnFrom?: string;
}

export interface TreeBox extends DrawnBox {
  choose?: (node: TreeNode) => void;
  watched?: boolean;
  lit?: number;
}
