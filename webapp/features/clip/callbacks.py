"""The Clip page's callbacks: which clip it is, what its chart shows, what is selected of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from dash import Dash, Input, Output, Patch, State, ctx, no_update, set_props
from dash.dependencies import ClientsideFunction

from core.editing.curves import ClipCurves
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.workspace import Workspace, WorkspaceError
from webapp.features.clip import clips, editing, layout, table
from webapp.features.clip.figures import curves as figures
from webapp.features.clip.figures.gait import gait_table
from webapp.features.clip.figures.path import path_chart, selected_part
from webapp.shell import results
from webapp.shell.results import find_edge, find_motif
from webapp.ui.charts import tall
from webapp.ui.timeline import motif_colour, motif_name


def register(app: Dash, workspace: Workspace) -> None:
    """All of the page's callbacks."""
    _choose(app, workspace)
    _controls(app, workspace)
    _draw(app, workspace)
    _browser(app)
    editing.register(app, workspace)
    table.register(app)


def clip_of(dataset: Dataset, graph: MotifGraph | None, selection: Mapping[str, Any]) -> str | None:
    """The clip that a selection is about: named by it, or the one of the motion or transition; None for none."""
    if "clip" in selection:
        return str(selection["clip"])
    motif = find_motif(graph, selection["motif"]) if graph and "motif" in selection else None
    if motif is not None:
        number = int(selection.get("motion", motif.medoid))
        return motif.segments[number if 0 <= number < len(motif.segments) else motif.medoid].clip
    edge = find_edge(graph, selection["edge"]) if graph and "edge" in selection else None
    return edge.transitions[0].clip if edge is not None and edge.transitions else None


def _choose(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output("clip-shown", "data"),
        Output("clip-picker", "data"),
        Output("clip-picker", "value"),
        Output("clip-nothing", "children"),
        Output("clip-body", "className"),
        Input("dataset", "data"),
        Input("selection", "data"),
        Input("revision", "data"),
        Input("graph-key", "data"),
        State("parameters", "data"),
        State("clip-shown", "data"),
    )
    def choose(name, selection, _revision, _key, parameters, before):
        try:
            dataset = workspace.open(name) if name else None
        except WorkspaceError:
            dataset = None
        if dataset is None or not dataset.clips:
            return None, [], None, layout.nothing(dataset, None), "hidden"
        graph = results.motif_graph(workspace, name, parameters)
        clip = clip_of(dataset, graph, selection or {})
        if clip is None and ctx.triggered_id == "graph-key" and before and before["clip"] in dataset.names:
            return (no_update,) * 5
        if clip is None:
            clip = dataset.names[0]
            if not selection:
                set_props("selection", {"data": {"clip": clip}})
        if clip not in dataset.names:
            return None, list(dataset.names), None, layout.nothing(dataset, clip), "hidden"
        recording = dataset.clip(clip)
        shown = {"dataset": dataset.name, "version": dataset.fingerprint, "clip": clip}
        shown |= {"fps": recording.fps, "frames": recording.n_frames}
        return (shown if shown != before else no_update), list(dataset.names), clip, None, ""

    @app.callback(
        Output("clip-previous", "disabled"),
        Output("clip-next", "disabled"),
        Input("clip-picker", "data"),
        Input("clip-picker", "value"),
    )
    def ends(names, clip):
        at = names.index(clip) if names and clip in names else -1
        return at <= 0, at < 0 or at == len(names) - 1

    app.clientside_callback(
        ClientsideFunction("clip", "pick"),
        Output("clip-sought", "data"),
        Input("clip-picker", "value"),
        Input("clip-previous", "n_clicks"),
        Input("clip-next", "n_clicks"),
        State("clip-picker", "data"),
        State("clip-shown", "data"),
        prevent_initial_call=True,
    )


def _controls(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output("clip-facts", "children"),
        Output("clip-gait-table", "data"),
        Input("clip-shown", "data"),
    )
    def show_facts(shown):
        curves = curves_of(workspace, shown)
        if curves is None:
            return None, None
        return layout.facts(curves), gait_table(curves.gait, curves.clip.name, curves.clip.fps)

    @app.callback(
        Output("clip-chart", "value"),
        Output("clip-kind", "value"),
        Output("clip-kind-box", "className"),
        Output("clip-joints", "data"),
        Output("clip-joints", "value"),
        Output("clip-joints-box", "className"),
        Output("clip-channels", "children"),
        Output("clip-channels", "value"),
        Output("clip-channels-box", "className"),
        Output("clip-choice", "data"),
        Input("clip-shown", "data"),
        Input("view", "data"),
    )
    def show_controls(shown, view):
        curves = curves_of(workspace, shown)
        if curves is None:
            return (no_update,) * 10
        chosen = clips.choice(view, curves)
        angles, body = chosen.chart == "angles", chosen.kind == "body"
        options = layout.joint_options(curves, chosen)
        chips = layout.channel_chips(chosen) if angles and body else []
        return (
            *(chosen.chart, chosen.kind, "" if angles else "hidden"),
            *(options, list(chosen.joints) if options else []),
            "clip-joints-box" + ("" if options else " hidden"),
            *(chips, list(chosen.channels), "clip-channels-box" + ("" if chips else " hidden")),
            {"joints": list(chosen.joints), "channels": list(chosen.channels)},
        )

    app.clientside_callback(
        ClientsideFunction("clip", "control"),
        Input("clip-chart", "value"),
        Input("clip-kind", "value"),
        Input("clip-joints", "value"),
        Input("clip-channels", "value"),
        State("view", "data"),
        State("clip-choice", "data"),
        prevent_initial_call=True,
    )

    @app.callback(Output("clip-range", "children"), Input("clip-shown", "data"), Input("selection", "data"))
    def show_range(shown, selection):
        if not shown:
            return None
        return layout.range_bar(shown["clip"], shown["fps"], shown["frames"], *editing.selected(shown, selection))


def _draw(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output("clip-graph", "figure"),
        Output("clip-graph", "style"),
        Output("clip-legend", "children"),
        Input("clip-shown", "data"),
        Input("view", "data"),
        Input("theme", "data"),
        Input("graph-key", "data"),
        State("parameters", "data"),
        State("selection", "data"),
    )
    def draw(shown, view, scheme, _key, parameters, selection):
        curves = curves_of(workspace, shown)
        if curves is None:
            return no_update, no_update, no_update
        chosen, scheme = clips.choice(view, curves), scheme or "light"
        if chosen.chart == "path":
            document = path_chart(curves, selection or {}, scheme)
            return document, tall(document), None
        panels = figures.panels_of(clips.chosen_curves(curves, chosen), chosen, scheme)
        bands = [*figures.foot_bands(curves, scheme), *_spans(workspace, shown, parameters)]
        document = figures.time_chart(curves, panels, bands, chosen, scheme)
        return document, tall(document), layout.legend(panels)

    @app.callback(
        Output("clip-graph", "figure", allow_duplicate=True),
        Input("selection", "data"),
        State("clip-shown", "data"),
        State("clip-drawn", "data"),
        State("theme", "data"),
        prevent_initial_call=True,
    )
    def mark_path(selection, shown, drawn, scheme):
        if drawn != "path" or (curves := curves_of(workspace, shown)) is None:
            return no_update
        changed = Patch()
        changed["data"][1] = selected_part(curves, selection or {}, scheme or "light")
        return changed


def curves_of(workspace: Workspace, shown: Mapping[str, Any] | None) -> ClipCurves | None:
    """The curves of the clip that is shown; None where it has gone meanwhile."""
    if not shown:
        return None
    try:
        dataset = workspace.open(shown["dataset"])
        return clips.clip_curves(dataset, shown["clip"])
    except (WorkspaceError, KeyError):
        return None


def _spans(workspace: Workspace, shown: Mapping[str, Any], parameters: Mapping[str, Any]) -> list[figures.Band]:
    """Bands of what people labelled and of the motifs that were found in this clip."""
    dataset = workspace.open(shown["dataset"])
    actions = sorted({label.action for label in dataset.labels})
    labels = [
        figures.Block(label.start, label.end, label.action, motif_colour(actions.index(label.action)))
        for label in dataset.labels
        if label.clip == shown["clip"]
    ]
    bands = figures.lanes("Labels", labels)
    graph = results.motif_graph(workspace, dataset.name, parameters)
    if graph is not None:
        notes = results.motif_notes(workspace, dataset.name, parameters)
        motions = [
            figures.Block(s.start, s.end, motif_name(m.id, notes), motif_colour(m.id))
            for m in graph.motifs
            for s in m.segments
            if s.clip == shown["clip"]
        ]
        bands += figures.lanes("Motifs", motions)
    return bands


def _browser(app: Dash) -> None:
    """What assets/clip_*.js must hear of."""
    app.clientside_callback(
        ClientsideFunction("clip", "drawn"),
        Output("clip-drawn", "data"),
        Input("clip-graph", "figure"),
        Input("clip-legend", "children"),
        State("clip-shown", "data"),
        State("view", "data"),
    )
    app.clientside_callback(
        ClientsideFunction("gait", "draw"), Output("clip-gait-drawn", "data"), Input("clip-gait-table", "data")
    )
    app.clientside_callback(
        ClientsideFunction("clip", "mark"),
        Output("clip-marked", "data"),
        Input("selection", "data"),
        Input("clip-shown", "data"),
    )
    app.clientside_callback(
        ClientsideFunction("clip", "seek"),
        Output("clip-sought", "data", allow_duplicate=True),
        Input("clip-seek", "data"),
        prevent_initial_call=True,
    )
