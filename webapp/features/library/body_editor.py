"""The body editor: which joint of a rig is which part of the body, corrected for all clips of the rig."""

from __future__ import annotations

import json

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import requests
from core.errors import MotionscapeError, ParameterError
from core.mocap.anatomy import CANONICAL
from core.mocap.corrections import FORMAT, to_json
from core.workspace import Workspace, WorkspaceError
from webapp.features.library import bodies, names
from webapp.jobs import changes
from webapp.shell.attributes import attributes
from webapp.shell.messages import notice
from webapp.shell.names import DATASET, NOTICES

HINT = (
    "Choose a part of the body in the list, then the joint that it is: in its row, or by a click in the drawing. "
    "A correction counts for all clips of the rig."
)


def dialog() -> Component:
    """The dialog; assets/library/body.mjs draws what is in it."""
    return dmc.Modal(
        id=names.BODY_DIALOG,
        title="Which joint is which",
        size="min(1100px, 96vw)",
        keepMounted=True,
        closeOnClickOutside=False,
        children=[
            html.Div(HINT, className="muted reading-hint"),
            html.Div(
                className="reading-controls",
                children=[
                    dmc.Select(
                        id=names.BODY_RIG,
                        label="Rig",
                        data=[],
                        allowDeselect=False,
                        comboboxProps={"shadow": "md"},
                    ),
                    html.Div(
                        [
                            html.Label("Frame", id=names.BODY_FRAME_LABEL, className="choice-label"),
                            dmc.Slider(
                                id=names.BODY_FRAME,
                                min=bodies.REST,
                                max=1,
                                value=0,
                                label=None,
                                mb=10,
                                **attributes(aria_labelledby=names.BODY_FRAME_LABEL),
                            ),
                        ]
                    ),
                ],
            ),
            html.Div(id=names.BODY_EDITOR, className="body-editor"),
            html.Div(id=names.BODY_PROBLEM, className="form-problem", role="alert"),
            dmc.Group(
                [
                    dmc.Button("Import", variant="default", **attributes(data_body="import")),
                    dmc.Button("Export", variant="default", **attributes(data_body="export")),
                    dmc.Button("Step back", variant="subtle", color="gray", **attributes(data_body="back")),
                    dmc.Button("Start over", variant="subtle", color="gray", **attributes(data_body="reset")),
                    dmc.Button("Save", id=names.BODY_SAVE, className="for-editors"),
                ],
                justify="flex-end",
                mt="md",
            ),
            dcc.Store(id=names.BODY_RIGS),
            dcc.Store(id=names.BODY_POSTURE),
            dcc.Store(id=names.BODY_DRAFT),
            dcc.Store(id=names.BODY_FILE),
            dcc.Store(id=names.BODY_FILLED),
        ],
    )


def register(app: Dash, workspace: Workspace) -> None:
    """The callbacks of the editor."""
    _open(app, workspace)
    _save(app, workspace)
    app.clientside_callback(
        ClientsideFunction("body", "show"), Input(names.BODY_RIGS, "data"), Input(names.BODY_POSTURE, "data")
    )
    app.clientside_callback(
        ClientsideFunction("body", "fill"), Input(names.BODY_FILLED, "data"), prevent_initial_call=True
    )


def _open(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.BODY_DIALOG, "opened"),
        Output(names.BODY_RIGS, "data"),
        Output(names.BODY_RIG, "data"),
        Output(names.BODY_RIG, "value"),
        Output(names.BODY_PROBLEM, "children"),
        Input(names.BODY_OF, "data"),
        prevent_initial_call=True,
    )
    def open_editor(of):
        if not of:
            return (no_update,) * 5
        try:
            rigs = bodies.edited_rigs(workspace.open(of["dataset"]))
        except WorkspaceError as error:
            set_props(NOTICES, {"sendNotifications": [notice("That did not work", str(error), "red")]})
            return (no_update,) * 5
        entries = [bodies.rig_entry(rig) for rig in rigs]
        shown = {"dataset": of["dataset"], "parts": list(CANONICAL), "format": FORMAT, "rigs": entries}
        choices = [{"value": str(k), "label": entry["words"]} for k, entry in enumerate(entries)]
        return True, shown | {"at": of.get("at")}, choices, "0", None

    @app.callback(
        Output(names.BODY_POSTURE, "data"),
        Output(names.BODY_FRAME, "max"),
        Input(names.BODY_RIGS, "data"),
        Input(names.BODY_RIG, "value"),
        Input(names.BODY_FRAME, "value"),
        prevent_initial_call=True,
    )
    def show_posture(shown, rig, frame):
        try:
            rigs = bodies.edited_rigs(workspace.open(shown["dataset"]))
        except (WorkspaceError, TypeError):
            return no_update, no_update
        number = int(rig or 0) if int(rig or 0) < len(rigs) else 0
        last = rigs[number].clips[0].n_frames - 1
        frame = min(int(frame or 0), last)
        return {"rig": number, "frame": frame, **bodies.posture(rigs[number], frame)}, last


def _save(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.BODY_FILLED, "data"),
        Output(names.BODY_PROBLEM, "children", allow_duplicate=True),
        Input(names.BODY_FILE, "data"),
        State(names.BODY_OF, "data"),
        prevent_initial_call=True,
    )
    def take_file(file, of):
        if not file or not of:
            return no_update, no_update
        try:
            rigs = bodies.edited_rigs(workspace.open(of["dataset"]))
            return {"rigs": bodies.fitting(rigs, file["text"]), "at": file.get("at")}, None
        except MotionscapeError as error:
            return no_update, str(error)

    @app.callback(
        Output(names.BODY_DIALOG, "opened", allow_duplicate=True),
        Output(names.BODY_PROBLEM, "children", allow_duplicate=True),
        Input(names.BODY_SAVE, "n_clicks"),
        State(names.BODY_DRAFT, "data"),
        State(names.BODY_OF, "data"),
        prevent_initial_call=True,
    )
    def save_bodies(_clicks, draft, of):
        if not of:
            return no_update, no_update
        try:
            rigs = bodies.edited_rigs(workspace.open(of["dataset"]))
            corrections = bodies.drafted(rigs, (draft or {}).get("rigs") or ())
            if not corrections.rigs:
                raise ParameterError("Nothing was changed.")
            text = json.dumps(to_json(corrections), ensure_ascii=False)
            changes.start(workspace, requests.reread_request(of["dataset"], body=text))
        except MotionscapeError as error:
            return no_update, str(error)
        set_props(DATASET, {"data": of["dataset"]})
        return False, None
