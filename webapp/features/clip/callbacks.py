"""The Clip page's callbacks: the clip, its chart and the selected range."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import islice
from typing import Any

from dash import Dash, Input, Output, Patch, State, ctx, no_update, set_props
from dash.dependencies import ClientsideFunction

from core.editing.curves import ClipCurves
from core.mocap.dataset import Dataset
from core.mocap.reports import Finding
from core.motifs.graph import MotifGraph
from core.workspace import Workspace, WorkspaceError
from webapp.features.clip import clips, doctor, editing, layout, names, table
from webapp.features.clip.figures import curves as figures
from webapp.features.clip.figures.gait import gait_table
from webapp.features.clip.figures.path import path_chart, selected_part
from webapp.shell import results
from webapp.shell.names import DATASET, MOTIF_METHOD, REVISION, SELECTION, THEME, VIEW
from webapp.shell.results import find_edge, find_motif
from webapp.ui.charts import tall
from webapp.ui.doubts import findings_by_clip
from webapp.ui.long_tables import LONG, OFFERED
from webapp.ui.timeline import motif_colour, motif_name


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the page's callbacks."""
    _choose(app, workspace)
    _controls(app, workspace)
    _draw(app, workspace)
    _browser(app)
    editing.register(app, workspace)
    doctor.register(app, workspace)
    table.register(app)


def clip_of(dataset: Dataset, graph: MotifGraph | None, selection: Mapping[str, Any]) -> str | None:
    """The clip of a selection: the one it names, or that of the motion or transition; None where there is none."""
    if "clip" in selection:
        return str(selection["clip"])
    motif = find_motif(graph, selection["motif"]) if graph and "motif" in selection else None
    if motif is not None:
        number = int(selection.get("motion", motif.medoid))
        return motif.segments[number if 0 <= number < len(motif.segments) else motif.medoid].clip
    edge = find_edge(graph, selection["edge"]) if graph and "edge" in selection else None
    return edge.transitions[0].clip if edge is not None and edge.transitions else None


def offered(all_names: Sequence[str], clip: str | None, typed: str = "") -> list[str]:
    """The clips to choose from, in order: all, or of thousands those beside ``clip`` and those that have ``typed``."""
    if len(all_names) <= LONG:
        return list(all_names)
    at = all_names.index(clip) if clip in all_names else 0
    near = range(max(0, at - OFFERED // 2), min(len(all_names), at + OFFERED // 2 + 1))
    asked = typed.lower()
    found = islice((k for k, name in enumerate(all_names) if asked in name.lower()), OFFERED if asked else 0)
    return [all_names[k] for k in sorted({*near, *found})]


def _choose(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.CLIP_SHOWN, "data"),
        Output(names.CLIP_PICKER, "data"),
        Output(names.CLIP_PICKER, "value"),
        Output(names.CLIP_NOTHING, "children"),
        Output(names.CLIP_BODY, "className"),
        Input(DATASET, "data"),
        Input(SELECTION, "data"),
        Input(REVISION, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        State(VIEW, "data"),
        State(names.CLIP_SHOWN, "data"),
    )
    def choose(name, selection, _revision, _key, view, before):
        try:
            dataset = workspace.open(name) if name else None
        except WorkspaceError:
            dataset = None
        if dataset is None or not dataset.clips:
            return None, [], None, layout.nothing(dataset, None), "hidden"
        graph = results.motif_graph(workspace, name, view)
        clip = clip_of(dataset, graph, selection or {})
        if clip is None and ctx.triggered_id == MOTIF_METHOD.result_key and before and before["clip"] in dataset.names:
            return (no_update,) * 5
        if clip is None:
            clip = dataset.names[0]
            if not selection:
                set_props(SELECTION, {"data": {"clip": clip}})
        if clip not in dataset.names:
            return None, offered(dataset.names, None), None, layout.nothing(dataset, clip), "hidden"
        recording = dataset.clip(clip)
        shown: dict[str, Any] = {"dataset": dataset.name, "version": dataset.fingerprint, "clip": clip}
        shown |= {"fps": recording.fps, "frames": recording.n_frames}
        return (shown if shown != before else no_update), offered(dataset.names, clip), clip, None, ""

    @app.callback(
        Output(names.CLIP_PICKER, "data", allow_duplicate=True),
        Input(names.CLIP_PICKER, "searchValue"),
        State(names.CLIP_SHOWN, "data"),
        State(DATASET, "data"),
        prevent_initial_call=True,
    )
    def find_clips(typed, shown, name):
        try:
            all_names = workspace.open(name).names if name else ()
        except WorkspaceError:
            return no_update
        if len(all_names) <= LONG:
            return no_update  # the list has them all
        clip = (shown or {}).get("clip")
        return offered(all_names, clip, "" if typed == clip else str(typed or ""))

    @app.callback(
        Output(names.CLIP_PREVIOUS, "disabled"),
        Output(names.CLIP_NEXT, "disabled"),
        Input(names.CLIP_PICKER, "data"),
        Input(names.CLIP_PICKER, "value"),
    )
    def ends(clips_here, clip):
        at = clips_here.index(clip) if clips_here and clip in clips_here else -1
        return at <= 0, at < 0 or at == len(clips_here) - 1

    app.clientside_callback(
        ClientsideFunction("clip", "pick"),
        Output(names.CLIP_SOUGHT, "data"),
        Input(names.CLIP_PICKER, "value"),
        Input(names.CLIP_PREVIOUS, "n_clicks"),
        Input(names.CLIP_NEXT, "n_clicks"),
        State(names.CLIP_PICKER, "data"),
        State(names.CLIP_SHOWN, "data"),
        prevent_initial_call=True,
    )


def _controls(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.CLIP_FACTS, "children"),
        Output(names.CLIP_DOUBTS, "children"),
        Output(names.CLIP_GAIT_TABLE, "data"),
        Input(names.CLIP_SHOWN, "data"),
    )
    def show_facts(shown):
        curves = curves_of(workspace, shown)
        if curves is None:
            return None, None, None
        doubts = doctor.panel(_findings(workspace, shown), curves.clip, workspace.open(shown["dataset"]))
        return layout.facts(curves), doubts, gait_table(curves.gait, curves.clip.name, curves.clip.fps)

    @app.callback(
        Output(names.CLIP_CHART, "value"),
        Output(names.CLIP_KIND, "value"),
        Output(names.CLIP_KIND_BOX, "className"),
        Output(names.CLIP_JOINTS, "data"),
        Output(names.CLIP_JOINTS, "value"),
        Output(names.CLIP_JOINTS_BOX, "className"),
        Output(names.CLIP_CHANNELS, "children"),
        Output(names.CLIP_CHANNELS, "value"),
        Output(names.CLIP_CHANNELS_BOX, "className"),
        Output(names.CLIP_CHOICE, "data"),
        Input(names.CLIP_SHOWN, "data"),
        Input(VIEW, "data"),
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
        Input(names.CLIP_CHART, "value"),
        Input(names.CLIP_KIND, "value"),
        Input(names.CLIP_JOINTS, "value"),
        Input(names.CLIP_CHANNELS, "value"),
        State(VIEW, "data"),
        State(names.CLIP_CHOICE, "data"),
        prevent_initial_call=True,
    )

    @app.callback(Output(names.CLIP_RANGE, "children"), Input(names.CLIP_SHOWN, "data"), Input(SELECTION, "data"))
    def show_range(shown, selection):
        if not shown:
            return None
        return layout.range_bar(shown["clip"], shown["fps"], shown["frames"], *editing.selected(shown, selection))


def _draw(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.CLIP_GRAPH, "figure"),
        Output(names.CLIP_GRAPH, "style"),
        Output(names.CLIP_LEGEND, "children"),
        Input(names.CLIP_SHOWN, "data"),
        Input(VIEW, "data"),
        Input(THEME, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        State(SELECTION, "data"),
    )
    def draw(shown, view, scheme, _key, selection):
        curves = curves_of(workspace, shown)
        if curves is None:
            return no_update, no_update, no_update
        chosen, scheme = clips.choice(view, curves), scheme or "light"
        if chosen.chart == "path":
            document = path_chart(curves, selection or {}, scheme)
            return document, tall(document), None
        panels = figures.panels_of(clips.chosen_curves(curves, chosen), chosen, scheme)
        doubts = doctor.bands(_findings(workspace, shown), curves.clip, scheme)
        bands = [*doubts, *figures.foot_bands(curves, scheme), *_spans(workspace, shown, view)]
        document = figures.time_chart(curves, panels, bands, chosen, scheme)
        return document, tall(document), layout.legend(panels)

    @app.callback(
        Output(names.CLIP_GRAPH, "figure", allow_duplicate=True),
        Input(SELECTION, "data"),
        State(names.CLIP_SHOWN, "data"),
        State(names.CLIP_DRAWN, "data"),
        State(THEME, "data"),
        prevent_initial_call=True,
    )
    def mark_path(selection, shown, drawn, scheme):
        if drawn != "path" or (curves := curves_of(workspace, shown)) is None:
            return no_update
        changed = Patch()
        changed["data"][1] = selected_part(curves, selection or {}, scheme or "light")
        return changed


def curves_of(workspace: Workspace, shown: Mapping[str, Any] | None) -> ClipCurves | None:
    """The curves of the clip that is shown; None where the clip no longer exists."""
    if not shown:
        return None
    try:
        dataset = workspace.open(shown["dataset"])
        return clips.clip_curves(dataset, shown["clip"])
    except (WorkspaceError, KeyError):
        return None


def _findings(workspace: Workspace, shown: Mapping[str, Any]) -> tuple[Finding, ...]:
    """What was found odd about the clip that is shown."""
    return findings_by_clip(workspace.open(shown["dataset"])).get(shown["clip"], ())


def _spans(workspace: Workspace, shown: Mapping[str, Any], view: Mapping[str, Any] | None) -> list[figures.Band]:
    """Bands of the labels and of the motifs in this clip."""
    dataset = workspace.open(shown["dataset"])
    actions = sorted({label.action for label in dataset.labels})
    labels = [
        figures.Block(label.start, label.end, label.action, motif_colour(actions.index(label.action)))
        for label in dataset.labels
        if label.clip == shown["clip"]
    ]
    bands = figures.lanes("Labels", labels)
    graph = results.motif_graph(workspace, dataset.name, view)
    if graph is not None:
        notes = results.motif_notes(workspace, dataset.name, view)
        motions = [
            figures.Block(s.start, s.end, motif_name(m.id, notes), motif_colour(m.id))
            for m in graph.motifs
            for s in m.segments
            if s.clip == shown["clip"]
        ]
        bands += figures.lanes("Motifs", motions)
    return bands


def _browser(app: Dash) -> None:
    """Registers the clientside callbacks."""
    app.clientside_callback(
        ClientsideFunction("clip", "drawn"),
        Output(names.CLIP_DRAWN, "data"),
        Input(names.CLIP_GRAPH, "figure"),
        Input(names.CLIP_LEGEND, "children"),
        State(names.CLIP_SHOWN, "data"),
        State(VIEW, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("gait", "draw"), Output(names.CLIP_GAIT_DRAWN, "data"), Input(names.CLIP_GAIT_TABLE, "data")
    )
    app.clientside_callback(
        ClientsideFunction("clip", "mark"),
        Output(names.CLIP_MARKED, "data"),
        Input(SELECTION, "data"),
        Input(names.CLIP_SHOWN, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("clip", "seek"),
        Output(names.CLIP_SOUGHT, "data", allow_duplicate=True),
        Input(names.CLIP_SEEK, "data"),
        prevent_initial_call=True,
    )
