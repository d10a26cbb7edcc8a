"""What the Boards page is told: all of it happens in the browser (assets/boards)."""

from __future__ import annotations

from dash import Dash, Input, Output
from dash.dependencies import ClientsideFunction

from core.workspace import Workspace
from webapp.features.boards import names
from webapp.shell.names import ADDRESS, DATASET, JOB_ENDED, SELECTION, THEME, VIEW


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callbacks that tell the page what is shown, and the comments what is selected."""
    app.clientside_callback(
        ClientsideFunction("boards", "show"),
        Output(names.BOARDS_SHOWN, "data"),
        Input(VIEW, "data"),
        Input(DATASET, "data"),
        Input(SELECTION, "data"),
        Input(THEME, "data"),
        Input(JOB_ENDED, "data"),
    )
    app.clientside_callback(ClientsideFunction("discussion", "look"), Input(ADDRESS, "data"))
