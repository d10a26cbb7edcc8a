// What the Grammar page makes of what the server tells (webapp/features/grammar/names.py), and its own shapes.
import type { Complete } from "../shared/types.d.ts";
import type { Composed, Others, Row as StringRow } from "./ids.mjs";
export type { Action, GrammarData, Other as OtherWay, Phrase, Routine, RoutineData as ShownRoutine, Way } from "./ids.mjs";
export type { StringRow };

/** Seconds from and to, the action, and its number among the action's occurrences. */
export type Piece = StringRow["pieces"][number];

/** A node of a tree that was chosen. */
export interface TreeNode {
  path: string;
  first: number;
  end: number;
  leaf: boolean;
}

/** The keys of the link that say which routine it is: sentence, pick, up, alt. */
export type RoutineKeys = Record<string, string | undefined>;

/** A new routine; what follows from its motion is missing where there is none. */
export type Composition = Complete<Composed, "error" | "name" | "chosen" | "skate" | "warnings" | "recipes">;

/** Other ways for the chosen part of a new routine. */
export type OtherWays = Complete<Others, "error">;

/** A box that remembers what it was drawn from. */
export interface DrawnBox extends HTMLElement {
  drawnFrom?: string;
}

export interface TreeBox extends DrawnBox {
  choose?: (node: TreeNode) => void;
  watched?: boolean;
  lit?: number;
}
