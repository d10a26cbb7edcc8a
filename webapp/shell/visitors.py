"""Who a request comes from: a reverse proxy says so, or a session, the server's token, or the link of a board."""

from __future__ import annotations

import hmac
import os
from dataclasses import replace

from flask import g, request

from core.workspace import Board, DocumentGone, Person, Workspace, WorkspaceError
from core.workspace.boards import shown
from core.workspace.people import OWNER
from webapp.shell.origin import from_trusted_proxy
from webapp.shell.sessions import person_of_session

USER_HEADER = "MOTIONSCAPE_USER_HEADER"
TOKEN_COOKIE, BOARDS_COOKIE = "motionscape-token", "motionscape-boards"
MOST_KEYS = 10  # board links that a browser keeps
GUEST = "guest"


class UnknownUser(WorkspaceError):
    """A reverse proxy has signed in someone who has no account here."""


def accounts_exist(workspace: Workspace) -> bool:
    """Whether one needs an account here: some were added, or a reverse proxy signs people in."""
    return bool(os.environ.get(USER_HEADER)) or workspace.users.exist()


def visitor(workspace: Workspace, token: str | None, active: bool) -> Person | None:
    """Who sends the current request; None where nobody is known. active: not just a page that asks for news.

    Raises UnknownUser.
    """
    person = _known(workspace, token, active)
    boards = boards_of_keys(workspace, kept_keys())
    if person is None:
        return _guest(boards) if boards else None
    edits = frozenset(board.id for board, right in boards if right == "edit")
    return replace(person, boards=edits) if edits else person


def _known(workspace: Workspace, token: str | None, active: bool) -> Person | None:
    if token and same(request.cookies.get(TOKEN_COOKIE, ""), token):
        return OWNER
    if not accounts_exist(workspace):
        return None if token else OWNER
    header = os.environ.get(USER_HEADER, "")
    name = request.headers.get(header, "").strip() if header and from_trusted_proxy() else ""
    if name:
        person = workspace.users.person(name)
        if person is None:
            raise UnknownUser(f"You are signed in as {name[:80]}, but have no account in this workspace.")
        return person
    return person_of_session(workspace, active)


def kept_keys() -> list[str]:
    """The keys of boards whose links this browser has opened."""
    return request.cookies.get(BOARDS_COOKIE, "").split(" ")[:MOST_KEYS]


def boards_of_keys(workspace: Workspace, keys: list[str]) -> list[tuple[Board, str]]:
    """The boards that keys open, each with "read" or "edit"; keys that open none are left out."""
    boards: list[tuple[Board, str]] = []
    for key in filter(None, keys):
        try:
            boards.append(workspace.boards.by_key(key))
        except (DocumentGone, WorkspaceError):
            continue
    return boards


def _guest(boards: list[tuple[Board, str]]) -> Person:
    named = [shown(board) for board, _ in boards]
    return Person(
        GUEST,
        "viewer",
        boards=frozenset(board.id for board, right in boards if right == "edit"),
        only=frozenset(board.id for board, _ in boards),
        datasets=frozenset().union(*(datasets for datasets, _ in named)),
        views=frozenset().union(*(views for _, views in named)),
    )


def current() -> Person:
    """Who sends the current request, once it has been let in."""
    person: Person = g.get("person", OWNER)
    return person


def same(offered: str, token: str) -> bool:
    """Whether a visitor offers the token, compared in constant time."""
    return hmac.compare_digest(offered.encode(errors="replace"), token.encode())
