"""Download of a clip's curves as a table: which columns, of which joints, of which frames."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any
from urllib.parse import quote, urlencode

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, html, no_update
from dash.development.base_component import Component

from webapp.features.clip import names
from webapp.features.clip.routes import COLUMNS
from webapp.shell.icons import icon
from webapp.shell.names import SELECTION

_JOINTS = {"shown": "Those of the chart", "all": "All"}
_FRAMES = {"range": "The selected range", "all": "The whole clip"}


def button() -> Component:
    """Opens the dialog."""
    return dmc.Button("Table", id=names.CLIP_TABLE_OPEN, variant="default", leftSection=icon("download", 16))


def dialogs() -> list[Component]:
    """The dialog that chooses the columns and frames of the table."""

    def radios(name: str, choices: Mapping[str, str], value: str, label: str) -> Component:
        group = dmc.Group([dmc.Radio(text, value=key) for key, text in choices.items()], gap="md", mt=4)
        return dmc.RadioGroup(group, id=name, value=value, label=label, mt="md")

    checks = dmc.Stack([dmc.Checkbox(label=text, value=name) for name, text in COLUMNS.items()], gap=6, mt=4)
    return [
        dmc.Modal(
            id=names.CLIP_TABLE_DIALOG,
            title="Download a table",
            children=[
                dmc.CheckboxGroup(
                    checks, id=names.CLIP_TABLE_COLUMNS, label="Columns", value=["angles", "speeds", "feet"]
                ),
                radios(names.CLIP_TABLE_JOINTS, _JOINTS, "all", "Joints of angles, speeds and positions"),
                radios(names.CLIP_TABLE_FRAMES, _FRAMES, "range", "Frames"),
                html.Div(id=names.CLIP_TABLE_WHAT, className="muted clip-table-what", role="status"),
                dmc.Group(
                    html.A(
                        [icon("download", 16), "Download CSV"],
                        id=names.CLIP_TABLE_LINK,
                        href="",
                        className="clip-download",
                    ),
                    justify="flex-end",
                    mt="md",
                ),
            ],
        )
    ]


def address(
    shown: Mapping[str, Any],
    selection: Mapping[str, Any],
    columns: Sequence[str],
    joints: Sequence[str] | None,
    whole: bool,
) -> str:
    """The address of the table; ``joints``: only these (None: all); ``whole``: all frames, not the selected ones."""
    query = {"columns": ",".join(name for name in COLUMNS if name in columns)}
    if joints:
        query["joints"] = ",".join(joints)
    if not whole and selection.get("clip") == shown["clip"] and "end" in selection:
        query |= {"start": selection["start"], "end": selection["end"]}
    return f"/api/clip-table/{quote(shown['dataset'], safe='')}/{quote(shown['clip'])}?{urlencode(query, safe=',')}"


def register(app: Dash) -> None:
    """Registers the callbacks of the dialog and its link."""

    @app.callback(
        Output(names.CLIP_TABLE_DIALOG, "opened"), Input(names.CLIP_TABLE_OPEN, "n_clicks"), prevent_initial_call=True
    )
    def open_dialog(clicks):
        return True if clicks else no_update

    @app.callback(
        Output(names.CLIP_TABLE_LINK, "href"),
        Output(names.CLIP_TABLE_WHAT, "children"),
        Input(names.CLIP_SHOWN, "data"),
        Input(SELECTION, "data"),
        Input(names.CLIP_TABLE_COLUMNS, "value"),
        Input(names.CLIP_TABLE_JOINTS, "value"),
        Input(names.CLIP_TABLE_FRAMES, "value"),
        State(names.CLIP_JOINTS, "value"),
        State(names.CLIP_KIND, "value"),
        Input(names.CLIP_TABLE_DIALOG, "opened"),
    )
    def update(shown, selection, columns, which, frames, joints, kind, _opened):
        if not shown:
            return "", ""
        if not columns:
            return "", "Choose at least one kind of column."
        listed = joints if which == "shown" and kind != "file" else None
        href = address(shown, selection or {}, columns, listed, frames == "all")
        chosen = "start=" in href
        n = selection["end"] - selection["start"] if chosen else shown["frames"]
        part = f"frames {selection['start']} to {selection['end']}" if chosen else "all frames"
        return href, f"{n:,} rows, one a frame: {part}. Units stand in the header."
