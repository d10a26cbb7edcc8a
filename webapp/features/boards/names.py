"""Ids of the Boards page, and the keys of its links."""

from typing import Annotated, TypedDict

from webapp.shell.feature import LinkKey
from webapp.shell.identifiers import Id


class View(TypedDict, total=False):
    """The board that is open."""

    board: Annotated[str, LinkKey(pattern=r"[0-9a-zA-Z_-]{1,64}")]


BOARDS_PLACE = Id("boards-place")
