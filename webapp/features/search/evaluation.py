"""Evaluation: how well the engines' rankings of clips agree with the labels of a data set (PCR section 5.2)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from urllib.parse import urlencode

import dash_mantine_components as dmc
from dash import ClientsideFunction, Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.development.base_component import Component

from core.caching import RecentCache
from core.errors import AnalysisError
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.rankings import CHANCE, KNOWN, Evaluation, evaluate
from core.workspace import Workspace, WorkspaceError
from webapp.features.search import names
from webapp.features.search.engines import ENGINES
from webapp.features.search.figures import ranking as figures
from webapp.shell import settings
from webapp.shell.attributes import attributes
from webapp.shell.errors import sentence
from webapp.shell.icons import icon
from webapp.shell.messages import empty_state
from webapp.shell.names import DATASET, REVISION, THEME, VIEW, VIEW_CHANGE
from webapp.ui import method_page
from webapp.ui.charts import CONFIG, tall
from webapp.ui.downloads import chart_menu
from webapp.ui.method_page import MethodPage, run_button, settings_fold, status_place

PAGE = "ranking"
METHOD = MethodPage(
    page=PAGE,
    title="Evaluation",
    action="Evaluate",
    doing="Comparing the engines",
    symbol="pulse",
    hint="It tells how often each engine's hits have the query's own label.",
    without=("engines",),
)
_BASELINES = {
    "weighted-pca": "Weighted PCA + DTW",
    "pose-clusters": "Pose clusters",
    "position-dtw": "Position DTW",
    "match-webs": "Match webs",
    CHANCE: "Chance",
}
NAMES = {name: ENGINES.get(name) or _BASELINES.get(name, name) for name in KNOWN}
HINT = (
    "Every clip is searched for with every engine; a hit counts where it has the query's label. The baselines compare "
    "all pairs of clips, which takes long on large datasets."
)


def layout() -> Component:
    """The panel of the evaluation."""
    usual = next(p.default for p in settings.parameters(PAGE) if p.name == "engines")
    chips = [dmc.Chip(NAMES[name], value=name, size="xs", variant="outline") for name in KNOWN]
    return html.Div(
        [
            html.P(HINT, className="muted study-hint"),
            html.Div(
                [
                    html.Div(
                        [
                            html.Span("Compare", className="search-label"),
                            dmc.ChipGroup(chips, id=names.RANKING_ENGINES, multiple=True, value=[]),
                        ],
                        className="study-line ranking-engines",
                        role="group",
                        **attributes(aria_label="What is compared"),
                    ),
                    run_button(METHOD),
                ],
                className="card study-setup ranking-setup",
            ),
            html.Div(settings_fold(METHOD), className="section"),
            status_place(METHOD),
            html.Div(id=names.RANKING_RESULT),
            dcc.Store(
                id=names.RANKING_ENGINES_OF, data={"key": f"{PAGE}-engines", "names": list(KNOWN), "usual": usual}
            ),
        ],
        className="study",
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the panel's callbacks."""
    method_page.register(app, workspace, METHOD)
    _choose(app)
    _show(app, workspace)


def _choose(app: Dash) -> None:
    app.clientside_callback(
        ClientsideFunction("settings", "list"),
        Output(names.RANKING_ENGINES, "value"),
        Input(names.RANKING.settings, "data"),
        State(names.RANKING_ENGINES_OF, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("settings", "listed"),
        Input(names.RANKING_ENGINES, "value"),
        State(VIEW, "data"),
        State(names.RANKING_ENGINES_OF, "data"),
        prevent_initial_call=True,
    )

    @app.callback(
        Input(names.RANKING_REGIME, "value"),
        Input(names.RANKING_CONFUSED, "value"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def choose_measure(regime, engine, view):
        text = f"{regime}:{engine}"
        if regime and engine and text != (view or {}).get("measure"):
            set_props(VIEW_CHANGE, {"data": {"measure": text}})


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.RANKING_RESULT, "children"),
        Input(names.RANKING.result_key, "data"),
        Input(VIEW, "data"),
        Input(THEME, "data"),
        Input(REVISION, "data"),
        State(DATASET, "data"),
    )
    def show(key, view, scheme, _revision, name):
        if (view or {}).get("look") != "evaluate":
            return no_update
        if not key or not name:
            return []
        try:
            dataset = workspace.open(name)
            measured = evaluation_of(workspace, dataset, key, view)
        except WorkspaceError:
            return []
        except AnalysisError as error:
            words = (
                f"{sentence(error)} Add labels in the Library: a CSV file with clip, start_frame, end_frame and action."
            )
            return [html.Div(empty_state("warning", "No labels to compare with", words), className="card section")]
        return result(dataset, measured, view, scheme) if measured else []


def evaluation_of(
    workspace: Workspace, dataset: Dataset, key: str, view: Mapping[str, str] | None
) -> Evaluation | None:
    """The scores of the rankings under this key, kept ready. Raises ValueError where there is no label."""
    place = workspace.path, key, dataset.labels
    if (evaluation := _evaluations.get(place)) is not None:
        return evaluation
    rankings = settings.result_of(workspace, PAGE, dataset.name, view)
    if rankings is None:
        return None
    return _evaluations.get_or_compute(place, lambda: evaluate(rankings, dataset))


def result(
    dataset: Dataset, measured: Evaluation, view: Mapping[str, str] | None, scheme: str | None
) -> list[Component]:
    """Table, curves and confusion of what a view shows."""
    engines = list(measured.engines)
    regimes = [r for r in figures.REGIMES if any(r in by for by in measured.engines.values())]
    regime, _, engine = (view or {}).get("measure", "").partition(":")
    regime = regime if regime in regimes else regimes[-1]
    engine = engine if engine in engines else engines[0]
    query = urlencode({"dataset": dataset.name, **{k: v for k, v in (view or {}).items() if k.startswith("ranking-")}})
    scores = measured.engines[engine][regime]
    count = f"{measured.queries:,} clips searched for, {scores.queries:,} of them with something to find"
    head = html.Div(
        [
            dmc.SegmentedControl(
                id=names.RANKING_REGIME,
                data=[{"value": value, "label": figures.REGIMES[value]} for value in regimes],
                value=regime,
                size="xs",
                **attributes(aria_label="What may be found"),
            ),
            html.Div(className="spacer"),
            html.A(
                [icon("download", 14), "All of it (JSON)"],
                href=f"/api/search/ranking.json?{query}",
                className="search-button",
            ),
        ],
        className="section-head section",
    )
    confused = dmc.Select(
        id=names.RANKING_CONFUSED,
        data=[{"value": name, "label": NAMES.get(name, name)} for name in engines],
        value=engine,
        size="xs",
        w=190,
        allowDeselect=False,
        **attributes(aria_label="Engine whose confusions are shown"),
    )
    return [
        head,
        html.Div(
            [
                figures.measures_table(measured.engines, regime, NAMES),
                html.P([count, ". ", figures.explained(measured.engines, regime)], className="muted ranking-words"),
            ],
            className="card study-figures",
        ),
        _chart(
            names.RANKING_CURVES,
            "Precision and recall",
            figures.curves_chart(measured.engines, regime, NAMES, scheme),
            [],
        ),
        _chart(names.RANKING_CONFUSION, "Confusion of labels", figures.confusion_chart(scores, scheme), [confused]),
    ]


def _chart(name: str, title: str, figure, controls: list[Component]) -> Component:
    bar = [html.H2(title), *controls, html.Div(className="spacer"), chart_menu(name, name.removeprefix("ranking-"))]
    graph = dcc.Graph(id=name, figure=figure, config=CONFIG, style=tall(figure))
    return html.Div([html.Div(bar, className="section-head"), graph], className="card study-figures section")


_evaluations: RecentCache[tuple[Path, str, tuple[Label, ...]], Evaluation] = RecentCache(8)
