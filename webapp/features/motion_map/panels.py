"""What stands below the map: a small map per label, the clips and how well they fit, what passes a region."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import plotly.graph_objects as go
from dash import dcc, html
from dash.development.base_component import Component
from plotly.subplots import make_subplots

from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.motion_map import layers
from core.motion_map.motion_map import MotionMap
from webapp.features.motion_map import names
from webapp.features.motion_map.figures import heatmap as figures
from webapp.features.motion_map.layout import BAD_FIT
from webapp.shell.buttons import sends
from webapp.shell.names import SELECTION
from webapp.ui.charts import CONFIG, tall, themed
from webapp.ui.downloads import chart_menu
from webapp.ui.tables import NUMBER, SECONDS, column, decimals

COLUMNS = 4
MOST_LABELS = 24


def multiples(motion_map: MotionMap, dataset: Dataset, scheme: str | None) -> list[Component]:
    """Where each label lies: a small map each, or what to do where there are no labels."""
    groups = figures.label_segments(dataset)
    if not groups:
        return [
            html.P(
                "These recordings have no labels; add them in the library (a CSV file), and each gets a map here.",
                className="muted map-hint",
            )
        ]
    figure = multiples_figure(motion_map, dataset, scheme)
    head = html.Div(
        [html.Div(className="spacer"), chart_menu(names.MAP_MULTIPLES_GRAPH, "labels on the map")],
        className="table-bar",
    )
    graph = dcc.Graph(
        id=names.MAP_MULTIPLES_GRAPH,
        figure=figure,
        config={**CONFIG, "staticPlot": True},
        style=tall(figure),
    )
    return [head, html.Div(graph, className="card")]


def multiples_figure(motion_map: MotionMap, dataset: Dataset, scheme: str | None) -> go.Figure:
    """A heatmap of seconds per label, each on a scale of its own, the U-matrix faint behind them."""
    groups = figures.label_segments(dataset)
    labels = list(groups)[:MOST_LABELS]
    seconds = layers.seconds_on_nodes(motion_map, [groups[name] for name in labels])
    rows = -(-len(labels) // COLUMNS)
    titles = [f"{name} ({total:.0f} s)" for name, total in zip(labels, seconds.sum(axis=(1, 2)), strict=True)]
    figure = make_subplots(rows, COLUMNS, subplot_titles=titles, horizontal_spacing=0.02, vertical_spacing=0.13 / rows)
    scale = figures.SCALES["dark" if scheme == "dark" else "light"]
    ground, tone = scale[0][1], "#8fb3f3" if scheme == "dark" else "#2f62b8"
    for k, values in enumerate(seconds):
        share = np.sqrt(values / max(values.max(), 1e-9))  # the root: rare postures can be seen as well
        heat = go.Heatmap(
            z=share.T, zmin=0, zmax=1, colorscale=[[0, ground], [1, tone]], showscale=False, name=labels[k]
        )
        figure.add_trace(heat, k // COLUMNS + 1, k % COLUMNS + 1)
    figure = themed(figure, scheme, height=190 * rows + 40, margin={"l": 8, "r": 8, "t": 30, "b": 8})
    figure.update_xaxes(visible=False, constrain="domain")
    for k in range(len(labels)):
        axis = "" if k == 0 else str(k + 1)
        figure.update_layout({f"yaxis{axis}": {"visible": False, "scaleanchor": f"x{axis}", "autorange": "reversed"}})
    return figure.update_annotations(font_size=12)


def clip_columns() -> list[dict[str, Any]]:
    """Columns of the table of clips."""
    tip = "Mean distance of its postures to the map, as a multiple of what is usual: above about 2 the map does not represent them."  # noqa: E501
    return [
        {"field": "clip", "headerName": "Clip", "flex": 1, "minWidth": 200},
        column("seconds", "Seconds", 88, **SECONDS),
        column("nodes", "Nodes", 78, **NUMBER),
        column("regions", "Regions", 88, **NUMBER),
        column("fit", "Off the map", 114, tip, **decimals(2)),
        {"field": "remark", "headerName": "", "width": 100},
    ]


def clip_rows(motion_map: MotionMap, dataset: Dataset) -> list[dict[str, Any]]:
    """A row for each clip: length, how much of the map it visits, and how badly it fits."""
    seconds = layers.seconds_of_clips(motion_map)
    rows = []
    for k, clip in enumerate(motion_map.clips):
        visited = seconds[k] > 0
        fit = float(motion_map.fits[k])
        rows.append(
            {
                "clip": clip,
                "seconds": round(motion_map.clip_frames[k] / motion_map.clip_fps[k], 1),
                "nodes": int(visited.sum()),
                "regions": len(np.unique(motion_map.regions[visited])),
                "fit": round(fit, 2),
                "remark": "fits badly" if fit >= BAD_FIT else "",
                "selection": {"clip": clip},
                "key": clip,
            }
        )
    return rows


def region(motion_map: MotionMap, dataset: Dataset, graph: MotifGraph | None, chosen: str | None) -> list[Component]:
    """What passes a region: its motifs and its clips, each a button that selects it."""
    if not chosen or not chosen.isdecimal() or int(chosen) >= len(motion_map.icons):
        return [
            html.P(
                "Choose Regions above the map, then click one: what passes through it is listed here.",
                className="muted map-hint",
            )
        ]
    nodes = np.equal(motion_map.regions, int(chosen))
    seconds = layers.seconds_of_clips(motion_map)[:, nodes].sum(axis=1)
    clips = [(motion_map.clips[k], seconds[k]) for k in np.argsort(-seconds, kind="stable") if seconds[k] > 0]
    total = f"{nodes.sum()} nodes, {seconds.sum():.1f} s of motion"
    parts: list[Component] = [
        html.Div([html.H2(f"Region {chosen}"), html.Span(total, className="muted")], className="section-head")
    ]
    parts += [html.H3("Motifs that pass through it"), _motifs(motion_map, graph, nodes)]
    buttons = [_choice(name, f"{spent:.1f} s", {"clip": name}) for name, spent in clips[:60]]
    return [*parts, html.H3("Clips that pass through it"), html.Div(buttons, className="map-region-groups")]


def _motifs(motion_map: MotionMap, graph: MotifGraph | None, nodes: np.ndarray) -> Component:
    if graph is None:
        return html.P("No motifs have been found yet (Motifs page).", className="muted map-hint")
    passing = layers.passing(motion_map, nodes, {motif.id: motif.segments for motif in graph.motifs})
    if not passing:
        return html.P("None of the motifs does.", className="muted map-hint")
    sizes = {motif.id: motif.n_motions for motif in graph.motifs}
    order: Sequence[int] = sorted(passing, key=lambda motif: (-len(passing[motif]) / sizes[motif], motif))
    buttons = [_choice(f"Motif {m}", f"{len(passing[m])} of {sizes[m]} motions", {"motif": m}) for m in order[:60]]
    all_of_them = {"motifs": "-".join(map(str, order[:300]))}
    together = html.Button(
        "Mark them in the motif graph", className="soft-button", **sends(SELECTION, all_of_them, page="motifs")
    )
    return html.Div([html.Div(buttons, className="map-region-groups"), together])


def _choice(name: str, detail: str, selection: dict[str, Any]) -> Component:
    return html.Button(
        [html.Span(name), html.Span(detail, className="muted number")],
        className="soft-button map-choice",
        **sends(SELECTION, selection),
    )
