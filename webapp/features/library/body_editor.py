"""The body editor: which joint of a rig is which part of the body, corrected for all clips of the rig."""

from __future__ import annotations

import json
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, ctx, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import requests
from core.errors import MotionscapeError, ParameterError
from core.mocap.anatomy import CANONICAL
from core.mocap.corrections import FORMAT, to_json
from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError
from webapp.features.library import bodies, dialogs, names
from webapp.shell.attributes import attributes

HINT = (
    "Drag a part of the body from the list onto its joint in a drawing, or from joint to joint there; or choose a "
    "part, then its joint, in its row or by a click. A correction counts for all clips of the rig."
)
_LISTED = 2000  # clips of a rig that can be chosen


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
                    dmc.Select(
                        id=names.BODY_CLIP,
                        label="Clip",
                        data=[],
                        allowDeselect=False,
                        searchable=True,
                        limit=100,
                        nothingFoundMessage="No clip of this name",
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
                                thumbLabel="Frame",
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


def _fill(dataset: Dataset, asked: dict[str, Any]) -> list[Any]:
    entries = [bodies.rig_entry(rig) for rig in bodies.edited_rigs(dataset)]
    shown = {"dataset": dataset.name, "parts": list(CANONICAL), "format": FORMAT, "rigs": entries}
    choices = [{"value": str(k), "label": entry["words"]} for k, entry in enumerate(entries)]
    return [shown | {"at": asked.get("at")}, choices, "0", None]


def _open(app: Dash, workspace: Workspace) -> None:
    filled = [
        Output(names.BODY_RIGS, "data"),
        Output(names.BODY_RIG, "data"),
        Output(names.BODY_RIG, "value"),
        Output(names.BODY_PROBLEM, "children"),
    ]
    dialogs.opens(app, workspace, names.BODY_DIALOG, names.BODY_OF, filled, _fill)

    @app.callback(
        Output(names.BODY_POSTURE, "data"),
        Output(names.BODY_FRAME, "max"),
        Output(names.BODY_CLIP, "data"),
        Output(names.BODY_CLIP, "value"),
        Input(names.BODY_RIGS, "data"),
        Input(names.BODY_RIG, "value"),
        Input(names.BODY_CLIP, "value"),
        Input(names.BODY_FRAME, "value"),
        prevent_initial_call=True,
    )
    def show_posture(shown, rig, clip, frame):
        try:
            rigs = bodies.edited_rigs(workspace.open(shown["dataset"]))
        except (WorkspaceError, TypeError):
            return (no_update,) * 4
        number = int(rig or 0) if int(rig or 0) < len(rigs) else 0
        chosen = bodies.clip_of(rigs[number], clip)
        last = chosen.n_frames - 1
        frame = min(int(frame or 0), last)
        another_rig = bool({names.BODY_RIGS, names.BODY_RIG} & set(ctx.triggered_prop_ids.values()))
        names_of_clips = [one.name for one in rigs[number].clips[:_LISTED]] if another_rig else no_update
        drawn = {"rig": number, "clip": chosen.name, "frame": frame, **bodies.posture(chosen, frame)}
        return drawn, last, names_of_clips, chosen.name


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

    dialogs.starts(
        app,
        workspace,
        names.BODY_DIALOG,
        names.BODY_SAVE,
        names.BODY_PROBLEM,
        names.BODY_OF,
        [State(names.BODY_DRAFT, "data")],
        _request,
    )


def _request(dataset: Dataset, _asked: dict[str, Any], draft: dict[str, Any] | None) -> requests.Request:
    corrections = bodies.drafted(bodies.edited_rigs(dataset), (draft or {}).get("rigs") or ())
    if not corrections.rigs:
        raise ParameterError("Nothing was changed.")
    return requests.reread_request(dataset.name, body=json.dumps(to_json(corrections), ensure_ascii=False))
