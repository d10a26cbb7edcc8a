"""How stable each motif is: measured on demand, then shown as rings in the graph and as a column of the table."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any
from urllib.parse import urlencode

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, ctx, dcc, html, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import analyses
from core.errors import ParameterError
from core.workspace import Job, Workspace, WorkspaceError
from webapp import jobs
from webapp.features.motifs import names, stability_request
from webapp.jobs.job_bar import stage_words
from webapp.jobs.names import JOB_ACTION, JOBS_SEEN
from webapp.shell import recipes, results, settings, theme
from webapp.shell.buttons import copies, sends
from webapp.shell.icons import icon
from webapp.shell.messages import notice
from webapp.shell.names import DATASET, JOB_STARTED, MOTIF_METHOD, NOTICES, SELECTION, VIEW, VIEW_CHANGE

if TYPE_CHECKING:
    from core.motifs.stability import Stability

HELP = (
    "Finds the motifs again and again: with noise on all joints, from other random seeds, and with kappa, rho and "
    "gamma a step up and down. A motif is stable when each time a motif with nearly the same motion turns up."
)
LOW, HIGH = theme.STABILITY
DEFAULTS = {"repetitions": 2, "noise_degrees": 2.0}


def control() -> Component:
    """The button above the graph, and what opens below it."""
    return dmc.Popover(
        position="bottom-end",
        shadow="md",
        width=320,
        keepMounted=True,
        children=[
            dmc.PopoverTarget(
                dmc.Button(
                    "Stability",
                    id=names.STABILITY_BUTTON,
                    variant="default",
                    size="xs",
                    className="stability-button",
                    rightSection=icon("chevron", 12),
                )
            ),
            dmc.PopoverDropdown(
                html.Div(
                    className="stability-form",
                    children=[
                        html.P(HELP, className="muted"),
                        html.Div(
                            className="stability-numbers",
                            children=[
                                _number("repetitions", "Repetitions", 1, 20, 1),
                                _number("noise_degrees", "Noise in degrees", 0, 45, 0.5),
                            ],
                        ),
                        html.Div(id=names.STABILITY_STATUS, role="status"),
                        html.Div(
                            className="stability-actions",
                            children=[
                                dmc.Button("Show stability", id=names.STABILITY_SHOW, size="compact-sm"),
                                dmc.Button("Hide", id=names.STABILITY_HIDE, size="compact-sm", variant="default"),
                            ],
                        ),
                    ],
                )
            ),
        ],
    )


def _number(name: str, label: str, low: float, high: float, step: float) -> Component:
    return dmc.NumberInput(
        id=names.STABILITY_NUMBERS[name],
        label=label,
        value=DEFAULTS[name],
        min=low,
        max=high,
        step=step,
        size="xs",
        w=130,
    )


def legend() -> Component:
    """What the rings mean, and the stability of the chosen motif; with the stores of this part."""
    ends = [
        html.Span("0 %"),
        html.Span(className="stability-scale", style={"--low": LOW, "--high": HIGH}),
        html.Span("100 %"),
    ]
    return html.Div(
        id=names.STABILITY_LEGEND,
        className="stability-legend hidden",
        children=[
            html.Span(["Rings: stability ", *ends], className="stability-key muted number"),
            html.Span(id=names.STABILITY_WORDS, role="status"),
            dcc.Store(id=names.STABILITY_DATA),
            dcc.Store(id=names.STABILITY_OF),
            dcc.Store(id=names.STABILITY_DRAWN),
        ],
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callbacks that start the measurement, follow it and show its result."""

    @app.callback(
        Output(VIEW_CHANGE, "data", allow_duplicate=True),
        Input(names.STABILITY_SHOW, "n_clicks"),
        Input(names.STABILITY_HIDE, "n_clicks"),
        State(names.STABILITY_NUMBERS["repetitions"], "value"),
        State(names.STABILITY_NUMBERS["noise_degrees"], "value"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def ask(shown, hidden, repetitions, degrees, name, view):
        if not (shown or hidden) or not name:
            return no_update  # the buttons came with a new graph
        if ctx.triggered_id == names.STABILITY_HIDE:
            return {"stability": ""}
        text = stability_request.write(repetitions, degrees)
        try:
            measurement = stability_request.request(name, view, text)
            if analyses.stored(workspace, measurement) is None:
                set_props(JOB_STARTED, {"data": jobs.start(workspace, measurement).id})
        except (ParameterError, WorkspaceError) as error:
            set_props(NOTICES, {"sendNotifications": [notice("Cannot measure stability", str(error), "red")]})
            return no_update
        return {"stability": text}

    @app.callback(
        Output(names.STABILITY_DATA, "data"),
        Output(names.STABILITY_STATUS, "children"),
        Output(names.STABILITY_BUTTON, "children"),
        Output(names.STABILITY_OF, "data"),
        Input(VIEW, "data"),
        Input(JOBS_SEEN, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        Input(names.STABILITY_BUTTON, "id"),
        State(DATASET, "data"),
        State(names.STABILITY_OF, "data"),
    )
    def follow(view, _seen, key, _id, name, before):
        if key and results.shown_graph(workspace, key, name, view) is None:
            return (no_update,) * 4  # the settings have changed, the key follows
        text = (view or {}).get("stability")
        measurement = (workspace, name, view, text)
        measured = stability_request.stored(*measurement) if text and key else None
        job = stability_request.latest_job(*measurement) if text and key and not measured else None
        percent = round(100 * job.fraction) if job and job.alive else None
        now = [key, text, measured is not None, job and [job.id, job.state, job.cancelling, percent]]
        if now == before:
            return (no_update,) * 4
        words = "Stability" if percent is None else f"Stability {percent} %"
        link = {"dataset": name or "", **settings.texts(results.MOTIFS, view), "stability": text or ""}
        copied = recipes.texts(workspace.path, stability_request.request(name, view, text)) if measured else {}
        return shown_values(measured), status(text, measured, job, urlencode(link), copied), words, now

    app.clientside_callback(
        ClientsideFunction("stability", "draw"),
        Output(names.STABILITY_DRAWN, "data"),
        Input(names.STABILITY_DATA, "data"),
        Input(names.MOTIF_GRAPH, "elements"),
        Input(SELECTION, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("stability", "list"),
        Output(names.STABILITY_LISTED, "data"),
        Input(names.STABILITY_DATA, "data"),
        Input(names.MOTIF_TABLE, "rowData"),
    )


def shown_values(stability: Stability | None) -> dict[str, Any] | None:
    """Motif id -> its figures, for assets/motifs/stability.mjs; and how many repeats there were."""
    if stability is None:
        return None
    overall, kinds, kept = stability.overall, stability.by_kind(), stability.times_kept
    return {
        "repeats": len(stability.repeats),
        "motifs": {
            str(motif): {"overall": round(float(overall[i]), 3), "kept": int(kept[i])}
            | {kind: round(float(values[i]), 3) for kind, values in kinds.items()}
            for i, motif in enumerate(stability.motifs)
        },
    }


def status(
    text: str | None,
    stability: Stability | None,
    job: Job | None,
    query: str,
    copied: Mapping[str, str] = MappingProxyType({}),
) -> Component | None:
    """A line with the progress or the result; copied: label of a button -> the recipe that it copies."""
    if stability is not None:
        mean = f"{stability.overall.mean():.0%}" if len(stability.motifs) else "–"
        summary = f"Mean stability {mean}, over {len(stability.repeats)} repeats. "
        link = html.A(
            "Save the figures (JSON)", href=f"/api/stability.json?{query}", download="", className="text-link"
        )
        again = [dmc.Button(label, size="compact-xs", variant="subtle", **copies(t)) for label, t in copied.items()]
        return html.Div([summary, link, html.Div(again, className="stability-again")])
    if job is not None and job.alive:
        cancel = dmc.Button(
            "Cancel",
            size="compact-xs",
            variant="default",
            disabled=job.cancelling,
            **sends(JOB_ACTION, {"action": "cancel", "job": job.id}, every_time=True),
        )
        return html.Div([f"{stage_words(job).capitalize()}, {round(100 * job.fraction)} % ", cancel])
    if job is not None and job.state == "failed":
        return html.Div(job.error, className="error-text")
    return html.Div("Not measured yet for this result.") if text else None
