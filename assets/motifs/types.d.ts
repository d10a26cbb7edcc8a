// What the Motifs page makes of what the server tells (webapp/features/motifs/names.py), and its own shapes.
import type { Complete } from "../shared/types.d.ts";
import type { BlendData as SentBlend, WalkData } from "./ids.mjs";
export type {
  BlendBody, BlendMotion, Flow, FlowBar as Bar, FlowRibbon as Ribbon, MotifStability, MotionRow, StabilityData as Stability,
  Timeline as TimelineData, TimelineMotif, TimelineRow,
} from "./ids.mjs";

/** What can be mixed of a motif. */
export type BlendData = Complete<SentBlend, "together">;

/** A walk and the ways of the graph; what follows from a walk is missing where there is none. */
export type Walk = Complete<WalkData, "error" | "gap" | "detour" | "name" | "skate" | "warnings" | "recipes">;

/** The keys of the link that say which walk it is: walk, extra, gaps, ends, feet. */
export type WalkKeys = Record<string, string | undefined>;

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
