// What the server tells of its jobs (webapp/jobs).
import type { JobRow } from "./ids.mjs";

export type Job = Required<Omit<JobRow, "error">> & Pick<JobRow, "error">;

