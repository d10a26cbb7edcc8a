// What the server tells the Grammar page (webapp/features/grammar).
import type { Span } from "../stage/types.d.ts";

export interface Action {
  id: number;
  name: string;
  short: string;
  colour: string;
  ink?: string;
  hint?: string;
  label?: string;
  named: number;
  strip?: string;
  clips?: number;
  count: number;
  seconds: number;
}

/** Seconds from and to, the action, and its number among the action's occurrences. */
export type Piece = [start: number, end: number, action: number, number: number];

/** A recording as a string of actions. */
export interface StringRow {
  clip: string;
  brief: string;
  seconds: number;
  fps: number;
  pieces: Piece[];
  cuts: number[];
  labels: [start: number, end: number, name: string][];
}

export interface Routine {
  clip: string;
  seconds: [number, number];
  actions: number[];
  leaves: [number, number][];
}

/** One way in which a phrase goes: actions by number, phrases by name. */
export interface Way {
  parts: (number | string)[];
  count: number;
}

export interface Phrase {
  id: string;
  name: string;
  seen: number;
  cyclic: boolean;
  ways: Way[];
}

/** A result. */
export interface GrammarData {
  key: string;
  dataset: string;
  version: string;
  names: string;
  actions: Action[];
  rows: StringRow[];
  rules: Phrase[];
  routines: Routine[];
}

/** The tree of a routine of the recordings. */
export interface ShownRoutine {
  key: string;
  number: number;
  svg: string;
}

/** A node of a tree that was chosen. */
export interface TreeNode {
  path: string;
  first: number;
  end: number;
  leaf: boolean;
}

export interface ChosenPart {
  name: string;
  first: number;
  end: number;
  ways: number;
  varies: boolean;
  larger: boolean;
  smaller: boolean;
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

/** One other way for the chosen part. */
export interface OtherWay {
  name: string;
  clip: string;
  code: string;
  actions: number[];
  first: number;
  end: number;
  start: number;
  stop: number;
  seconds: number;
  bands: Span[];
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
