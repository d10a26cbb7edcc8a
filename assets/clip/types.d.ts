// What the server tells the Clip page (webapp/features/clip).
import type { Standing } from "../stage/types.d.ts";
import type { Bout, ClipShown as ShownClip, GaitTable as Gait } from "./ids.mjs";
export type { Bout, ShownClip, Gait };

/** Frames [start, end). */
export type Range = [start: number, end: number];

/** Where the chart's axes lie within the box, in pixels, and what it shows. */
export interface Plot {
  graph: any;
  full: any;
  meta: { clip: string; kind: string; fps: number; frames: number; thinned?: boolean };
  lines: any[];
  chips: HTMLElement[];
  left: number;
  width: number;
  top: number;
  height: number;
  x(value: number): number;
  y(value: number): number;
  time(pixel: number): number;
  range: number[];
}

/** A point of the chart's box. */
export interface Spot {
  plot: Plot;
  x: number;
  y: number;
}

/** What the Clip page shows now. */
export interface ClipState {
  shown: ShownClip | null;
  frame: number | null;
  hover: number | null;
  items: Standing[];
  pending: { clip: string; frame: number } | null;
  values: Float32Array | null;
  from: string;
  range: Range | null;
  dragged: Range | null;
}
