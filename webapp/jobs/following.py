"""A background callback that waits for a job which the browser started, so that its end is noticed immediately."""

from __future__ import annotations

from dash import Dash, Input, Output

from core.workspace import Workspace
from webapp import jobs
from webapp.shell.names import JOB_ENDED, JOB_STARTED


def register(app: Dash, workspace: Workspace) -> None:
    """The store "job-ended" changes when the job in "job-started" has ended."""
    path = str(workspace.path)

    @app.callback(
        Output(JOB_ENDED, "data"),
        Input(JOB_STARTED, "data"),
        background=True,
        prevent_initial_call=True,
    )
    def follow(job_id):
        return jobs.wait_for(path, job_id)
