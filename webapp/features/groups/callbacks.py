"""What the Groups page is told: all of it happens in the browser (assets/groups)."""

from __future__ import annotations

from dash import Dash, Input, Output
from dash.dependencies import ClientsideFunction

from core.workspace import Workspace
from webapp.features.groups import names
from webapp.shell.names import DATASET, JOB_ENDED, VIEW


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callback that tells the page what is shown."""
    app.clientside_callback(
        ClientsideFunction("groups", "show"),
        Output(names.GROUPS_SHOWN, "data"),
        Input(VIEW, "data"),
        Input(DATASET, "data"),
        Input(JOB_ENDED, "data"),
    )
