"""A background callback that waits for a job which the browser started, so that its end is noticed at once."""

from __future__ import annotations

from dash import Dash, Input, Output

from core.workspace import Workspace
from webapp import jobs


def register(app: Dash, workspace: Workspace) -> None:
    """The store "job-ended" changes when the job in "job-started" has ended."""
    path = str(workspace.path)

    @app.callback(
        Output("job-ended", "data"),
        Input("job-started", "data"),
        background=True,
        prevent_initial_call=True,
    )
    def follow(job_id):
        return jobs.work(path, job_id)
