"""The motif graph as a language: recordings as strings of motifs, and the walks that its edges allow."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from core.motifs.graph import MotifGraph


@dataclass(frozen=True)
class MotifPaths:
    """Clip -> its motifs in order of their first frames (those of clips with none are left out)."""

    by_clip: dict[str, tuple[int, ...]]

    @cached_property
    def known(self) -> set[tuple[int, ...]]:
        """All stretches of the recordings' strings."""
        return {
            path[i:j] for path in self.by_clip.values() for i in range(len(path)) for j in range(i + 1, len(path) + 1)
        }

    @cached_property
    def edges(self) -> int:
        """Different pairs of motifs that follow one another."""
        return len(self._pairs(None))

    @cached_property
    def bits(self) -> float:
        """Description length of edges and strings, for each string: two of the motifs an edge, then, at every step,
        log2 of the ways that lead on, an end among them."""
        pairs = self._pairs(None)
        motifs = {motif for path in self.by_clip.values() for motif in path}
        if not motifs:
            return float("nan")
        ways = {motif: 1 + sum(a == motif for a, _ in pairs) for motif in motifs}
        choice_bits = sum(np.log2(len(motifs)) + sum(np.log2(ways[m]) for m in path) for path in self.by_clip.values())
        return float((2 * len(pairs) * np.log2(len(motifs) + 1) + choice_bits) / len(self.by_clip))

    def without(self, clip: str) -> Callable[[Sequence[int]], bool]:
        """Whether all steps of a string are edges that other clips than this one have."""
        pairs = self._pairs(clip)
        return lambda path: all(pair in pairs for pair in pairwise(path))

    def _pairs(self, without: str | None) -> set[tuple[int, int]]:
        return {pair for name, path in self.by_clip.items() if name != without for pair in pairwise(path)}


def motif_paths(graph: MotifGraph) -> MotifPaths:
    """The strings of motifs that the recordings of a motif graph spell."""
    paths: dict[str, list[tuple[int, int]]] = {}
    for motif in graph.motifs:
        for segment in motif.segments:
            paths.setdefault(segment.clip, []).append((segment.start, motif.id))
    return MotifPaths({clip: tuple(motif for _, motif in sorted(paths[clip])) for clip in sorted(paths)})
