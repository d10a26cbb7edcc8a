"""Recordings that were uploaded to be looked for: ``~upload~KEY`` holds the one clip that a job read.

KEY is the key of the request that read it (core/workspace/query_files.py).
"""

from __future__ import annotations

import re

from core import requests
from core.mocap.dataset import Dataset
from core.workspace import Job, ResultDamaged, Workspace, WorkspaceError
from core.workspace.query_files import kept_query
from webapp import jobs
from webapp.shell.virtual import virtual_name

UPLOAD = "upload"
GONE = "The uploaded recording is no longer here; upload it again."


def start(workspace: Workspace, file: str, token: str) -> Job:
    """Starts the job that reads an upload, shown to people as ``file``. Raises WorkspaceError, ParameterError."""
    workspace.uploads.path(token)  # raises where there is none
    return jobs.start(workspace, requests.query_request(file[:80] or "recording", token))


def name_of(job: Job) -> str:
    """The made-up data set that holds what a job has read."""
    return virtual_name(UPLOAD, job.key)


def open_upload(workspace: Workspace, key: str) -> Dataset:
    """The data set ``~upload~`` + key. Raises WorkspaceError where it is not there any more."""
    try:
        clip = kept_query(workspace, key) if re.fullmatch(r"[0-9a-f]{8,64}", key) else None
    except ResultDamaged:
        clip = None
    if clip is None:
        raise WorkspaceError(GONE)
    return Dataset(virtual_name(UPLOAD, key), (clip,))
