"""Progress and cancelling of long computations.

A computation calls ``report(stage, fraction)`` now and then. Whoever started it may raise
:class:`Cancelled` from there; nothing else is needed to stop it cleanly.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

Report = Callable[[str, float], None]


class Cancelled(Exception):
    """The person who started the computation stopped it."""


def silent(stage: str, fraction: float) -> None:
    """A report that does nothing. ``fraction`` runs from 0 to 1 within ``stage``."""


Progress = Callable[[float], None]
"""Hears how much of one stage is done, from 0 to 1."""


def unheard(fraction: float) -> None:
    """A progress that nobody hears."""


def part_of(progress: Progress, start: float, end: float) -> Progress:
    """The progress of a part of a stage, which goes from ``start`` to ``end`` of it."""
    return lambda fraction: progress(start + (end - start) * fraction)


@contextmanager
def timed(stage: str, seconds: dict[str, float]) -> Iterator[None]:
    """Records in ``seconds`` how long the block took."""
    started = time.perf_counter()
    yield
    seconds[stage] = time.perf_counter() - started
