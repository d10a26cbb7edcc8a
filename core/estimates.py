"""How long a job will take and how much memory, said before it starts.

An estimate begins with what the benchmark measured (``core/data/costs.json``, written by ``python -m benchmarks
scale``): for each method seconds and memory at several amounts of work, on the demo, whose motion repeats itself all
the time. It is then scaled by what jobs of the same method took on this machine: those on the same dataset count alone
where there are any, because only they know how much of it repeats. The range says how far they lay apart.
"""

from __future__ import annotations

import json
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Any

import numpy as np

from core.grammar.table import TableParameters
from core.machine import PeakMemory, free_bytes, in_gigabytes
from core.motifs.axes import SweepParameters
from core.requests import Request
from core.workspace import Workspace, WorkspaceError
from core.workspace.costs import Cost

if TYPE_CHECKING:
    from core.mocap.dataset import Dataset

PRIOR = Path(__file__).parent / "data" / "costs.json"
LONG = 600.0  # seconds from which on a job asks first
_START = 1.0  # seconds a job takes beside the work itself
_UNKNOWN = 2.5  # by which factor a method may take more or less that has not run on this machine
_ONE = 1.6  # the same after one job
_MORE = 1.25  # beyond the longest and shortest of several jobs
_UPLOADS = ("import", "add", "query")
_EXACT = "exact"  # motifs that are found by matching everything with everything


@dataclass(frozen=True)
class Estimate:
    """What a job will take. seconds, bytes: least and most; measured: how many jobs on this machine it rests on."""

    seconds: tuple[float, float]
    bytes: tuple[float, float]
    measured: int

    @property
    def words(self) -> str:
        """``2 to 5 min, up to 1.3 GB``."""
        return f"{_span(*self.seconds)}, up to {in_gigabytes(self.bytes[1])}"

    @property
    def middle(self) -> tuple[float, float]:
        """Likely seconds and bytes."""
        return float(np.sqrt(np.prod(self.seconds))), float(np.sqrt(np.prod(self.bytes)))

    def objection(self, advice: str) -> str:
        """Why one should think twice before the job starts, with the ``advice``; empty where there is no reason."""
        seconds, size = self.middle
        free = free_bytes()
        if size > free:
            return (
                f"This would take about {in_gigabytes(size)} of memory, and {in_gigabytes(free)} may be used; "
                f"it would end without a result. {advice}"
            )
        return f"This would take {_span(*self.seconds)}. {advice}" if seconds > LONG else ""


def estimate(workspace: Workspace, request: Request) -> Estimate | None:
    """What a normalised request will take; None where nothing like it was ever measured."""
    past = workspace.costs.of(kind_of(request))
    same = [cost for cost in past if cost.fingerprint == _fingerprint(workspace, request)]
    return _estimated(kind_of(request), amount_of(workspace, request), same or past, workspace.costs.newest())


def estimate_of(dataset: Dataset, request: Request) -> Estimate | None:
    """The same for an analysis of a dataset in memory, which no workspace knows."""
    amount = amount_of_frames(request, dataset.seconds, dataset.n_frames)
    return _estimated(kind_of(request), amount, (), ())


def _estimated(kind: str, amount: float, experience: Sequence[Cost], newest: Sequence[Cost]) -> Estimate | None:
    """experience: what the same kind of job took on this machine; newest: what any did."""
    points = _prior().get(kind) or [(cost.amount, cost.seconds, cost.bytes) for cost in experience[:1]]
    if not amount or not points:
        return None
    ratios = [_ratio(points, cost) for cost in experience]
    if not ratios:
        others = [_ratio(_prior()[cost.method], cost) for cost in newest if cost.method in _prior()]
        ratios, spread = [_median(others) or (1.0, 1.0)], _UNKNOWN
    else:
        spread = _ONE if len(ratios) == 1 else _MORE
    seconds, size = _likely(points, amount)
    times, sizes = zip(*ratios, strict=True)
    return Estimate(
        (seconds * min(times) / spread, seconds * max(times) * spread),
        (size * min(sizes) / _MORE, size * max(sizes) * _MORE),
        len(experience),
    )


def advice_for(request: Request) -> str:
    """What makes a request cheaper, in a sentence."""
    if request.method in _UPLOADS:
        return "Bring fewer files at a time."
    if kind_of(request) == _EXACT:
        return "Leave sample at its default and seeding at largest, or take fewer clips or a lower frame rate."
    if request.method == "sweep":
        return "Take fewer values or seeds, fewer clips or a lower frame rate."
    return "Take fewer clips or a lower frame rate."


def kind_of(request: Request) -> str:
    """The name under which costs of a request are kept: its method, but matching everything is a kind of its own."""
    values = request.parameters
    exact = values.get("sample") == 0 or values.get("seeding") == "random"
    return _EXACT if request.method == "motifs" and exact else request.method


def amount_of_frames(request: Request, seconds: float, frames: int) -> float:
    """The amount of work of an analysis of so many seconds and frames."""
    return _frames_looked_at(request, seconds, frames) * _analyses(request)


def amount_of(workspace: Workspace, request: Request) -> float:
    """The amount of work of a request: frames that are looked at, times the number of analyses; bytes of an upload.

    0 where there is no such dataset or upload.
    """
    with suppress(WorkspaceError):
        return _amount(workspace, request)
    return 0.0


def _amount(workspace: Workspace, request: Request) -> float:
    if request.method in _UPLOADS:
        return float(workspace.uploads.size(str(request.parameters["upload"]))[1])
    if request.method == "demo":
        return 60.0 * float(request.parameters["minutes"])
    info = workspace.info(request.dataset)
    return amount_of_frames(request, info.seconds, info.frames)


@contextmanager
def counted(workspace: Workspace, request: Request) -> Iterator[None]:
    """Keeps what the block took, if it ends well, for later estimates; a table that is busy is no reason to fail."""
    amount, started = amount_of(workspace, request), time.perf_counter()  # before: an upload is gone afterwards
    with PeakMemory() as peak:
        yield
    seconds = time.perf_counter() - started
    with suppress(WorkspaceError):
        fingerprint = _fingerprint(workspace, request)
        workspace.costs.add(Cost(kind_of(request), fingerprint, amount, seconds, peak.bytes))


def _frames_looked_at(request: Request, seconds: float, frames: int) -> float:
    """Frames that a request looks at in recordings of so many seconds and frames; all where it has no rate of its own.

    Methods that work on a result of another one look at what that one looked at.
    """
    values: Mapping[str, Any] = request.parameters
    for inner in ("terminals", "grammar", "graph"):
        values = values[inner] if isinstance(values.get(inner), Mapping) else values
    rate = values.get("analysis_fps")
    return seconds * float(rate) if isinstance(rate, int | float) and rate > 0 else float(frames)


def _analyses(request: Request) -> int:
    values = request.parameters
    if request.method == "sweep":
        return len(SweepParameters(**values).points())
    if request.method == "grammar-table":
        return len(TableParameters(**values).points())
    if request.method == "stability":
        return 7 + 2 * int(values["repetitions"])
    return 1


def _fingerprint(workspace: Workspace, request: Request) -> str:
    with suppress(WorkspaceError):
        return workspace.info(request.dataset).fingerprint
    return ""


Point = tuple[float, float, float]
"""Amount of work, seconds, bytes."""


@cache
def _prior() -> dict[str, list[Point]]:
    document = json.loads(PRIOR.read_text(encoding="utf-8"))
    return {method: [(a, s, b) for a, s, b in points] for method, points in document["methods"].items()}


def _likely(points: Sequence[Point], amount: float) -> tuple[float, float]:
    """Seconds and bytes for an amount of work, between and beyond measured points; growth is a power of the amount."""
    amounts, seconds, sizes = np.log(np.maximum(np.array(points, float).T, 1e-9))
    at = np.log(max(amount, 1e-9))
    likely = _START + np.exp(_power(amounts, seconds, at, 1.0))
    return float(likely), float(np.exp(_power(amounts, sizes, at, 0.0)))


def _power(x: np.ndarray, y: np.ndarray, at: float, least: float) -> float:
    """``y`` at ``at`` along straight lines through the points; beyond them as steep as there, at least ``least``."""
    slopes = np.diff(y) / np.diff(x) if len(x) > 1 else np.array([1.0])
    if at > x[-1]:
        return float(y[-1] + max(slopes[-1], least) * (at - x[-1]))
    if at < x[0]:
        return float(y[0] + max(slopes[0], 0.0) * (at - x[0]))
    return float(np.interp(at, x, y))


def _ratio(points: Sequence[Point], cost: Cost) -> tuple[float, float]:
    """By what factors a job took more time and memory than the points say."""
    seconds, size = _likely(points, cost.amount)
    return cost.seconds / seconds, cost.bytes / size


def _median(ratios: Sequence[tuple[float, float]]) -> tuple[float, float] | None:
    return (median(r[0] for r in ratios), median(r[1] for r in ratios)) if ratios else None


def _span(low: float, high: float) -> str:
    """``2 to 5 min``: from ``low`` to ``high`` seconds as people say it."""
    if high < 5:
        return "a few seconds"
    first, last = _in_words(low), _in_words(high)
    if first == last:
        return f"about {last}"
    short = first.removesuffix(last[last.index(" ") :])  # "2 to 5 min", but "40 s to 2 min"
    return f"{short} to {last}"


def _in_words(seconds: float) -> str:
    unit, word = next((u, w) for u, w in ((3600.0, "h"), (60.0, "min"), (1.0, "s")) if seconds >= 1.5 * u or u == 1)
    number = float(f"{seconds / unit:.1g}") if seconds < 10 * unit else round(seconds / unit)
    return f"{max(number, 1):g} {word}"
