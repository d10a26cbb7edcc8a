"""The job table: what was asked for, how far it is, how it ended. All processes see the same rows.

A job is ``queued``, ``running``, ``done``, ``failed`` or ``cancelled``. A queued one may be held: no worker takes it
until someone says that it shall start. Among the living jobs (queued or running, not asked to stop) there is at most
one per key, so that the same request is computed once. Times are seconds since 1970.
"""

from __future__ import annotations

import json
import socket
import sqlite3
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import Any

import psutil

from core.progress import Cancelled
from core.workspace.audit import record
from core.workspace.database import Database
from core.workspace.errors import WorkspaceError
from core.workspace.people import acting, require

STOPPED = "The worker stopped before it was finished (it may have been ended, or run out of memory); run it again."
HEARTBEAT = 0.5  # seconds between two signs of life
STALE_ELSEWHERE = 30.0  # a worker on another machine can only be judged by its heartbeat
STALE_HERE = 900.0  # here we see whether the process exists; long kernels may keep it from its heartbeat
CANCEL_PATIENCE = 10.0  # a worker that ignores a request to stop for this long is given up
KEPT = 200  # finished jobs kept as history
PROGRESS_EVERY = 0.2  # seconds
_WAITS = "state = 'queued' AND held = ''"  # for a worker


@dataclass(frozen=True)
class Job:
    """A row of the job table. ``fraction`` is from 0 to 1 within ``stage``; ``died`` where its worker vanished.

    expected: what it will take, in words. held: why it has not been put in the queue yet, in words; empty where it has.
    """

    id: int
    key: str
    request: dict[str, Any]
    title: str
    state: str
    stage: str
    fraction: float
    cancelling: bool
    created: float
    started: float | None
    finished: float | None
    heartbeat: float
    pid: int | None
    error: str
    died: bool
    expected: str = ""
    held: str = ""

    @property
    def alive(self) -> bool:
        """Queued or running."""
        return self.state in ("queued", "running")


class JobTable:
    """The jobs of one workspace. Every method may raise WorkspaceError when the table is busy or damaged."""

    def __init__(self, database: Database):
        self._database = database

    def share_between_machines(self) -> None:
        """Makes the table one that several machines may use, where the folder is on a file system that they share.

        Raises WorkspaceError where other processes have the table open.
        """
        self._database.share_between_machines()

    def submit(self, key: str, request: dict[str, Any], title: str, *, expected: str = "", held: str = "") -> Job:
        """The living job for ``key``, or a new one, queued. ``request`` must be JSON; the rest as in :class:`Job`."""
        text, now = json.dumps(request, sort_keys=True), time.time()
        with self._database.transaction("enter the job") as table:
            _require_editor(table, request, "start this")
            _bury_dead(table)
            row = table.execute(
                "SELECT * FROM jobs WHERE key = ? AND state IN ('queued', 'running') AND cancel IS NULL", (key,)
            ).fetchone()
            if row is None:
                entry = table.execute(
                    "INSERT INTO jobs (key, request, title, created, heartbeat, expected, held) "
                    "VALUES (?, ?, ?, ?, ?, ?, ?)",
                    (key, text, title, now, now, expected, held),
                )
                row = table.execute("SELECT * FROM jobs WHERE id = ?", (entry.lastrowid,)).fetchone()
                _prune(table)
                record(table, "job started", title, f"job {row['id']}")
        return _job(row)

    def claim(self, job_id: int) -> Job | None:
        """Makes this process the worker of a queued job; None when it is no longer queued."""
        with self._database.transaction("start the job") as table:
            return _claim(table, table.execute("SELECT * FROM jobs WHERE id = ?", (job_id,)).fetchone())

    def claim_next(self, limit: int) -> Job | None:
        """Makes this process the worker of the oldest queued job; None when the queue is empty or ``limit`` run."""
        with self._database.transaction("start the next job") as table:
            _bury_dead(table)
            if table.execute("SELECT count(*) FROM jobs WHERE state = 'running'").fetchone()[0] >= limit:
                return None
            return _claim(table, table.execute(f"SELECT * FROM jobs WHERE {_WAITS} ORDER BY id").fetchone())

    def beat(self, job_id: int) -> bool:
        """A sign of life from the worker; True when the job has been asked to stop."""
        with self._database.transaction("note that the job is alive") as table:
            table.execute("UPDATE jobs SET heartbeat = ? WHERE id = ? AND state = 'running'", (time.time(), job_id))
            row = table.execute("SELECT state, cancel FROM jobs WHERE id = ?", (job_id,)).fetchone()
        return row is None or row["cancel"] is not None or row["state"] == "cancelled"

    def progress(self, job_id: int, stage: str, fraction: float) -> None:
        """Notes how far a running job is; ``fraction`` from 0 to 1 within ``stage``."""
        with self._database.transaction("note the progress") as table:
            table.execute(
                "UPDATE jobs SET stage = ?, fraction = ?, heartbeat = ? WHERE id = ? AND state = 'running'",
                (stage, min(max(float(fraction), 0.0), 1.0), time.time(), job_id),
            )

    def finish(self, job_id: int) -> None:
        """The work is done and stored (also where its worker had been given up too early)."""
        self._end(job_id, "done", "", ("running", "failed"))

    def fail(self, job_id: int, error: str, *, died: bool = False) -> None:
        """The work ended with ``error``, plain words for the person who asked."""
        self._end(job_id, "failed", error, ("queued", "running"), died)

    def stopped(self, job_id: int) -> None:
        """The worker has stopped as it was asked to."""
        self._end(job_id, "cancelled", "", ("queued", "running"))

    def cancel(self, job_id: int) -> Job | None:
        """Asks a job to stop: a queued one is cancelled at once, a running one by its worker. None where unknown."""
        now = time.time()
        with self._database.transaction("cancel the job") as table:
            asked = table.execute("SELECT request, title, state FROM jobs WHERE id = ?", (job_id,)).fetchone()
            if asked is None:
                return None
            _require_editor(table, json.loads(asked["request"]), "cancel this")
            if asked["state"] in ("queued", "running"):
                record(table, "job cancelled", asked["title"], f"job {job_id}")
            table.execute(
                "UPDATE jobs SET cancel = ?, finished = ?, state = 'cancelled' WHERE id = ? AND state = 'queued'",
                (now, now, job_id),
            )
            table.execute(
                "UPDATE jobs SET cancel = ? WHERE id = ? AND state = 'running' AND cancel IS NULL", (now, job_id)
            )
            row = table.execute("SELECT * FROM jobs WHERE id = ?", (job_id,)).fetchone()
        return _job(row) if row else None

    def release(self, job_id: int) -> Job | None:
        """Lets a held job start. None where there is no such job."""
        with self._database.transaction("start the job") as table:
            asked = table.execute("SELECT request, title FROM jobs WHERE id = ?", (job_id,)).fetchone()
            if asked is None:
                return None
            _require_editor(table, json.loads(asked["request"]), "start this")
            if table.execute("UPDATE jobs SET held = '' WHERE id = ? AND held != ''", (job_id,)).rowcount:
                record(table, "job released", asked["title"], f"job {job_id}")
            return _job(table.execute("SELECT * FROM jobs WHERE id = ?", (job_id,)).fetchone())

    def get(self, job_id: int) -> Job | None:
        """The job, or None where there is none. A dead worker has been noticed."""
        return next(iter(self._read("WHERE id = ?", job_id)), None)

    def latest(self, key: str) -> Job | None:
        """The newest job for ``key``, or None."""
        return next(iter(self._read("WHERE key = ? ORDER BY id DESC LIMIT 1", key)), None)

    def newest_queued(self) -> int | None:
        """The id of the newest job that waits for a worker, or None."""
        newest: int | None = self._database.rows(f"SELECT max(id) FROM jobs WHERE {_WAITS}")[0][0]
        return newest

    def running(self) -> int:
        """Number of jobs that run; dead workers have been noticed."""
        self.bury_dead()
        running: int = self._database.rows("SELECT count(*) FROM jobs WHERE state = 'running'")[0][0]
        return running

    def counts(self) -> dict[str, int]:
        """How many jobs there are in each state; dead workers have been noticed."""
        self.bury_dead()
        return dict(tuple(row) for row in self._database.rows("SELECT state, count(*) FROM jobs GROUP BY state"))

    def interrupted(self, since: float) -> list[int]:
        """The jobs whose worker vanished after ``since`` (seconds since 1970), once: of the same request no other job
        is there, and none that broke off before. They may be started again, oldest first."""
        self.bury_dead()
        rows = self._database.rows(
            "SELECT min(id) AS id FROM jobs GROUP BY key HAVING count(*) = 1 AND max(died) = 1 "
            "AND max(state) = 'failed' AND max(error) = ? AND max(finished) > ? ORDER BY id",
            STOPPED,
            since,
        )
        return [int(row["id"]) for row in rows]

    def bury_dead(self) -> int:
        """Marks running jobs as failed whose worker is gone; they may be submitted again. How many there were."""
        gone = sum(_is_gone(row) for row in self._database.rows("SELECT * FROM jobs WHERE state = 'running'"))
        if gone:
            with self._database.transaction("look after the jobs") as table:
                _bury_dead(table)
        return gone

    @contextmanager
    def working(self, job_id: int) -> Iterator[Callable[[str, float], None]]:
        """For the worker: gives a report that writes throttled progress and raises Cancelled when asked to stop.

        A thread sends heartbeats meanwhile. The job's end is the caller's to write.
        """
        stop_requested, over = threading.Event(), threading.Event()
        last_stage, last_time = "", 0.0

        def beats() -> None:
            while not over.wait(HEARTBEAT):
                with suppress(WorkspaceError):  # a busy table is no reason to stop working
                    if self.beat(job_id):
                        stop_requested.set()
            self._database.close()

        def report(stage: str, fraction: float) -> None:
            nonlocal last_stage, last_time
            if stop_requested.is_set():
                raise Cancelled
            now = time.monotonic()
            if now - last_time < (PROGRESS_EVERY if stage == last_stage else PROGRESS_EVERY / 4):
                return
            last_stage, last_time = stage, now
            with suppress(WorkspaceError):
                self.progress(job_id, stage, fraction)

        thread = threading.Thread(target=beats, name=f"heartbeat of job {job_id}", daemon=True)
        thread.start()
        try:
            yield report
        finally:
            over.set()
            thread.join()

    def _end(self, job_id: int, state: str, error: str, before: tuple[str, ...], died: bool = False) -> None:
        marks = ", ".join("?" * len(before))
        with self._database.transaction("note the end of the job") as table:
            table.execute(
                f"UPDATE jobs SET state = ?, error = ?, died = ?, finished = ? WHERE id = ? AND state IN ({marks})",
                (state, error, died, time.time(), job_id, *before),
            )

    def _read(self, condition: str, *values: object) -> list[Job]:
        self.bury_dead()
        jobs, person = [_job(row) for row in self._database.rows(f"SELECT * FROM jobs {condition}", *values)], acting()
        return [job for job in jobs if not person.is_guest or job.request.get("dataset") in person.datasets]

    def list(self, limit: int = 50) -> list[Job]:
        """The newest jobs, newest first; dead workers have been noticed."""
        return self._read("ORDER BY id DESC LIMIT ?", limit)


def _job(row: sqlite3.Row) -> Job:
    values = {name: row[name] for name in row.keys() if name in Job.__dataclass_fields__}  # noqa: SIM118
    return Job(
        **values | {"request": json.loads(row["request"]), "died": bool(row["died"])},
        cancelling=row["cancel"] is not None and row["state"] == "running",
    )


def _require_editor(table: sqlite3.Connection, request: dict[str, Any], to: str) -> None:
    """Raises AccessRefused where who acts is no editor of the dataset that a request is about."""
    query = "SELECT id FROM datasets WHERE name = ? AND trashed IS NULL"
    row = table.execute(query, (str(request.get("dataset", "")),)).fetchone()
    require("editor", row["id"] if row else None, to=to)


def _claim(table: sqlite3.Connection, row: sqlite3.Row | None) -> Job | None:
    if row is None or row["state"] != "queued":
        return None
    me, now = psutil.Process(), time.time()
    table.execute(
        "UPDATE jobs SET state = 'running', started = ?, heartbeat = ?, pid = ?, born = ?, host = ? WHERE id = ?",
        (now, now, me.pid, me.create_time(), socket.gethostname(), row["id"]),
    )
    return _job(table.execute("SELECT * FROM jobs WHERE id = ?", (row["id"],)).fetchone())


def _bury_dead(table: sqlite3.Connection) -> None:
    now = time.time()
    for row in table.execute("SELECT * FROM jobs WHERE state = 'running'").fetchall():
        if not _is_gone(row):
            continue
        state, error = ("cancelled", "") if row["cancel"] is not None else ("failed", STOPPED)
        table.execute(
            "UPDATE jobs SET state = ?, error = ?, died = 1, finished = ? WHERE id = ?", (state, error, now, row["id"])
        )


def _is_gone(row: sqlite3.Row) -> bool:
    now = time.time()
    silent: float = now - row["heartbeat"]
    if row["cancel"] is not None and now - row["cancel"] > CANCEL_PATIENCE and silent > CANCEL_PATIENCE:
        return True
    if row["host"] != socket.gethostname():
        return silent > STALE_ELSEWHERE
    return silent > STALE_HERE or not _exists(row["pid"], row["born"])


def _exists(pid: int, born: float) -> bool:
    """Whether the process lives and is the same one: ids are used again, so its birth must agree."""
    try:
        process = psutil.Process(pid)
        return abs(process.create_time() - born) < 2.0 and process.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False
    except psutil.Error:  # not ours to look at: it exists
        return True


def _prune(table: sqlite3.Connection) -> None:
    table.execute(
        "DELETE FROM jobs WHERE id IN (SELECT id FROM jobs WHERE state NOT IN ('queued', 'running') "
        "ORDER BY id DESC LIMIT -1 OFFSET ?)",
        (KEPT,),
    )
