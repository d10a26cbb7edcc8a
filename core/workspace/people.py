"""Who is acting, and what they may do. The app says who it is for each request; everything else acts as the owner.

The checks stand where the workspace is changed, so that no route, callback or command can forget them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from getpass import getuser

from core.workspace.errors import WorkspaceError

ROLES = ("viewer", "editor", "owner")  # each may do what those before it may


class AccessRefused(WorkspaceError):
    """The person who acts may not do this; the message says which role may."""


@dataclass(frozen=True)
class Person:
    """Someone who acts. role: one of ROLES; roles: id of a dataset -> their role there, where it is another.

    boards: ids of boards that an edit link lets them change. only: for a guest with links to boards, the ids of those
    boards; they see nothing else but the datasets (names) and saved views (ids) that these show. None: they see all.
    """

    name: str = ""
    role: str = "owner"
    roles: Mapping[str, str] = field(default_factory=dict)
    boards: frozenset[str] = frozenset()
    only: frozenset[str] | None = None
    datasets: frozenset[str] = frozenset()
    views: frozenset[str] = frozenset()

    @property
    def is_guest(self) -> bool:
        """Whether links to boards are all they have."""
        return self.only is not None

    def may(self, role: str, dataset: str | None = None) -> bool:
        """Whether they have this role or a higher one, on the dataset with this id where one is given."""
        own = self.roles.get(dataset, self.role) if dataset else self.role
        return ROLES.index(own) >= ROLES.index(role)

    def may_change_something(self) -> bool:
        """Whether there is any dataset that they may change."""
        return self.may("editor") or any(self.may("editor", dataset) for dataset in self.roles)

    def may_change_board(self, board: str) -> bool:
        """Whether they may change the board with this id: editors any, others those whose edit link they have."""
        return self.may("editor") or board in self.boards

    def may_see_board(self, board: str) -> bool:
        """Whether they may see the board with this id."""
        return self.only is None or board in self.only


OWNER = Person()
_acting: ContextVar[Person] = ContextVar("acting", default=OWNER)


def acting() -> Person:
    """Who acts now."""
    return _acting.get()


@contextmanager
def acting_as(person: Person) -> Iterator[None]:
    """Within the block ``person`` acts, in this thread."""
    token = _acting.set(person)
    try:
        yield
    finally:
        _acting.reset(token)


def start_acting(person: Person) -> None:
    """``person`` acts from now on, in this thread; for servers that hear of a request before its work begins."""
    _acting.set(person)


def require(role: str, dataset: str | None = None, *, to: str) -> None:
    """Raises AccessRefused where who acts does not have the role, on the dataset with this id where one is given.

    to: what is about to be done, as in "delete this dataset".
    """
    person = acting()
    if not person.may(role, dataset):
        raise AccessRefused(refusal(person, role, to))


def require_board(board: str, *, to: str) -> None:
    """Raises AccessRefused where who acts may not change the board with this id."""
    person = acting()
    if not person.may_change_board(board):
        raise AccessRefused(refusal(person, "editor", to))


def refusal(person: Person, role: str, to: str) -> str:
    """Why someone may not do something, in words."""
    if person.is_guest:
        return f"This link does not let you {to}."
    return f"Only {'an' if role != 'viewer' else 'a'} {role} may {to}; {person.name or 'you'} may not."


def author(given: str = "") -> str:
    """The name under which a change is kept: of who is signed in, else the one that was given."""
    return acting().name or given


def name_on_record() -> str:
    """Whom the audit log names: who is signed in, else the account of the operating system."""
    if acting().name:
        return acting().name
    try:
        return getuser()
    except (OSError, KeyError, ImportError):
        return "someone on this machine"
