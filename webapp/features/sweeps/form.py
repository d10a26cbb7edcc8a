"""The form of the Sweeps page: filled from the link, checked while one types, and read when the sweep is to run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from dash import ALL, Dash, Input, Output, State, ctx, no_update, set_props

from core import analyses
from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.motifs.axes import SweepParameters
from core.workspace import Workspace, WorkspaceError
from webapp import jobs
from webapp.features.sweeps import names, reading
from webapp.features.sweeps.reading import Form
from webapp.shell import settings
from webapp.shell.messages import notice
from webapp.shell.names import DATASET, JOB_STARTED, MOTIF_METHOD, NOTICES, VIEW, VIEW_CHANGE
from webapp.shell.results import MOTIFS
from webapp.ui.parameter_form import parameter_form, read_form, summary

_BASE = names.BASE_SETTING(ALL)


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callbacks of the form and of the button that runs the sweep."""
    _fill(app, workspace)
    _run(app, workspace)


def _fill(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        *(Output(control, "value") for control in names.FORM),
        Output(names.SWEEP_BOX["y"], "className"),
        Input(VIEW, "data"),
        Input(DATASET, "data"),
        Input(names.SWEEP_NAME["x"], "value"),
        Input(names.SWEEP_NAME["y"], "value"),
    )
    def fill(view, name, x_name, y_name):
        dataset = _dataset(workspace, name)
        form = reading.form_of(dataset, view)
        values: dict[str, Any] = {}
        if ctx.triggered_id == names.SWEEP_NAME["x"] and x_name and x_name != form.x_name:
            values = {"x_name": x_name, "x_values": reading.usual_values(dataset, x_name)}
            values |= {"y_name": y_name, "y_values": no_update, "seeds": no_update}
        elif ctx.triggered_id == names.SWEEP_NAME["y"] and y_name and y_name != form.y_name:
            values = {"y_name": y_name, "y_values": reading.usual_values(dataset, y_name)}
            values |= {"x_name": x_name, "x_values": no_update, "seeds": no_update}
        shown = form._asdict() | values
        return (*shown.values(), "hidden" if shown["y_name"] == reading.NO_AXIS else "")

    @app.callback(
        Output(names.SWEEP_BASE, "children"),
        Output(names.SWEEP_BASE_SUMMARY, "children"),
        Input(MOTIF_METHOD.settings, "data"),
        Input(names.SWEEP_NAME["x"], "value"),
        Input(names.SWEEP_NAME["y"], "value"),
    )
    def show_base(view, x_name, y_name):
        values = _base_values(x_name, y_name, view)
        shown = [parameter for parameter in settings.parameters(MOTIFS) if parameter.name in values]
        return parameter_form(shown, values, names.BASE_SETTING), summary(settings.not_default(MOTIFS, values))

    @app.callback(
        Output(names.SWEEP_PLAN, "children"),
        Output(names.SWEEP_VALUES["x"], "error"),
        Output(names.SWEEP_VALUES["y"], "error"),
        Output(names.SWEEP_NAME["y"], "error"),
        Output(names.SWEEP_SEEDS, "error"),
        *(Input(control, "value") for control in names.FORM),
        Input(names.SWEEP_SEEN, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def plan(x_name, x_values, y_name, y_values, seeds, _seen, name, view):
        form = _form(x_name, x_values, y_name, y_values, seeds)
        if form is None:
            return (no_update,) * 5
        problems = reading.problems_of(form)
        same = form.x_name == form.y_name
        y = problems.get("y")
        errors = problems.get("x"), None if same else y, y if same else None, problems.get("seeds")
        try:
            sweep = reading.sweep_of(form, view)
        except ParameterError as error:
            return "" if problems else str(error), *errors
        dataset = _dataset(workspace, name)
        n_ready = reading.table_of(workspace, dataset, sweep).n_ready if dataset else 0
        expected = "" if not name or n_ready else analyses.expected_words(workspace, reading.request_of(name, sweep))
        return _plan(sweep, n_ready, expected), *errors


def _base_values(x_name: str | None, y_name: str | None, view: Mapping[str, str] | None) -> dict[str, Any]:
    """The settings of a view that all points have, by parameter: those of the axes and the seed left out."""
    values = settings.request_of(MOTIFS, "", view).parameters
    return {name: value for name, value in values.items() if name not in (x_name, y_name, "seed")}


def _plan(sweep: SweepParameters, n_ready: int, expected: str) -> str:
    counts = [len(values) for values in sweep.values_of_axes().values()]
    total = sweep.seeds
    for n in counts:
        total *= n
    factors = " × ".join([*map(str, counts), f"{sweep.seeds} seed{'s' if sweep.seeds > 1 else ''}"])
    done = (
        ""
        if not n_ready
        else ", all of them there already"
        if n_ready == total
        else f", {n_ready} of them there already"
    )
    return f"{factors} = {total} points{done}{f'; {expected}' if expected else ''}."


def _run(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.SWEEP_BASE_FOLD, "value"),
        Output(_BASE, "error"),
        Input(names.SWEEP_RUN, "n_clicks"),
        *(State(control, "value") for control in names.FORM),
        State(_BASE, "value"),
        State(_BASE, "id"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def run(_clicks, x_name, x_values, y_name, y_values, seeds, base, ids, name, view):
        # a form that has not come yet will show the settings of the link
        form = _form(x_name, x_values, y_name, y_values, seeds) or reading.form_of(_dataset(workspace, name), view)
        base_values, problems = _base_values(form.x_name, form.y_name, view), dict[str, str]()
        if ids:
            base_values, problems = read_form(settings.parameters(MOTIFS), ids, base)
        if problems:
            return "base", [problems.get(component["name"]) for component in ids]
        try:
            if not name:
                raise WorkspaceError("Choose a dataset first; the library has none yet.")
            dataset = workspace.open(name)
            change = settings.view_of(MOTIFS, base_values)
            request = reading.request_of(name, sweep := reading.sweep_of(form, change))
            if reading.table_of(workspace, dataset, sweep).n_ready < len(sweep.points()):
                set_props(JOB_STARTED, {"data": jobs.start(workspace, request).id})
            set_props(VIEW_CHANGE, {"data": reading.view_of(form) | change})
        except (ParameterError, WorkspaceError) as error:
            set_props(NOTICES, {"sendNotifications": [notice("Cannot run the sweep", str(error), "red")]})
        return no_update, [None] * len(ids)


def _dataset(workspace: Workspace, name: str | None) -> Dataset | None:
    try:
        return workspace.open(name) if name else None
    except WorkspaceError:
        return None


def _form(x_name, x_values, y_name, y_values, seeds) -> Form | None:
    if not x_name or not y_name:
        return None  # not filled yet
    return Form(x_name, x_values or "", y_name, y_values or "", "" if seeds is None else str(seeds))
