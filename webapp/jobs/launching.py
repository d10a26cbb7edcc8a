"""Starts workers: processes that take jobs from the workspace's table until none is left.

``start`` enters a request and makes sure that a worker runs. A worker is a separate process that outlives the server:
it claims the oldest queued job, computes it in a child process on all cores (the child can be ended at any moment, even
inside a long kernel or when it has used up the memory), sends heartbeats, and continues with the next job.

``python -m webapp.jobs WORKSPACE`` is such a worker; ``--job N`` its child, ``--detach`` starts one and returns.
Only the standard library is imported at the top: a worker must start quickly and stay small.
"""

from __future__ import annotations

import atexit
import contextlib
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from core.analyses import Request
    from core.workspace import Job, Workspace

REDIS = "MOTIONSCAPE_REDIS_URL"
GRACE = 0.8  # seconds a job has to stop by itself before its process is ended
POLL = 0.2  # seconds between two checks of the child and the table
RELAUNCH = 3.0  # seconds a worker has to appear before another is started
OUT_OF_MEMORY = (
    "The system ended the worker, most likely because memory ran out. "
    "Close other programs, or take fewer clips or a lower frame rate, and run it again."
)

# By workspace: the newest job that a worker was started for, and when.
_launched: dict[str, tuple[int, float]] = {}
_lock = threading.Lock()


def limit() -> int:
    """How many jobs run at the same time: one for each core; the others wait in order."""
    return os.cpu_count() or 1


def start(workspace: Workspace, request: Request) -> Job:
    """Enters a request into the job table (or finds the active job for it) and makes sure that a worker runs.

    Raises ParameterError, WorkspaceError.
    """
    from core.analyses import submit

    job = submit(workspace, request)
    ensure_worker(workspace)
    return job


def restart(workspace: Workspace, job_id: int) -> Job:
    """Starts a job again. Raises WorkspaceError where the table no longer has it."""
    from core.workspace import WorkspaceError

    old = workspace.jobs.get(job_id)
    if old is None:
        raise WorkspaceError("This job is no longer known; start it again from its page.")
    job = workspace.jobs.submit(old.key, old.request, old.title)
    ensure_worker(workspace)
    return job


def ensure_worker(workspace: Workspace) -> bool:
    """Starts a worker if jobs are waiting and a core is free; returns whether it did. Cheap enough for every poll."""
    newest = workspace.jobs.newest_queued()
    if newest is None or workspace.jobs.running() >= limit():
        return False
    place, now = str(workspace.path), time.monotonic()
    with _lock:
        job, when = _launched.get(place, (0, 0.0))
        if job == newest and now - when < RELAUNCH:
            return False  # a worker for it is starting
        _launched[place] = newest, now
    launch(workspace.path)
    return True


def wait_for(workspace_path: str, job_id: int) -> str:
    """Waits until a job has ended and returns its final state. For Dash's background callbacks.

    The waiting thread or process may be ended (Dash does so when a callback is called again); the worker goes on.
    """
    from core.workspace import shared_workspace

    workspace = shared_workspace(workspace_path)
    while (job := workspace.jobs.get(job_id)) is not None and job.alive:
        ensure_worker(workspace)
        time.sleep(POLL)
    return job.state if job else "unknown"


def launch(workspace_path: str | Path) -> None:
    """Starts a detached worker process, which does not end with Dash or the server."""
    subprocess.run(_command("--detach", Path(workspace_path).absolute()), check=True, **_QUIET)


def background_manager(workspace_path: str | Path) -> Any:
    """What runs Dash's background callbacks: Celery where MOTIONSCAPE_REDIS_URL is set, else threads that only wait.

    Raises RuntimeError where Redis is asked for and Celery is not installed.
    """
    url = os.environ.get(REDIS)
    if url:
        try:
            from celery import Celery
            from dash import CeleryManager
        except ImportError as error:
            raise RuntimeError(
                f"{REDIS} is set, but Celery is not installed: pip install 'motionscape[celery]'"
            ) from error
        return CeleryManager(Celery("motionscape", broker=url, backend=url))
    from diskcache import Cache

    from webapp.jobs.background import WaitingManager

    # Dash's own notes (pickles) must not lie in a workspace that people pass on, and need not outlive the server.
    folder = tempfile.mkdtemp(prefix="motionscape-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return WaitingManager(Cache(folder))


def serve_queue(workspace: Workspace) -> int:
    """Runs queued jobs, oldest first, until none waits or enough other workers run; returns how many it ran."""
    done = 0
    while (job := workspace.jobs.claim_next(limit())) is not None:
        supervise(workspace, job)
        done += 1
    return done


def supervise(workspace: Workspace, job: Job) -> None:
    """Runs a claimed job in a child process, and records how it ended where the child could not."""
    log = workspace.logs / f"job-{job.id}-output.log"
    with log.open("wb") as output:
        quiet = _QUIET | {"stdout": output, "stderr": output}
        child = subprocess.Popen(_command("--job", str(job.id), workspace.path), **quiet)
        ended_by_us = _watch(workspace, job, child)
    if log.stat().st_size == 0:
        log.unlink()
    after = workspace.jobs.get(job.id)
    if after is None or not after.alive:
        return
    if ended_by_us or after.cancelling:
        workspace.jobs.stopped(job.id)
    elif child.returncode == -getattr(signal, "SIGKILL", 9):
        workspace.jobs.fail(job.id, OUT_OF_MEMORY, died=True)
    else:
        from core.workspace.jobs import STOPPED

        workspace.jobs.fail(job.id, STOPPED, died=True)


def _watch(workspace: Workspace, job: Job, child: subprocess.Popen) -> bool:
    """Waits for the child, sending heartbeats; ends it if a cancelled job does not stop. Returns whether it did."""
    from core.workspace import WorkspaceError

    cancelled_at = None
    while True:
        with contextlib.suppress(subprocess.TimeoutExpired):
            child.wait(POLL)
            return False
        with contextlib.suppress(WorkspaceError):  # a busy table: try again
            if workspace.jobs.beat(job.id) and cancelled_at is None:
                cancelled_at = time.monotonic()
        if cancelled_at is not None and time.monotonic() - cancelled_at > GRACE:
            child.kill()
            child.wait()
            return True


def _compute(workspace: Workspace, job_id: int) -> None:
    from core.analyses import execute
    from core.errors import AnalysisError
    from core.machine import limit_memory
    from core.progress import Cancelled

    limit_memory()
    job = workspace.jobs.get(job_id)
    if job is not None and job.state == "running":
        with contextlib.suppress(AnalysisError, Cancelled):  # the table has both states
            execute(workspace, job)


def _leave_with_parent(parent: int) -> None:
    """Ends this process when its worker is gone, because no one would record the result."""
    while os.getppid() == parent:
        time.sleep(0.5)
    os._exit(1)


def _command(option: str, *rest: str | Path) -> list[str]:
    return [sys.executable, "-m", "webapp.jobs", option, *map(str, rest)]


_QUIET: dict[str, Any] = {
    "stdin": subprocess.DEVNULL,
    "stdout": subprocess.DEVNULL,
    "stderr": subprocess.DEVNULL,
    "cwd": Path(__file__).resolve().parents[2],
}
if sys.platform == "win32":
    _QUIET["creationflags"] = subprocess.DETACHED_PROCESS | subprocess.CREATE_NEW_PROCESS_GROUP
else:
    _QUIET["start_new_session"] = True


def main(arguments: list[str]) -> None:
    """Runs as a worker, as a worker's child, or starts a detached worker: see the module's description."""
    *options, path = arguments
    if options == ["--detach"]:
        subprocess.Popen([sys.executable, "-m", "webapp.jobs", path], **_QUIET)
        return
    if options[:1] == ["--job"]:
        threading.Thread(target=_leave_with_parent, args=(os.getppid(),), daemon=True).start()
        if hasattr(os, "nice"):
            os.nice(5)  # lower priority than the server, so that the Stage stays smooth
    from core.workspace import Workspace

    workspace = Workspace(path)
    if options[:1] == ["--job"]:
        _compute(workspace, int(options[1]))
    else:
        serve_queue(workspace)
