// What the server tells of its jobs (webapp/jobs).
import type { Complete } from "../shared/types.d.ts";
import type { JobRow } from "./ids.mjs";

export type Job = Complete<JobRow, "error" | "held" | "expected">;
