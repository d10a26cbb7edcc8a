"""Results that the views show: which request the URL's parameters stand for, and its answer if there is one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from core import analyses
from core.errors import ParameterError
from core.motifs.graph import Edge, Motif, MotifGraph
from core.workspace import Job, MotifNote, Workspace, WorkspaceError

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


def motif_notes(workspace: Workspace, dataset: str, parameters: Mapping[str, Any] | None) -> dict[int, MotifNote]:
    """What people said of the motifs of this result, by motif id; empty where there is no result."""
    graph, key = motif_graph(workspace, dataset, parameters), motif_graph_key(workspace, dataset, parameters)
    if graph is None or key is None:
        return {}
    return workspace.notes.of(workspace.info(dataset).id, key, {motif.id: motif.segments for motif in graph.motifs})


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
