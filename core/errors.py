"""The errors that are meant for people: their messages are shown unchanged.

Every other exception that reaches a person is a bug of ours: it is logged with an id, and the person sees the id.
"""

from __future__ import annotations

import os


class MotionscapeError(Exception):
    """What was asked for cannot be done; the message says what is wrong and, where possible, what to do about it."""


class ParameterError(MotionscapeError, ValueError):
    """A setting or another choice cannot be used; the message says which and what is expected."""


class AnalysisError(MotionscapeError, ValueError):
    """What was asked for cannot be made of these recordings or results."""


class FormatError(MotionscapeError, ValueError):
    """A document is not of the expected format, or is damaged."""


class LoggedBug(AnalysisError):
    """A bug that has been logged under ``bug_id``; the message tells the person so."""

    def __init__(self, message: str, bug_id: str) -> None:
        super().__init__(message)
        self.bug_id = bug_id


def new_bug_id() -> str:
    """Six letters and digits that identify a bug in the log and in the message."""
    return os.urandom(3).hex()
