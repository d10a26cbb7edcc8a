"""Edits of the clip that is shown: chosen in a dialog and run as a job, like other changes of a dataset."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import requests
from core.editing import edits
from core.editing.mirror import partners
from core.errors import MotionscapeError, ParameterError
from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError, check_name
from webapp.features.clip import names
from webapp.jobs import changes
from webapp.shell import settings
from webapp.shell.buttons import sends
from webapp.shell.icons import icon
from webapp.shell.messages import notice
from webapp.shell.names import NOTICES, SELECTION
from webapp.shell.results import MOTIFS

ACTIONS = {  # name: texts of the menu, of the dialog and of its button
    "trim": ("Make the selected range a clip", "A new clip of the selected frames.", "Make the clip"),
    "mirror": (
        "Mirror left and right",
        "A new clip with left and right exchanged, as seen in a mirror. Labels keep their words.",
        "Mirror",
    ),
    "rate": ("Change the frame rate", "A new clip of the same motion at another rate.", "Make the clip"),
    "split": ("Split at a frame", "Two new clips: up to this frame, and from it on.", "Split"),
    "labels": ("Split at its labels", "A new clip for every stretch between the ends of labels.", "Split"),
}
HERE, NEW = "here", "new"


def menu() -> Component:
    """The menu of edits."""
    items = [
        dmc.MenuItem(ACTIONS[name][0], **sends(names.CLIP_EDIT, {"action": name}, every_time=True)) for name in ACTIONS
    ]
    return dmc.Menu(
        [
            dmc.MenuTarget(
                dmc.Button(
                    "Edit",
                    variant="default",
                    rightSection=icon("chevron", 14),
                    id=names.CLIP_EDIT_MENU,
                    className="for-editors",
                )
            ),
            dmc.MenuDropdown([dmc.MenuLabel("The clip itself stays as it is"), *items]),
        ],
        shadow="md",
        position="bottom-end",
    )


def dialogs() -> list[Component]:
    """The dialog, and the stores of its callbacks."""
    number = {"size": "sm", "mt": "md", "allowNegative": False}
    where = dmc.RadioGroup(
        dmc.Stack(
            [dmc.Radio("Add it to this dataset", value=HERE), dmc.Radio("Into a dataset of its own", value=NEW)],
            gap=6,
            mt=4,
        ),
        id=names.CLIP_EDIT_WHERE,
        label="Where",
        value=HERE,
        mt="md",
    )
    dialog = dmc.Modal(
        id=names.CLIP_EDIT_DIALOG,
        children=[
            html.Div(id=names.CLIP_EDIT_SAYS),
            dmc.NumberInput(id=names.CLIP_EDIT_FPS, label="Frames per second", min=1, max=1000, value=30, **number),
            dmc.NumberInput(
                id=names.CLIP_EDIT_FRAME, label="First frame of the second clip", min=1, allowDecimal=False, **number
            ),
            where,
            dmc.TextInput(id=names.CLIP_EDIT_NAME, label="Name of the new dataset", mt="sm"),
            html.Div(id=names.CLIP_EDIT_EFFECT, className="muted clip-edit-effect"),
            html.Div(id=names.CLIP_EDIT_PROBLEM, className="form-problem", role="alert"),
            dmc.Group(dmc.Button("Make the clip", id=names.CLIP_EDIT_DO), justify="flex-end", mt="md"),
        ],
    )
    return [dialog, dcc.Store(id=names.CLIP_EDIT), dcc.Store(id=names.CLIP_EDIT_AT_FRAME)]


def problem(dataset: Dataset, clip: str, action: str, options: Mapping[str, Any]) -> str:
    """Why an edit cannot be made, "" where it can; a cheap check."""
    try:
        recording, labels = dataset.clip(clip), [label for label in dataset.labels if label.clip == clip]
        if action == "trim":
            edits.trim(recording, labels, options["start"], options["end"])
        elif action == "mirror":
            partners(recording.skeleton)
        elif action == "rate":
            edits.check_rate(recording, options["fps"])
        else:
            cuts = [options["frame"]] if action == "split" else edits.label_cuts(recording, labels)
            edits.split(recording, labels, cuts)
    except (KeyError, TypeError):
        return "Select a range of the clip first." if action == "trim" else "This clip is no longer there."
    except MotionscapeError as error:
        return f"{error}."
    return ""


def effect(workspace: Workspace, name: str, where: str) -> str:
    """What the edit means for existing results."""
    if where == NEW:
        return f"{name} and its results stay as they are."
    if not settings.earlier(workspace, MOTIFS, name):
        return f"{name} gets the new clip; nothing else changes, and it can be undone."
    return (
        f"{name} gets the new clip. Its motif graphs belong to what it holds now: with the new clip in it they must be "
        "computed again. Undo brings dataset and graphs back as they are."
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the dialog and the job it starts; webapp/jobs/changes.py announces its end and undoes it."""
    _open(app, workspace)
    _do(app, workspace)


def _open(app: Dash, workspace: Workspace) -> None:
    app.clientside_callback(  # the frame at the cursor is part of the request
        ClientsideFunction("clip", "editAtFrame"),
        Output(names.CLIP_EDIT_AT_FRAME, "data"),
        Input(names.CLIP_EDIT, "data"),
    )

    @app.callback(
        Output(names.CLIP_EDIT_DIALOG, "opened"),
        Output(names.CLIP_EDIT_DIALOG, "title"),
        Output(names.CLIP_EDIT_SAYS, "children"),
        Output(names.CLIP_EDIT_DO, "children"),
        Output(names.CLIP_EDIT_FPS, "style"),
        Output(names.CLIP_EDIT_FRAME, "style"),
        Output(names.CLIP_EDIT_FRAME, "value"),
        Output(names.CLIP_EDIT_NAME, "value"),
        Output(names.CLIP_EDIT_PROBLEM, "children"),
        Input(names.CLIP_EDIT_AT_FRAME, "data"),
        State(names.CLIP_SHOWN, "data"),
        State(SELECTION, "data"),
        prevent_initial_call=True,
    )
    def open_dialog(request, shown, selection):
        action = (request or {}).get("action")
        if action not in ACTIONS or not shown:
            return (no_update,) * 9
        title, says, button = ACTIONS[action]
        if action == "trim":
            start, end = selected(shown, selection)
            if start is None or end is None:
                hint = notice("No range is selected", "Drag over the chart to select one.", "orange")
                set_props(NOTICES, {"sendNotifications": [hint]})
                return (no_update,) * 9
            says = f"A new clip of frames {start} to {end}, {(end - start) / shown['fps']:.2f} s."
        elif action == "rate":
            says = f"{says} It has {shown['fps']:g} frames per second now."
        hidden = {"display": "none"}
        frame = min(max(int(request.get("frame") or 0), 1), max(shown["frames"] - 1, 1))
        name = workspace.free_name(f"{shown['clip']} {'parts' if action in ('split', 'labels') else 'edited'}")
        return (
            *(True, title, says, button),
            None if action == "rate" else hidden,
            None if action == "split" else hidden,
            *(frame, name, None),
        )

    @app.callback(
        Output(names.CLIP_EDIT_EFFECT, "children"),
        Output(names.CLIP_EDIT_NAME, "style"),
        Input(names.CLIP_EDIT_WHERE, "value"),
        Input(names.CLIP_EDIT_DIALOG, "opened"),
        State(names.CLIP_SHOWN, "data"),
        prevent_initial_call=True,
    )
    def say_effect(where, opened, shown):
        if not opened or not shown:
            return no_update, no_update
        return effect(workspace, shown["dataset"], where), None if where == NEW else {"display": "none"}


def _do(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.CLIP_EDIT_PROBLEM, "children", allow_duplicate=True),
        Output(names.CLIP_EDIT_DIALOG, "opened", allow_duplicate=True),
        Input(names.CLIP_EDIT_DO, "n_clicks"),
        State(names.CLIP_EDIT_AT_FRAME, "data"),
        State(names.CLIP_SHOWN, "data"),
        State(SELECTION, "data"),
        State(names.CLIP_EDIT_FPS, "value"),
        State(names.CLIP_EDIT_FRAME, "value"),
        State(names.CLIP_EDIT_WHERE, "value"),
        State(names.CLIP_EDIT_NAME, "value"),
        prevent_initial_call=True,
    )
    def do(_clicks, request, shown, selection, fps, frame, where, name):
        action = (request or {}).get("action")
        if action not in ACTIONS or not shown:
            return no_update, False
        options = _options(action, shown, selection, fps, frame)
        try:
            dataset = workspace.open(shown["dataset"])
            if wrong := problem(dataset, shown["clip"], action, options):
                return wrong, no_update
            if where == NEW:
                options["into"] = workspace.check_free(check_name(name or ""))
            changes.start(workspace, requests.edit_request(dataset.name, shown["clip"], action, **options))
        except (WorkspaceError, ParameterError) as error:
            return str(error), no_update
        return None, False


def selected(shown: Mapping[str, Any], selection: Mapping[str, Any] | None) -> tuple[int | None, int | None]:
    """The selected frames of the clip that is shown, clipped to it; (None, None) where none are."""
    chosen = selection or {}
    if chosen.get("clip") != shown["clip"] or "end" not in chosen or "start" not in chosen:
        return None, None
    start, end = int(chosen["start"]), min(int(chosen["end"]), shown["frames"])
    return (start, end) if 0 <= start < end else (None, None)


def _options(action: str, shown, selection, fps: Any, frame: Any) -> dict[str, Any]:
    if action == "trim":
        start, end = selected(shown, selection)
        return {"start": start, "end": end}
    if action == "rate":
        return {"fps": float(fps) if isinstance(fps, int | float) else 0.0}
    return {"frame": int(frame) if isinstance(frame, int | float) else 0} if action == "split" else {}
