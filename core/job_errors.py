"""What a job that failed says to the person, and where the details of a bug stand."""

from __future__ import annotations

import traceback
from contextlib import suppress
from datetime import datetime

from core.errors import AnalysisError, LoggedBug, MotionscapeError, new_bug_id
from core.workspace import Job, Workspace, explain

_KEPT_LOGS = 50


def failure(workspace: Workspace, job: Job, error: Exception) -> AnalysisError:
    """The message for the person. Errors that are not meant for people go to a log file of the workspace."""
    if isinstance(error, MotionscapeError):
        return AnalysisError(str(error))
    bug_id, log = new_bug_id(), workspace.logs / f"job-{job.id}.log"
    with suppress(OSError):
        trace = "".join(traceback.format_exception(error))
        head = f"{datetime.now():%Y-%m-%d %H:%M:%S} {bug_id} {job.title} {job.request}"
        log.write_text(f"{head}\n{trace}", encoding="utf-8")
        for old in sorted(workspace.logs.glob("job-*"), key=lambda path: path.stat().st_mtime)[:-_KEPT_LOGS]:
            old.unlink()
    if isinstance(error, OSError | MemoryError):
        return AnalysisError(f"{job.title} failed: {explain(error)}.")
    where = f"The details stand in logs/{log.name} of the workspace"
    return LoggedBug(f"{job.title} failed because of a fault in Motionscape. {where} (error {bug_id}).", bug_id)


def failure_elsewhere(workspace: Workspace, job: Job) -> AnalysisError:
    """What ended a job that another process worked on: a LoggedBug where its log has the id that the job's error
    names."""
    try:
        head = (workspace.logs / f"job-{job.id}.log").read_text(encoding="utf-8").split(maxsplit=3)
    except (OSError, UnicodeDecodeError):
        return AnalysisError(job.error)
    bug_id = head[2] if len(head) > 2 else ""  # after the date and the time
    return LoggedBug(job.error, bug_id) if bug_id and f"(error {bug_id})" in job.error else AnalysisError(job.error)
