"""Comparisons as the page asks for them: from what a link says to the request, and its result with names of motifs."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

from core import analyses
from core.comparing import design_json
from core.errors import ParameterError
from core.groups.design import SUBJECT_NAMES, make_design
from core.workspace import Job, Workspace
from core.workspace.clip_properties import present_properties
from webapp.shell import settings
from webapp.shell.results import motif_notes

COUNTED = ("motifs", "grammar", "labels")
MOST_VALUES = 200


def choices(workspace: Workspace, dataset: str) -> dict[str, Any]:
    """What can be compared: ``columns`` with values, ``who``: the property that names who moves, ``labels``: any?"""
    known = present_properties(workspace, dataset)
    values = {column: known.groups(column) for column in known.columns}
    columns = [
        {"name": name, "values": [[value, len(clips)] for value, clips in list(own.items())[:MOST_VALUES]]}
        for name, own in values.items()
    ]
    who = next((name for name in known.columns if name.lower() in SUBJECT_NAMES), "")
    return {"columns": columns, "who": who, "labels": bool(workspace.open(dataset).labels)}


def request_of(workspace: Workspace, dataset: str, link: Mapping[str, str]) -> analyses.Request:
    """The request behind a link. Raises ParameterError, AnalysisError, WorkspaceError in plain words."""
    opened = workspace.open(dataset)
    counted = link.get("counted") or ("labels" if opened.labels else "motifs")
    if counted not in COUNTED:
        raise ParameterError("What is counted is motifs, grammar or labels.")
    if counted == "labels" and not opened.labels:
        raise ParameterError("These recordings have no labels to count; choose motifs or actions.")
    who, chosen = link.get("who"), [link[key] for key in ("first", "second") if link.get(key)]
    design = make_design(
        present_properties(workspace, dataset),
        opened.names,
        link.get("by", ""),
        subject="" if who == "-" else who or None,
        groups=chosen,
        paired=_paired(link.get("paired", "")),
    )
    values: dict[str, Any] = {"of": counted, "design": design_json(design), "on_map": True}
    if counted != "labels":
        values["settings"] = json.dumps(dict(settings.request_of(counted, dataset, link).parameters))
    return analyses.Request(dataset, "groups", values)


def _paired(text: str) -> Any:
    if text not in ("", "auto", "yes", "no"):
        raise ParameterError("paired is auto, yes or no.")
    return text or "auto"


def state_of(workspace: Workspace, request: analyses.Request, link: Mapping[str, str]) -> dict[str, Any]:
    """``state``: "ready" with the ``document``, "running" with ``stage`` and ``fraction``, "failed" with ``error``, or
    "missing"."""
    document = analyses.stored(workspace, request)
    if document is not None:
        return {"state": "ready", "document": named(workspace, request.dataset, document, link)}
    job: Job | None = workspace.jobs.latest(analyses.key(workspace, request))
    if job is not None and job.alive:
        return {"state": "running", "stage": job.stage or "waiting", "fraction": round(job.fraction, 2)}
    if job is not None and job.state == "failed":
        return {"state": "failed", "error": job.error}
    return {"state": "missing"}


def named(workspace: Workspace, dataset: str, document: dict[str, Any], link: Mapping[str, str]) -> dict[str, Any]:
    """A document with the names that people gave to motifs in place of their numbers."""
    notes = motif_notes(workspace, dataset, link)
    names = {str(motif): note.name for motif, note in notes.items() if note.name}
    if not names or not any(row["kind"] == "motif" for row in document["comparisons"]):
        return document

    def spoken(text: str) -> str:
        return re.sub(r"\bmotif (\d+)\b", lambda found: names.get(found[1], found[0]), text)

    rows = {part: [_renamed(row, spoken) for row in document[part]] for part in ("comparisons", "transitions")}
    words = [one | {"text": spoken(one["text"])} for one in document["words"]]
    return {**document, **rows, "words": words}


def _renamed(row: dict[str, Any], spoken: Any) -> dict[str, Any]:
    return {**row, "name": spoken(row["name"]), **({"words": spoken(row["words"])} if "words" in row else {})}
