"""The timeline: a row for each clip with its labels and motifs; a click on a block plays it."""

from __future__ import annotations

from urllib.parse import urlencode

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace
from webapp.features.motifs import names
from webapp.shell import results, settings
from webapp.shell.attributes import attributes
from webapp.shell.names import DATASET, MOTIF_METHOD, SELECTION, VIEW
from webapp.ui.downloads import drawing_menu
from webapp.ui.timeline import timeline

ORDERS = (("name", "By name"), ("share", "Least in motifs first"), ("chosen", "Chosen motif first"))


def layout() -> Component:
    """Controls, legend and the place where assets/motifs/timeline.mjs draws the rows."""
    return html.Div(
        className="timeline-view",
        children=[
            html.Div(
                className="timeline-bar",
                children=[
                    dmc.Select(
                        id=names.TIMELINE_ORDER,
                        data=[{"value": value, "label": label} for value, label in ORDERS],
                        value="name",
                        size="xs",
                        w=190,
                        allowDeselect=False,
                        **attributes(aria_label="Order of the clips"),
                    ),
                    dmc.SegmentedControl(
                        id=names.TIMELINE_SCALE,
                        data=[{"value": "same", "label": "Same scale"}, {"value": "fill", "label": "Fill the width"}],
                        value="same",
                        size="xs",
                        **attributes(aria_label="Scale of time"),
                    ),
                    drawing_menu("timeline", "timeline"),
                    html.Div(id=names.TIMELINE_LEGEND, className="timeline-legend"),
                ],
            ),
            html.Div(
                id=names.TIMELINE_ROWS, className="card timeline-rows", role="list", **attributes(aria_label="Clips")
            ),
            dcc.Store(id=names.TIMELINE_DATA),
            dcc.Store(id=names.TIMELINE_DRAWN),
            dcc.Store(id=names.TIMELINE_MARKED),
        ],
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callback that sends the data of a result; the browser draws it."""

    @app.callback(
        Output(names.TIMELINE_DATA, "data"),
        Input(VIEW, "data"),
        Input(names.TIMELINE_ROWS, "id"),
        Input(names.NOTES_NAMES, "data"),
        State(MOTIF_METHOD.result_key, "data"),
        State(DATASET, "data"),
    )
    def gather(view, _rows, _names, key, name):
        if not key or not name or (view or {}).get("view") != "timeline":
            return no_update
        graph = results.shown_graph(workspace, key, name, view)
        if graph is None:
            return no_update
        drawing_data = timeline(workspace.open(name), graph, results.motif_notes(workspace, name, view))
        address = f"/api/timeline.svg?{urlencode({'dataset': name, **settings.texts(results.MOTIFS, view)})}"
        return drawing_data | {"drawing": address}

    app.clientside_callback(
        ClientsideFunction("timeline", "draw"),
        Output(names.TIMELINE_DRAWN, "data"),
        Input(names.TIMELINE_DATA, "data"),
        Input(names.TIMELINE_ORDER, "value"),
        Input(names.TIMELINE_SCALE, "value"),
        State(SELECTION, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("timeline", "mark"),
        Output(names.TIMELINE_MARKED, "data"),
        Input(SELECTION, "data"),
        State(names.TIMELINE_ORDER, "value"),
    )
