"""Features of a dataset for other tools: requested in the Library, computed as a job, downloaded when ready."""

from __future__ import annotations

from urllib.parse import quote

from dash import Dash, Input, Output, State, dcc, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import analyses
from core.errors import ParameterError
from core.workspace import Workspace, WorkspaceError
from webapp import jobs
from webapp.features.library import names
from webapp.jobs.names import JOBS_FINISHED
from webapp.shell.messages import notice
from webapp.shell.names import JOB_STARTED, NOTICES


def stores() -> list[Component]:
    """Stores for the frame of the app: features may become ready while another page is open."""
    return [
        dcc.Store(id=names.FEATURES_CHOICE),  # {"dataset": name, "suffix": ".npz"} that someone waits for
        dcc.Store(id=names.FEATURES_READY),  # address of the download
    ]


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callback that starts the job of missing features and downloads those that are ready."""

    @app.callback(
        Output(names.FEATURES_READY, "data"),
        Input(names.FEATURES_CHOICE, "data"),
        Input(JOBS_FINISHED, "data"),
        State(names.FEATURES_CHOICE, "data"),
        prevent_initial_call=True,
    )
    def deliver(_request, _finished, wanted):
        if not wanted:
            return no_update
        request = analyses.Request(str(wanted.get("dataset")), "features")
        try:
            if analyses.stored(workspace, request) is not None:
                set_props(names.FEATURES_CHOICE, {"data": None})
                address = f"/api/features/{quote(request.dataset, safe='')}{wanted.get('suffix')}"
                return {"address": address, "at": wanted.get("at")}
            job = workspace.jobs.latest(analyses.key(workspace, request))
            if wanted.get("job") is None:
                job = jobs.start(workspace, request)
                set_props(JOB_STARTED, {"data": job.id})
                set_props(names.FEATURES_CHOICE, {"data": wanted | {"job": job.id}})
            elif job is None or not job.alive:
                set_props(names.FEATURES_CHOICE, {"data": None})
                if job is not None and job.state == "failed":
                    raise WorkspaceError(job.error)
        except (ParameterError, WorkspaceError) as error:
            set_props(names.FEATURES_CHOICE, {"data": None})
            set_props(NOTICES, {"sendNotifications": [notice("Cannot compute the features", str(error), "red")]})
        return no_update

    app.clientside_callback(ClientsideFunction("downloads", "fetch"), Input(names.FEATURES_READY, "data"))
