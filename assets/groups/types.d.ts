// What the server says of comparisons of groups: see webapp/features/groups and core/groups/documents.py.

export interface Choices {
  columns: { name: string; values: [string, number][] }[];
  who: string;
  labels: boolean;
}

export type Piece = [string, number, number] | null;

export interface Row {
  kind: string;
  id: string;
  name: string;
  measure: string;
  unit: string;
  groups: [string, string];
  means: (number | null)[];
  n: [number, number];
  difference: number | null;
  interval: (number | null)[];
  effect: number | null;
  p: number | null;
  q: number | null;
  significant: boolean;
  words?: string;
  examples?: Record<string, { typical: Piece; extreme: Piece }>;
}

export interface Curve {
  item: string;
  curve: string;
  unit: string;
  groups: [string, string];
  n: [number, number];
  means: number[][];
  spreads: number[][];
  clusters: { start: number; end: number; sign: number; p: number }[];
  q: number;
  significant: boolean;
}

export interface Comparison {
  by: string;
  unit: string;
  paired: boolean;
  test: string;
  correction: string;
  effect: string;
  smallest_p: number;
  groups: { name: string; units: number; clips: number; minutes: number }[];
  remarks: string[];
  words: { text: string; kind?: string; id?: string; measure?: string }[];
  comparisons: Row[];
  transitions: Row[];
  curves: Curve[];
  map?: OnMap[];
}

export interface OnMap {
  groups: [string, string];
  grid: [number, number];
  difference: number[];
  clusters: { nodes: [number, number][]; sign: number; p: number }[];
}

export interface Answer {
  state: "ready" | "running" | "failed" | "refused" | "missing";
  document?: Comparison;
  stage?: string;
  fraction?: number;
  error?: string;
}
