"""Boards, saved views and comments as the browser gets them."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict
from typing import Any
from urllib.parse import urlencode

from core.workspace import Board, Comment, SavedView, Workspace, WorkspaceError, acting, pinned_state
from core.workspace.blocks import Block
from core.workspace.boards import shown
from core.workspace.clip_properties import present_properties
from webapp.features.boards.contents import request_of
from webapp.features.boards.parts import Part
from webapp.shell import settings
from webapp.shell.feature import blocks

MOST_NAMES = 40
MOST_GROUPS = 60  # values of a property that a board offers to narrow itself to


def fingerprints(workspace: Workspace) -> dict[str, str]:
    """Name of each dataset -> fingerprint of what it holds now."""
    return {info.name: info.fingerprint for info in workspace.datasets()}


def board_mark(workspace: Workspace, id: str) -> str:
    """Changes with everything that :func:`board_data` says, by a few cheap queries; raises DocumentGone."""
    parts = [workspace.boards.version(id), workspace.comments.state(f"board:{id}"), fingerprints(workspace)]
    parts += [acting().may_change_board(id), acting().name]
    parts += [workspace.properties.state(info.id) for info in workspace.datasets()]
    return hashlib.blake2b(json.dumps(parts, sort_keys=True).encode(), digest_size=12).hexdigest()


def board_data(workspace: Workspace, id: str) -> dict[str, Any]:
    """A board with its comments; raises DocumentGone, DocumentDamaged."""
    board, known = workspace.boards.get(id), fingerprints(workspace)
    comments = workspace.comments.under(f"board:{id}")
    may_edit = acting().may_change_board(id)
    return {
        "id": board.id,
        "title": board.title,
        "note": board.note,
        "version": board.version,
        "author": board.author,
        "updated": board.updated,
        "filters": dict(board.filters),
        "blocks": [block_data(board, block, known) for block in board.blocks],
        "comments": [comment_data(comment) for comment in comments],
        "may_edit": may_edit,
        "me": acting().name,
        "datasets": sorted(known),
        "groups": groups_of(workspace, str(board.filters.get("dataset") or "")),
        "links": links_of(board, may_edit),
        "names": _names(workspace, board, comments),
    }


def groups_of(workspace: Workspace, dataset: str) -> list[tuple[str, list[str]]]:
    """Properties of clips of a dataset with their values; columns with many values are left out."""
    try:
        known = present_properties(workspace, dataset)
    except WorkspaceError:
        return []
    values = [(column, list(known.groups(column))) for column in known.columns]
    return [(column, some) for column, some in values if 0 < len(some) <= MOST_GROUPS]


def clips_of_group(workspace: Workspace, board: Board, group: str) -> dict[str, list[str]]:
    """Of each dataset on a board the clips of a group, written ``column=value``."""
    column, _, value = group.partition("=")
    clips: dict[str, list[str]] = {}
    for name in sorted(shown(board)[0]):
        with suppress(WorkspaceError):
            of_clips = workspace.properties.of(workspace.info(name).id).values
            clips[name] = [clip for clip in workspace.open(name).names if of_clips.get(clip, {}).get(column) == value]
    return clips


def block_data(board: Board, block: Block, known: Mapping[str, str]) -> dict[str, Any]:
    """A block; ``data``: whether what it is pinned to is still there as it was."""
    return asdict(block) | {"data": pinned_state(block.settings, known), "dataset": dataset_of(board, block)}


def part_of(block: Block) -> Part:
    """What the block shows, as reports have it."""
    own = block.settings
    return Part(
        block.kind,
        str(own.get("title", "")),
        str(own.get("note", "")),
        _texts(own.get("view")),
        _texts(own.get("options")),
        max(1, min(12, block.w)),
    )


def dataset_of(board: Board, block: Block) -> str:
    """The dataset that a block shows: its own, else that of the board."""
    return str(block.settings.get("dataset") or board.filters.get("dataset") or "")


def links_of(board: Board, may_edit: bool) -> dict[str, str]:
    """Addresses that open the board: to read, and for those who may change it to edit."""
    read = {"board": board.id, "screen": "read", "key": board.read_key}
    edit = {"board": board.id, "key": board.edit_key}
    return {"read": f"/boards?{urlencode(read)}"} | ({"edit": f"/boards?{urlencode(edit)}"} if may_edit else {})


def comment_data(comment: Comment) -> dict[str, Any]:
    """A comment; ``block``: the id of the block it belongs to, "" for the board itself."""
    return asdict(comment) | {"block": comment.place.partition("/block:")[2]}


def board_entry(board: Board) -> dict[str, Any]:
    """A line of the list of boards."""
    return {
        "id": board.id,
        "title": board.title,
        "note": board.note,
        "author": board.author,
        "updated": board.updated,
        "version": board.version,
        "dataset": str(board.filters.get("dataset", "")),
        "shape": [[block.x, block.y, block.w, block.h, block.kind] for block in board.blocks],
    }


def view_entry(view: SavedView) -> dict[str, Any]:
    """A line of the list of saved views."""
    return asdict(view) | {"picture": f"/api/views/{view.id}/picture?v={view.version}"}


def kinds() -> list[dict[str, Any]]:
    """The kinds of blocks that can be added."""
    return [
        {
            "kind": kind,
            "label": block.label,
            "symbol": block.symbol,
            "size": list(block.size),
            "options": dict(block.options),
            "keys": [*(settings.keys(block.method) if block.method else ()), *block.keys],
            "computes": bool(block.method),
        }
        for kind, block in blocks().items()
    ]


def can_compute(dataset: str, block: Block) -> bool:
    """Whether there is a result behind a block that could be computed."""
    return bool(dataset) and request_of(dataset, part_of(block)) is not None


def _texts(values: object) -> dict[str, str]:
    return {str(key): str(value) for key, value in values.items()} if isinstance(values, Mapping) else {}


def _names(workspace: Workspace, board: Board, comments: list[Comment]) -> list[str]:
    """People who have worked on a board, and for people with an account all who have one, for mentions."""
    authors = [*(block.author for block in board.blocks), *(comment.author for comment in comments)]
    return people_of(workspace, board.author, *authors)


def people_of(workspace: Workspace, *names: str) -> list[str]:
    """These names, and for people with an account those of all who have one."""
    accounts = [] if acting().is_guest else [account.name for account in workspace.users.list()]
    return sorted({name for name in (*accounts, *names) if name})[:MOST_NAMES]
