// What the server tells of its jobs (webapp/jobs).

export interface Job {
  id: number;
  title: string;
  stage: string;
  percent: number | null;
  stopping: boolean;
  error?: string;
}
