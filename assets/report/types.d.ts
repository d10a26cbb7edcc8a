// A report as its file holds it: see webapp/features/boards/report.py.
import type { Header } from "../stage/types.d.ts";

/** Every `step`-th frame from `start` on, `frames` of them, in `unit` metres from `origin`. */
export interface Piece {
  clip: string;
  start: number;
  end: number;
  step: number;
  frames: number;
  unit: number;
  origin: number[];
}

export interface ReportPart {
  kind: string;
  title: string;
  note: string;
  columns: number;
  content: any;
}

export interface Report {
  title: string;
  dataset: string;
  made: string;
  version: string;
  parts: ReportPart[];
  motion: { bodies: Record<string, Header>; pieces: Piece[]; words: string };
}
