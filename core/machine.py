"""What the machine has left for an analysis: told before one starts, and a limit that ends it with words."""

from __future__ import annotations

import os
import threading
from contextlib import suppress
from pathlib import Path
from types import TracebackType

import psutil

from core.errors import AnalysisError, ParameterError

MEMORY = "MOTIONSCAPE_MEMORY_GB"
"""The environment variable that says how much memory analyses may take; without it, as much as is free."""

_CONTAINER = Path("/sys/fs/cgroup")  # where Linux keeps the limits of a container
_LEFT_FREE = 0.1  # share of the free memory that an analysis leaves to others


class TooLarge(AnalysisError):
    """An analysis would take more memory than there is; the message says how much, and what to do about it."""


def free_bytes() -> float:
    """Memory an analysis may take: what MOTIONSCAPE_MEMORY_GB says, else nine tenths of what is free.

    Raises ParameterError where the variable is no positive number.
    """
    if said := os.environ.get(MEMORY):
        try:
            gigabytes = float(said)
        except ValueError:
            gigabytes = 0.0
        if not 0 < gigabytes < float("inf"):
            raise ParameterError(f"{MEMORY} must be a number of gigabytes, such as 8, not {said!r}")
        return gigabytes * 1e9
    free = float(psutil.virtual_memory().available)
    with suppress(OSError, ValueError, KeyError):  # no container, or one without a limit ("max")
        used = dict(line.split() for line in (_CONTAINER / "memory.stat").read_text().splitlines())["anon"]
        free = min(free, float(int((_CONTAINER / "memory.max").read_text()) - int(used)))
    return (1 - _LEFT_FREE) * max(free, 0.0)


def check_fits(needed: float, what: str, advice: str) -> None:
    """Raises TooLarge, with ``what`` and the ``advice`` in words, if ``needed`` bytes are more than may be taken."""
    free = free_bytes()
    if needed > free:
        raise TooLarge(
            f"{what} would take about {in_gigabytes(needed)} of memory, and {in_gigabytes(free)} may be used. {advice} "
            f"(The environment variable {MEMORY} says how much analyses may take.)"
        )


def in_gigabytes(size: float) -> str:
    """Bytes as people read them: ``1.5 GB``."""
    return f"{size / 1e9:.1f} GB" if size >= 1e8 else f"{max(size / 1e6, 1):.0f} MB"


def used_bytes() -> int:
    """Memory that this process has for itself: without files that are mapped, whose pages the system can take back."""
    process = psutil.Process()
    with suppress(OSError, IndexError, ValueError):  # Linux alone tells it at once
        status = Path(f"/proc/{process.pid}/status").read_text(encoding="ascii")
        return int(status.partition("RssAnon:")[2].split()[0]) * 1024
    return int(process.memory_info().rss)


class PeakMemory:
    """The most memory that this process had for itself while the block ran: ``bytes``, looked at now and then."""

    def __init__(self, every: float = 0.2):
        self.bytes, self._every, self._over = used_bytes(), every, threading.Event()
        self._thread = threading.Thread(target=self._look, name="peak memory", daemon=True)

    def __enter__(self) -> PeakMemory:
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._over.set()
        self._thread.join()
        self.bytes = max(self.bytes, used_bytes())

    def _look(self) -> None:
        while not self._over.wait(self._every):
            self.bytes = max(self.bytes, used_bytes())


def limit_memory() -> None:
    """Lets this process take no more memory than is there, so that one that wants more gets a MemoryError.

    Without it the system ends some process or other, or comes to a halt. Does nothing where there is no such limit.
    """
    try:
        import resource
    except ImportError:  # Windows
        return
    taken = psutil.Process().memory_info()
    allowed = int(getattr(taken, "data", taken.rss) + free_bytes())
    soft, hard = resource.getrlimit(resource.RLIMIT_DATA)
    if soft == resource.RLIM_INFINITY or allowed < soft:
        resource.setrlimit(resource.RLIMIT_DATA, (allowed, hard))
        _limited.set()


_limited = threading.Event()  # this process has a limit of limit_memory


def allow_mapped(size: int) -> None:
    """Leaves a file of ``size`` bytes that is to be mapped privately out of the limit of :func:`limit_memory`.

    The system counts such a file as memory, though its pages can be taken back: a collection may be larger than memory.
    """
    if _limited.is_set():
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_DATA)
        resource.setrlimit(resource.RLIMIT_DATA, (soft + size if hard == resource.RLIM_INFINITY else hard, hard))
