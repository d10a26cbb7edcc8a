"""What small jobs cost from the click to the result: the first one of a worker, and the ones after it.

usage: python -m benchmarks start_of_jobs
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import psutil

from core.analyses import Request
from core.demo import make_demo
from core.workspace import Workspace
from webapp import jobs

METHODS = {"motifs": "Motif graph", "map": "Motion map"}
NEXT = 5  # jobs after the first; the table shows their median


def main() -> str:
    """The section of docs/benchmarks.md, in Markdown."""
    rows = []
    for method, title in METHODS.items():
        with tempfile.TemporaryDirectory() as folder:
            workspace = Workspace(Path(folder) / "workspace")
            workspace.add_dataset("demo", make_demo(minutes=1.0))
            run(workspace, method, 1)  # kernels have been compiled
            psutil.Process(workspace.jobs.list()[0].pid).kill()
            first, *later = [run(workspace, method, seed) for seed in range(2, NEXT + 3)]
            median = [sorted(values)[NEXT // 2] for values in zip(*later, strict=True)]
            rows.append(f"| {title} | {first[0]:.2f} | {first[1]:.2f} | {median[0]:.2f} | {median[1]:.2f} |")
    return "\n".join(
        [
            "## Start of jobs",
            "",
            "`python -m benchmarks start_of_jobs`: a minute of the demo, seconds of a job from the request to its",
            "result. Processor time is that of the worker and its child. The first job starts a worker, which stays;",
            "the next ones are forked from it with everything imported.",
            "",
            "| job | first: processor | first: clock | next: processor | next: clock |",
            "|---|---|---|---|---|",
            *rows,
        ]
    )


def run(workspace: Workspace, method: str, seed: int) -> tuple[float, float]:
    """Processor time and time by the clock of a job, in seconds."""
    before = _spent(workspace.jobs.list(1)[0].pid) if workspace.jobs.list(1) else (0, 0.0)
    job = jobs.start(workspace, Request("demo", method, {"seed": seed}))
    jobs.wait_for(str(workspace.path), job.id)
    done = workspace.jobs.get(job.id)
    while psutil.Process(done.pid).children():
        pass
    pid, spent = _spent(done.pid)
    return spent - (before[1] if before[0] == pid else 0.0), done.finished - done.created


def _spent(pid: int | None) -> tuple[int, float]:
    try:
        return pid or 0, sum(psutil.Process(pid).cpu_times()[:4])
    except psutil.NoSuchProcess:
        return 0, 0.0
