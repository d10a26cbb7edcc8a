"""A worker: a process of its own that takes jobs from a workspace's table until none is left.

It claims the oldest queued job and computes it in a child process on all cores. The child can be ended at any moment,
even inside a long kernel or when it has used up the memory, and its memory is free when it ends. The worker itself
never computes: it imports what the job needs and forks, so the next child of the same method starts with everything
imported (on Windows and macOS, where that is not safe, a child imports it again). Without work it stays for a while,
see ``idle``.

``python -m webapp.jobs WORKSPACE`` is such a worker.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import shutil
import signal
import sys
import threading
import time
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import TYPE_CHECKING, Any

from webapp.jobs import idle

if TYPE_CHECKING:
    from core.workspace import Job, Workspace

GRACE = 0.8  # seconds a job has to stop by itself before its process is ended
BEAT = 0.2  # seconds between two looks at the table
FORKS = sys.platform not in ("win32", "darwin")  # on macOS system libraries may not be used after a fork
PATIENCE = 60.0  # seconds to write the end of a job where the table cannot be written
LEAST_ROOM = 1 << 22  # bytes on the disk below which a job breaks off because it can store nothing
DISK_FULL = "The disk is full; free some space and run it again."
OUT_OF_MEMORY = (
    "The system ended the worker, most likely because memory ran out. "
    "Close other programs, or take fewer clips or a lower frame rate, and run it again."
)


def work(workspace_path: str, caller: int) -> None:
    """Works on the jobs of a workspace, then of those it is called to, until nobody calls for a while.

    caller: the process that started this worker.
    """
    from core.workspace import Workspace, WorkspaceError

    called: tuple[str, int] | None = (workspace_path, caller)
    while called:
        try:
            workspace = Workspace(called[0], create=False)
        except WorkspaceError:  # it has been deleted
            break
        with contextlib.closing(workspace):
            serve_queue(workspace)
        called = idle.wait(called[1]) if FORKS else None


def serve_queue(workspace: Workspace) -> int:
    """Runs queued jobs, oldest first, until none waits or enough other workers run; returns how many it ran."""
    from webapp.jobs.launching import limit

    done = 0
    while (job := workspace.jobs.claim_next(limit())) is not None:
        supervise(workspace, job)
        done += 1
    return done


def supervise(workspace: Workspace, job: Job) -> None:
    """Runs a claimed job in a child process, and records how it ended where the child could not."""
    log = workspace.logs / f"job-{job.id}-output.log"
    if FORKS:
        _prepare(job.request["method"])
    context: Any = multiprocessing.get_context("fork" if FORKS else "spawn")
    child = context.Process(target=_compute, args=(str(workspace.path), job.id, str(log)))
    child.start()
    try:
        ended_by_us = _watch(workspace, job, child)
    finally:  # whatever ends this worker: who waits for the job must see that nobody works on it
        child.kill()
        child.join()
    with contextlib.suppress(OSError):
        if log.stat().st_size == 0:
            log.unlink()
    _note_end(workspace, job, ended_by_us, child.exitcode)


def _note_end(workspace: Workspace, job: Job, ended_by_us: bool, exit_code: int | None) -> None:
    """Writes how a job ended into the table, where its child could not. A full disk is waited for a while."""
    from core.workspace import WorkspaceError

    deadline, full = time.monotonic() + PATIENCE, _is_full(workspace)
    while True:
        try:
            after = workspace.jobs.get(job.id)
            if after is None or not after.alive:
                return
            if ended_by_us or after.cancelling:
                return workspace.jobs.stopped(job.id)
            return workspace.jobs.fail(job.id, DISK_FULL if full else _why(exit_code), died=True)
        except WorkspaceError:
            if time.monotonic() > deadline:
                raise
            full = full or _is_full(workspace)
            time.sleep(1.0)


def _why(exit_code: int | None) -> str:
    from core.workspace.jobs import STOPPED

    return OUT_OF_MEMORY if exit_code == -getattr(signal, "SIGKILL", 9) else STOPPED


def _is_full(workspace: Workspace) -> bool:
    with contextlib.suppress(OSError):
        return shutil.disk_usage(workspace.path).free < LEAST_ROOM
    return False


def _prepare(method: str) -> None:
    """Imports what jobs of a method need and gets numba ready. Nothing is computed: no thread may run at a fork."""
    from core.analyses import parameters
    from core.compiled import warm_up

    with contextlib.suppress(Exception):  # the child meets the same fault, and tells it
        parameters(method)
        warm_up()


def _watch(workspace: Workspace, job: Job, child: BaseProcess) -> bool:
    """Waits for the child, sending heartbeats; True where a cancelled job does not stop and is to be ended."""
    from core.workspace import WorkspaceError

    cancelled_at = None
    while True:
        child.join(BEAT)
        if child.exitcode is not None:
            return False
        with contextlib.suppress(WorkspaceError):  # a busy table: try again
            if workspace.jobs.beat(job.id) and cancelled_at is None:
                cancelled_at = time.monotonic()
        if cancelled_at is not None and time.monotonic() - cancelled_at > GRACE:
            return True


def _compute(workspace_path: str, job_id: int, log: str) -> None:
    """The child: computes a job; what is printed meanwhile goes into the file ``log``."""
    _write_to(log)
    threading.Thread(target=_leave_with_worker, daemon=True).start()
    if hasattr(os, "nice"):
        os.nice(5)  # lower priority than the server, so that the Stage stays smooth
    from core.analyses import execute
    from core.errors import AnalysisError
    from core.machine import limit_memory
    from core.progress import Cancelled
    from core.workspace import Workspace

    limit_memory()
    workspace = Workspace(workspace_path, create=False)
    job = workspace.jobs.get(job_id)
    if job is not None and job.state == "running":
        with contextlib.suppress(AnalysisError, Cancelled):  # the table has both states
            execute(workspace, job)


def _write_to(log: str) -> None:
    with Path(log).open("wb") as output:
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
            os.dup2(output.fileno(), stream.fileno())


def _leave_with_worker() -> None:
    """Ends this process when its worker is gone, because no one would record the result."""
    worker = multiprocessing.parent_process()
    if worker is not None:
        worker.join()
        os._exit(1)
