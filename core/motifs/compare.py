"""Two motif graphs of one data set side by side: which motifs are kept, lost, gained, split or merged.

Motifs are compared by the time they share, and every frame lies in one motif at most, so one pass over the frames tells
all: cost linear in frames, whatever the number of motions.

Two motifs are *linked* when more than half of either lies in the other. A motif is *kept* when more than half of each
lies in the other (no motif can have two such partners), or when it is the only one linked to the only motif it is
linked to. Of the others, a motif linked to none is *lost* (of the second graph: *gained*); one linked to several is
*split* into them (of the second graph: *merged* from them); one whose partner is linked to several is one of the motifs
*merged* into it (of the second graph: *split* off it). Exchanging the graphs exchanges lost and gained, split and
merged.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np
from scipy.sparse import coo_array, csr_array

from core.errors import AnalysisError
from core.motifs.graph import MotifGraph

FORMAT = "motionscape/comparison/1"
CHANGES = ("kept", "split", "merged", "lost", "gained")
_HALF = 0.5 * (1 + 1e-9)  # exactly half is not more than half, whatever rounding says


@dataclass(frozen=True)
class Link:
    """Motif ``a`` of the first graph and ``b`` of the second share ``seconds`` of motion.

    overlap: what they share over what either has (Jaccard), 0 to 1; kept: whether they stand for each other.
    """

    a: int
    b: int
    overlap: float
    seconds: float
    kept: bool


@dataclass(frozen=True)
class Fate:
    """The change of a motif between two graphs, one of CHANGES.

    partners: motifs of the other graph it is linked to, the most shared first; best: its highest overlap with any motif
    of the other graph, linked or not; seconds: motion in it.
    """

    motif: int
    change: str
    partners: tuple[int, ...]
    best: float
    seconds: float


@dataclass(frozen=True, eq=False)
class Comparison:
    """Fates of the motifs of the first graph (``a``) and of the second (``b``), in the order of the graphs.

    links: linked pairs, the most shared first. shared: ``(n_a + 1, n_b + 1)`` seconds in each pair of motifs, in the
    order of the graphs after row and column 0, which stand for frames in no motif. agreement: share of all motion that
    lies in motifs kept for each other, or in none either time. adjusted_rand: the adjusted Rand index of the two
    groupings of all frames, "in no motif" being a group: 1 when they are equal, about 0 when they are unrelated.
    """

    a: tuple[Fate, ...]
    b: tuple[Fate, ...]
    links: tuple[Link, ...]
    shared: csr_array = field(repr=False)
    agreement: float
    adjusted_rand: float

    def counts(self, side: str) -> dict[str, int]:
        """Change -> number of motifs of the first ("a") or second ("b") graph; KeyError for other sides."""
        numbers = Counter(fate.change for fate in {"a": self.a, "b": self.b}[side])
        return {change: numbers[change] for change in CHANGES}

    def to_json(self) -> dict[str, Any]:
        """All but the table of shared seconds, as plain values."""
        return {
            "format": FORMAT,
            "agreement": self.agreement,
            "adjusted_rand": self.adjusted_rand,
            "first": [asdict(fate) for fate in self.a],
            "second": [asdict(fate) for fate in self.b],
            "links": [asdict(link) for link in self.links],
        }


def compare(a: MotifGraph, b: MotifGraph) -> Comparison:
    """The motifs of two graphs of the same clips matched by the motion they share.

    Time counts, not frames, so a clip of a higher rate weighs no more. Raises AnalysisError where the clips differ.
    """
    if dict(_clips(a)) != dict(_clips(b)):
        raise AnalysisError("the two results are of different recordings and cannot be compared motif by motif")
    first, weight = frame_motifs(a)
    second, _ = frame_motifs(b)
    shape = len(a.motifs) + 1, len(b.motifs) + 1
    shared = csr_array(coo_array((weight, (first + 1, second + 1)), shape=shape))
    shared.sum_duplicates()
    per_second = min((fps for _, _, fps in a.clips), default=1.0)
    return _comparison(a, b, shared, per_second)


def frame_motifs(graph: MotifGraph) -> tuple[np.ndarray, np.ndarray]:
    """Which motif each frame of all clips lies in, ``(n_frames,)`` int32 places in ``graph.motifs`` or -1, clips in
    the order of their names, and the time of each frame, ``(n_frames,)``, in frames of the slowest clip."""
    clips = sorted(graph.clips)
    starts = np.concatenate([[0], np.cumsum([frames for _, frames, _ in clips])]).astype(np.int64)
    at = {name: int(start) for (name, _, _), start in zip(clips, starts, strict=False)}
    motifs = np.full(starts[-1], -1, np.int32)
    for place, motif in enumerate(graph.motifs):
        for clip, start, end in motif.segments:
            motifs[at[clip] + start : at[clip] + end] = place
    rates = np.array([fps for _, _, fps in clips], float)
    return motifs, np.repeat(rates.min(initial=np.inf) / rates, np.diff(starts))


def _clips(graph: MotifGraph) -> Mapping[str, tuple[int, float]]:
    return {name: (frames, fps) for name, frames, fps in graph.clips}


def _comparison(a: MotifGraph, b: MotifGraph, shared: csr_array, per_second: float) -> Comparison:
    """``shared`` in frames of the slowest clip: whole numbers, and so exact, where all clips have one rate."""
    sizes_a, sizes_b = shared.sum(axis=1), shared.sum(axis=0)
    table = shared.tocoo()
    inner = (table.row > 0) & (table.col > 0)
    i, j, both = table.row[inner] - 1, table.col[inner] - 1, table.data[inner]
    of_a, of_b = sizes_a[i + 1], sizes_b[j + 1]
    overlap = both / (of_a + of_b - both)
    in_b, in_a = both > _HALF * of_a, both > _HALF * of_b
    linked = in_a | in_b
    degree_a = np.bincount(i[linked], minlength=len(a.motifs))
    degree_b = np.bincount(j[linked], minlength=len(b.motifs))
    kept = (in_a & in_b) | (linked & (degree_a[i] == 1) & (degree_b[j] == 1))
    links = [
        Link(a.motifs[i[k]].id, b.motifs[j[k]].id, float(overlap[k]), float(both[k] / per_second), bool(kept[k]))
        for k in np.flatnonzero(linked)
    ]
    links.sort(key=lambda link: (-link.seconds, link.a, link.b))
    agreed = shared[0, 0] + both[kept].sum()
    return Comparison(
        _fates(a, sizes_a[1:], _best(i, overlap, len(a.motifs)), links, per_second, first=True),
        _fates(b, sizes_b[1:], _best(j, overlap, len(b.motifs)), links, per_second, first=False),
        links=tuple(links),
        shared=csr_array(shared / per_second),
        agreement=float(agreed / max(sizes_a.sum(), 1e-12)),
        adjusted_rand=_adjusted_rand(shared.data, sizes_a, sizes_b),
    )


def _best(of: np.ndarray, overlap: np.ndarray, n: int) -> np.ndarray:
    best = np.zeros(n)
    np.maximum.at(best, of, overlap)
    return best


def _fates(
    graph: MotifGraph, sizes: np.ndarray, best: np.ndarray, links: list[Link], per_second: float, *, first: bool
) -> tuple[Fate, ...]:
    partners: dict[int, list[int]] = {motif.id: [] for motif in graph.motifs}
    kept = set()
    for link in links:
        here, there = (link.a, link.b) if first else (link.b, link.a)
        partners[here].append(there)
        if link.kept:
            kept.add(here)
    return tuple(
        Fate(
            motif.id,
            "kept" if motif.id in kept else _change(len(partners[motif.id]), first),
            tuple(partners[motif.id]),
            float(best[place]),
            float(sizes[place] / per_second),
        )
        for place, motif in enumerate(graph.motifs)
    )


def _change(links: int, first: bool) -> str:
    """Of a motif that is not kept; with one link only, its partner has several."""
    if links == 0:
        return "lost" if first else "gained"
    return "split" if (links > 1) == first else "merged"


def _adjusted_rand(cells: np.ndarray, rows: np.ndarray, columns: np.ndarray) -> float:
    """From the sizes of the groups' intersections and of the groups, in frames."""
    together, in_rows, in_columns = (_pairs(sizes) for sizes in (cells, rows, columns))
    expected = in_rows * in_columns / max(_pairs(np.array([rows.sum()])), 1e-12)
    highest = (in_rows + in_columns) / 2
    return float((together - expected) / (highest - expected)) if highest > expected else 1.0


def _pairs(sizes: np.ndarray) -> float:
    return float(np.maximum(sizes * (sizes - 1) / 2, 0).sum())
