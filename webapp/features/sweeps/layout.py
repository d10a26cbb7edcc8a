"""What the Sweeps page consists of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from core.motifs.axes import sweepable
from core.motifs.suggestion import CLEAR, Suggestion
from core.workspace import Job
from webapp.features.sweeps import names
from webapp.features.sweeps.figures.measures import MEASURES
from webapp.features.sweeps.reading import MOST_SEEDS, NO_AXIS
from webapp.jobs.running import running
from webapp.shell.attributes import attributes
from webapp.shell.buttons import copies
from webapp.shell.icons import icon
from webapp.shell.messages import empty_state
from webapp.ui.charts import CONFIG, empty
from webapp.ui.downloads import chart_menu, table_download
from webapp.ui.page_head import page_head

PAIR_NAMES = {"error-coverage": "Error and coverage", "motifs": "Motifs and motions", "labels": "Agreement with labels"}
HINT = (
    "Press Run sweep: motifs are found for all these settings, which share most of the work, and the charts show how "
    "the results depend on them."
)


def page() -> Component:
    """The page before any data is loaded."""
    return html.Div(
        className="sweeps",
        children=[
            page_head(
                "Sweeps",
                html.Div(id=names.SWEEP_MENU, className="head-menus"),
                dmc.Button("Run sweep", id=names.SWEEP_RUN, leftSection=icon("sweep", 16)),
            ),
            _form(),
            html.Div(id=names.SWEEP_STATUS),
            dcc.Store(id=names.SWEEP_STATUS_OF),  # what it speaks of: drawn anew only when that changes
            dcc.Store(id=names.SWEEP_SEEN),  # which sweep is shown and how much of it is there
            html.Div(id=names.SWEEP_RESULT, className="hidden", children=_result()),
        ],
    )


def _form() -> Component:
    settings = [{"value": p.name, "label": p.label} for p in sweepable()]
    return html.Div(
        className="card sweep-form",
        children=[
            _axis("x", "Try different", settings),
            _axis("y", "and", [{"value": NO_AXIS, "label": "Nothing else"}, *settings]),
            html.Div(
                className="sweep-last",
                children=[
                    dmc.NumberInput(
                        id=names.SWEEP_SEEDS,
                        label="Seeds",
                        description="Repeats of each setting",
                        min=1,
                        max=MOST_SEEDS,
                        step=1,
                        allowDecimal=False,
                        clampBehavior="none",
                        w=150,
                    ),
                    html.Div(id=names.SWEEP_PLAN, className="sweep-plan muted number", role="status"),
                ],
            ),
            dmc.Accordion(
                id=names.SWEEP_BASE_FOLD,
                variant="default",
                className="form-advanced",
                children=dmc.AccordionItem(
                    value="base",
                    children=[
                        dmc.AccordionControl(
                            [
                                html.Span("All other settings", className="settings-title"),
                                html.Span(id=names.SWEEP_BASE_SUMMARY, className="muted"),
                            ]
                        ),
                        dmc.AccordionPanel(html.Div(id=names.SWEEP_BASE)),
                    ],
                ),
            ),
        ],
    )


def _axis(side: str, label: str, settings: Sequence[Mapping[str, str]]) -> Component:
    return html.Div(
        className="sweep-axis",
        children=[
            dmc.Select(
                id=names.SWEEP_NAME[side], label=label, data=list(settings), allowDeselect=False, searchable=True
            ),
            html.Div(
                dmc.TextInput(
                    id=names.SWEEP_VALUES[side], label="Values, separated by commas", debounce=500, autoComplete="off"
                ),
                id=names.SWEEP_BOX[side],
            ),
        ],
    )


def _result() -> list[Component]:
    return [
        html.Div(id=names.SWEEP_SUGGESTION, className="section"),
        html.Div([_chart("x"), _chart("y"), _heat()], className="sweep-charts section"),
        html.Div(
            [html.H2("All points"), html.Div(className="spacer"), table_download(names.SWEEP_TABLE, "sweep")],
            className="section-head section",
        ),
        html.Div(id=names.SWEEP_TABLE_PLACE),
    ]


def _chart(side: str) -> Component:
    """A chart along one axis, and what it shows."""
    return html.Div(
        id=names.SWEEP_CARD[side],
        className="card chart-card",
        children=[
            html.Div(
                className="chart-head",
                children=[
                    dmc.Select(
                        id=names.SWEEP_PAIR[side],
                        size="xs",
                        w=190,
                        allowDeselect=False,
                        **attributes(aria_label="Figures shown"),
                    ),
                    html.Div(
                        [
                            html.Span(id=names.SWEEP_AT_NAME[side], className="muted"),
                            dmc.Select(
                                id=names.SWEEP_AT[side],
                                size="xs",
                                w=92,
                                allowDeselect=False,
                                **attributes(aria_label="Value of the other axis"),
                            ),
                        ],
                        id=names.SWEEP_AT_BOX[side],
                        className="sweep-at",
                    ),
                    html.Div(className="spacer"),
                    chart_menu(names.SWEEP_LINES[side], f"sweep {side}"),
                ],
            ),
            _graph(names.SWEEP_LINES[side], 330),
        ],
    )


def _heat() -> Component:
    measures = [{"value": name, "label": measure.name} for name, measure in MEASURES.items()]
    return html.Div(
        id=names.SWEEP_CARD["heat"],
        className="card chart-card sweep-heat-card",
        children=[
            html.Div(
                className="chart-head",
                children=[
                    dmc.Select(
                        id=names.SWEEP_MEASURE,
                        data=measures,
                        value="explained",
                        size="xs",
                        w=190,
                        allowDeselect=False,
                        **attributes(aria_label="Figure of the map"),
                    ),
                    html.Span(id=names.SWEEP_MEASURE_HELP, className="muted sweep-help"),
                    html.Div(className="spacer"),
                    chart_menu(names.SWEEP_HEAT, "sweep map"),
                ],
            ),
            _graph(names.SWEEP_HEAT, 360),
        ],
    )


def _graph(name: str, height: int) -> Component:
    return dcc.Graph(id=name, figure=empty(), config=CONFIG, className="sweep-chart", style={"height": f"{height}px"})


def status(dataset: str | None, job: Job | None, ready: int, total: int, problem: str = "") -> Component | None:
    """The message above the charts, or in their place: progress, how the sweep ended, or what to do."""
    if not dataset:
        link = dcc.Link("Go to the library", href="/library", className="text-link")
        return _card(empty_state("person", "No dataset yet", "Add recordings, or make the demo, in the library.", link))
    if problem:
        return _card(empty_state("warning", "This sweep cannot be run", problem))
    if job is not None and job.alive:
        if ready:  # above the charts that are there already
            return running(job, "Sweeping", "sweep", "card sweep-running section")
        return _card(running(job, "Sweeping", "sweep"))
    if ready == total:
        return None
    state = job.state if job is not None else ""
    symbol, words = {"failed": ("error", "The sweep failed"), "cancelled": ("sweep", "The sweep was cancelled")}.get(
        state, ("sweep", "No sweep yet")
    )
    if not ready:
        return _card(empty_state(symbol, words, job.error if job is not None and state == "failed" else HINT))
    message = {"failed": f"{words}: {job.error if job else ''}", "cancelled": f"{words}."}.get(state, "")
    return _note(f"{message} {ready} of {total} points are there; Run sweep computes the others.")


def _note(words: str) -> Component:
    return html.Div([icon("info", 16), html.Span(words)], className="card sweep-note section", role="status")


def _card(child: Component) -> Component:
    return html.Div(child, className="card section")


def suggestion(suggested: Suggestion, link: str, complete: bool) -> Component:
    """The sentence, and a way to the result it speaks of."""
    clear = suggested.verdict == CLEAR
    title = "Suggestion" if clear else "No clear suggestion"
    parts: list[Component | None] = [
        html.Div(icon("star" if clear else "info", 20), className="sweep-star" if clear else "sweep-star unsure"),
        html.Div([html.B(title if complete else f"{title} so far"), html.P(suggested.why)], className="sweep-why"),
        html.A("Open it", href=link, className="point-link soft-button") if link else None,
    ]
    return html.Div([part for part in parts if part is not None], className="card sweep-suggestion")


def menu(recipes: Mapping[str, str]) -> list[Component]:
    """Ways to have the same sweep elsewhere."""
    items = [dmc.MenuItem(label, **copies(text)) for label, text in recipes.items()]
    button = dmc.Button("Copy", variant="default", rightSection=icon("chevron", 14))
    return [dmc.Menu(shadow="md", position="bottom-end", children=[dmc.MenuTarget(button), dmc.MenuDropdown(items)])]
