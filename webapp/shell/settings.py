"""What pages beyond the motifs are told of their method: the settings of each, kept in the link beside what it shows.

The Motifs page's parameters have names of their own in the link; every other page's settings stand in the store
"view" under ``<page>-<parameter>``, defaults left out. So they are in the link, and stay while one goes from page to
page. A feature names the methods of its page (``Feature.methods``); most have one, called like the page.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from core import analyses
from core.errors import ParameterError
from core.parameters import Parameter
from core.workspace import Job, Workspace, WorkspaceError
from webapp.shell.feature import features

MOST_LETTERS = 300  # of a value in a link


def methods() -> dict[str, str]:
    """Name of the settings in the link -> the method they belong to, of all features."""
    return {name: method for feature in features() for name, method in feature.methods.items()}


def parameters(page: str) -> tuple[Parameter, ...]:
    """The parameters of the page's method."""
    return analyses.parameters(methods()[page])


def keys(page: str) -> tuple[str, ...]:
    """Keys of the page's settings in the store "view" and in links: ``map-grid``."""
    return tuple(f"{page}-{parameter.name}" for parameter in parameters(page))


def request_of(page: str, dataset: str, view: Mapping[str, Any] | None) -> analyses.Request:
    """The request that a view stands for; settings that cannot be used are left at their defaults (see refused)."""
    usable = {}
    for parameter in parameters(page):
        text = (view or {}).get(f"{page}-{parameter.name}")
        if text not in (None, ""):
            try:
                usable[parameter.name] = parameter.parse(text)
            except ParameterError:
                continue
    return analyses.Request(dataset, methods()[page], usable)


def refused(page: str, view: Mapping[str, Any] | None) -> tuple[str, ...]:
    """Why settings of a view cannot be used, one sentence each."""
    problems = []
    for parameter in parameters(page) if page in methods() else ():
        text = (view or {}).get(f"{page}-{parameter.name}")
        if text not in (None, ""):
            try:
                parameter.parse(text)
            except ParameterError as error:
                problems.append(f"{error}.")
    if page in methods() and not problems:
        try:
            analyses.normalise(request_of(page, "", view))
        except ParameterError as error:  # what only its method knows, or what two settings together cannot be
            problems.append(f"{error}.")
    return tuple(problems)


def not_default(page: str, values: Mapping[str, Any]) -> dict[str, str]:
    """Settings as text, by parameter, defaults left out."""
    return {p.name: _text(values[p.name]) for p in parameters(page) if p.name in values and values[p.name] != p.default}


def view_of(page: str, values: Mapping[str, Any]) -> dict[str, str]:
    """What to put into the store "view-change" for these values: ``""``, which takes a key out, for a default."""
    said = not_default(page, values)
    return {f"{page}-{p.name}": said.get(p.name, "") for p in parameters(page)}


def of_other_pages(page: str, view: Mapping[str, str] | None) -> dict[str, str]:
    """The settings of all pages but ``page`` in a view: a link to one page leaves them as they are."""
    others = {key for other in methods() if other != page for key in keys(other)}
    return {key: text for key, text in (view or {}).items() if key in others}


def key_of(workspace: Workspace, page: str, dataset: str | None, view: Mapping[str, Any] | None) -> str | None:
    """Key of the result that a view shows where it is stored and this version can use it, else None."""
    try:
        key = analyses.key(workspace, request_of(page, dataset, view)) if dataset else None
    except (ParameterError, WorkspaceError):
        return None
    return key if key and workspace.results.has(key) else None


def result_of(workspace: Workspace, page: str, dataset: str | None, view: Mapping[str, Any] | None) -> Any | None:
    """The result that a view shows, kept in memory; None where it has not been computed."""
    try:
        return analyses.stored(workspace, request_of(page, dataset, view)) if dataset else None
    except (ParameterError, WorkspaceError):
        return None


def latest_job(workspace: Workspace, page: str, dataset: str | None, view: Mapping[str, Any] | None) -> Job | None:
    """The newest job for the result that a view shows, or None."""
    try:
        return workspace.jobs.latest(analyses.key(workspace, request_of(page, dataset, view))) if dataset else None
    except (ParameterError, WorkspaceError):
        return None


def earlier(workspace: Workspace, page: str, dataset: str | None) -> list[tuple[Job, dict[str, str]]]:
    """Finished jobs of the page's method on the content of ``dataset``, newest first, one a result that this version

    can open, each with its settings (see not_default).
    """
    try:
        fingerprint = workspace.info(dataset).fingerprint if dataset else None
    except WorkspaceError:
        return []
    found: dict[str, tuple[Job, dict[str, str]]] = {}
    for job in workspace.jobs.list(200) if fingerprint else ():
        mine = job.request.get("method") == methods()[page] and job.request.get("fingerprint") == fingerprint
        if job.state == "done" and mine and job.key not in found:
            values = not_default(page, job.request["parameters"])
            if key_of(workspace, page, dataset, view_of(page, job.request["parameters"])) == job.key:
                found[job.key] = job, values
    return list(found.values())


def _text(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else repr(value) if isinstance(value, float) else str(value)
