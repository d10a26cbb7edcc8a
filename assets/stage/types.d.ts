// What the Stage shows, what it fetches, and the events it sends.
import type { Colour as Span, Figure as Item, StageRequest } from "../shared/ids.mjs";
import type { MotionHeader as Header } from "./ids.mjs";
export type { Header, Item, Span, StageRequest };

/** Red, green and blue, 0 to 255. */
export type Rgb = number[];

export interface PaintedSpan extends Span {
  rgb: Rgb;
}

/** positions: (frames, joints, 3) in metres. */
export interface Motion {
  header: Header;
  positions: Float32Array<ArrayBuffer>;
  bytes: number;
}

/** A segment of a clip, as motions are asked for. */
export interface Segment {
  dataset: string;
  version: string;
  clip: string;
  start: number | string;
  end: number | string;
  key: string;
  permanent: boolean;
}

/** Bones that are sorted by depth together: pairs of joints, parent and child. */
export interface Limb {
  side: number;
  bones: number[];
  joints: number[];
  flanks?: number[];
  trunk?: boolean;
}

export interface Timeline {
  reference: number;
  warped: boolean;
  fps: number;
  duration: number;
}

export interface Shelf {
  level: number;
  half: number;
}

export interface Theme {
  [colour: string]: any;
  dark: boolean;
  font: string;
  sky: Rgb;
  haze: Rgb;
  muted: Rgb;
  left: Rgb;
  right: Rgb;
  spine: Rgb;
}

/** Colours as text for every depth: `fill[side][level]`. */
export interface Shades {
  ball(level: number): HTMLCanvasElement;
  fill: string[][];
  edge: string[][];
  sheen: string[][];
  light: string[][];
}

/** The path of a root over the floor: points (n, 3), and runs of one colour. */
export interface Path {
  points: Float32Array;
  runs: { from: number; to: number; colour: string }[];
  n: number;
}

/** A frame of a clip, of an item by its index or of any that shows it. */
export interface Moment {
  clip: string;
  frame: number;
  dataset?: string;
  index?: number;
}

/** Where a figure stands. */
export interface Standing {
  index: number;
  dataset: string | undefined;
  clip: string;
  label: string;
  start: number;
  end: number;
  frame: number;
  span: string | null;
}

export interface CameraState {
  yaw: number;
  pitch: number;
  distance: number;
  pan: number[];
  follow: boolean;
  centre?: number[];
}

/** What one sees, small enough for a link. */
export interface StageState {
  time: number;
  speed: number;
  loop: string;
  playing: boolean;
  layout: string;
  sync: string;
  ghosts: boolean;
  trails: string;
  hidden: number[];
  camera: CameraState;
}

/** A state to take up: what is missing stays as it is. */
export type SavedState = Partial<Omit<StageState, "camera">> & { camera?: Partial<CameraState> };
