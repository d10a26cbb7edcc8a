"""The blend space of a motif: weights over its motions; assets/motifs/blend.mjs plays the mixture while one drags."""

from __future__ import annotations

from typing import Any

import numpy as np
from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.mocap.dataset import Dataset
from core.motifs.blend_space import BlendSpace, blendable
from core.motifs.graph import Motif
from core.workspace import Workspace, WorkspaceError
from webapp.features.motifs import mixtures, names
from webapp.features.motifs.playing import mixing, moment, shown_motions, stage_request
from webapp.shell import results
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.names import DATASET, MOTIF_METHOD, SELECTION, VIEW
from webapp.shell.results import find_motif
from webapp.ui.brief_names import brief_names

MOST_MIXED = 8  # motions that are mixed at once
KNOTS = 25  # moments at which the browser knows the times of each motion


def layout() -> Component:
    """The containers of the controls, and the message shown while there is nothing to mix."""
    return html.Div(
        className="blend-side",
        children=[
            html.P("Choose a motif to mix its motions.", id=names.BLEND_HINT, className="muted"),
            html.Div(
                id=names.BLEND_PANEL,
                className="hidden",
                children=[
                    html.Div(
                        [html.H2(id=names.BLEND_TITLE), html.Span(id=names.BLEND_COUNT, className="muted")],
                        className="section-head",
                    ),
                    html.Div(id=names.BLEND_CONTROLS, className="blend-controls"),
                    html.Div(
                        className="blend-buttons",
                        role="group",
                        children=[
                            _button("Mean", "mean", "All motions alike"),
                            _button("Random", "random", "Weights by chance"),
                            _button("Sources", "sources", "Show the motions it is mixed of too", toggle=True),
                            _button("Middle frames", "middles", "The middle frame of every motion of the motif"),
                            html.A(
                                [icon("download", 14), "BVH"],
                                id=names.BLEND_BVH,
                                className="blend-button",
                                title="Save the mixture as a BVH file",
                            ),
                        ],
                        **attributes(aria_label="Mixture"),
                    ),
                    html.P(id=names.BLEND_NOTE, className="muted blend-note"),
                ],
            ),
            dcc.Store(id=names.BLEND_DATA),
            dcc.Store(id=names.BLEND_DRAWN),
        ],
    )


def _button(label: str, action: str, tip: str, toggle: bool = False) -> Component:
    data = attributes(data_blend=action) | (attributes(aria_pressed="false") if toggle else {})
    return html.Button(label, type="button", className="blend-button", title=tip, **data)


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callback that sends what can be mixed of a motif; the rest happens in the browser."""

    @app.callback(
        Output(names.BLEND_DATA, "data"),
        Input(SELECTION, "data"),
        Input(VIEW, "data"),
        Input(names.BLEND_CONTROLS, "id"),
        State(MOTIF_METHOD.result_key, "data"),
        State(DATASET, "data"),
        State(names.BLEND_DATA, "data"),
    )
    def gather(selection, view, _controls, key, name, before):
        if not mixing(view) or not key or not name:
            return no_update
        number = (selection or {}).get("motif")
        if before and (before.get("key"), before.get("motif")) == (key, number):
            return no_update
        graph = results.shown_graph(workspace, key, name, view)
        if graph is None:
            return no_update
        motif = find_motif(graph, number)
        if motif is None:
            return {"key": key, "motif": number}
        try:
            dataset = workspace.open(name)
            note = results.motif_notes(workspace, name, view).get(motif.id)
            called = (note.name if note else "") or f"Motif {motif.id}"
            return blend_data(workspace, key, dataset, motif, called) | {
                "together": stage_request(dataset, graph, {"motif": motif.id})
            }
        except WorkspaceError:
            return {"key": key, "motif": number}

    app.clientside_callback(
        ClientsideFunction("blend", "draw"),
        Output(names.BLEND_DRAWN, "data"),
        Input(names.BLEND_DATA, "data"),
        Input(VIEW, "data"),
        Input(names.BLEND_CONTROLS, "id"),
        State(SELECTION, "data"),
    )


def blend_data(workspace: Workspace, key: str, dataset: Dataset, motif: Motif, called: str) -> dict[str, Any]:
    """For assets/motifs/blend.mjs: the bodies of the motif, the motions of each, and how their times run together."""
    groups = [group for group in blendable(dataset, motif) if len(group) > 1]
    spaces = [mixtures.space_of(workspace, key, motif.id, group[0]) for group in groups]
    return {
        "key": key,
        "motif": motif.id,
        "title": called,
        "total": motif.n_motions,
        "dataset": dataset.name,
        "version": dataset.fingerprint,
        "most": MOST_MIXED,
        "bodies": [_body(dataset, motif, space) for space in spaces],
        "middles": middles(dataset, motif, called),
    }


def _body(dataset: Dataset, motif: Motif, space: BlendSpace) -> dict[str, Any]:
    at = np.linspace(0, len(space.tracks[space.reference].ticks) - 1, KNOTS)
    brief = dict(zip(dataset.names, brief_names(dataset.names), strict=True))
    motions = []
    for k, track in space.tracks.items():
        segment = motif.segments[k]
        seconds = np.interp(at, np.arange(len(track.ticks)), track.seconds)
        motions.append(
            {
                "motion": k,
                "clip": segment.clip,
                "brief": brief[segment.clip],
                "start": segment.start,
                "end": segment.end,
                "fps": track.clip.fps,
                "when": moment(dataset, segment),
                "seconds": [round(float(s), 3) for s in seconds],
            }
        )
    return {"motions": motions, "chosen": sorted(space.most_different(MOST_MIXED)), "reference": space.reference}


def middles(dataset: Dataset, motif: Motif, called: str) -> dict[str, Any]:
    """The stage request of MMG's Figure 4: the middle frames of all motions of a motif, side by side."""
    items = [
        {
            "clip": motif.segments[k].clip,
            "start": motif.segments[k].start,
            "end": motif.segments[k].end,
            "label": f"{k + 1}",
        }
        for k in shown_motions(motif, most=48)
    ]
    return {
        "dataset": dataset.name,
        "version": dataset.fingerprint,
        "items": items,
        "layout": "pose",
        "sync": "start",
        "title": f"{called}: middle frames",
    }
