"""Results that the views show: which request the URL's parameters stand for, and its answer if there is one."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from core import analyses
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.parameters import ParameterError
from core.workspace import Job, MotifNote, Workspace, WorkspaceError
from webapp.components.filmstrip import icon_data_uri
from webapp.figures import graph as graph_figure

if TYPE_CHECKING:
    from core.motifs.stability import Stability

MOTIFS = "motifs"
STABILITY = "stability"


def motif_request(dataset: str, parameters: Mapping[str, Any] | None) -> analyses.Request:
    """The request behind ``parameters``; unusable values are left at their defaults (see :func:`refused`)."""
    usable = {}
    for parameter in analyses.parameters(MOTIFS):
        if parameter.name in (parameters or {}):
            try:
                usable[parameter.name] = parameter.parse(parameters[parameter.name])
            except ParameterError:
                continue
    return analyses.Request(dataset, MOTIFS, usable)


def refused(parameters: Mapping[str, Any]) -> tuple[str, ...]:
    """Why values among ``parameters`` cannot be used, one sentence each."""
    problems = []
    for parameter in analyses.parameters(MOTIFS):
        if parameter.name in parameters:
            try:
                parameter.parse(parameters[parameter.name])
            except ParameterError as error:
                problems.append(f"{error}.")
    return tuple(problems)


def not_default(parameters: Mapping[str, Any]) -> dict[str, str]:
    """Parameters as they stand in a link: text, defaults left out."""
    defaults = {parameter.name: parameter.default for parameter in analyses.parameters(MOTIFS)}
    return {
        name: f"{value:g}" if isinstance(value, float) else str(value)
        for name, value in parameters.items()
        if name in defaults and value != defaults[name]
    }


def motif_graph(workspace: Workspace, dataset: str, parameters: Mapping[str, Any] | None) -> MotifGraph | None:
    """The graph if it has been computed; kept in memory, so that a click costs no reading."""
    try:
        return analyses.stored(workspace, motif_request(dataset, parameters))
    except ParameterError:
        return None


def motif_notes(workspace: Workspace, dataset: str, parameters: Mapping[str, Any] | None) -> dict[int, MotifNote]:
    """What people said of the motifs of this result, by motif id; empty where there is no result."""
    graph, key = motif_graph(workspace, dataset, parameters), motif_graph_key(workspace, dataset, parameters)
    if graph is None or key is None:
        return {}
    return workspace.notes.of(workspace.info(dataset).id, key, {motif.id: motif.segments for motif in graph.motifs})


def comparing(view: Mapping[str, str] | None) -> bool:
    """Whether the Motifs page compares the result with another: a motif then plays beside its partners there."""
    return (view or {}).get("view") == "compare" and bool((view or {}).get("other"))


def mixing(view: Mapping[str, str] | None) -> bool:
    """Whether the Motifs page mixes motions: a motif then plays as its mixture (assets/blend.js)."""
    return (view or {}).get("side") == "blend"


def walking(view: Mapping[str, str] | None) -> bool:
    """Whether the Motifs page makes walks: clicks on motifs are then steps (assets/walk.js)."""
    return (view or {}).get("side") == "walk"


def stability_request(dataset: str, parameters: Mapping[str, Any] | None, text: str | None) -> analyses.Request:
    """The request for the stability of the motifs of these parameters; text: repetitions and degrees of noise, as in
    a link (``2,1.5``), left at their defaults where they make no sense."""
    known = {parameter.name: parameter for parameter in analyses.parameters(STABILITY)}
    values = dict(motif_request(dataset, parameters).parameters)
    for name, word in zip(("repetitions", "noise_degrees"), (text or "").split(","), strict=False):
        try:
            values[name] = known[name].parse(word)
        except ParameterError:
            continue
    return analyses.Request(dataset, STABILITY, values)


def stability(
    workspace: Workspace, dataset: str, parameters: Mapping[str, Any] | None, text: str | None
) -> Stability | None:
    """How stable the motifs are, where it has been measured."""
    try:
        return analyses.stored(workspace, stability_request(dataset, parameters, text))
    except (ParameterError, WorkspaceError):
        return None


def stability_job(
    workspace: Workspace, dataset: str, parameters: Mapping[str, Any] | None, text: str | None
) -> Job | None:
    """The newest job that measures it, or None."""
    try:
        return workspace.jobs.latest(analyses.key(workspace, stability_request(dataset, parameters, text)))
    except (ParameterError, WorkspaceError):
        return None


def latest_job(workspace: Workspace, dataset: str, parameters: Mapping[str, Any] | None) -> Job | None:
    """The newest job for this very request, or None."""
    try:
        return workspace.jobs.latest(analyses.key(workspace, motif_request(dataset, parameters)))
    except (ParameterError, WorkspaceError):
        return None


def earlier(workspace: Workspace, dataset: str) -> list[Job]:
    """Finished motif jobs on the content of ``dataset``, newest first, one a result that this version can open."""
    try:
        fingerprint = workspace.info(dataset).fingerprint
    except WorkspaceError:
        return []
    found: dict[str, Job] = {}
    for job in workspace.jobs.list(200):
        request = job.request
        if job.state == "done" and request.get("method") == MOTIFS and request.get("fingerprint") == fingerprint:
            found.setdefault(job.key, job)
    return [job for job in found.values() if motif_graph_key(workspace, dataset, job.request["parameters"]) == job.key]


def motif_graph_key(workspace: Workspace, dataset: str, parameters: Mapping[str, Any] | None) -> str | None:
    """Key of the graph where it is stored and this version can use it, else None."""
    try:
        key = analyses.key(workspace, motif_request(dataset, parameters))
    except (ParameterError, WorkspaceError):
        return None
    return key if workspace.results.has(key) else None


def graph_elements(dataset: Dataset, key: str, graph: MotifGraph) -> list[dict[str, Any]]:
    """Cytoscape elements, placed and drawn once a result: the layout and the icons are the slow part of showing it."""
    with _lock:
        if key not in _drawn:
            icons = graph_figure.icon_addresses(graph, lambda segment, scheme: icon_data_uri(dataset, segment, scheme))
            _drawn[key] = graph_figure.graph_elements(graph, icons)
            while len(_drawn) > _KEPT_DRAWINGS:
                _drawn.pop(next(iter(_drawn)))
        return _drawn[key]


_drawn: dict[str, list[dict[str, Any]]] = {}  # by the result's key: the same key always stands for the same drawing
_lock = threading.Lock()
_KEPT_DRAWINGS = 16
