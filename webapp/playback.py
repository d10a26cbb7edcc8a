"""From what is selected to what the Stage plays: pure functions, and the one callback that uses them."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from dash import Dash, Input, Output, State, no_update, set_props

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import Edge, Motif, MotifGraph
from core.workspace import Workspace, WorkspaceError
from webapp import actions_playing
from webapp.components.errors import notice
from webapp.figures.tables import clock
from webapp.results import comparing, mixing, motif_graph, motif_notes

MOST_FIGURES = 24  # the Stage stays fluid; more bodies would hide one another anyway
AROUND = 1.0  # seconds of motion before and after a transition

Request = dict[str, Any]


def stage_request(
    dataset: Dataset,
    graph: MotifGraph | None,
    selection: Mapping[str, Any],
    names: Mapping[int, str] = MappingProxyType({}),
) -> Request | None:
    """What to play for ``selection`` (see links.View), None where it names nothing that is there; names: of motifs."""
    if "clip" in selection:
        return _clip(dataset, selection)
    if graph is None:
        return None
    if "motif" in selection:
        return _motif(dataset, graph, selection, names)
    return _edge(dataset, graph, selection) if "edge" in selection else None


def find_motif(graph: MotifGraph, number: Any) -> Motif | None:
    """The motif with this id, or None."""
    return next((motif for motif in graph.motifs if str(motif.id) == str(number)), None)


def find_motifs(graph: MotifGraph, selection: Mapping[str, Any]) -> list[Motif]:
    """The motifs that a selection names, one or several; those that are not there left out."""
    wanted = set(str(selection.get("motifs", selection.get("motif", ""))).split("-"))
    return [motif for motif in graph.motifs if str(motif.id) in wanted]


def find_edge(graph: MotifGraph, name: Any) -> Edge | None:
    """The edge called ``"source-target"``, or None."""
    return next((edge for edge in graph.edges if f"{edge.source}-{edge.target}" == str(name)), None)


def shown_motions(motif: Motif, most: int = MOST_FIGURES) -> list[int]:
    """Indices of the motions that play together: all, or the medoid and others spread evenly over the list."""
    n = len(motif.segments)
    if n <= most:
        return list(range(n))
    picked = {motif.medoid, *(round(i * (n - 1) / (most - 1)) for i in range(most))}
    return sorted(picked, key=lambda i: (i != motif.medoid, i))[:most]


def transition_segment(dataset: Dataset, graph: MotifGraph, edge: Edge, number: int) -> Segment:
    """End of the motion before, the frames in between, start of the motion after: one segment of the clip."""
    between = edge.transitions[number]
    source, target = find_motif(graph, edge.source), find_motif(graph, edge.target)
    clip = dataset.clip(between.clip)
    margin = round(AROUND * clip.fps)
    before = [s.start for s in source.segments if s.clip == between.clip and s.end == between.start] if source else []
    after = [s.end for s in target.segments if s.clip == between.clip and s.start == between.end] if target else []
    low, high = min(between.start, between.end), max(between.start, between.end)
    start = max(low - margin, min(before, default=0), 0)
    end = min(high + margin, max(after, default=clip.n_frames), clip.n_frames)
    return Segment(between.clip, start, max(end, start + 1))


def moment(dataset: Dataset, segment: Segment) -> str:
    """Where in its clip a segment lies: ``0:03.2 to 0:04.9``."""
    fps = dataset.clip(segment.clip).fps
    return f"{clock(segment.start / fps)} to {clock(segment.end / fps)}"


def _clip(dataset: Dataset, selection: Mapping[str, Any]) -> Request | None:
    try:
        clip = dataset.clip(str(selection["clip"]))
    except (KeyError, ValueError):
        return None
    start, end = int(selection.get("start", 0)), int(selection.get("end", clip.n_frames))
    start, end = (start, min(end, clip.n_frames)) if start < clip.n_frames and end > start else (0, clip.n_frames)
    return _request(dataset, [_item(clip.name, start, end, clip.name)], clip.name)


def _motif(
    dataset: Dataset, graph: MotifGraph, selection: Mapping[str, Any], names: Mapping[int, str]
) -> Request | None:
    motif = find_motif(graph, selection["motif"])
    if motif is None:
        return None
    called = names.get(motif.id) or f"Motif {motif.id}"
    alone = selection.get("motion")
    if alone is not None and 0 <= int(alone) < len(motif.segments):
        segment = motif.segments[int(alone)]
        title = f"{called}, motion {int(alone) + 1} of {len(motif.segments)}"
        return _request(dataset, [_item(*segment, segment.clip)], title)
    shown = shown_motions(motif)
    items = [
        _item(*motif.segments[i], motif.segments[i].clip, [round(float(f), 2) for f in motif.warps[i]]) for i in shown
    ]
    count = f"{len(shown)} of {len(motif.segments)}" if len(shown) < len(motif.segments) else f"{len(shown)}"
    return _request(dataset, items, f"{called}: {count} motion{'s' if len(motif.segments) != 1 else ''}")


def _edge(dataset: Dataset, graph: MotifGraph, selection: Mapping[str, Any]) -> Request | None:
    edge = find_edge(graph, selection["edge"])
    if edge is None or not edge.transitions:
        return None
    number = int(selection.get("transition", 0))
    number = number if 0 <= number < len(edge.transitions) else 0
    segment = transition_segment(dataset, graph, edge, number)
    title = f"From motif {edge.source} to {edge.target}, {number + 1} of {len(edge.transitions)}"
    return _request(dataset, [_item(*segment, segment.clip)], title)


def _item(clip: str, start: int, end: int, label: str, warp: list[float] | None = None) -> dict[str, Any]:
    return {"clip": clip, "start": int(start), "end": int(end), "label": label, "warp": warp}


def _request(dataset: Dataset, items: list[dict[str, Any]], title: str) -> Request:
    content = {"dataset": dataset.name, "version": dataset.fingerprint, "items": items, "title": title}
    return {**content, "layout": "overlay", "sync": "warp"}


def selected_request(
    workspace: Workspace,
    dataset_name: str | None,
    parameters: Mapping[str, Any] | None,
    selection: Mapping[str, Any] | None,
    view: Mapping[str, str] | None,
) -> Request | None:
    """What plays when this is selected on a page that shows ``view``; None where nothing does."""
    if not selection or not dataset_name:
        return None
    if comparing(view) and "motif" in selection and "motion" not in selection:
        return None  # the comparison plays both results (pages/motifs/compare_view.py)
    if mixing(view) and "motif" in selection and "motion" not in selection:
        return None  # the mixture plays (assets/blend.js)
    try:
        dataset = workspace.open(dataset_name)
        if "action" in selection or selection.get("as") == "actions":
            return actions_playing.stage_request(workspace, dataset, view, selection)
        graph = motif_graph(workspace, dataset_name, parameters) if "clip" not in selection else None
        said = motif_notes(workspace, dataset_name, parameters) if "motif" in selection else {}
        names = {motif: note.name for motif, note in said.items()}
        return stage_request(dataset, graph, selection, names)
    except WorkspaceError:
        return None


def missing(
    workspace: Workspace,
    dataset_name: str | None,
    parameters: Mapping[str, Any] | None,
    selection: Mapping[str, Any],
    view: Mapping[str, str] | None = None,
) -> str | None:
    """What a selection names that is not there, in plain words; None where it is, or where nobody can tell yet."""
    if not selection or not dataset_name:
        return None
    try:
        if "clip" in selection:
            known = selection["clip"] in workspace.open(dataset_name).names
            return None if known else f"“{dataset_name}” has no clip called “{selection['clip']}”."
        if "action" in selection:
            return actions_playing.missing(workspace, dataset_name, view, selection)
        graph = motif_graph(workspace, dataset_name, parameters)
    except WorkspaceError:
        return None
    if graph is None:
        return None
    if "motif" in selection and find_motif(graph, selection["motif"]) is None:
        return f"The result shown has no motif {selection['motif']}; it has {len(graph.motifs)} motifs."
    if "motifs" in selection and not find_motifs(graph, selection):
        return f"The result shown has none of the motifs of the link; it has {len(graph.motifs)} motifs."
    if "edge" in selection and find_edge(graph, selection["edge"]) is None:
        return f"In the result shown, no motion leads from motif {str(selection['edge']).replace('-', ' to ')}."
    return None


def register(app: Dash, workspace: Workspace) -> None:
    """The selection plays, whichever page it was made on."""

    @app.callback(
        Output("stage-request", "data"),
        Input("selection", "data"),
        Input("graph-key", "data"),
        State("view", "data"),
        State("dataset", "data"),
        State("parameters", "data"),
        prevent_initial_call=True,
    )
    def play(selection, _key, view, dataset_name, parameters):
        gone = missing(workspace, dataset_name, parameters, selection, view)
        if gone:
            set_props("notices", {"sendNotifications": [notice("That is not there", gone, "orange", id="not-there")]})
            set_props("selection", {"data": {}})
        return selected_request(workspace, dataset_name, parameters, selection, view) or no_update
