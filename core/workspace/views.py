"""Saved views: links with a title, a note and tags, and every version of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from core.workspace.database import Database
from core.workspace.documents import Document, Documents, Kept
from core.workspace.errors import ConflictError, WorkspaceError
from core.workspace.people import acting, require
from core.workspace.texts import one_line, paragraphs

LONGEST_TITLE, LONGEST_NOTE, MOST_TAGS, LONGEST_ADDRESS = 120, 4000, 20, 4200


@dataclass(frozen=True)
class SavedView:
    """A view of the app under a title. address: path and query of its link, such as ``/motifs?dataset=demo&motif=3``;

    author: who saved this version; created, updated: seconds since 1970.
    """

    id: str
    title: str
    note: str
    tags: tuple[str, ...]
    address: str
    author: str
    created: float
    updated: float
    version: int


class Views(Documents[SavedView]):
    """The saved views of a workspace."""

    def __init__(self, database: Database):
        super().__init__(database, "view", "saved view")

    def save(
        self,
        address: str,
        title: str,
        note: str = "",
        tags: Iterable[str] = (),
        author: str = "",
        id: str | None = None,
        expected_version: int | None = None,
    ) -> SavedView:
        """Saves a view as a new one, or with ``id`` as the next version of one that is there.

        Raises ConflictError where its version is not ``expected_version`` (None: whatever it is), DocumentGone, and
        WorkspaceError for a text that is too long or an address of another site.
        """
        document = _document(address, title, note, tags)
        if id is None:
            return self._create(document, author)

        def edit(present: SavedView) -> Document:
            if expected_version not in (None, present.version):
                who = present.author or "Someone"
                raise ConflictError(f"{who} has saved this view meanwhile.", present, present.author)
            return document

        return self._change(id, edit, author, "saved")

    def _may_see(self, id: str) -> bool:
        return not acting().is_guest or id in acting().views

    def _require(self, id: str | None, document: Document | None, to: str) -> None:
        require("editor", to=to)

    def _content(self, kept: Kept) -> SavedView:
        document = kept.document
        title, note = str(document["title"]), str(document["note"])
        tags, address = tuple(map(str, document["tags"])), check_address(document["address"])
        return SavedView(kept.id, title, note, tags, address, kept.author, kept.created, kept.saved, kept.version)


def check_address(address: object) -> str:
    """The path and query of a link of this app; raises WorkspaceError for anything else."""
    text = str(address)
    if len(text) > LONGEST_ADDRESS or not text.isprintable():
        raise WorkspaceError("This address is too long or holds characters that no link has.")
    if not text.startswith("/") or text.startswith("//") or "\\" in text:
        raise WorkspaceError("A saved view is a page of this app: its address begins with one “/”.")
    return text


def clean_tags(tags: Iterable[str]) -> tuple[str, ...]:
    """Tags as lines of text, each once; raises WorkspaceError where they are too many or too long."""
    plain = tuple(dict.fromkeys(filter(None, (one_line(tag, "tag", LONGEST_TITLE) for tag in tags))))
    if len(plain) > MOST_TAGS:
        raise WorkspaceError(f"There are at most {MOST_TAGS} tags; these are {len(plain)}.")
    return plain


def _document(address: str, title: str, note: str, tags: Iterable[str]) -> Document:
    return {
        "address": check_address(address),
        "title": one_line(title, "title", LONGEST_TITLE, needed=True),
        "note": paragraphs(note, "note", LONGEST_NOTE),
        "tags": list(clean_tags(tags)),
    }
