"""Comments on a block of a board, a motif or a moment of a clip, with answers, open or resolved."""

from __future__ import annotations

import re
import secrets
import sqlite3
import time
from dataclasses import dataclass

from core.workspace import people
from core.workspace.audit import record
from core.workspace.database import Database
from core.workspace.errors import ConflictError, DocumentGone, WorkspaceError
from core.workspace.texts import LONGEST_NAME, one_line, paragraphs

LONGEST_TEXT, LONGEST_PLACE = 4000, 400
_PLACE = re.compile(r"(board|motif|moment|view|dataset):[^/]+(/.*[^/])?")
_MENTION = re.compile(r"(?<![\w@.])@([\w][\w.-]{0,79})")


@dataclass(frozen=True)
class Comment:
    """What someone said.

    place: ``board:ID/block:ID``, ``motif:DATASET/KEY/3`` or ``moment:DATASET/CLIP/FRAME``, where DATASET is an id.
    created, updated: seconds since 1970. mentions: the names behind an @ in the text. parent: the id of the comment
    that this one answers.
    """

    id: str
    place: str
    text: str
    author: str
    created: float
    updated: float
    version: int
    mentions: tuple[str, ...]
    resolved: bool
    parent: str | None


class Comments:
    """The comments of a workspace."""

    def __init__(self, database: Database):
        self._database = database

    def add(self, place: str, text: str, author: str = "", parent: str | None = None) -> Comment:
        """Keeps a comment. Raises WorkspaceError (empty, too long, no place), DocumentGone where the parent is gone."""
        place, text = _place(place), paragraphs(text, "comment", LONGEST_TEXT, needed=True)
        _require(place, "comment")
        author, now, id = one_line(people.author(author), "name", LONGEST_NAME), time.time(), secrets.token_hex(6)
        if parent is not None and self.get(parent).place != place:
            raise WorkspaceError("An answer belongs to the place of the comment that it answers.")
        with self._database.transaction("keep the comment") as table:
            table.execute(
                "INSERT INTO comments VALUES (?, ?, ?, ?, ?, ?, 1, 0, ?, NULL)",
                (id, place, text, author, now, now, parent),
            )
            record(table, "comment added", place, text[:80])
        return Comment(id, place, text, author, now, now, 1, mentions(text), False, parent)

    def get(self, id: str) -> Comment:
        """The comment with this id; raises DocumentGone."""
        return _comment(self._row(id))

    def at(self, place: str) -> list[Comment]:
        """The comments at a place, oldest first."""
        rows = self._database.rows(
            "SELECT * FROM comments WHERE place = ? AND deleted IS NULL ORDER BY created, id", str(place)
        )
        return [_comment(row) for row in rows if _may_see(row["place"])]

    def under(self, prefix: str) -> list[Comment]:
        """The comments at a place and below it, such as all of ``board:ID``, oldest first."""
        below, after = f"{prefix.rstrip('/')}/", f"{prefix.rstrip('/')}0"  # "0" is the letter behind "/"
        rows = self._database.rows(
            "SELECT * FROM comments WHERE (place = ? OR place > ? AND place < ?) AND deleted IS NULL "
            "ORDER BY created, id",
            *(below[:-1], below, after),
        )
        return [_comment(row) for row in rows if _may_see(row["place"])]

    def state(self, prefix: str) -> str:
        """A short text that changes whenever :meth:`under` does, by one cheap query."""
        below, after = f"{prefix.rstrip('/')}/", f"{prefix.rstrip('/')}0"
        row = self._database.rows(
            "SELECT COUNT(*), TOTAL(version), COUNT(deleted) FROM comments WHERE place = ? OR place > ? AND place < ?",
            *(below[:-1], below, after),
        )[0]
        return f"{row[0]}.{row[1]:.0f}.{row[2]}"

    def edit(self, id: str, text: str, expected_version: int) -> Comment:
        """Another text; raises ConflictError where the comment has been changed since, DocumentGone."""
        text = paragraphs(text, "comment", LONGEST_TEXT, needed=True)
        with self._database.transaction("keep the comment") as table:
            present = self.get(id)
            _require_own(present, "edit this comment")
            if present.version != expected_version:
                raise ConflictError("This comment has been changed meanwhile.", present, present.author)
            table.execute(
                "UPDATE comments SET text = ?, updated = ?, version = version + 1 WHERE id = ?", (text, time.time(), id)
            )
            record(table, "comment edited", present.place, text[:80])
        return self.get(id)

    def resolve(self, id: str) -> Comment:
        """Marks a comment as done; raises DocumentGone."""
        _require(self.get(id).place, "resolve this comment")
        return self._set(id, "resolved = 1", "resolved")

    def reopen(self, id: str) -> Comment:
        """Marks a resolved comment as open again; raises DocumentGone."""
        _require(self.get(id).place, "reopen this comment")
        return self._set(id, "resolved = 0", "reopened")

    def delete(self, id: str) -> None:
        """Takes a comment away until :meth:`undelete`; its answers stay. Raises DocumentGone."""
        _require_own(self.get(id), "delete this comment")
        self._set(id, "deleted = 1", "deleted")

    def undelete(self, id: str) -> Comment:
        """Brings a deleted comment back; raises DocumentGone."""
        _require_own(_comment(self._row(id, deleted=True)), "bring this comment back")
        return self._set(id, "deleted = NULL", "restored")

    def _set(self, id: str, what: str, done: str) -> Comment:
        with self._database.transaction("keep the comment") as table:
            table.execute(
                f"UPDATE comments SET {what}, updated = ?, version = version + 1 WHERE id = ?", (time.time(), str(id))
            )
            comment = _comment(self._row(id, deleted=True))
            record(table, f"comment {done}", comment.place, comment.text[:80])
        return comment

    def _row(self, id: str, deleted: bool = False) -> sqlite3.Row:
        rows = self._database.rows("SELECT * FROM comments WHERE id = ?", str(id))
        if not rows or (rows[0]["deleted"] and not deleted) or not _may_see(rows[0]["place"]):
            raise DocumentGone("There is no such comment. It may have been deleted.")
        return rows[0]


def mentions(text: str) -> tuple[str, ...]:
    """The names that follow an @ in a text, each once."""
    return tuple(dict.fromkeys(name.rstrip(".-") for name in _MENTION.findall(text)))


def _may_see(place: str) -> bool:
    """Whether who acts may see what is said at a place: a guest sees their board's."""
    kind, _, rest = place.partition("/")[0].partition(":")
    return not people.acting().is_guest or (kind == "board" and people.acting().may_see_board(rest))


def _require(place: str, to: str) -> None:
    kind, _, rest = place.partition("/")[0].partition(":")
    if kind == "board":
        people.require_board(rest, to=to)
    else:
        people.require("editor", rest if kind in ("motif", "moment", "dataset") else None, to=to)


def _require_own(comment: Comment, to: str) -> None:
    """Raises AccessRefused for the comment of someone else, except for owners."""
    _require(comment.place, to)
    person = people.acting()
    if comment.author != person.name and not person.may("owner"):
        raise people.AccessRefused(f"Only {comment.author or 'its author'} or an owner may {to}.")


def _place(place: object) -> str:
    text = one_line(place, "place of a comment", LONGEST_PLACE, needed=True)
    if not _PLACE.fullmatch(text):
        raise WorkspaceError(
            "A comment belongs to a place such as board:ID/block:ID, motif:DATASET/KEY/NUMBER or "
            "moment:DATASET/CLIP/FRAME."
        )
    return text


def _comment(row: sqlite3.Row) -> Comment:
    id, place, text, author = (str(value) for value in tuple(row)[:4])
    when, parent = (float(row["created"]), float(row["updated"]), int(row["version"])), row["parent"]
    return Comment(id, place, text, author, *when, mentions(text), bool(row["resolved"]), parent)
