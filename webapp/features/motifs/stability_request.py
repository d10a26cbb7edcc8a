"""The stability of the motifs that a view shows: its settings in the link, its request and its result."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from core import analyses
from core.errors import ParameterError
from core.parameters import write_value
from core.workspace import Job, Workspace, WorkspaceError
from webapp.shell import results, settings

if TYPE_CHECKING:
    from core.motifs.stability import Stability

METHOD = "stability"
NAMES = ("repetitions", "noise_degrees")  # of the parameters, in the order in which they stand in the link


def write(repetitions: float, noise_degrees: float) -> str:
    """Repetitions and degrees of noise as they stand in a link: ``2,1.5``."""
    return f"{write_value(repetitions)},{write_value(noise_degrees)}"


def request(dataset: str, view: Mapping[str, Any] | None, text: str | None) -> analyses.Request:
    """The request for the stability of the motifs that ``view`` shows.

    text: see :func:`write`; values that make no sense are left at their defaults.
    """
    known = {parameter.name: parameter for parameter in analyses.parameters(METHOD)}
    values = dict(settings.request_of(results.MOTIFS, dataset, view).parameters)
    for name, word in zip(NAMES, (text or "").split(","), strict=False):
        try:
            values[name] = known[name].parse(word)
        except ParameterError:
            continue
    return analyses.Request(dataset, METHOD, values)


def stored(workspace: Workspace, dataset: str, view: Mapping[str, Any] | None, text: str | None) -> Stability | None:
    """How stable the motifs are, where it has been measured."""
    try:
        return analyses.stored(workspace, request(dataset, view, text))
    except (ParameterError, WorkspaceError):
        return None


def latest_job(workspace: Workspace, dataset: str, view: Mapping[str, Any] | None, text: str | None) -> Job | None:
    """The newest job that measures it, or None."""
    try:
        return workspace.jobs.latest(analyses.key(workspace, request(dataset, view, text)))
    except (ParameterError, WorkspaceError):
        return None
