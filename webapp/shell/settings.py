"""The settings of methods, kept in the link beside what a page shows.

All settings stand in the store "view" as text, defaults left out: ``map-grid`` is the grid of the map. So they are in
the link, and stay when another page is opened. A feature names the methods of its page (``Feature.methods``);
most have one, with the name of the page. Where other pages show the result too, the settings stand in the links of all
pages, under the names of the parameters alone (``Feature.on_every_page``): ``kappa`` of the motifs.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from core import analyses
from core.errors import ParameterError
from core.parameters import Parameter, write_value
from core.workspace import Job, Workspace, WorkspaceError
from webapp.shell.feature import features

MOST_LETTERS = 300  # of a value in a link


def methods() -> dict[str, str]:
    """Name of the settings in the link -> the method they belong to, of all features."""
    return {name: method for feature in features() for name, method in feature.methods.items()}


def parameters(name: str) -> tuple[Parameter, ...]:
    """The parameters of the method that has its settings under ``name``."""
    return analyses.parameters(methods()[name])


def key(name: str, parameter: str) -> str:
    """The key of one setting in the store "view" and in links: ``map-grid``, or ``kappa``."""
    return parameter if any(name in feature.on_every_page for feature in features()) else f"{name}-{parameter}"


def keys(name: str) -> tuple[str, ...]:
    """The keys of all settings under ``name``, in the order of the parameters."""
    return tuple(key(name, parameter.name) for parameter in parameters(name))


def keys_on_every_page() -> tuple[str, ...]:
    """The keys of settings that stand in the links of all pages."""
    return tuple(key for feature in features() for name in feature.on_every_page for key in keys(name))


def texts(name: str, view: Mapping[str, Any] | None) -> dict[str, str]:
    """The settings under ``name`` among what a view holds, as they stand in a link, in the order of the parameters."""
    return {key: view[key] for key in keys(name) if key in view} if view else {}


def request_of(name: str, dataset: str, view: Mapping[str, Any] | None) -> analyses.Request:
    """The request that a view stands for; settings that cannot be used are left at their defaults (see refused)."""
    return analyses.Request(dataset, methods()[name], _read(name, view)[0])


def refused(name: str, view: Mapping[str, Any] | None) -> tuple[str, ...]:
    """Why settings of a view cannot be used, one sentence each; also where two do not go together."""
    values, problems = _read(name, view)
    if not problems:
        problem = _problem(name, values)  # what only the method knows, or what two settings together cannot be
        return (problem,) if problem else ()
    return tuple(problems.values())


def usable(page: str, view: Mapping[str, str]) -> tuple[dict[str, str], tuple[str, ...]]:
    """A view whose settings can all be used, defaults left out; and why others could not, one sentence each.

    Whether settings go together is checked for the methods of ``page`` alone: a sweep puts other values in the place of
    those that stand in the link.
    """
    usable_view = dict(view)
    problems: list[str] = []
    for feature in features():
        for name in feature.methods:
            values, wrong = _read(name, view)
            problems += wrong.values()
            if feature.path == page and not wrong and (problem := _problem(name, values)):
                problems.append(problem)
                values = _going_together(name, values)
            usable_view = {k: text for k, text in usable_view.items() if k not in keys(name)} | in_link(name, values)
    return usable_view, tuple(problems)


def not_default(name: str, values: Mapping[str, Any]) -> dict[str, str]:
    """Settings as text, by parameter, defaults left out."""
    return {
        p.name: write_value(values[p.name])
        for p in parameters(name)
        if p.name in values and values[p.name] != p.default
    }


def view_of(name: str, values: Mapping[str, Any]) -> dict[str, str]:
    """What to put into the store "view-change" for these values: ``""``, which takes a key out, for a default."""
    texts = not_default(name, values)
    return {key(name, p.name): texts.get(p.name, "") for p in parameters(name)}


def in_link(name: str, values: Mapping[str, Any]) -> dict[str, str]:
    """These values as they stand in a link: key -> text, defaults left out."""
    return {key: text for key, text in view_of(name, values).items() if text}


def write_list(name: str, values: Mapping[str, Any]) -> str:
    """Settings as one text: ``kappa:250,seed:1``; those with default values left out."""
    return ",".join(f"{parameter}:{text}" for parameter, text in sorted(not_default(name, values).items()))


def read_list(name: str, text: str) -> dict[str, str]:
    """What :func:`write_list` wrote, as a view holds it; what makes no sense is left out."""
    pairs = (part.partition(":") for part in text.split(",") if ":" in part)
    texts_given = {key(name, parameter.strip()): value.strip() for parameter, _, value in pairs}
    return in_link(name, request_of(name, "", texts_given).parameters)


def of_other_pages(page: str, view: Mapping[str, str] | None) -> dict[str, str]:
    """The settings in a view that a link to ``page`` says nothing of, and so leaves as they are."""
    others = {k for feature in features() if feature.path != page for name in feature.methods for k in keys(name)}
    return {key: text for key, text in (view or {}).items() if key in others - set(keys_on_every_page())}


def key_of(workspace: Workspace, name: str, dataset: str | None, view: Mapping[str, Any] | None) -> str | None:
    """Key of the result that a view shows where it is stored and this version can use it, else None."""
    try:
        key = analyses.key(workspace, request_of(name, dataset, view)) if dataset else None
    except (ParameterError, WorkspaceError):
        return None
    return key if key and workspace.results.has(key) else None


def result_of(workspace: Workspace, name: str, dataset: str | None, view: Mapping[str, Any] | None) -> Any | None:
    """The result that a view shows, kept in memory; None where it has not been computed."""
    try:
        return analyses.stored(workspace, request_of(name, dataset, view)) if dataset else None
    except (ParameterError, WorkspaceError):
        return None


def latest_job(workspace: Workspace, name: str, dataset: str | None, view: Mapping[str, Any] | None) -> Job | None:
    """The newest job for the result that a view shows, or None."""
    try:
        return workspace.jobs.latest(analyses.key(workspace, request_of(name, dataset, view))) if dataset else None
    except (ParameterError, WorkspaceError):
        return None


def earlier(workspace: Workspace, name: str, dataset: str | None) -> list[tuple[Job, dict[str, str]]]:
    """Finished jobs of the method on ``dataset`` with their settings (see not_default), newest first.

    Each result is listed once, and only where this version can open it.
    """
    try:
        fingerprint = workspace.info(dataset).fingerprint if dataset else None
    except WorkspaceError:
        return []
    past: dict[str, tuple[Job, dict[str, str]]] = {}
    for job in workspace.jobs.list(200) if fingerprint else ():
        same_dataset = job.request.get("method") == methods()[name] and job.request.get("fingerprint") == fingerprint
        if job.state == "done" and same_dataset and job.key not in past:
            values = job.request["parameters"]
            if key_of(workspace, name, dataset, view_of(name, values)) == job.key:
                past[job.key] = job, not_default(name, values)
    return list(past.values())


def _read(name: str, view: Mapping[str, Any] | None) -> tuple[dict[str, Any], dict[str, str]]:
    """Values of a view by parameter, and what is wrong with the others: parameter -> sentence."""
    texts_in_view = texts(name, view)
    values: dict[str, Any] = {}
    problems: dict[str, str] = {}
    for parameter in parameters(name) if texts_in_view else ():
        text = texts_in_view.get(key(name, parameter.name))
        if text not in (None, ""):
            try:
                values[parameter.name] = parameter.parse(text)
            except ParameterError as error:
                problems[parameter.name] = f"{error}."
    return values, problems


def _problem(name: str, values: Mapping[str, Any]) -> str:
    """Why the method cannot take these values together, as a sentence; empty where it can."""
    try:
        analyses.normalise(analyses.Request("", methods()[name], values))
    except ParameterError as error:
        return f"{error}."
    return ""


def _going_together(name: str, values: Mapping[str, Any]) -> dict[str, Any]:
    """The values without the last one whose absence makes them valid; empty where no single one does."""
    for left_out in reversed(list(values)):
        others = {parameter: value for parameter, value in values.items() if parameter != left_out}
        if not _problem(name, others):
            return others
    return {}
