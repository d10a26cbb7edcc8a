"""What a load balancer and a monitoring system ask: ``/health``, ``/ready`` and ``/metrics`` (Prometheus' text format).

No answer names a dataset or a person. Only those who may see the workspace get the metrics.
"""

from __future__ import annotations

import os
import shutil
import threading
import time
from collections import Counter

import psutil
from flask import Blueprint, Flask, Response, g, jsonify, request
from flask.typing import ResponseReturnValue

from core.workspace import Workspace, WorkspaceError

LEAST_ROOM = 1 << 26  # bytes on the disk below which nothing can be stored any more
STATES = ("queued", "running", "done", "failed", "cancelled")
_SLOWEST = (0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 10.0)  # seconds; bounds of the histogram of answers


class Answers:
    """Counts the answers of a server, by kind of status, and how long they took."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self.by_status: Counter[str] = Counter()
        self.within = [0] * len(_SLOWEST)
        self.seconds = 0.0

    def count(self, status: int, seconds: float) -> None:
        """Counts one answer."""
        with self._lock:
            self.by_status[f"{status // 100}xx"] += 1
            self.seconds += seconds
            for k, bound in enumerate(_SLOWEST):
                self.within[k] += seconds <= bound


def register(server: Flask, workspace: Workspace) -> None:
    """Answers the three addresses and counts all answers; to be registered before what may refuse a request.

    Health and readiness are answered before anyone is let in, also where the job table is damaged.
    """
    answers, started = Answers(), time.time()
    routes = Blueprint("monitoring", __name__)

    @server.before_request
    def _begin() -> ResponseReturnValue | None:
        g.begun = time.perf_counter()
        if request.path == "/health":
            return jsonify(status="ok")
        if request.path == "/ready":
            reason = unready(workspace)
            return (jsonify(status="not ready", reason=reason), 503) if reason else jsonify(status="ready")
        return None

    @server.after_request
    def _count(response: Response) -> Response:
        if begun := g.get("begun"):
            answers.count(response.status_code, time.perf_counter() - begun)
        return response

    @routes.get("/metrics")
    def metrics() -> ResponseReturnValue:
        text = "".join(f"{line}\n" for line in lines(workspace, answers, started))
        return Response(text, content_type="text/plain; version=0.0.4; charset=utf-8")

    server.register_blueprint(routes)


def unready(workspace: Workspace) -> str | None:
    """Why nobody can work with the workspace now, in words; None where everything is well."""
    try:
        workspace.jobs.newest_queued()
        if not os.access(workspace.path / "results", os.W_OK):
            return "the workspace is read-only"
        if shutil.disk_usage(workspace.path).free < LEAST_ROOM:
            return "the disk is full"
    except (WorkspaceError, OSError):
        return "the job table cannot be read"
    return None


def lines(workspace: Workspace, answers: Answers, started: float) -> list[str]:
    """The metrics, line by line; ``started``: when the server did, in seconds since 1970. Raises WorkspaceError."""
    counts = workspace.jobs.counts()
    bounds = zip(_SLOWEST, answers.within, strict=True)
    total = sum(answers.by_status.values())
    return [
        *_metric("motionscape_jobs", "gauge", {f'state="{s}"': counts.get(s, 0) for s in STATES}),
        *_metric("motionscape_datasets", "gauge", {"": len(workspace.datasets())}),
        *_metric("motionscape_disk_free_bytes", "gauge", {"": shutil.disk_usage(workspace.path).free}),
        *_metric("motionscape_ready", "gauge", {"": int(unready(workspace) is None)}),
        *_metric("motionscape_answers_total", "counter", {f'status="{s}"': n for s, n in answers.by_status.items()}),
        "# TYPE motionscape_answer_seconds histogram",
        *(f'motionscape_answer_seconds_bucket{{le="{bound}"}} {count}' for bound, count in bounds),
        f'motionscape_answer_seconds_bucket{{le="+Inf"}} {total}',
        f"motionscape_answer_seconds_sum {answers.seconds:.6f}",
        f"motionscape_answer_seconds_count {total}",
        *_metric("process_resident_memory_bytes", "gauge", {"": psutil.Process().memory_info().rss}),
        *_metric("process_start_time_seconds", "gauge", {"": round(started, 3)}),
    ]


def _metric(name: str, kind: str, values: dict[str, float]) -> list[str]:
    labelled = (f"{name}{{{label}}} {value}" if label else f"{name} {value}" for label, value in values.items())
    return [f"# TYPE {name} {kind}", *labelled]
