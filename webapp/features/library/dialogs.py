"""Dialogs that change a data set: opened for what a store names, closed when their job is started."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from dash import Dash, Input, Output, State, no_update, set_props

from core.analyses import Request
from core.errors import MotionscapeError
from core.mocap.dataset import Dataset
from core.workspace import Workspace
from webapp.jobs import changes
from webapp.shell.messages import notice
from webapp.shell.names import DATASET, NOTICES


def opens(
    app: Dash,
    workspace: Workspace,
    dialog: str,
    of: str,
    filled: Sequence[Output],
    fill: Callable[[Dataset, dict[str, Any]], Sequence[Any]],
) -> None:
    """Opens ``dialog`` when the store ``of`` names a data set, with the values that ``fill`` gives for ``filled``.

    fill: takes the data set and what the store holds. Where there is no such data set, a notice says so.
    """

    @app.callback(Output(dialog, "opened"), *filled, Input(of, "data"), prevent_initial_call=True)
    def open_dialog(asked):
        nothing = (no_update,) * (1 + len(filled))
        if not asked:
            return nothing
        try:
            return True, *fill(workspace.open(asked["dataset"]), asked)
        except MotionscapeError as error:
            set_props(NOTICES, {"sendNotifications": [notice("That did not work", str(error), "red")]})
            return nothing


def starts(
    app: Dash,
    workspace: Workspace,
    dialog: str,
    button: str,
    problem: str,
    of: str,
    states: Sequence[State],
    request: Callable[..., Request],
) -> None:
    """Starts a job when ``button`` is clicked, and closes ``dialog``; what is wrong stands in ``problem``.

    request: takes the data set, what the store ``of`` holds and the values of ``states``, and gives the request of the
    job, or raises a MotionscapeError.
    """

    @app.callback(
        Output(dialog, "opened", allow_duplicate=True),
        Output(problem, "children", allow_duplicate=True),
        Input(button, "n_clicks"),
        State(of, "data"),
        *states,
        prevent_initial_call=True,
    )
    def start(_clicks, asked, *values):
        if not asked:
            return no_update, no_update
        try:
            changes.start(workspace, request(workspace.open(asked["dataset"]), asked, *values))
        except MotionscapeError as error:
            return no_update, str(error)
        set_props(DATASET, {"data": asked["dataset"]})
        return False, None
