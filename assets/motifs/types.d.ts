// What the server tells the Motifs page (webapp/features/motifs).
import type { Selection } from "../shared/types.d.ts";
import type { Span, StageRequest } from "../stage/types.d.ts";

/** A motion that can be mixed: where it stands in its clip, and when it passes the common moments. */
export interface BlendMotion {
  motion: number;
  clip: string;
  brief: string;
  when: string;
  start: number;
  end: number;
  fps: number;
  seconds: number[];
}

export interface BlendBody {
  motions: BlendMotion[];
  chosen: number[];
}

export interface BlendData {
  key: string;
  motif: number | null;
  dataset: string;
  version: string;
  title: string;
  total: number;
  most: number;
  bodies: BlendBody[];
  middles: StageRequest;
  together?: StageRequest;
}

/** The mixture that is shown: motions and weights of one body. */
export interface Mixture {
  data: BlendData;
  body: number;
  chosen: number[];
  values: number[];
  sources: boolean;
  written: string;
}

/** What the controls of a mixture may do. */
export interface MixtureActions {
  set(weights: number[]): void;
  body(number: number): void;
  add(motion: number): void;
  remove(motion: number): void;
}

export interface Bar {
  side: "a" | "b";
  motif: number | null;
  y: number;
  h: number;
  label: string;
  title: string;
  change: string | null;
}

export interface Ribbon {
  a: number | null;
  b: number | null;
  ya: number;
  yb: number;
  h: number;
  kind: "kept" | "linked" | "rest";
  title: string;
}

/** Two results side by side. */
export interface Flow {
  height: number;
  bars: Bar[];
  ribbons: Ribbon[];
}

/** A row of the list of motions. */
export interface MotionRow {
  clip: string;
  brief: string;
  when: string;
  strip: string;
  selection: Selection;
  chosen: boolean;
}

/** How a motif fared in the repeats: shares. */
export interface MotifStability {
  overall: number;
  kept: number;
  noise?: number;
  seed?: number;
  parameters?: number;
}

export interface Stability {
  repeats: number;
  motifs: Record<string, MotifStability>;
}

/** A clip of the timeline, times in seconds. */
export interface TimelineRow {
  clip: string;
  brief: string;
  seconds: number;
  fps: number;
  share: number;
  labels: [start: number, end: number, action: number][];
  motions: [start: number, end: number, motif: number, motion: number][];
}

export interface TimelineMotif {
  name: string;
  colour: string;
  motions: number;
}

export interface TimelineData {
  drawing: string;
  actions: string[];
  colours: string[];
  motifs: Record<string, TimelineMotif>;
  rows: TimelineRow[];
}

/** Which walk was asked for: walk, extra, gaps, ends, feet. */
export type WalkKeys = Record<string, string | undefined>;

/** A walk, or why there is none, and the ways of the graph. */
export interface Walk {
  key: string;
  asked: WalkKeys;
  error?: string;
  gap?: [number, number];
  detour?: number[];
  name?: string;
  path: number[];
  kinds: string[];
  visits: [number, number][];
  frames: number;
  seconds: number;
  bands: Span[];
  skate: [number, number, number];
  speeds: [string, string];
  jump: boolean;
  blends: number;
  warnings?: string[];
  recipes?: Record<string, string>;
  motifs: { id: number; name?: string }[];
  parts: number[];
  dead: number[];
  further: [number, number][];
}

/** What clicks in the graph do while one walks. */
export interface WalkSteps {
  add(motif: number): void;
  follow(source: number, target: number): void;
}

/** What the chips of a path may do. */
export interface PathActions {
  write(ids: number[]): void;
  jump(visit: number): void;
}

/** Elements of a Cytoscape graph. */
export interface GraphElements {
  [member: string]: any;
  length: number;
  data(...parts: any[]): any;
  forEach(visit: (element: GraphElements, k: number) => void): void;
  filter(test: (element: GraphElements) => boolean): GraphElements;
  map<T>(make: (element: GraphElements, k: number) => T): T[];
}

export interface GraphEvent {
  target: any;
  renderedPosition: { x: number; y: number };
}

/** A Cytoscape graph. */
export interface Cytoscape {
  [member: string]: any;
  nodes(selector?: string): GraphElements;
  edges(selector?: string): GraphElements;
  elements(selector?: string): GraphElements;
  getElementById(id: string): GraphElements;
  collection(): GraphElements;
  container(): HTMLElement;
  batch(change: () => void): void;
  zoom(view?: object): number;
  on(kind: string, handler: (event: GraphEvent) => void): void;
  on(kind: string, selector: string, handler: (event: GraphEvent) => void): void;
}
