// Files that are being sent.

export interface Upload {
  file: File;
  path: string;
  sent: number;
  state: "waiting" | "sending" | "ok" | "error";
  message: string;
  /** Whether the server found a recording in it, once it has come. */
  recording?: boolean;
  row: HTMLElement | null;
  request?: XMLHttpRequest;
}

/** What was chosen or dropped together, and what becomes of it. */
export interface Batch {
  token: string | null;
  items: Upload[];
  sent: number;
  bytes: number;
  active: number;
  queue: Upload[];
  stopped: boolean;
  name: string;
  hidden: number;
  /** Files that were left out: kind, and how many. */
  ignored: Record<string, number>;
}

/** A file and its path, folders included. */
export interface FoundFile {
  file: File;
  path: string;
}

/** What may be sent: bytes of a file, of all, number of files, and how their names end. */
export interface Limits {
  fileBytes: number;
  totalBytes: number;
  files: number;
  suffixes: string[];
}

/** A property of clips: see webapp/features/library/property_routes.py. */
export interface ColumnOfClips {
  name: string;
  kind: string;
  distinct: number;
  missing: number;
  values: [string, number][];
}

/** What is known of the clips of a data set, and after a change some of the clips whose values are others now. */
export interface ClipProperties {
  dataset: string;
  clips: number;
  columns: ColumnOfClips[];
  first: string;
  remarks?: string[];
  rows?: Record<string, string>[];
  before?: number;
}
