"""Compression: size against error of the chosen motif and of the data set; compressed motions play on the Stage."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.development.base_component import Component

from core.motifs.compressed_dataset import Compression
from core.motifs.compression import METHODS, Curves, Step, motion_errors
from core.workspace import Workspace, WorkspaceError
from webapp.features.motifs import mixtures, names, on_demand
from webapp.features.motifs.figures.compression import (
    HEIGHT,
    MEASURES,
    dataset_chart,
    dataset_sentence,
    motif_chart,
    motif_sentence,
)
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.names import MOTIF_METHOD, SELECTION, STAGE_REQUEST, THEME, VIEW, VIEW_CHANGE
from webapp.ui import charts
from webapp.ui.downloads import chart_menu

WHOLE = on_demand.OnDemand(
    name="compression",
    method="compression",
    ids=names.COMPRESSION,
    symbol="stack",
    doing="Compressing",
    missing="Not computed yet",
    hint="All motifs, and what is in none, against PCA clip by clip, at equal error.",
    button="Compress all",
    refused="Cannot compress",
    frame=lambda waiting: [html.Div(html.H3("Whole dataset"), className="chart-head"), waiting],
)
_TALL = {"height": HEIGHT}
_NO_CHART: dict[str, Any] = {"data": [], "layout": {}}
HELP = (
    "Own motions: some motions of the motif are kept as they are, the others are weighted sums of these. "
    "PCA of motions: sums of principal motions. PCA of postures: each frame is a sum of principal postures. "
    "Own motions + PCA: kept motions that are themselves stored by PCA of postures. "
    "Every number that is stored counts, two bytes each."
)


def layout() -> Component:
    """Two cards: the motif, and all of the data set."""
    return html.Div(
        className="compression-view",
        children=[
            html.Div(
                className="card chart-card",
                children=[
                    html.Div(
                        [
                            html.H3("This motif", id=names.COMPRESSION_TITLE),
                            help_mark(HELP),
                            html.Div(className="spacer"),
                            dmc.SegmentedControl(
                                id=names.COMPRESSION_MEASURE,
                                data=[{"value": value, "label": label} for value, (label, _) in MEASURES.items()],
                                value="cm",
                                size="xs",
                                **attributes(aria_label="How the error is measured"),
                            ),
                            chart_menu(names.COMPRESSION_CHART, "compression of a motif"),
                        ],
                        className="chart-head",
                    ),
                    dcc.Loading(
                        _motif_part(),
                        delay_show=500,
                        color="var(--accent)",
                        overlay_style={"visibility": "visible", "opacity": 0.4},
                    ),
                ],
            ),
            html.Div(id=WHOLE.ids.place, className="card chart-card"),
            dcc.Store(id=names.COMPRESSION_OF),
            *WHOLE.stores(),
        ],
    )


def _motif_part() -> list[Component]:
    return [
        html.P(id=names.COMPRESSION_SENTENCE, className="muted compression-sentence"),
        html.Div(
            id=names.COMPRESSION_MOTIF,
            className="hidden",
            children=[
                dcc.Graph(id=names.COMPRESSION_CHART, figure=_NO_CHART, config=charts.CONFIG, style=_TALL),
                html.Div(
                    className="compression-bar",
                    children=[
                        _select(names.COMPRESSION_STEP, "Play what comes back from …", "How it is stored"),
                        _select(names.COMPRESSION_MOTION, "Motion", "Which motion"),
                    ],
                ),
            ],
        ),
    ]


def help_mark(text: str) -> Component:
    """A mark that explains what is beside it."""
    return dmc.Tooltip(
        html.Span(icon("info", 14), className="help-mark", tabIndex="0", role="note", **attributes(aria_label=text)),
        label=text,
        events={"hover": True, "focus": True, "touch": True},
    )


def _select(name: str, placeholder: str, label: str) -> Component:
    return dmc.Select(
        id=name,
        data=[],
        placeholder=placeholder,
        size="xs",
        clearable=False,
        allowDeselect=False,
        comboboxProps={"shadow": "md", "position": "top-start"},
        maxDropdownHeight=320,
        **attributes(aria_label=label),
    )


def register(app: Dash, workspace: Workspace) -> None:
    """All of the view's callbacks."""
    _chart(app, workspace)
    _play(app, workspace)
    on_demand.register(app, workspace, WHOLE, _whole)


def _chart(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.COMPRESSION_TITLE, "children"),
        Output(names.COMPRESSION_SENTENCE, "children"),
        Output(names.COMPRESSION_MOTIF, "className"),
        Output(names.COMPRESSION_CHART, "figure"),
        Output(names.COMPRESSION_STEP, "data"),
        Output(names.COMPRESSION_STEP, "value"),
        Output(names.COMPRESSION_OF, "data"),
        Input(SELECTION, "data"),
        Input(VIEW, "data"),
        Input(names.COMPRESSION_MEASURE, "value"),
        Input(THEME, "data"),
        Input(names.COMPRESSION_CHART, "id"),
        State(MOTIF_METHOD.result_key, "data"),
        State(names.COMPRESSION_OF, "data"),
    )
    def show(selection, view, measure, scheme, _id, key, before):
        if not _shown(view) or not key:
            return (no_update,) * 7
        number = (selection or {}).get("motif")
        now = [key, number, measure, scheme]
        if now == before:
            return (no_update,) * 7
        try:
            curves = None if number is None else mixtures.curves_of(workspace, key, number)
            words = _words(workspace, key, number, curves)
        except WorkspaceError as error:
            curves, words = None, str(error)
        if curves is None:
            return "This motif", words, "hidden", _NO_CHART, [], None, now
        same, steps = before and before[:2] == now[:2], _steps(curves)
        requested = (view or {}).get("step") if not before else None  # the link's value
        chosen = requested if any(requested == one["value"] for group in steps for one in group["items"]) else None
        figure = motif_chart(curves, measure, scheme)
        return f"Motif {number}", words, "", figure, steps, no_update if same else chosen, now

    @app.callback(
        Output(names.COMPRESSION_STEP, "value", allow_duplicate=True),
        Input(names.COMPRESSION_CHART, "clickData"),
        prevent_initial_call=True,
    )
    def choose(clicked):
        try:
            return ":".join(map(str, clicked["points"][0]["customdata"][:3]))
        except (KeyError, IndexError, TypeError):
            return no_update


def _words(workspace: Workspace, key: str, number: Any, curves: Curves | None) -> str:
    if number is None:
        return "Choose a motif to see how small it can be stored, and what is lost."
    if curves is None:
        return "No two motions of this motif are of one body, so there is nothing to compress together."
    total = mixtures.motif_of(workspace, key, number)[1].n_motions
    some = f" These are {curves.motions} of its {total} motions, those of one body." if curves.motions < total else ""
    return motif_sentence(curves) + some


def _steps(curves: Curves) -> list[dict[str, Any]]:
    """Choices of the menu, grouped by method."""
    return [
        {
            "group": METHODS[method],
            "items": [
                {
                    "value": f"{method}:{p.step.motions}:{p.step.components}",
                    "label": f"{p.step}: {100 * p.numbers / curves.raw:.0f} %, {p.cm:.1f} cm",
                }
                for p in points
            ],
        }
        for method, points in curves.points.items()
    ]


def _play(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.COMPRESSION_MOTION, "data"),
        Output(names.COMPRESSION_MOTION, "value"),
        Input(names.COMPRESSION_STEP, "value"),
        State(names.COMPRESSION_OF, "data"),
        prevent_initial_call=True,
    )
    def list_motions(value, shown_part):
        set_props(VIEW_CHANGE, {"data": {"step": value or ""}})
        if not value or not shown_part:
            return [], None
        method, step = read_step(value)
        motions = mixtures.matrices_of(workspace, shown_part[0], shown_part[1])
        errors = motion_errors(motions, method, step)
        worst = max(errors, key=lambda motion: errors[motion])
        data = [
            {"value": str(k), "label": f"Motion {k + 1}: {cm:.1f} cm" + (", worst" if k == worst else "")}
            for k, cm in errors.items()
        ]
        return data, str(worst)

    @app.callback(
        Output(STAGE_REQUEST, "data", allow_duplicate=True),
        Input(names.COMPRESSION_MOTION, "value"),
        Input(names.COMPRESSION_STEP, "value"),
        State(names.COMPRESSION_MOTION, "data"),
        State(names.COMPRESSION_OF, "data"),
        State(THEME, "data"),
        prevent_initial_call=True,
    )
    def play(motion, value, known, shown_part, scheme):
        if not value or not shown_part or motion is None or motion not in {str(one["value"]) for one in known or []}:
            return no_update
        return rebuilt_request(shown_part[0], shown_part[1], *read_step(value), int(motion), scheme)


def read_step(value: str) -> tuple[str, Step]:
    """Method and step of a choice in the menu."""
    method, motions, components = value.split(":")
    return method, Step(int(motions), int(components))


def rebuilt_request(key: str, number: Any, method: str, step: Step, motion: int, scheme: str | None) -> dict[str, Any]:
    """What the Stage plays: a motion after compression, over the original."""
    name = mixtures.rebuilt_name(key, number, method, step)
    grey = "#7c8797" if scheme == "dark" else "#9aa5b4"
    items = [
        {"clip": f"{motion + 1} rebuilt", "label": "Rebuilt"},
        {"clip": f"{motion + 1} original", "label": "Original", "colour": grey},
    ]
    title = f"Motif {number}, motion {motion + 1}: {METHODS[method]}, {step}"
    return {"dataset": name, "items": items, "layout": "overlay", "sync": "start", "title": title}


def _whole(whole: Compression, name: str, view: Mapping[str, Any] | None, scheme: str | None) -> list[Component]:
    """The chart over all of the data set."""
    head = [html.H3("Whole dataset"), html.Div(className="spacer"), chart_menu(names.COMPRESSION_ALL, "compression")]
    return [
        html.Div(head, className="chart-head"),
        html.P(dataset_sentence(whole), className="muted compression-sentence"),
        dcc.Graph(id=names.COMPRESSION_ALL, figure=dataset_chart(whole, scheme), config=charts.CONFIG, style=_TALL),
    ]


def _shown(view: Mapping[str, str] | None) -> bool:
    return (view or {}).get("view") == WHOLE.name
