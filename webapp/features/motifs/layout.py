"""What the Motifs page consists of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any

import dash_cytoscape as cyto
import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from core.mocap.dataset import Dataset
from core.motifs.graph import Motif, MotifGraph
from core.workspace import MotifNote
from webapp.features.motifs import graph_parts, names, stability_marks, views
from webapp.features.motifs.figures import graph as graph_figure
from webapp.features.motifs.playing import moment, transition_segment
from webapp.shell.attributes import attributes
from webapp.shell.buttons import sends, similar
from webapp.shell.icons import icon
from webapp.shell.messages import empty_state
from webapp.shell.names import SELECTION
from webapp.shell.results import MOTIFS, find_edge, find_motif, find_motifs
from webapp.ui import method_page
from webapp.ui.brief_names import brief_names
from webapp.ui.method_page import MethodPage
from webapp.ui.page_head import page_head
from webapp.ui.tables import strip_address
from webapp.ui.tile import metric_tile

ERROR_RATIO = (
    "How far the motions of a motif lie apart, compared with how far poses lie from the average pose. "
    "Lower is tighter; the 2008 paper reports .23."
)
METHOD = MethodPage(
    page=MOTIFS,
    title="Motif graph",
    action="Find motifs",
    doing="Finding motifs",
    symbol="graph",
    hint="It shows which movements recur in these recordings, and what follows what.",
    refused="Cannot find motifs",
    run_symbol="spark",
    everywhere=True,
)
MANY_TO_FILTER = 20  # edges, from which on rare ones can be hidden
MOST_ROWS = 60  # motions or transitions listed at once


def stores() -> list[Component]:
    """The stores in the frame of the app, by which other pages know the graph."""
    return [*method_page.stores(METHOD), dcc.Store(id=names.GRAPH_TOOL)]


def page() -> Component:
    """The page before any data is loaded."""
    return html.Div(
        className="motifs",
        children=[
            page_head("Motifs", html.Div(id=names.MOTIF_MENUS, className="head-menus"), method_page.run_button(METHOD)),
            method_page.settings_fold(METHOD),
            method_page.status_place(METHOD),
            html.Div(id=names.MOTIF_RESULT),
            dcc.Store(id=names.MOTIFS_DRAWN),
        ],
    )


def result(graph: MotifGraph, dataset: Dataset, elements: list[dict], scheme: str) -> Component:
    """Metrics, graph, and the views beside and below it; or what to try where no motif was found."""
    if not graph.motifs:
        hint = (
            "Nothing recurs under these settings. Try a smaller kappa, a larger speed tolerance, "
            "or a smaller shortest motion."
        )
        return html.Div(empty_state("graph", "No motif found", hint), className="card section")
    return html.Div(
        [
            html.Div([metric_tile(*tile) for tile in metric_tiles(graph, dataset)], className="tiles section"),
            html.Div(
                className="graph-and-selection section",
                children=[
                    _graph_card(graph, elements, scheme),
                    html.Div(
                        [views.BESIDE.switch(), *views.BESIDE.panels()],
                        className="card selection-card",
                    ),
                ],
            ),
            html.Div([views.BELOW.switch()], className="section-head section"),
            *views.BELOW.panels(),
            *(dcc.Store(id=name) for name in (names.MOTIONS, names.GRAPH_TAPPED, names.GRAPH_MARKED)),
        ]
    )


def metric_tiles(graph: MotifGraph, dataset: Dataset) -> list[tuple[str, str, str]]:
    """Name, value and explanation of each figure."""
    metrics = graph.metrics
    rates = {clip.name: clip.fps for clip in dataset.clips}
    lengths = [s.n_frames / rates.get(s.clip, 30.0) for motif in graph.motifs for s in motif.segments]
    spread = metrics.get("mean_pose_distance", 0)
    ratio = metrics.get("average_frame_error", 0) / spread if spread else 0.0
    return [
        ("Motifs", f"{len(graph.motifs)}", "Movements that recur."),
        ("Coverage", f"{100 * metrics.get('coverage', 0):.0f} %", "Share of all frames that belong to some motif."),
        ("Error ratio", f"{ratio:.2f}", ERROR_RATIO),
        ("Motions per motif", f"{metrics.get('mean_motions', 0):.1f}", "Mean number of motions of a motif."),
        ("Mean length", f"{sum(lengths) / len(lengths):.1f} s" if lengths else "–", "Mean duration of a motion."),
    ]  # fmt: skip


def _part_chooser(graph: MotifGraph) -> list[Component]:
    """Which motifs of a large graph are drawn; all of a small one."""
    if not graph_parts.is_large(graph):
        return []
    chooser = dmc.Select(
        id=names.GRAPH_PART,
        data=graph_parts.choices(graph),
        value=graph_parts.LARGEST,
        allowDeselect=False,
        size="xs",
        w=176,
        comboboxProps={"shadow": "md"},
        **attributes(aria_label="Motifs that are drawn"),
    )
    words = graph_parts.words_of(graph, graph_parts.ids_of_part(graph, graph_parts.LARGEST, None))
    shown = html.Span(words, id=names.GRAPH_PART_WORDS, className="muted number graph-part-words")
    start = {"part": graph_parts.LARGEST, "centre": None}
    stores = [dcc.Store(id=names.GRAPH_PART_SHOWN, data=start), dcc.Store(id=names.GRAPH_SOUGHT)]
    return [chooser, shown, *stores]


def _graph_card(graph: MotifGraph, elements: list[dict], scheme: str) -> Component:
    counts = graph_figure.counts_of(elements)
    threshold = graph_figure.first_threshold(counts)
    return html.Div(
        className="card graph-card",
        children=[
            html.Div(
                className="graph-bar",
                children=[
                    *_part_chooser(graph),
                    html.Div(
                        className="edge-filter"
                        + ("" if max(counts, default=1) > 1 and len(counts) > MANY_TO_FILTER else " hidden"),
                        children=[
                            html.Span(
                                f"Transitions seen at least {threshold}×",
                                className="number",
                                id=names.EDGE_FILTER_LABEL,
                            ),
                            dmc.Slider(
                                id=names.EDGE_THRESHOLD,
                                min=1,
                                max=max(2, min(max(counts, default=2), 20)),
                                value=threshold,
                                size="xs",
                                w=120,
                                thumbLabel="Hide successions seen less often",
                            ),
                        ],
                    ),
                    html.Div(className="spacer"),
                    stability_marks.control(),
                    html.Div(
                        className="graph-tools",
                        children=[
                            _tool("plus", "Zoom in", {"graph": "in"}),
                            _tool("minus", "Zoom out", {"graph": "out"}),
                            _tool("fit", "Show the whole graph", {"graph": "fit"}),
                        ],
                    ),
                ],
            ),
            cyto.Cytoscape(
                id=names.MOTIF_GRAPH,
                elements=elements,
                layout={"name": "preset", "fit": True, "padding": 26},
                stylesheet=graph_figure.stylesheet(scheme),
                style={"width": "100%", "height": "100%"},
                minZoom=0.05,
                maxZoom=3,
                boxSelectionEnabled=False,
                autoRefreshLayout=False,
                responsive=False,
            ),
            html.Div(graph_figure.legend(graph), className="graph-legend muted"),
            stability_marks.legend(),
        ],
    )


def _tool(symbol: str, label: str, value: dict[str, str]) -> Component:
    return dmc.ActionIcon(
        icon(symbol, 16),
        variant="default",
        size=30,
        **sends(names.GRAPH_TOOL, value, every_time=True),
        **attributes(aria_label=label),
        attributes={"root": {"title": label}},
    )


def download_menu(graph: MotifGraph, query: str, copies: Sequence[Component]) -> list[Component]:
    """Downloads of the graph, whose link is ``query``, and menu items that copy recipes for it."""
    if not graph.motifs:
        return []
    items = [
        _download("Motifs and edges (JSON)", f"/api/motifs.json?{query}"),
        _download("All motions (CSV)", f"/api/motifs.csv?{query}"),
        _download("Drawing of the graph (SVG)", f"/api/motifs.svg?{query}"),
        dmc.MenuItem("Picture of the graph (PNG)", **sends(names.GRAPH_TOOL, {"graph": "png"}, every_time=True)),
        dmc.MenuDivider(),
        *copies,
    ]
    target = dmc.Button("Download", variant="default", leftSection=icon("download", 16))
    children = [dmc.MenuTarget(target), dmc.MenuDropdown(items)]
    return [dmc.Menu(shadow="md", position="bottom-end", children=children)]


def _download(label: str, address: str) -> Component:
    return dmc.MenuItem(label, href=address, refresh=True)


def selection_panel(
    graph: MotifGraph, selection: Mapping[str, Any], notes: Mapping[int, MotifNote] = MappingProxyType({})
) -> Component:
    """What is selected, in a line: its name, how many motions or transitions, and a way to play them together."""
    motif = find_motif(graph, selection["motif"]) if "motif" in selection else None
    if motif is not None:
        together = dmc.Button(
            "Play all",
            size="compact-sm",
            variant="default" if "motion" in selection else "filled",
            leftSection=icon("play", 14),
            **sends(SELECTION, {"motif": motif.id}),
        )
        name = notes[motif.id].name if motif.id in notes else ""
        number = int(selection.get("motion", motif.medoid))
        motion = motif.segments[number if 0 <= number < len(motif.segments) else motif.medoid]
        alike = dmc.Button("More like this", size="compact-sm", variant="default", **similar(*motion))
        actions = html.Div([alike, together], className="head-menus")
        return _panel_head(name or f"Motif {motif.id}", f"{len(motif.segments)} motions", actions)
    edge = find_edge(graph, selection["edge"]) if "edge" in selection else None
    if edge is not None:
        return _panel_head(f"From {edge.source} to {edge.target}", f"seen {edge.count}×")
    several = find_motifs(graph, selection) if "motifs" in selection else []
    if several:
        return _several(several, notes)
    hint = (
        "Choose a box to see all motions of a motif play together, or an arrow to see how one motif leads to the next."
    )
    return html.Div(
        [html.Div(icon("play", 26), className="empty-icon"), html.P(hint, className="muted")],
        className="selection-hint",
    )


def _several(motifs: list[Motif], notes: Mapping[int, MotifNote]) -> Component:
    """Motifs that are marked together, each a button that selects it alone."""
    buttons = [
        html.Button(
            (notes[motif.id].name if motif.id in notes else "") or f"Motif {motif.id}",
            className="soft-button",
            **sends(SELECTION, {"motif": motif.id}),
        )
        for motif in motifs
    ]
    head = _panel_head(f"{len(motifs)} motifs marked" if len(motifs) > 1 else "1 motif marked", "choose one to play it")
    return html.Div([head, html.Div(buttons, className="marked-motifs")])


def _panel_head(title: str, count: str, action: Component | None = None) -> Component:
    parts = [html.H2(title), html.Span(count, className="muted"), html.Div(className="spacer"), action]
    return html.Div(parts, className="section-head")


def motion_list(dataset: Dataset, graph: MotifGraph, selection: Mapping[str, Any]) -> dict[str, Any]:
    """The motions of the selected motif or the transitions of the selected edge, for assets/motifs/motion_list.mjs."""
    motif = find_motif(graph, selection["motif"]) if "motif" in selection else None
    edge = find_edge(graph, selection["edge"]) if "edge" in selection else None
    if motif is not None:
        name: dict[str, Any] = {"motif": motif.id}
        key, total, chosen = "motion", len(motif.segments), selection.get("motion")
        segments = motif.segments[:MOST_ROWS]
    elif edge is not None:
        name, key = {"edge": f"{edge.source}-{edge.target}"}, "transition"
        total, chosen = len(edge.transitions), selection.get("transition", 0)
        segments = tuple(transition_segment(dataset, graph, edge, i) for i in range(min(total, MOST_ROWS)))
    else:
        return {}
    brief = dict(zip(dataset.names, brief_names(dataset.names, 26), strict=True))
    rows = [
        {
            "clip": segment.clip,
            "brief": brief[segment.clip],
            "when": moment(dataset, segment),
            "strip": strip_address(dataset.name, segment, 4, dataset.fingerprint),
            "selection": {**name, key: i},
            "chosen": str(chosen) == str(i),
        }
        for i, segment in enumerate(segments)
    ]
    return {"name": f"{dataset.fingerprint} {name}", "rows": rows, "more": total - len(rows)}
