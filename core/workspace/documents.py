"""Documents that a team changes together: every save is a version, who saved what when is kept, any can come back.

A document is JSON: a saved view, a board. The store knows nothing of what is in it.
"""

from __future__ import annotations

import json
import secrets
import sqlite3
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any, Generic, TypeVar

from core.workspace import people
from core.workspace.audit import record
from core.workspace.database import Database
from core.workspace.errors import DocumentDamaged, DocumentGone, WorkspaceError
from core.workspace.texts import LONGEST_NAME, one_line

T = TypeVar("T")
Document = dict[str, Any]

_PRESENT = (
    "SELECT d.id, d.version, v.document, v.author, d.created, v.saved, d.deleted FROM documents d "
    "LEFT JOIN document_versions v ON v.kind = d.kind AND v.id = d.id AND v.version = d.version WHERE d.kind = ?"
)


@dataclass(frozen=True)
class Kept:
    """A version of a document. author: who saved this version; created, saved: seconds since 1970."""

    id: str
    version: int
    document: Document
    author: str
    created: float
    saved: float


@dataclass(frozen=True)
class Change:
    """One entry of a document's history: ``author`` saved ``version`` at ``saved`` (seconds since 1970) by ``what``."""

    version: int
    author: str
    saved: float
    what: str


class Documents(Generic[T], ABC):
    """The documents of one kind; ``word`` is what people call one of them, as in "the board".

    kept_versions: of each document, the oldest go first; largest_document: letters of its JSON.
    """

    kept_versions = 200
    largest_document = 1_000_000

    def __init__(self, database: Database, kind: str, word: str):
        self._database, self._kind, self._word = database, kind, word

    @abstractmethod
    def _content(self, kept: Kept) -> T:
        """What a version stands for; a LookupError, TypeError, ValueError or AttributeError says that it is damaged."""

    def _again(self, old: Kept, present: T | None) -> Document:
        """What :meth:`restore` saves, of the earlier version and of what there is now (None: damaged)."""
        return old.document

    def _title(self, document: Document) -> str:
        """What the audit log calls a document."""
        return str(document.get("title", ""))

    @abstractmethod
    def _may_see(self, id: str) -> bool:
        """Whether who acts may see the document with this id."""

    @abstractmethod
    def _require(self, id: str | None, document: Document | None, to: str) -> None:
        """Raises AccessRefused where who acts may not change the document with this id, or make one (None).

        document: what it is to become, where that is known.
        """

    def _create(self, document: Document, author: str, what: str = "made", id: str = "") -> T:
        """Keeps a new document under ``id``, or a new one; raises WorkspaceError where it is too large or cannot be
        written."""
        self._require(id or None, document, f"make a {self._word}")
        id, now = id or secrets.token_hex(6), time.time()
        text, author = self._text(document), self._author(author)
        with self._database.transaction(f"keep the {self._word}") as table:
            table.execute("INSERT INTO documents VALUES (?, ?, 1, ?, NULL)", (self._kind, id, now))
            table.execute(
                "INSERT INTO document_versions VALUES (?, ?, 1, ?, ?, ?, ?)", (self._kind, id, text, author, now, what)
            )
            record(table, f"{self._word} {what}", self._title(document), id)
        return self._content(Kept(id, 1, document, author, now, now))

    def get(self, id: str, version: int | None = None) -> T:
        """The present version, or an earlier one; raises DocumentGone, DocumentDamaged."""
        return self._read(self._row(id, version))[1]

    def all(self) -> list[T]:
        """The present versions, newest first; the deleted and the damaged are left out (:meth:`damaged`)."""
        return [content for _, content in self._readable() if content is not None]

    def damaged(self) -> list[str]:
        """The ids of documents whose present version cannot be read; :meth:`restore` brings back an earlier one."""
        return [id for id, content in self._readable() if content is None]

    def _readable(self) -> Iterator[tuple[str, T | None]]:
        for row in self._rows():
            try:
                yield row["id"], self._read(row)[1]
            except DocumentDamaged:
                yield row["id"], None

    def version(self, id: str) -> int:
        """The number of the present version, by one cheap query; raises DocumentGone."""
        rows = self._database.rows(
            "SELECT version FROM documents WHERE kind = ? AND id = ? AND deleted IS NULL", self._kind, str(id)
        )
        if not rows or not self._may_see(id):
            raise self._gone(id)
        return int(rows[0]["version"])

    def _change(self, id: str, edit: Callable[[T], Document], author: str, what: str) -> T:
        """Saves what ``edit`` makes of the present version as the next one; nobody else saves in between.

        What ``edit`` raises comes out and nothing is saved. Raises DocumentGone, DocumentDamaged, WorkspaceError.
        """
        author = self._author(author)
        with self._database.transaction(f"keep the {self._word}") as table:
            kept, content = self._read(self._row(id))
            return self._append(table, kept, edit(content), author, what)

    def restore(self, id: str, version: int, author: str = "") -> T:
        """Saves an earlier version once more, as the newest; also where the present one is damaged.

        Raises DocumentGone, DocumentDamaged.
        """
        author = self._author(author)
        with self._database.transaction(f"restore the {self._word}") as table:
            row = self._row(id)
            old, _ = self._read(self._row(id, version))
            newest = replace(old, version=row["version"])
            present = None
            with suppress(DocumentDamaged):
                present = self._read(row)[1]
            document = self._again(old, present)
            return self._append(table, newest, document, author, f"version {version} restored")

    def history(self, id: str) -> list[Change]:
        """Who saved what when, newest first; also of a deleted document. Raises DocumentGone."""
        rows = self._database.rows(
            "SELECT version, author, saved, what FROM document_versions WHERE kind = ? AND id = ? "
            "ORDER BY version DESC",
            self._kind,
            str(id),
        )
        if not rows or not self._may_see(id):
            raise self._gone(id)
        return [Change(row["version"], row["author"], row["saved"], row["what"]) for row in rows]

    def delete(self, id: str) -> None:
        """Takes the document away until :meth:`undelete`; raises DocumentGone where it is not there."""
        self._mark(id, time.time())

    def undelete(self, id: str) -> T:
        """Brings a deleted document back; raises DocumentGone where there has never been one."""
        self._mark(id, None)
        return self.get(id)

    def _mark(self, id: str, deleted: float | None) -> None:
        doing = "restore" if deleted is None else "delete"
        self._require(str(id), None, f"{doing} this {self._word}")
        living = "" if deleted is None else " AND deleted IS NULL"
        with self._database.transaction(f"{doing} the {self._word}") as table:
            done = table.execute(
                f"UPDATE documents SET deleted = ? WHERE kind = ? AND id = ?{living}", (deleted, self._kind, str(id))
            )
            if not done.rowcount:
                raise self._gone(id)
            record(table, f"{self._word} {doing}d", self._latest_title(table, str(id)), id)

    def _latest_title(self, table: sqlite3.Connection, id: str) -> str:
        row = table.execute(
            "SELECT document FROM document_versions WHERE kind = ? AND id = ? ORDER BY version DESC", (self._kind, id)
        ).fetchone()
        with suppress(ValueError, TypeError, AttributeError):
            return self._title(json.loads(row["document"])) if row else ""
        return ""

    def _append(self, table: sqlite3.Connection, newest: Kept, document: Document, author: str, what: str) -> T:
        """Writes the version after ``newest``."""
        self._require(newest.id, document, f"change this {self._word}")
        id, text, now, version = newest.id, self._text(document), time.time(), newest.version + 1
        table.execute("UPDATE documents SET version = ? WHERE kind = ? AND id = ?", (version, self._kind, id))
        table.execute(
            "INSERT INTO document_versions VALUES (?, ?, ?, ?, ?, ?, ?)",
            (self._kind, id, version, text, author, now, what),
        )
        table.execute(
            "DELETE FROM document_versions WHERE kind = ? AND id = ? AND version <= ?",
            (self._kind, id, version - self.kept_versions),
        )
        record(table, f"{self._word}: {what}", self._title(document), id)
        return self._content(Kept(id, version, document, author, newest.created, now))

    def _rows(self) -> list[sqlite3.Row]:
        rows = self._database.rows(f"{_PRESENT} AND d.deleted IS NULL ORDER BY v.saved DESC, d.id", self._kind)
        return [row for row in rows if self._may_see(row["id"])]

    def _row(self, id: str, version: int | None = None) -> sqlite3.Row:
        rows = self._database.rows(f"{_PRESENT} AND d.id = ? AND d.deleted IS NULL", self._kind, str(id))
        if not rows or not self._may_see(str(id)):
            raise self._gone(id)
        if version is None or version == rows[0]["version"]:
            return rows[0]
        old = self._database.rows(
            "SELECT v.id, v.version, v.document, v.author, d.created, v.saved FROM document_versions v "
            "JOIN documents d ON d.kind = v.kind AND d.id = v.id WHERE v.kind = ? AND v.id = ? AND v.version = ?",
            self._kind,
            str(id),
            int(version),
        )
        if not old:
            raise DocumentGone(f"There is no version {version} of this {self._word} any more.")
        return old[0]

    def _read(self, row: sqlite3.Row) -> tuple[Kept, T]:
        try:
            document = json.loads(row["document"])
            kept = Kept(row["id"], row["version"], document, row["author"], row["created"], row["saved"])
            return kept, self._content(kept)
        except (LookupError, ValueError, TypeError, AttributeError) as error:
            raise DocumentDamaged(
                f"Version {row['version']} of the {self._word} {row['id']} is damaged and cannot be read. "
                "Restore an earlier version from its history."
            ) from error

    @staticmethod
    def _author(given: str) -> str:
        return one_line(people.author(given), "name", LONGEST_NAME)

    def _gone(self, id: str) -> DocumentGone:
        return DocumentGone(f"There is no {self._word} {str(id)[:40]!r}. It may have been deleted.")

    def _text(self, document: Document) -> str:
        text = json.dumps(document, allow_nan=False, separators=(",", ":"))
        if len(text) > self.largest_document:
            raise WorkspaceError(
                f"This {self._word} has become too large: {len(text):,} letters, where {self.largest_document:,} fit."
            )
        return text
