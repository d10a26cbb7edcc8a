// What blocks draw and what they may ask of the page around them.
import type { Figure } from "../stage/figure.mjs";
import type { Item, StageRequest } from "../stage/types.d.ts";
import type { Selection } from "../shared/types.d.ts";
export type { Figure, Item, Selection, StageRequest };

/** A stretch of a clip: its name, first frame and the one after the last. */
export type Segment = [string, number, number];

/** What plays for a selection where the page plays by itself. */
export interface Playing {
  title: string;
  items: Item[];
}

/** The page around a block. */
export interface Context {
  /** Choose something: everything that shows it lights up, and it plays. */
  select(selection: Selection, playing?: Playing): void;
  /** Figures for these items, in their order; those that are not there are left out. */
  figures(items: Item[], request?: StageRequest): Promise<Figure[]>;
  dark(): boolean;
  /** Links of the app can be opened. */
  opens: boolean;
}

/** A drawn block. */
export interface Drawn {
  /** Show what is selected. `motion`: the stretches of clips that it stands for, as far as a block knows them. */
  light?(selection: Selection, motion: Segment[]): void;
  /** The stretches of clips that a selection stands for; undefined where this block does not know it. */
  motion?(selection: Selection): Segment[] | undefined;
  /** Mark what was made with the settings that the page has. */
  settle?(view: Record<string, string>): void;
  /** Fade what has nothing to do with a label ("" fades nothing), and what is of no clip among these (null: all are). */
  narrow?(label: string, among: Set<string> | null): void;
  /** The page is light or dark now. */
  recolour?(): void;
  close?(): void;
}

export type Draw<Content = any> = (place: HTMLElement, content: Content, context: Context) => Drawn;

export interface MotifContent {
  id: number;
  name: string;
  colour: string;
  count: number;
  seconds: number;
  medoid: Segment;
  motions: Segment[];
  warps: number[][];
  label?: string;
  note?: string;
  clips?: number;
  strip?: string;
}

export interface GraphMotif extends MotifContent {
  part: string;
  place: [number, number];
  size: [number, number];
  icon: string;
}

export interface GraphContent {
  motifs: GraphMotif[];
  edges: [number, number, number, number][];
}

export interface MatrixContent {
  motifs: MotifContent[];
  cells: [number, number, number][];
}

export interface MapContent {
  grid: [number, number];
  heights: number[];
  seconds: number[];
  parents: number[];
  sides: string[];
  roles: string[];
  postures: string;
  icons: { light: string; dark: string };
  passes: Segment[][];
  /** Stays of clips on nodes, the longest: five numbers each, index of the clip, node, start, end, index of the label or -1. */
  stays?: number[];
  clips?: string[];
  labels?: string[];
}

export interface OverviewContent {
  facts: [string, string][];
  clips: { name: string; seconds: number; frames: number; fps: number; labels: string; verdict: string; strip: string }[];
  more: number;
}

export interface TracksContent {
  rows: { clip: string; brief: string; fps: number; seconds: number; motions: number[][]; labels: number[][] }[];
  motifs: Record<string, { name: string; colour: string; motions: number }>;
  actions: string[];
  colours: string[];
}

export interface ActionsContent {
  actions: { id: number; name: string; short: string; colour: string; ink: string; count: number; segments: Segment[]; label?: string }[];
  rows: { clip: string; brief: string; fps: number; seconds: number; pieces: number[][]; cuts: number[] }[];
}

export interface SweepContent {
  x: { name: string; values: string[] };
  series: string[];
  measures: [string, string, string, number][];
  figures: Record<string, ([number, number, number] | null)[][]>;
  ready: [number, number];
  /** Keys of a view, and their texts at each place of the chart, a row a series. */
  keys?: string[];
  settings?: Record<string, string>[][];
}

/** A coloured stretch of a row, in seconds. */
export interface Stretch {
  start: number;
  end: number;
  colour: string;
  ink?: string;
  text: string;
  tip: string;
  key: string;
  choose(): void;
}

export interface Track {
  clip: string;
  fps: number;
  brief: string;
  seconds: number;
  lanes: Stretch[][];
}
