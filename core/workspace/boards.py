"""Boards: blocks on a grid that a team arranges together; different blocks can be changed at once without conflict."""

from __future__ import annotations

import hmac
import secrets
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any, Literal

from core.workspace import people
from core.workspace.blocks import LARGEST_SETTINGS, Block, check_block, checked, moved_to, named, place_of
from core.workspace.database import Database
from core.workspace.documents import Document, Documents, Kept
from core.workspace.errors import ConflictError, DocumentGone, WorkspaceError
from core.workspace.people import AccessRefused, acting, require, require_board
from core.workspace.texts import one_line, paragraphs, plain_json
from core.workspace.views import LONGEST_NOTE, LONGEST_TITLE

MOST_BLOCKS = 100
Right = Literal["read", "edit"]


@dataclass(frozen=True)
class Board:
    """A board as it was saved in ``version`` by ``author``; created, updated: seconds since 1970.

    filters: what the whole board is narrowed to. read_key, edit_key: whoever has one may see or change this board.
    """

    id: str
    title: str
    note: str
    blocks: tuple[Block, ...]
    filters: Mapping[str, Any]
    version: int
    author: str
    created: float
    updated: float
    read_key: str
    edit_key: str

    def block(self, id: str) -> Block | None:
        """The block with this id."""
        return next((block for block in self.blocks if block.id == id), None)


class Boards(Documents[Board]):
    """The boards of a workspace. All that changes one gives the new board and raises DocumentGone, DocumentDamaged,

    or WorkspaceError for what does not fit.
    """

    def __init__(self, database: Database):
        super().__init__(database, "board", "board")

    def create(self, title: str, blocks: Iterable[Block] = (), author: str = "", note: str = "") -> Board:
        """A new board; blocks whose id is empty or taken get one."""
        known: list[Block] = []
        for block in blocks:
            known.append(checked(block, known, 1, people.author(author)))
        return self._create(_document(_title(title), _note(note), known, {}, *_new_keys()), author)

    def by_key(self, key: str) -> tuple[Board, Right]:
        """The board that ``key`` opens, and whether to read or to edit; raises DocumentGone for any other text."""
        try:
            board = self.get(str(key).partition("-")[0])
        except DocumentGone as error:
            raise DocumentGone("This link opens no board. It may have been deleted or its link renewed.") from error
        rights: tuple[tuple[str, Right], ...] = ((board.edit_key, "edit"), (board.read_key, "read"))
        for own, right in rights:
            if hmac.compare_digest(own.encode(), str(key).encode()):
                return board, right
        raise DocumentGone("This link opens no board. It may have been deleted or its link renewed.")

    def change_block(self, board_id: str, block: Block, expected_version: int, author: str = "") -> Board:
        """Saves kind and settings of a block; its place stays what it is (:meth:`move_blocks`).

        expected_version: of the block as it was seen. Raises ConflictError where it has been changed or removed since.
        """

        def edit(board: Board) -> list[Block]:
            present = _unchanged(board, block.id, expected_version)
            new = replace(present, kind=block.kind, settings=block.settings)
            new = checked(new, [], board.version + 1, people.author(author))
            return [new if old.id == block.id else old for old in board.blocks]

        return self._change_blocks(board_id, edit, author, f"block {block.id} changed")

    def add_block(self, board_id: str, block: Block, author: str = "") -> Board:
        """Adds a block at the end; one whose id is empty or taken gets a new id."""

        def edit(board: Board) -> list[Block]:
            return [*board.blocks, checked(block, board.blocks, board.version + 1, people.author(author))]

        return self._change_blocks(board_id, edit, author, "block added")

    def remove_block(
        self, board_id: str, block_id: str, author: str = "", expected_version: int | None = None
    ) -> Board:
        """Removes a block; raises ConflictError where it is gone, or changed since ``expected_version``."""

        def edit(board: Board) -> list[Block]:
            _unchanged(board, block_id, expected_version)
            return [block for block in board.blocks if block.id != block_id]

        return self._change_blocks(board_id, edit, author, f"block {block_id} removed")

    def move_blocks(self, board_id: str, places: Mapping[str, Sequence[int]], author: str = "") -> Board:
        """Places blocks anew. places: block id -> x, y, width, height in cells; blocks that are gone are left out."""
        checked = {id: place_of(place) for id, place in places.items()}

        def edit(board: Board) -> list[Block]:
            return [moved_to(block, checked[block.id]) if block.id in checked else block for block in board.blocks]

        return self._change_blocks(board_id, edit, author, "blocks moved")

    def set_filters(self, board_id: str, filters: Mapping[str, Any], author: str = "") -> Board:
        """What the whole board is narrowed to."""
        plain = plain_json(filters, "filters", LARGEST_SETTINGS)
        return self._change(
            board_id, lambda board: _as_document(replace(board, filters=plain)), author, "filters changed"
        )

    def rename(self, board_id: str, title: str, note: str | None = None, author: str = "") -> Board:
        """Another title, and another note where one is given."""
        title, note = _title(title), None if note is None else _note(note)

        def edit(board: Board) -> Document:
            return _as_document(replace(board, title=title, note=board.note if note is None else note))

        return self._change(board_id, edit, author, "renamed")

    def renew_keys(self, board_id: str, author: str = "") -> Board:
        """New keys: links that were given away before open the board no more."""

        require("editor", to="renew the links of a board")

        def edit(board: Board) -> Document:
            return _document(board.title, board.note, board.blocks, board.filters, *_new_keys())

        return self._change(board_id, edit, author, "links renewed")

    def duplicate(self, board_id: str, title: str = "", author: str = "") -> Board:
        """A new board with the same blocks, filters and note, and keys of its own."""
        board = self.get(board_id)
        title = _title(title or f"{board.title[: LONGEST_TITLE - 7]} (copy)")
        blocks = [replace(block, version=1, author=people.author(author)) for block in board.blocks]
        return self._create(_document(title, board.note, blocks, board.filters, *_new_keys()), author, "copied")

    def _change_blocks(self, id: str, edit: Callable[[Board], list[Block]], author: str, what: str) -> Board:
        def document(board: Board) -> Document:
            return _as_document(replace(board, blocks=tuple(edit(board))))

        return self._change(id, document, author, what)

    def _may_see(self, id: str) -> bool:
        return acting().may_see_board(id)

    def _require(self, id: str | None, document: Document | None, to: str) -> None:
        person = acting()
        if id is None or document is None:
            require("editor", to=to)
            return
        require_board(id, to=to)
        if document is not None and person.is_guest:
            datasets, views = named(document["blocks"], document["filters"])
            if not (datasets <= person.datasets and views <= person.views):
                raise AccessRefused("This link does not let you show data that the board does not show already.")

    def _content(self, kept: Kept) -> Board:
        document = kept.document
        blocks = tuple(Block(**block) for block in document["blocks"])
        for block in blocks:
            check_block(block)
        keys = [f"{kept.id}-{document[name]}" for name in ("read_key", "edit_key")]
        texts, filters = (str(document["title"]), str(document["note"])), dict(document["filters"])
        return Board(kept.id, *texts, blocks, filters, kept.version, kept.author, kept.created, kept.saved, *keys)

    def _again(self, old: Kept, present: Board | None) -> Document:
        """The keys stay what they are now; a block that becomes another counts as changed."""
        board, version = self._content(old), (present.version if present else old.version) + 1
        if present is None:
            return _as_document(board)
        blocks = []
        for block in board.blocks:
            now = present.block(block.id)
            same = now is not None and (now.kind, now.settings) == (block.kind, block.settings)
            blocks.append(replace(block, version=now.version if same and now else version))
        board = replace(board, blocks=tuple(blocks), read_key=present.read_key, edit_key=present.edit_key)
        return _as_document(board)


def shown(board: Board) -> tuple[frozenset[str], frozenset[str]]:
    """The datasets (names) and saved views (ids) that blocks and filters of a board name."""
    return named([block.settings for block in board.blocks], board.filters)


def _unchanged(board: Board, block_id: str, expected_version: int | None) -> Block:
    present = board.block(block_id)
    if present is None:
        raise ConflictError("This block has been removed meanwhile.", None, board.author)
    if expected_version not in (None, present.version):
        who = present.author or "Someone"
        raise ConflictError(f"{who} has changed this block meanwhile.", present, present.author)
    return present


def _title(title: object) -> str:
    return one_line(title, "title", LONGEST_TITLE, needed=True)


def _note(note: object) -> str:
    return paragraphs(note, "note", LONGEST_NOTE)


def _new_keys() -> tuple[str, str]:
    return secrets.token_urlsafe(16), secrets.token_urlsafe(16)


def _as_document(board: Board) -> Document:
    keys = (key.partition("-")[2] for key in (board.read_key, board.edit_key))  # without the id before them
    return _document(board.title, board.note, board.blocks, board.filters, *keys)


def _document(
    title: str, note: str, blocks: Iterable[Block], filters: Mapping[str, Any], read_key: str, edit_key: str
) -> Document:
    return {
        "title": title,
        "note": note,
        "blocks": _bounded(blocks),
        "filters": dict(filters),
        "read_key": read_key,
        "edit_key": edit_key,
    }


def _bounded(blocks: Iterable[Block]) -> list[dict[str, Any]]:
    plain = [asdict(block) for block in blocks]
    if len(plain) > MOST_BLOCKS:
        raise WorkspaceError(f"A board has at most {MOST_BLOCKS} blocks.")
    return plain
