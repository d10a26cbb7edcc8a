"""Messages for people when something cannot be done, and the log of unexpected errors."""

from __future__ import annotations

import logging

from core.errors import MotionscapeError, new_bug_id

log = logging.getLogger(__name__)


def sentence(error: MotionscapeError) -> str:
    """The message of an error that is meant for people, as a sentence."""
    text = str(error)
    if text.partition(" ")[0].isalpha():  # else it is the name of a clip or a file
        text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "?", "!")) else f"{text}."


def log_bug(where: str, error: BaseException) -> str:
    """Logs an error that is not meant for people, with its traceback; returns the id to show to the person."""
    bug_id = new_bug_id()
    log.error("error %s in %s", bug_id, where, exc_info=error)
    return bug_id
