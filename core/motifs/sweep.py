"""Many motif graphs of one data set; the points of a sweep share all stages that they have in common.

Poses are computed once per frame rate and kind, letters once per kappa and seed, matches once per rule; only the greedy
discovery and what follows is done for every point (MMG section 5.2 runs the whole method for every point).
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from queue import Empty, LifoQueue, SimpleQueue
from threading import Event, Lock, Thread, get_ident
from typing import Any, NamedTuple

from core.mocap.dataset import Dataset
from core.motifs.axes import Axes, points_of
from core.motifs.graph import MotifGraph
from core.motifs.parameters import MotifParameters
from core.motifs.stages import STAGES, Stage, Work, made
from core.progress import Cancelled, Report, silent

_LOOK = 0.1  # seconds between two looks at whether the sweep has been cancelled
# of the time of an analysis, the others 1
_SHARES = {"poses": 2.0, "quantisation": 3.0, "matching": 8.0, "discovery": 8.0, "alignment": 2.0}


class Point(NamedTuple):
    """A point of a sweep and its result."""

    parameters: MotifParameters
    graph: MotifGraph


def sweep(
    dataset: Dataset,
    base: MotifParameters,
    axes: Axes,
    seeds: int = 1,
    on_point: Callable[[Point], None] | None = None,
    report: Report = silent,
) -> tuple[Point, ...]:
    """The motif graphs of every combination of the axes' values, in the order of :func:`core.motifs.axes.points_of`.

    Each graph is the one that ``find_motifs`` finds with the same parameters. ``on_point`` gets each as soon as it is
    there, in this thread. Raises ParameterError (a ValueError) for axes that cannot be used, ValueError for a data set
    without poses, and whatever ``report`` or ``on_point`` raises.
    """
    points = points_of(base, axes, seeds)
    points_by_index: dict[int, Point] = {}
    for k, graph in graphs_of(dataset, points, report):
        points_by_index[k] = Point(points[k], graph)
        if on_point is not None:
            on_point(points_by_index[k])
    return tuple(points_by_index[k] for k in range(len(points)))


def graphs_of(
    dataset: Dataset,
    points: Sequence[MotifParameters],
    report: Report = silent,
    *,
    ready: int = 0,
    workers: int | None = None,
    stages: Sequence[Stage] = STAGES,
) -> Iterator[tuple[int, MotifGraph]]:
    """The graph of each of ``points``, with its number among them, as they get ready; one thread a core.

    The seconds of a graph are those of the stages behind it, whoever shares them. ``report`` is called in the thread
    that iterates, ten times a second at least; what it raises stops the sweep, and so does no longer iterating.
    ready: how many more points were there before, for the report.
    ``stages``: the pipeline, where it is another; the last one must leave the graph.
    """
    tree = _Tree(dataset, points, stages)
    threads = [Thread(target=tree.work, daemon=True) for _ in range(min(workers or os.cpu_count() or 1, len(points)))]
    total, already = ready + len(points), ready
    if total:
        report(f"{ready} of {total} points", already / total)
    for thread in threads:
        thread.start()
    try:
        while ready < total:
            report(f"{ready} of {total} points", (already + tree.fraction * len(points)) / total)
            for k, graph in tree.next_graphs():
                ready += 1
                yield k, graph
        report(f"{ready} of {total} points", 1.0)
    finally:
        tree.stop(len(threads))
        for thread in threads:
            thread.join()


class _Node(NamedTuple):
    """A stage that waits to be done, for the points that all share it, on the work of the stages before."""

    depth: int
    points: list[int]
    work: Work


class _Tree:
    """The stages of all points as a tree, whose leaves are graphs. Several threads may work on it at once.

    What was begun last is continued first, so that points get ready one after another, and only as many half-finished
    analyses are in memory as there are threads. A stage's result is let go when its last point has used it.
    """

    def __init__(self, dataset: Dataset, points: Sequence[MotifParameters], stages: Sequence[Stage]):
        self._points, self._stages = points, stages
        self._waiting: LifoQueue[_Node | None] = LifoQueue()
        self._ready: SimpleQueue[tuple[list[int], MotifGraph] | BaseException] = SimpleQueue()
        self._over, self._counting = Event(), Lock()
        keys = [tuple(stage.key(point) for stage in stages) for point in points]
        self._n_nodes = sum(
            _SHARES.get(stage.name, 1.0) * len({key[: depth + 1] for key in keys}) for depth, stage in enumerate(stages)
        )
        self._n_done = 0.0
        self._begun: dict[int, float] = {}  # what the stages that are being done add, by thread
        self._push(0, list(range(len(points))), Work(dataset=dataset))

    @property
    def fraction(self) -> float:
        """Share of all stages that is done, by the time that they usually take."""
        with self._counting:
            return min((self._n_done + sum(tuple(self._begun.values()))) / self._n_nodes, 1.0)

    def work(self) -> None:
        """Does stages until it is told to stop; for a thread."""
        while (node := self._waiting.get()) is not None and not self._over.is_set():
            try:
                self._do(node)
            except BaseException as error:
                self._ready.put(error)

    def next_graphs(self) -> Iterator[tuple[int, MotifGraph]]:
        """What got ready since, after waiting for a moment; raises what stopped a thread."""
        try:
            item = self._ready.get(timeout=_LOOK)
        except Empty:
            return
        if isinstance(item, BaseException):
            raise item
        yield from ((k, item[1]) for k in item[0])

    def stop(self, n_threads: int) -> None:
        """Has ``n_threads`` threads leave as soon as their kernels end."""
        self._over.set()
        for _ in range(n_threads):
            self._waiting.put(None)

    def _do(self, node: _Node) -> None:
        stage, thread = self._stages[node.depth], get_ident()
        share, furthest = _SHARES.get(stage.name, 1.0), 0.0

        def look(_stage: str, fraction: float) -> None:
            nonlocal furthest
            if self._over.is_set():
                raise Cancelled
            furthest = max(furthest, fraction)  # a stage may report several times from 0 to 1
            self._begun[thread] = share * furthest

        work = stage.after(node.work, self._points[node.points[0]], look)
        with self._counting:
            self._begun[thread] = 0.0
            self._n_done += share
        if node.depth + 1 < len(self._stages):
            self._push(node.depth + 1, node.points, work)
        else:
            self._ready.put((node.points, replace(made(work.graph), seconds=dict(work.seconds))))

    def _push(self, depth: int, points: list[int], work: Work) -> None:
        groups: dict[tuple[Any, ...], list[int]] = {}
        for k in points:
            groups.setdefault(self._stages[depth].key(self._points[k]), []).append(k)
        for group in reversed(groups.values()):
            self._waiting.put(_Node(depth, group, work))
