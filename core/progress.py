"""Progress and cancelling: the one protocol every long computation speaks.

A computation calls ``report(stage, fraction)`` now and then. Whoever started it may raise
:class:`Cancelled` from there; nothing else is needed to stop it cleanly.
"""

from __future__ import annotations

from collections.abc import Callable

Report = Callable[[str, float], None]


class Cancelled(Exception):
    """The person who started the computation stopped it."""


def silent(stage: str, fraction: float) -> None:
    """A report that nobody reads. ``fraction`` runs from 0 to 1 within ``stage``."""
