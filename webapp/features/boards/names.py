"""Ids of the Boards page, what its stores hold, and the keys of its links."""

from typing import Annotated, Any, TypedDict

from webapp.shell.feature import LinkKey
from webapp.shell.identifiers import Id, Store


class View(TypedDict, total=False):
    """The board that is open, and whether only to look at it."""

    board: Annotated[str, LinkKey(pattern=r"[0-9a-zA-Z_-]{1,64}")]
    screen: Annotated[str, LinkKey(pattern="read|present")]


BOARDS_PLACE = Id("boards-place")  # what assets/boards fills
SAVE_VIEW = Id("save-view")
COMMENTS_BUTTON = Id("comments-button")  # of what is selected
BOARDS_SHOWN = Store("boards-shown", Any)
