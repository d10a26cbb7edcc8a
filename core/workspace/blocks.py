"""Blocks of boards: what is allowed in one, which data they name, and whether the data behind a result has changed."""

from __future__ import annotations

import re
import secrets
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal
from urllib.parse import parse_qs, urlsplit

from core.workspace.errors import WorkspaceError
from core.workspace.texts import LONGEST_NAME, one_line, plain_json

LARGEST_SETTINGS, LARGEST_PLACE = 64_000, 10_000
Place = tuple[int, int, int, int]  # x, y, width, height in cells of the grid


@dataclass(frozen=True)
class Block:
    """A part of a board. x, y, w, h: its place in cells of the grid; settings: JSON that its kind understands.

    ``settings["pinned"]`` names the result it shows as it was made: its dataset, fingerprint and key.
    version: the board's version in which its kind or settings were changed last, by ``author``.
    """

    id: str
    kind: str
    x: int = 0
    y: int = 0
    w: int = 4
    h: int = 4
    settings: Mapping[str, Any] = field(default_factory=dict)
    version: int = 0
    author: str = ""


def pinned_state(
    settings: Mapping[str, Any], fingerprints: Mapping[str, str]
) -> Literal["not pinned", "unchanged", "changed", "gone"]:
    """Whether the data behind a block's pinned result is still what it was made with.

    fingerprints: name of each dataset -> fingerprint of what it holds now. "gone": there is no such dataset.
    """
    pinned = settings.get("pinned")
    if not isinstance(pinned, Mapping) or not pinned.get("dataset"):
        return "not pinned"
    now = fingerprints.get(str(pinned["dataset"]))
    if now is None:
        return "gone"
    return "unchanged" if now == pinned.get("fingerprint") else "changed"


def named(*parts: object) -> tuple[frozenset[str], frozenset[str]]:
    """The datasets (names) and saved views (ids) that settings and filters name, at any depth."""
    datasets: set[str] = set()
    views: set[str] = set()

    def look(value: object, key: str = "") -> None:
        if isinstance(value, Mapping):
            for name, part in value.items():
                look(part, name)
        elif isinstance(value, list | tuple):
            for part in value:
                look(part, key)
        elif isinstance(value, str):
            if key in ("dataset", "datasets"):
                datasets.add(value)
            elif key in ("view", "views"):
                views.add(value)
            elif key == "address":
                datasets.update(parse_qs(urlsplit(value).query).get("dataset", ()))

    look(parts)
    return frozenset(datasets), frozenset(views)


def checked(block: Block, others: Sequence[Block], version: int, author: str) -> Block:
    """The block in its final form, with an id that none of ``others`` has."""
    taken = {other.id for other in others}
    id = block.id if block.id and block.id not in taken else secrets.token_hex(4)
    settings = plain_json(block.settings, "settings of a block", LARGEST_SETTINGS)
    author = one_line(author, "name", LONGEST_NAME)
    place = place_of((block.x, block.y, block.w, block.h))
    return check_block(moved_to(replace(block, id=id, settings=settings, version=version, author=author), place))


def check_block(block: Block) -> Block:
    """The block itself; raises WorkspaceError where a part of it cannot be."""
    if not (re.fullmatch(r"[0-9A-Za-z_-]{1,40}", block.id) and re.fullmatch(r"[a-z][a-z0-9 _-]{0,39}", block.kind)):
        raise WorkspaceError("The id or the kind of a block holds characters that it cannot have.")
    if not isinstance(block.settings, Mapping) or not isinstance(block.version, int):
        raise WorkspaceError("The settings of a block are a mapping and its version is a whole number.")
    place_of((block.x, block.y, block.w, block.h))
    return block


def place_of(numbers: Sequence[int]) -> Place:
    """A place in cells of the grid; raises WorkspaceError for anything else."""
    whole = len(numbers) == 4 and all(isinstance(n, int) and not isinstance(n, bool) for n in numbers)
    if not whole or min(numbers) < 0 or max(numbers) > LARGEST_PLACE or min(numbers[2:]) < 1:
        raise WorkspaceError("The place of a block is four whole numbers: x and y from 0, width and height from 1.")
    x, y, w, h = numbers
    return x, y, w, h


def moved_to(block: Block, place: Place) -> Block:
    """The same block at another place."""
    x, y, w, h = place
    return replace(block, x=x, y=y, w=w, h=h)
