"""Paths through a motif graph: chosen motif by motif, between two motifs, or at random.

In text, as links and the command line give them: ``3-7-9``; ``fewest:3:9`` or ``used:3:9`` from motif 3 to motif 9 in
the fewest steps or along the most-used edges; ``random:30:7`` or ``random:30:7:3``, 30 seconds at random with seed 7,
beginning anywhere or in motif 3.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components, dijkstra

from core.errors import AnalysisError, ParameterError
from core.mocap.dataset import Dataset
from core.motifs.graph import Motif, MotifGraph
from core.synthesis.links import Link, further_links, seen_links
from core.synthesis.postures import Moment, moments_apart

MOST_MOTIFS = 1000
MOST_SECONDS = 600.0
_JUMPS = 5  # a jump from a dead end goes to one of so many motifs that begin most like it ends


class Between(NamedTuple):
    """From one motif to another: in the fewest steps, or ("used") along the edges that were seen most often."""

    start: int
    target: int
    by: str = "fewest"


class Random(NamedTuple):
    """At random, edges as likely as they were often, for about so many seconds; ``start``: a motif, or anywhere."""

    seconds: float
    seed: int = 0
    start: int | None = None


class NoWay(AnalysisError):
    """No edge leads from ``source`` to ``target``; ``detour``: motifs of the shortest way, ends included, or None."""

    def __init__(self, source: int, target: int, detour: tuple[int, ...] | None):
        self.source, self.target, self.detour = source, target, detour
        by = ", ".join(map(str, detour[1:-1])) if detour else ""
        way = f"The shortest way goes by way of {by}" if detour else "Nor is there any way round"
        super().__init__(
            f"No edge leads from motif {source} to motif {target}. {way}; a blend could bridge the gap as well."
        )


@dataclass(frozen=True, eq=False)
class Ways:
    """The links a walk may take, by (source, target).

    clips: the clips they are in, all of one kind of skeleton.
    """

    motifs: Mapping[int, Motif]
    links: Mapping[tuple[int, int], tuple[Link, ...]]
    clips: frozenset[str]

    @cached_property
    def following(self) -> dict[int, dict[int, int]]:
        """Per motif with motions in these clips: the motifs that can follow it, and by how many links."""
        ways: dict[int, dict[int, int]] = {
            m.id: {} for m in self.motifs.values() if any(s.clip in self.clips for s in m.segments)
        }
        for (source, target), links in self.links.items():
            ways[source][target] = len(links)
        return ways

    @cached_property
    def dead_ends(self) -> tuple[int, ...]:
        """Motifs that no other motif can follow."""
        return tuple(motif for motif, after in self.following.items() if not set(after) - {motif})

    @cached_property
    def components(self) -> tuple[tuple[int, ...], ...]:
        """Groups of motifs that can all reach one another, largest first."""
        ids = list(self.following)
        if not ids:
            return ()
        _, group = connected_components(self._matrix(ids, lambda count: 1.0), connection="strong")
        groups: dict[int, list[int]] = {}
        for motif, g in zip(ids, group, strict=True):
            groups.setdefault(int(g), []).append(motif)
        return tuple(sorted(map(tuple, groups.values()), key=lambda members: (-len(members), members)))

    def shortest(self, way: Between) -> tuple[int, ...] | None:
        """Motif ids of the best way, ends included; None where there is none. Raises ValueError for unknown motifs."""
        for motif in (way.start, way.target):
            self.check(motif)
        ids = list(self.following)
        # fewest steps: of two ways with as many, the more used one
        matrix = self._matrix(ids, lambda count: 1 + 1e-3 / count if way.by == "fewest" else 1 / count)
        _, before = dijkstra(matrix, indices=np.array(ids.index(way.start)), return_predecessors=True)
        at, path = ids.index(way.target), [way.target]
        while ids[at] != way.start:
            at = int(before[at])
            if at < 0:
                return None
            path.append(ids[at])
        return tuple(reversed(path))

    def check(self, motif: int) -> None:
        """Raises ParameterError where a walk cannot come to this motif."""
        if motif not in self.motifs:
            known = f"they go from {min(self.motifs)} to {max(self.motifs)}" if self.motifs else "there are none"
            raise ParameterError(f"There is no motif {motif}; {known}.")
        if motif not in self.following:
            raise ParameterError(f"Motif {motif} has no motion of the skeleton that this walk keeps to.")

    def _matrix(self, ids: Sequence[int], cost: Callable[[int], float]) -> csr_matrix:
        at = {motif: k for k, motif in enumerate(ids)}
        rows = [(at[s], at[t], cost(n)) for s, after in self.following.items() for t, n in after.items() if s != t]
        table = np.array(rows, np.float64).reshape(-1, 3)
        i, k = table[:, 0].astype(np.int64), table[:, 1].astype(np.int64)
        return csr_matrix((table[:, 2], (i, k)), shape=(len(ids), len(ids)))


def open_ways(dataset: Dataset, graph: MotifGraph, further: bool = False, family: int = 0) -> Ways:
    """The links of one family of skeletons (those with the same joints), the one with most motion first.

    further: with :func:`core.synthesis.links.further_links`. Raises IndexError where there is no such family.
    """
    motifs = {motif.id: motif for motif in graph.motifs}
    clips = skeleton_families(dataset, graph)[family]
    links = dict(seen_links(graph, clips))
    if further:
        links |= further_links(dataset, graph, clips)
    return Ways(motifs, links, clips)


def skeleton_families(dataset: Dataset, graph: MotifGraph) -> list[frozenset[str]]:
    """Names of the clips of the motifs, grouped by the joints of their skeletons, the group with most motion first.

    Raises KeyError for a clip that the data set does not have.
    """
    groups: dict[tuple[Any, ...], dict[str, float]] = {}
    for motif in graph.motifs:
        for segment in motif.segments:
            clip = dataset.clip(segment.clip)
            joints = clip.skeleton.names, tuple(clip.skeleton.parents)
            group = groups.setdefault(joints, {})
            group[clip.name] = group.get(clip.name, 0.0) + segment.n_frames / clip.fps
    return [frozenset(group) for group in sorted(groups.values(), key=lambda group: -sum(group.values()))]


def parse_path(text: str) -> tuple[int, ...] | Between | Random:
    """What a path in text asks for. Raises ParameterError, saying what is expected."""
    if re.fullmatch(r"\d{1,6}(-\d{1,6})*", text):
        path = tuple(map(int, text.split("-")))
        if len(path) > MOST_MOTIFS:
            raise ParameterError(f"A walk has at most {MOST_MOTIFS} motifs, not {len(path)}.")
        return path
    if match := re.fullmatch(r"(fewest|used):(\d{1,6}):(\d{1,6})", text):
        return Between(int(match[2]), int(match[3]), match[1])
    if match := re.fullmatch(r"random:(\d{1,6}(?:\.\d{1,3})?):(\d{1,9})(?::(\d{1,6}))?", text):
        seconds = float(match[1])
        if not 0 < seconds <= MOST_SECONDS:
            raise ParameterError(
                f"A random walk lasts at most {MOST_SECONDS:g} seconds, and more than 0, not {seconds:g}."
            )
        return Random(seconds, int(match[2]), int(match[3]) if match[3] else None)
    shown = text if len(text) <= 40 else text[:39] + "…"
    raise ParameterError(f"“{shown}” is no path; it should look like 3-7-9, fewest:3:9, used:3:9 or random:30:7.")


def random_path(dataset: Dataset, ways: Ways, wanted: Random, dead_end: str = "jump") -> tuple[tuple[int, ...], str]:
    """Motif ids of a random walk, and why it ended before its time ("" where it did not).

    dead_end: "stop" there, or "jump" to a motif that begins much like the dead end ends. The length is an estimate from
    the mean lengths of motions and transitions. Raises AnalysisError where there is nothing to walk.
    """
    if not ways.following:
        raise AnalysisError("There are no motifs to walk through.")
    rng = np.random.default_rng(wanted.seed)
    leads_on = [motif for motif in ways.following if motif not in ways.dead_ends] or list(ways.following)
    if wanted.start is None:
        path = [int(rng.choice(leads_on))]
    else:
        ways.check(wanted.start)
        path = [wanted.start]
    lengths = {motif: _seconds(dataset, ways, motif) for motif in ways.following}
    total = lengths[path[0]]
    while total < wanted.seconds and len(path) < MOST_MOTIFS:
        here = path[-1]
        if here not in ways.dead_ends:
            after = list(ways.following[here])
            weights = np.array([ways.following[here][motif] for motif in after], np.float64)
            path.append(int(rng.choice(after, p=weights / weights.sum())))
            total += _between(dataset, ways.links[here, path[-1]])
        elif dead_end == "stop" or not set(leads_on) - {here}:
            return tuple(path), f"The walk ends early, in motif {here}: nothing leads on from there."
        else:
            path.append(_jump(dataset, ways, here, leads_on, rng))
        total += lengths[path[-1]]
    return tuple(path), ""


def fill_gaps(ways: Ways, path: Sequence[int]) -> tuple[int, ...]:
    """The path with the shortest ways put in wherever no edge leads on. Raises NoWay where there is none."""
    whole = [path[0]]
    for source, target in pairwise(path):
        if (source, target) in ways.links:
            whole.append(target)
            continue
        detour = ways.shortest(Between(source, target)) if source != target else None
        if detour is None:
            raise NoWay(source, target, None)
        whole += detour[1:]
    return tuple(whole)


def _seconds(dataset: Dataset, ways: Ways, motif: int) -> float:
    motions = [s for s in ways.motifs[motif].segments if s.clip in ways.clips]
    return float(np.mean([s.n_frames / dataset.clip(s.clip).fps for s in motions]))


def _between(dataset: Dataset, links: Collection[Link]) -> float:
    """Mean seconds of the frames between two motifs."""
    gaps = [(k.entry.frame - k.exit.frame) / dataset.clip(k.exit.clip).fps if k.kind == "seen" else 0.0 for k in links]
    return float(np.mean(gaps))


def _jump(dataset: Dataset, ways: Ways, here: int, targets: Sequence[int], rng: np.random.Generator) -> int:
    """One of the motifs that begin most like this one ends."""
    others = [motif for motif in targets if motif != here]
    first = {motif: next(s for s in ways.motifs[motif].segments if s.clip in ways.clips) for motif in (here, *others)}
    moments = [Moment(first[here].clip, first[here].end - 1), *(Moment(first[m].clip, first[m].start) for m in others)]
    features = moments_apart(dataset, moments)
    order = np.linalg.norm(features[1:] - features[0], axis=1).argsort(kind="stable")
    return others[int(rng.choice(order[:_JUMPS]))]
