"""What the blocks of boards show: made once for each state of the data, and kept as it was where the data changes."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal, NamedTuple

from core import analyses
from core.caching import RecentCache
from core.errors import MotionscapeError
from core.mocap.dataset import Dataset
from core.workspace import ResultDamaged, Workspace, WorkspaceError
from webapp.features.boards.parts import Part, fill
from webapp.shell import settings
from webapp.shell.feature import blocks

State = Literal["current", "changed", "gone", "missing", "broken"]
FORMAT = "motionscape/block/1"


class Answer(NamedTuple):
    """What a block shows. state: "current"; "changed": as it was before the data changed; "gone": there is no such
    dataset; "missing": not computed; "broken": it cannot be shown. words: about any but the first, for people.
    pin: what the content was made with, for ``settings["pinned"]``.
    """

    state: State
    content: dict[str, Any] | None
    words: str = ""
    pin: Mapping[str, str] | None = None


def answer(workspace: Workspace, dataset: str, part: Part, pinned: Mapping[str, Any] | None = None) -> Answer:
    """What a block shows of a data set, or of what it was when the block was pinned to it."""
    try:
        present = workspace.open(dataset)
    except WorkspaceError:
        kept = _kept(workspace, part, pinned)
        return Answer("gone", kept, f"The dataset “{dataset}” is no longer here." + _as_kept(kept), pinned)
    if pinned and pinned.get("dataset") == dataset and pinned.get("fingerprint") not in ("", None, present.fingerprint):
        kept = _kept(workspace, part, pinned)
        if kept is not None:
            return Answer("changed", kept, "The data has changed since this was made." + _as_kept(kept), pinned)
    found = _present(workspace, present, part)
    if found.state != "missing" or (kept := _kept(workspace, part, found.pin)) is None:
        return found
    return Answer("missing", kept, found.words + _as_kept(kept), found.pin)  # made with another version of the method


def _present(workspace: Workspace, dataset: Dataset, part: Part) -> Answer:
    block = blocks().get(part.kind)
    if block is None:
        return Answer("broken", None, f"This version has no block of the kind “{part.kind}”.")
    pin = _pin(workspace, dataset, part)
    key = (workspace.path, part.kind, _mark(workspace, dataset, part, pin["key"]))
    if block.lasting and (content := _made.get(key)) is not None:
        return Answer("current", content, "", pin)
    filled = fill(workspace, dataset, part)
    if filled.content is None:
        can_compute = filled.missing and block.method != ""
        return Answer("missing" if can_compute else "broken", None, filled.problem, pin)
    if block.lasting:
        _made.put(key, filled.content)
        _keep(workspace, part, pin, filled.content)
    return Answer("current", filled.content, "", pin)


def pin_of(workspace: Workspace, dataset: str, kind: str, view: Mapping[str, str]) -> dict[str, str] | None:
    """What a block of this kind is pinned to when it is made now; None where there is no such dataset or kind."""
    try:
        present = workspace.open(dataset)
    except WorkspaceError:
        return None
    return _pin(workspace, present, Part(kind, view=view)) if kind in blocks() else None


def _pin(workspace: Workspace, dataset: Dataset, part: Part) -> dict[str, str]:
    return {"dataset": dataset.name, "fingerprint": dataset.fingerprint, "key": _result_key(workspace, dataset, part)}


def request_of(dataset: str, part: Part) -> analyses.Request | None:
    """The request whose result a block shows; None where it shows none."""
    block = blocks().get(part.kind)
    return settings.request_of(block.method, dataset, part.view) if block and block.method else None


def _result_key(workspace: Workspace, dataset: Dataset, part: Part) -> str:
    block = blocks()[part.kind]
    return (settings.key_of(workspace, block.method, dataset.name, part.view) if block.method else None) or ""


def _mark(workspace: Workspace, dataset: Dataset, part: Part, result: str) -> str:
    """Changes with everything that a lasting content depends on."""
    notes = workspace.notes.state(workspace.info(dataset.name).id)
    return _digest([dataset.name, dataset.fingerprint, dataset.labels, result, notes, part.view, part.options])


def _place(part: Part, pinned: Mapping[str, Any]) -> str:
    """The key under which a content is kept as it was; it depends on nothing that changes."""
    return _digest(["block", part.kind, pinned.get("fingerprint"), part.view, part.options])


def _keep(workspace: Workspace, part: Part, pin: Mapping[str, str], content: dict[str, Any]) -> None:
    workspace.results.put(_place(part, pin), {"format": FORMAT, "kind": part.kind, "content": content})


def _kept(workspace: Workspace, part: Part, pinned: Mapping[str, Any] | None) -> dict[str, Any] | None:
    if not pinned:
        return None
    try:
        found = workspace.results.get(_place(part, pinned))
    except (ResultDamaged, MotionscapeError):
        return None
    return found.document.get("content") if found and found.document.get("format") == FORMAT else None


def _as_kept(kept: object) -> str:
    return " It is shown as it was." if kept is not None else ""


def _digest(parts: object) -> str:
    return hashlib.blake2b(json.dumps(parts, sort_keys=True, default=dict).encode(), digest_size=16).hexdigest()


_made: RecentCache[tuple[Path, str, str], dict[str, Any]] = RecentCache(200)
