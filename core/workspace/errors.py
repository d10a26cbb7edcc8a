"""Errors of the workspace, in plain words for the person who sees them."""

from __future__ import annotations

import errno
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager

from core.errors import MotionscapeError


class WorkspaceError(MotionscapeError, ValueError):
    """The workspace cannot do what was asked; the message says what happened and what to do."""


class NameRefused(WorkspaceError):
    """A name cannot be used for a data set or an uploaded file; the message says why."""


class ResultDamaged(WorkspaceError):
    """A stored result cannot be read. It has been set aside, so that it can be computed again."""


class DocumentGone(WorkspaceError):
    """There is no such view, board, comment or version, or it has been deleted."""


class DocumentDamaged(WorkspaceError):
    """A version of a view or a board cannot be read; an earlier one can be restored."""


class ConflictError(WorkspaceError):
    """Someone else has changed the same thing meanwhile; nothing was saved.

    present: what it is now, None where it has been removed; author: who changed it last.
    """

    def __init__(self, message: str, present: object, author: str) -> None:
        super().__init__(message)
        self.present, self.author = present, author


_SYSTEM = {
    errno.ENOSPC: "the disk is full; free some space and try again",
    errno.EDQUOT: "your disk quota is used up; free some space and try again",
    errno.EACCES: "permission denied; check who owns the workspace folder",
    errno.EPERM: "permission denied; check who owns the workspace folder",
    errno.EROFS: "the disk is read-only; choose a workspace on a disk that can be written",
    errno.ENAMETOOLONG: "the path is too long; choose a workspace nearer to the root of the disk",
    errno.EMFILE: "too many files are open; close other programs or raise the limit (ulimit -n)",
}
_TABLE = {
    "locked": "the job table is busy; another process has held it for long. Try again in a moment",
    "busy": "the job table is busy; another process has held it for long. Try again in a moment",
    "full": "the disk is full; free some space and try again",
    "readonly": "the job table is read-only; check who owns the workspace folder",
    "unable to open": "the job table cannot be opened; check that the workspace folder exists and is writable",
}
_DAMAGED = (
    "workspace.sqlite is damaged. Stop Motionscape and run motionscape doctor WORKSPACE --repair, or rename that file "
    "and start again: datasets and results are found again"
)


def explain(error: BaseException) -> str:
    """What ``error`` (an OSError, MemoryError or sqlite3.Error) means for a person, as one line."""
    if isinstance(error, MemoryError):
        return "not enough memory; close other programs, or take fewer clips or a lower frame rate"
    if isinstance(error, sqlite3.Error):
        text = str(error).lower()
        return next((words for mark, words in _TABLE.items() if mark in text), _DAMAGED)
    if isinstance(error, OSError):
        return _SYSTEM.get(error.errno or 0, error.strerror or str(error))
    return str(error)


def was_interrupted(error: BaseException | None) -> bool:
    """Whether ``error`` is Ctrl+C, or what came of it inside a compiled kernel (numba raises a SystemError there)."""
    while error is not None:
        if isinstance(error, KeyboardInterrupt):
            return True
        error = error.__cause__ or error.__context__
    return False


@contextmanager
def plain_errors(doing: str) -> Iterator[None]:
    """Turns system and table errors inside the block into WorkspaceError: ``doing``, then what to do about it."""
    try:
        yield
    except (OSError, sqlite3.DatabaseError, MemoryError) as error:
        raise WorkspaceError(f"Could not {doing}: {explain(error)}.") from error
