// A motion map: what its file holds, and what is searched on it.
export type { Facts, KnownMap, MapHeader } from "./ids.mjs";

export type Point = number[];

/** Joint positions (3 n_joints) in metres, the pelvis at the origin. */
export type Posture = ArrayLike<number>;

/** A stretch of a clip that passes through all keys; clip a number, analysis frames. */
export interface Hit {
  clip: number;
  start: number;
  end: number;
  distance: number;
}

/** How fast, in metres a second, and where to a stretch may travel. */
export interface Pace {
  slowest: number;
  fastest: number;
  way?: string;
}

/** Frames [start, end) of a clip at its own rate. */
export interface ClipSegment {
  clip: string;
  start: number;
  end: number;
}

/** A way over the map, a point every `step` frames from `start` on. */
export interface MapPath {
  start: number;
  step: number;
  points: Point[];
}

/** A motion whose way is drawn. */
export interface Followed {
  dataset: string;
  clip: string;
  start: number;
  end: number;
  index: number;
  frame?: number;
}

export interface Dot {
  x: number;
  y: number;
  colour: string;
}

/** What the overlay tells the page. */
export interface OverlayActions {
  hover(node: number): void;
  leave(): void;
  choose(node: number): void;
  undo(): void;
  draws(): boolean;
  path(points: Point[]): void;
}
