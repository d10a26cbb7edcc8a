"""Starts work: a request enters the workspace's job table, and a worker is called or started for it.

A worker (``webapp.jobs.worker``) is a separate process that outlives the server. Where MOTIONSCAPE_REDIS_URL is set,
Celery's workers do the same on any machine (``webapp.jobs.celery_workers``).
Only the standard library is imported at the top: a worker must start quickly.
"""

from __future__ import annotations

import atexit
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from webapp.jobs import idle

if TYPE_CHECKING:
    from core.analyses import Request
    from core.workspace import Job, Workspace

REDIS = "MOTIONSCAPE_REDIS_URL"
POLL = 0.2  # seconds between two looks at the table
RESUMED = 3 * 24 * 3600.0  # seconds since a job broke off within which it is started again by itself
RELAUNCH = 3.0  # seconds a worker has to appear before another is started

# By workspace: the newest job that a worker was started for, and when.
_launched: dict[str, tuple[int, float]] = {}
_lock = threading.Lock()


def limit() -> int:
    """How many jobs run at the same time: one for each core, or as many as there are Celery workers."""
    return sys.maxsize if os.environ.get(REDIS) else os.cpu_count() or 1


def start(workspace: Workspace, request: Request) -> Job:
    """Enters a request into the job table (or finds the active job for it) and makes sure that a worker runs.

    One that would take very long, or more memory than there is, is held until someone says that it shall start.
    Raises ParameterError, WorkspaceError.
    """
    from core.analyses import submit

    job = submit(workspace, request, ask=True)
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


def resume(workspace: Workspace) -> int:
    """Starts the jobs again that broke off with their worker in the last days, each once; how many.

    Each is started in the name of who started it first, whoever's page notices. A job that breaks off again may be what
    ends its worker, and waits for a person.
    """
    from core.workspace.people import Person, acting_as

    ids = workspace.jobs.interrupted(time.time() - RESUMED)
    for job_id in ids:
        with acting_as(Person(workspace.audit.who_started(job_id))):
            restart(workspace, job_id)
    return len(ids)


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
    if os.environ.get(REDIS):
        from webapp.jobs import celery_workers

        return celery_workers.call(workspace.path, workspace.jobs.counts().get("queued", 0))
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
    """Calls an idle worker, or starts one: a detached process, which does not end with Dash or the server."""
    path = Path(workspace_path).absolute()
    if not idle.call(path):
        subprocess.run(_command("--detach", os.getpid(), path), check=True, **_QUIET)


def get_ready(workspace: Workspace) -> None:
    """Where MOTIONSCAPE_REDIS_URL is set, makes the job table one that several machines can use. Do it before any work.

    Raises RuntimeError where Celery is not installed, WorkspaceError where other processes have the table open.
    """
    if not os.environ.get(REDIS):
        return
    try:
        from webapp.jobs import celery_workers  # noqa: F401
    except ImportError as error:
        raise RuntimeError(f"{REDIS} is set, but Celery is not installed: pip install 'motionscape[celery]'") from error
    workspace.jobs.share_between_machines()


def background_manager() -> Any:
    """What runs Dash's background callbacks: threads, for they only wait; workers compute."""
    from diskcache import Cache

    from webapp.jobs.background import WaitingManager

    # Dash's own notes (pickles) must not lie in a workspace that people pass on, and need not outlive the server.
    folder = tempfile.mkdtemp(prefix="motionscape-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return WaitingManager(Cache(folder))


def _command(*arguments: str | int | Path) -> list[str]:
    return [sys.executable, "-m", "webapp.jobs", *map(str, arguments)]


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
    """Starts a detached worker (``--detach CALLER WORKSPACE``), or works itself (``[CALLER] WORKSPACE``)."""
    if arguments[:1] == ["--detach"]:
        subprocess.Popen(_command(*arguments[1:]), **_QUIET)
        return
    from webapp.jobs.worker import work

    *caller, path = arguments
    work(path, int(caller[0]) if caller else os.getppid())
