"""What can be done to a board: one function a change, by the name that the browser gives it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from core.workspace import Workspace
from core.workspace.blocks import Block
from webapp.features.boards.contents import pin_of
from webapp.features.boards.documents import dataset_of, part_of
from webapp.shell.routes import BadRequest

Body = Mapping[str, Any]


def _add(workspace: Workspace, id: str, body: Body, author: str) -> None:
    block = _block(body)
    workspace.boards.add_block(id, _pinned(workspace, id, block), author)


def _change(workspace: Workspace, id: str, body: Body, author: str) -> None:
    block = _block(body)
    workspace.boards.change_block(id, _pinned(workspace, id, block), whole_of(body, "version"), author)


def _pinned(workspace: Workspace, id: str, block: Block) -> Block:
    """The block, pinned to what its dataset holds now, unless it says what it is pinned to."""
    if block.settings.get("pinned"):
        return block
    return pinned_to(workspace, dataset_of(workspace.boards.get(id), block), block)


def pinned_to(workspace: Workspace, dataset: str, block: Block) -> Block:
    pin = pin_of(workspace, dataset, block.kind, part_of(block).view) if dataset else None
    return replace(block, settings={**block.settings, **({"pinned": pin} if pin else {})})


def _renew(workspace: Workspace, id: str, body: Body, author: str) -> None:
    """Blocks are pinned to the data as it is now: the one that is named, or all that the data has left behind."""
    for block in workspace.boards.get(id).blocks:
        if body.get("block") in (None, block.id):
            bare = {name: value for name, value in block.settings.items() if name != "pinned"}
            fresh = replace(block, settings=bare)
            workspace.boards.change_block(id, _pinned(workspace, id, fresh), block.version, author)


def _remove(workspace: Workspace, id: str, body: Body, author: str) -> None:
    version = body.get("version")
    workspace.boards.remove_block(id, str(body.get("block")), author, None if version is None else int(version))


def _move(workspace: Workspace, id: str, body: Body, author: str) -> None:
    places = body.get("places")
    if not isinstance(places, Mapping):
        raise BadRequest("Places are a mapping of blocks to four whole numbers.")
    workspace.boards.move_blocks(id, {str(block): list(place) for block, place in places.items()}, author)


def _filter(workspace: Workspace, id: str, body: Body, author: str) -> None:
    filters = body.get("filters")
    workspace.boards.set_filters(id, filters if isinstance(filters, Mapping) else {}, author)


def _rename(workspace: Workspace, id: str, body: Body, author: str) -> None:
    note = body.get("note")
    workspace.boards.rename(id, str(body.get("title", "")), None if note is None else str(note), author)


def _duplicate(workspace: Workspace, id: str, body: Body, author: str) -> str:
    return workspace.boards.duplicate(id, str(body.get("title", "")), author).id


def _delete(workspace: Workspace, id: str, body: Body, author: str) -> str:
    workspace.boards.delete(id)
    return ""


def _undelete(workspace: Workspace, id: str, body: Body, author: str) -> None:
    workspace.boards.undelete(id)


def _restore(workspace: Workspace, id: str, body: Body, author: str) -> None:
    workspace.boards.restore(id, whole_of(body, "version"), author)


def _renew_links(workspace: Workspace, id: str, body: Body, author: str) -> None:
    workspace.boards.renew_keys(id, author)


CHANGES: dict[str, Callable[[Workspace, str, Body, str], str | None]] = {
    "add": _add,
    "change": _change,
    "remove": _remove,
    "move": _move,
    "renew": _renew,
    "filter": _filter,
    "rename": _rename,
    "duplicate": _duplicate,
    "delete": _delete,
    "undelete": _undelete,
    "restore": _restore,
    "renew-links": _renew_links,
}
"""What can be done to a board: gives the id of the board to show then, None for the same, "" for none."""


def _block(body: Body) -> Block:
    given = body.get("block")
    if not isinstance(given, Mapping) or not isinstance(given.get("settings", {}), Mapping):
        raise BadRequest("A block is a mapping with a kind and settings.")
    x, y, w, h = (given.get(name, default) for name, default in (("x", 0), ("y", 0), ("w", 4), ("h", 4)))
    return Block(str(given.get("id", "")), str(given.get("kind", "")), x, y, w, h, dict(given.get("settings", {})))


def whole_of(body: Body, name: str) -> int:
    value = body.get(name)
    if not isinstance(value, int) or isinstance(value, bool):
        raise BadRequest(f"{name} must be a whole number.")
    return value
