"""Jobs on several machines: Celery carries the word that a workspace has work, and its workers compute it.

The job table of the workspace, in a folder that all machines share under the same path, stays the truth. A call names
only the workspace; a worker takes the oldest job from the table, as the workers of this machine do. Where a call is
lost, with Redis or with a worker, no job is: the next look at the table makes another call.

``celery --app webapp.jobs.celery_workers worker`` is such a worker. It computes one job at a time.
"""

from __future__ import annotations

import contextlib
import logging
import os
from pathlib import Path

from celery import Celery
from celery.exceptions import OperationalError
from redis import Redis, RedisError

from core.errors import ParameterError
from core.workspace import Workspace, WorkspaceError
from webapp.jobs.launching import REDIS
from webapp.jobs.worker import serve_queue

QUEUE = "motionscape"
PATIENCE = 2.0  # seconds for Redis to answer
_log = logging.getLogger(__name__)


def _address() -> str:
    if url := os.environ.get(REDIS):
        return url
    raise ParameterError(f"{REDIS} is not set: a Celery worker needs the address of Redis, as in redis://host:6379/0.")


app = Celery("motionscape", broker=_address())
app.conf.update(
    task_default_queue=QUEUE,
    task_ignore_result=True,  # the job table has what became of a job
    task_serializer="json",
    accept_content=["json"],
    task_acks_late=True,  # with the next line: a call is taken by a worker that is free, not kept by a busy one
    worker_prefetch_multiplier=1,
    worker_redirect_stdouts=False,  # a child sends its own into a file
    worker_concurrency=1,
    worker_pool="solo",  # jobs are computed in children of their own, see webapp.jobs.worker
    broker_connection_retry_on_startup=True,
    broker_connection_max_retries=None,
    broker_transport_options={"socket_connect_timeout": PATIENCE, "socket_timeout": 60.0},
)


@app.task(name="motionscape.work")
def work(workspace_path: str) -> None:
    """Works on the jobs of a workspace until none waits. Does nothing where the workspace is gone."""
    try:
        workspace = Workspace(workspace_path, create=False)
    except WorkspaceError as error:
        _log.warning("A call for %s came to nothing: %s", workspace_path, error)
        return
    with contextlib.closing(workspace):
        serve_queue(workspace)


def call(workspace_path: Path, waiting: int) -> bool:
    """Calls a worker to a workspace, unless as many calls as jobs are ``waiting``; False where Redis is silent."""
    try:
        with Redis.from_url(_address(), socket_connect_timeout=PATIENCE, socket_timeout=PATIENCE) as redis:
            if redis.llen(QUEUE) >= waiting:
                return True
        work.apply_async((str(workspace_path),), retry=False)
        return True
    except (RedisError, OperationalError, OSError) as error:
        _log.warning("Redis does not answer; jobs wait until it does: %s", error)
        return False
