"""What people said and arranged about a data set: properties of its clips, notes, saved views, boards with comments."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any
from urllib.parse import parse_qsl, urlencode, urlsplit

from core.bundles.manifest import plain
from core.errors import FormatError, ParameterError
from core.mocap.dataset import Dataset
from core.mocap.properties import Properties, from_json
from core.workspace import Workspace, WorkspaceError
from core.workspace.blocks import Block
from core.workspace.clip_properties import present_properties


def said_of(workspace: Workspace, dataset: Dataset) -> dict[str, list[dict[str, Any]]]:
    """What people said and arranged about a data set: notes, saved views, boards, properties of its clips."""
    boards = [board for board in workspace.boards.all() if _shows(asdict(board), dataset.name)]
    views = [view for view in workspace.views.all() if _dataset_in(view.address) == dataset.name]
    return {
        "notes": workspace.notes.all(workspace.info(dataset.name).id),
        "views": sorted(
            ({"address": v.address, "title": v.title, "note": v.note, "tags": list(v.tags)} for v in views), key=plain
        ),
        "boards": sorted(
            (
                {
                    "title": board.title,
                    "note": board.note,
                    "filters": dict(board.filters),
                    "blocks": [_bare(asdict(block)) for block in board.blocks],
                    "comments": _comments(workspace, board.id),
                }
                for board in boards
            ),
            key=plain,
        ),
        "properties": [known.to_json()] if (known := present_properties(workspace, dataset.name)).columns else [],
    }


def _bare(block: dict[str, Any]) -> dict[str, Any]:
    return {name: block[name] for name in ("id", "kind", "x", "y", "w", "h", "settings")}


def _comments(workspace: Workspace, board: str) -> list[dict[str, Any]]:
    """The comments of a board; parent: the number of the comment that one answers."""
    comments = workspace.comments.under(f"board:{board}")
    number = {comment.id: k for k, comment in enumerate(comments)}
    return [
        {
            "block": comment.place.partition("/block:")[2],
            "text": comment.text,
            "author": comment.author,
            "resolved": comment.resolved,
            "parent": number.get(comment.parent) if comment.parent else None,
        }
        for comment in comments
    ]


def _shows(value: object, dataset: str) -> bool:
    if isinstance(value, Mapping):
        return value.get("dataset") == dataset or any(_shows(part, dataset) for part in value.values())
    return isinstance(value, list | tuple) and any(_shows(part, dataset) for part in value)


def say(
    workspace: Workspace, dataset: str, before: str, said: Mapping[str, list[dict[str, Any]]]
) -> tuple[int, int, int]:
    """Keeps notes, views and boards that are not there yet; how many of each. Raises WorkspaceError."""
    try:
        id = workspace.info(dataset).id
        _say_properties(workspace, dataset, id, said.get("properties", ()))
        notes = [note for note in said["notes"] if note not in workspace.notes.all(id)]
        for note in notes:
            texts = {name: note[name] for name in ("name", "tags", "note")}
            workspace.notes.put(id, str(note["result"]), int(note["motif"]), note["segments"], **texts)
        present = said_of(workspace, workspace.open(dataset))
        views = [view for view in _renamed(said["views"], before, dataset) if view not in present["views"]]
        for view in views:
            workspace.views.save(view["address"], view["title"], view["note"], view["tags"])
        boards = [board for board in _renamed(said["boards"], before, dataset) if board not in present["boards"]]
        for board in boards:
            _make_board(workspace, board)
    except (KeyError, TypeError, AttributeError, IndexError, FormatError, ParameterError) as error:
        raise WorkspaceError(
            f"What the bundle says of notes, properties, views and boards is incomplete ({error!r})."
        ) from error
    return len(notes), len(views), len(boards)


def _say_properties(workspace: Workspace, dataset: str, id: str, kept: Sequence[Mapping[str, Any]]) -> None:
    """Properties of clips that have none in that column yet."""
    present = workspace.properties.of(id)
    for document in kept:
        come = from_json(document).of_clips(workspace.open(dataset).names)
        missing = {
            clip: {name: value for name, value in own.items() if name not in present.values.get(clip, {})}
            for clip, own in come.values.items()
        }
        if any(missing.values()):
            both = present.with_values(missing)
            columns = {
                name: come.columns.get(name, kind) if name not in present.columns else kind
                for name, kind in both.columns.items()
            }
            workspace.properties.put(id, Properties(columns, both.values), "from a bundle")


def _make_board(workspace: Workspace, board: Mapping[str, Any]) -> None:
    blocks = [
        Block(**{name: block[name] for name in ("id", "kind", "x", "y", "w", "h", "settings")})
        for block in board["blocks"]
    ]
    made = workspace.boards.create(board["title"], blocks, note=board["note"])
    if board["filters"]:
        workspace.boards.set_filters(made.id, board["filters"])
    ids: list[str] = []
    for comment in board["comments"]:
        place = f"board:{made.id}" + (f"/block:{comment['block']}" if comment["block"] else "")
        parent = None if comment["parent"] is None else ids[comment["parent"]]
        kept = workspace.comments.add(place, comment["text"], comment["author"], parent)
        ids.append(kept.id)
        if comment["resolved"]:
            workspace.comments.resolve(kept.id)


def _renamed(value: Any, before: str, now: str) -> Any:
    """The same with another name of the data set: where something says which, and in addresses."""
    if isinstance(value, Mapping):
        return {
            key: now
            if key == "dataset" and part == before
            else _address(part, before, now)
            if key == "address"
            else _renamed(part, before, now)
            for key, part in value.items()
        }
    return [_renamed(part, before, now) for part in value] if isinstance(value, list) else value


def _address(address: Any, before: str, now: str) -> Any:
    if before == now or _dataset_in(str(address)) != before:
        return address
    parts = urlsplit(str(address))
    pairs = [(key, now if key == "dataset" else text) for key, text in parse_qsl(parts.query)]
    return f"{parts.path}?{urlencode(pairs)}"


def _dataset_in(address: str) -> str | None:
    return dict(parse_qsl(urlsplit(address).query)).get("dataset")
