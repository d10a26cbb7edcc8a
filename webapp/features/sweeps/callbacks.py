"""The Sweeps page's callbacks: they follow the job and show the results."""

from __future__ import annotations

from typing import Any, NamedTuple

from dash import Dash, Input, Output, State, no_update
from dash.dependencies import ClientsideFunction

from core import analyses
from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.motifs.axes import SweepParameters
from core.motifs.suggestion import suggest
from core.motifs.sweep_table import SweepTable
from core.parameters import write_value
from core.workspace import Workspace, WorkspaceError
from webapp.features.sweeps import form, layout, names, reading
from webapp.features.sweeps.figures import charts
from webapp.features.sweeps.figures import rows as sweep_rows
from webapp.features.sweeps.figures.drawing import fixed
from webapp.features.sweeps.figures.measures import MEASURES, PAIRS, pairs_of
from webapp.jobs.names import JOBS_FINISHED, JOBS_SEEN
from webapp.shell.names import DATASET, THEME, VIEW
from webapp.ui import tables


class Shown(NamedTuple):
    """The sweep of a view and the results that exist."""

    dataset: Dataset
    sweep: SweepParameters
    table: SweepTable

    @property
    def key(self) -> str:
        """Changes with the sweep and with every point that gets ready."""
        return f"{self.dataset.fingerprint} {self.sweep} {self.table.n_ready}"

    def link(self, point: Any) -> str:
        """Address of the result of a point, on the Motifs page."""
        return reading.link_to_point(self.dataset.name, point)


def register(app: Dash, workspace: Workspace) -> None:
    """All of the page's callbacks."""
    form.register(app, workspace)
    _look(app, workspace)
    _draw(app, workspace)
    for graph in (names.SWEEP_LINES["x"], names.SWEEP_LINES["y"], names.SWEEP_HEAT):
        app.clientside_callback(ClientsideFunction("sweeps", "open"), Input(graph, "clickData"))


def shown_sweep(workspace: Workspace, name: str | None, view: Any) -> Shown | None:
    """What the view shows; None without a dataset. Raises ParameterError, WorkspaceError."""
    if not name:
        return None
    dataset = workspace.open(name)
    sweep = reading.sweep_of(reading.form_of(dataset, view), view)
    return Shown(dataset, sweep, reading.table_of(workspace, dataset, sweep))


def _look(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.SWEEP_STATUS, "children"),
        Output(names.SWEEP_STATUS_OF, "data"),
        Output(names.SWEEP_SEEN, "data"),
        Output(names.SWEEP_RESULT, "className"),
        Input(DATASET, "data"),
        Input(VIEW, "data"),
        Input(JOBS_SEEN, "data"),
        Input(JOBS_FINISHED, "data"),
        Input(names.SWEEP_RESULT, "id"),
        State(names.SWEEP_STATUS_OF, "data"),
        State(names.SWEEP_SEEN, "data"),
    )
    def look(name, view, _seen, _finished, _page, shown_status, seen):
        problem, shown, job = "", None, None
        try:
            shown = shown_sweep(workspace, name, view)
            if shown is not None:
                job = workspace.jobs.latest(analyses.key(workspace, reading.request_of(name, shown.sweep)))
        except (ParameterError, WorkspaceError) as error:
            problem = str(error)
        ready, total = (shown.table.n_ready, len(shown.table.figures)) if shown else (0, 0)
        alive = job is not None and job.alive
        now = [name, problem, job.id if job else 0, job.state if job else "", ready > 0, alive or ready]
        key = shown.key if shown else ""
        return (
            no_update if now == shown_status else layout.status(name, job, ready, total, problem) or [],
            no_update if now == shown_status else now,
            no_update if key == seen else key,
            "" if ready else "hidden",
        )


def _draw(app: Dash, workspace: Workspace) -> None:
    where = (State(DATASET, "data"), State(VIEW, "data"))

    @app.callback(
        *(Output(names.SWEEP_AT[side], prop) for side in "xy" for prop in ("data", "value")),
        *(Output(names.SWEEP_AT_NAME[side], "children") for side in "xy"),
        *(Output(names.SWEEP_AT_BOX[side], "className") for side in "xy"),
        *(Output(names.SWEEP_PAIR[side], prop) for side in "xy" for prop in ("data", "value")),
        Output(names.SWEEP_CARD["heat"], "className"),
        Output(names.SWEEP_MENU, "children"),
        Input(names.SWEEP_SEEN, "data"),
        *(State(names.SWEEP_AT[side], "value") for side in "xy"),
        *(State(names.SWEEP_PAIR[side], "value") for side in "xy"),
        *where,
    )
    def choices(_seen, at_x, at_y, pair_x, pair_y, *view):
        shown = _shown(workspace, *view)
        if shown is None:
            return (no_update,) * 13 + ([],)
        axes = list(shown.table.axes)
        others = {"x": axes[1:2], "y": axes[:1] if len(axes) > 1 else []}
        data, values = {}, {}
        for side, at_value in (("x", at_x), ("y", at_y)):
            words = [write_value(v) for name in others[side] for v in shown.table.axes[name]]
            usual = _usual(shown.table, axes[0] if side == "x" else axes[-1])
            data[side] = words
            values[side] = at_value if at_value in words else usual
        at_texts = {side: f"at {others[side][0].replace('_', ' ')}" if others[side] else "" for side in "xy"}
        pairs = [{"value": pair, "label": layout.PAIR_NAMES[pair]} for pair in pairs_of(shown.table)]
        known = {pair["value"] for pair in pairs}
        return (
            data["x"], values["x"], data["y"], values["y"], at_texts["x"], at_texts["y"],
            *("sweep-at" if others[side] else "hidden" for side in "xy"),
            pairs, pair_x if pair_x in known else "error-coverage", pairs, pair_y if pair_y in known else "motifs",
            "card chart-card sweep-heat-card" if len(axes) > 1 else "hidden",
            layout.menu(reading.recipes_of(workspace.path, shown.dataset.name, shown.sweep)),
        )  # fmt: skip

    for side in "xy":
        _draw_lines(app, workspace, side, where)

    @app.callback(
        Output(names.SWEEP_HEAT, "figure"),
        Output(names.SWEEP_MEASURE, "data"),
        Output(names.SWEEP_MEASURE_HELP, "children"),
        Input(names.SWEEP_SEEN, "data"),
        Input(names.SWEEP_MEASURE, "value"),
        Input(THEME, "data"),
        *where,
    )
    def draw_heat(_seen, measure, scheme, *view):
        shown = _shown(workspace, *view)
        if shown is None or len(shown.table.axes) < 2:
            return (no_update,) * 3
        offered = [{"value": m, "label": words.name} for m, words in MEASURES.items() if shown.table.has(m)]
        measure = measure if any(entry["value"] == measure for entry in offered) else "explained"
        addresses = charts.link_array(shown.table, shown.sweep.points(), shown.link)
        figure = charts.heat(shown.table, addresses, measure, suggest(shown.table), scheme)
        return figure, offered, MEASURES[measure].help

    @app.callback(
        Output(names.SWEEP_SUGGESTION, "children"),
        Output(names.SWEEP_TABLE_PLACE, "children"),
        Input(names.SWEEP_SEEN, "data"),
        *where,
    )
    def tell(_seen, *view):
        shown = _shown(workspace, *view)
        if shown is None:
            return [], []
        table, points = shown.table, shown.sweep.points()
        addresses, suggested = charts.link_array(table, points, shown.link), suggest(table)
        link = (
            addresses[(*suggested.index, charts.typical_seed(table.of("explained")[suggested.index]))]
            if suggested.at
            else ""
        )
        rows = sweep_rows.rows(table, points, addresses)
        grid = tables.grid(
            names.SWEEP_TABLE, sweep_rows.columns(table), rows, "All points", row_height=34, headerHeight=48
        )
        return layout.suggestion(suggested, link, table.n_ready == len(points)), grid


def _draw_lines(app: Dash, workspace: Workspace, side: str, where: tuple) -> None:
    @app.callback(
        Output(names.SWEEP_LINES[side], "figure"),
        Input(names.SWEEP_SEEN, "data"),
        Input(names.SWEEP_AT[side], "value"),
        Input(names.SWEEP_PAIR[side], "value"),
        Input(THEME, "data"),
        *where,
    )
    def draw(_seen, at, pair, scheme, *view):
        shown = _shown(workspace, *view)
        if shown is None or pair not in PAIRS:
            return no_update
        axes = list(shown.table.axes)
        name = axes[0] if side == "x" else axes[-1]
        others = {other: {write_value(v): v for v in shown.table.axes[other]} for other in axes if other != name}
        if any(at not in values for values in others.values()):
            return no_update  # the choices of the last sweep: those of this one are on the way
        addresses = charts.link_array(shown.table, shown.sweep.points(), shown.link)
        at_values = {other: values[at] for other, values in others.items()}
        return charts.lines(shown.table, addresses, name, at_values, PAIRS[pair], suggest(shown.table), scheme)


def _usual(table: SweepTable, name: str) -> str | None:
    """Where the other axis stands in a chart along ``name`` until someone chooses."""
    at = fixed(table, name)
    return next((write_value(value) for value in at.values()), None)


def _shown(workspace: Workspace, name: str | None, view: Any) -> Shown | None:
    """The sweep that is shown; None where no point of it has been computed."""
    try:
        shown = shown_sweep(workspace, name, view)
    except (ParameterError, WorkspaceError):
        return None
    return shown if shown is not None and shown.table.n_ready else None
