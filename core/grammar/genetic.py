"""The paper's coarse search: a genetic algorithm over cuts on a regular grid (SYN section 4.2, after Lee et al. 2011).

An individual says of every place of the grid whether there is a cut. Its score is F of the clusters that PAM finds
among its segments from the first K of them. Each generation keeps the best individual; the others are children of two
parents drawn by their scores, crossed at two points and mutated in about one place each. The paper does not give the
operators; these are the usual ones.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import kmedoids
import numpy as np

from core.grammar.objective import clustering_of, span_distances
from core.grammar.pose_space import PoseSpace
from core.progress import Report, silent

_PLACES = 150  # places of a grid that are searched at a time; longer recordings are split, as the paper does
_CANDIDATES = 6000  # different segments whose distances to one another are kept


@dataclass(frozen=True)
class GeneticSettings:
    """Size of the search; population and generations as in the paper's section 7.

    grid: poses between places; the paper says "e.g. 30 frames", of a rate that it does not tell.
    """

    grid: int = 15
    population: int = 100
    generations: int = 500


def genetic_spans(
    space: PoseSpace,
    k: int,
    weight: float,
    limits: tuple[int, int],
    rng: np.random.Generator,
    settings: GeneticSettings | None = None,
    report: Report = silent,
) -> np.ndarray:
    """Spans ``(n, 2)`` on the grid with the highest F that the search has seen, ends of clips always cut.

    Recordings with more than some 150 places are split into stretches that are searched one by one, with at most half
    as many groups as a stretch could have segments. limits: poses of the shortest and the longest segment; on a finer
    grid, cuts too near to the one before are left out.
    """
    settings = settings or GeneticSettings()
    stretches = _stretches(space, settings.grid, limits)
    spans = []
    for i, places in enumerate(stretches):

        def progress(stage: str, share: float, i: int = i) -> None:
            report(stage, (i + share) / len(stretches))

        spans.append(_search(space, places, k, weight, limits, rng, settings, progress))
    return np.concatenate(spans)


def pam(distances: np.ndarray, k: int) -> np.ndarray:
    """Medoids ``(k,)`` of the least sum of distances ``(n, n)``, from the first ``k`` objects: the paper's PAM."""
    if k >= len(distances):
        return np.arange(len(distances))
    clustering = kmedoids.fasterpam(distances, np.arange(k, dtype=np.uint64), n_cpu=1)
    return np.array(clustering.medoids, np.int64)


def _stretches(space: PoseSpace, grid: int, limits: tuple[int, int]) -> list[list[np.ndarray]]:
    """Groups of neighbouring clips, or parts of clips, each as arrays of places: start, places for cuts, end."""
    pieces = []
    for start, end in pairwise(space.clip_starts):
        places = np.arange(start, max(start + 1, end - limits[0] + 1), grid)
        for first in range(0, len(places), _PLACES):
            part = places[first : first + _PLACES]
            last = end if first + _PLACES >= len(places) else places[first + _PLACES]
            pieces.append(np.append(part, last))
    stretches: list[list[np.ndarray]] = [[]]
    for piece in pieces:
        if stretches[-1] and sum(map(len, stretches[-1])) + len(piece) > _PLACES:
            stretches.append([])
        stretches[-1].append(piece)
    return stretches


class _Stretch:
    """One stretch: turns genomes into spans, and scores them."""

    def __init__(self, space: PoseSpace, places: list[np.ndarray], k: int, weight: float, limits: tuple[int, int]):
        self.space, self.weight, self.limits = space, weight, limits
        self.places, self.sizes = places, [len(p) - 2 for p in places]
        self.n_genes = sum(self.sizes)
        poses = sum(int(p[-1] - p[0]) for p in places)
        self.k = max(1, min(k, poses // limits[0] // 2))
        self.poses = poses
        self.known: dict[bytes, float] = {}
        self.numbers: dict[tuple[int, int], int] = {}
        candidates = self._candidates()
        if len(candidates) <= _CANDIDATES:
            self.numbers = {span: i for i, span in enumerate(candidates)}
            self.distances = span_distances(space, np.array(candidates, np.int64))

    def _candidates(self) -> list[tuple[int, int]]:
        candidates = []
        for places in self.places:
            whole = (int(places[0]), int(places[-1]))
            spans = {
                (int(a), int(b))
                for i, a in enumerate(places[:-1])
                for b in places[i + 1 :]
                if self.limits[0] <= b - a <= self.limits[1]
            }
            candidates += sorted(spans | {whole})
        return candidates

    def spans(self, genes: np.ndarray) -> np.ndarray:
        """Spans ``(n, 2)`` of genes ``(n_genes,)``: cuts that would make a segment too short are left out, and where a
        segment would be too long there is a cut at the last place that fits."""
        spans, first = [], 0
        shortest, longest = self.limits
        for places, size in zip(self.places, self.sizes, strict=True):
            wanted = genes[first : first + size]
            first += size
            cuts, end = [int(places[0])], int(places[-1])
            inner = places[1:-1].tolist()
            for i, at in enumerate(inner):
                following = inner[i + 1] if i + 1 < size else end
                if at - cuts[-1] >= shortest and (wanted[i] or following - cuts[-1] > longest):
                    cuts.append(at)
            spans += list(pairwise([*cuts, end]))
        return np.array(spans, np.int64)

    def score(self, genes: np.ndarray) -> float:
        """F of genes ``(n_genes,)``; 0 where there are fewer segments than groups."""
        key = genes.tobytes()
        if key not in self.known:
            self.known[key] = self._score(self.spans(genes))
        return self.known[key]

    def _score(self, spans: np.ndarray) -> float:
        if len(spans) < self.k:
            return 0.0
        if self.numbers:
            rows = [self.numbers.get(span, -1) for span in map(tuple, spans.tolist())]
        if self.numbers and min(rows) >= 0:
            distances = self.distances[np.ix_(rows, rows)]
        else:
            distances = span_distances(self.space, spans)
        medoids = pam(distances, self.k)
        clustering = clustering_of(spans, medoids, distances[:, medoids])
        repetition = clustering.lengths[medoids].sum() / self.poses
        error = clustering.lengths @ clustering.distances / self.poses / self.space.largest
        return float(1 / max(self.weight * repetition + (1 - self.weight) * error, 1e-12))


def _search(
    space: PoseSpace,
    places: list[np.ndarray],
    k: int,
    weight: float,
    limits: tuple[int, int],
    rng: np.random.Generator,
    settings: GeneticSettings,
    report: Report,
) -> np.ndarray:
    stretch = _Stretch(space, places, k, weight, limits)
    if stretch.n_genes == 0:
        return stretch.spans(np.empty(0, bool))
    population = rng.random((settings.population, stretch.n_genes)) < rng.uniform(0.3, 1, (settings.population, 1))
    best = population[0]
    for generation in range(settings.generations):
        report("genetic search", generation / settings.generations)
        scores = np.array([stretch.score(genes) for genes in population])
        best = population[scores.argmax()].copy()
        population = _children(population, scores, rng)
        population[0] = best
    scores = np.array([stretch.score(genes) for genes in population])
    return stretch.spans(population[scores.argmax()])


def _children(population: np.ndarray, scores: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """As many children ``(n, n_genes)`` as there are parents, who are drawn by ``scores (n,)`` above the lowest."""
    n, genes = population.shape
    fitness = scores - scores.min() + 1e-9 + 0.05 * np.ptp(scores)
    parents = rng.choice(n, (2, n), p=fitness / fitness.sum())
    points = np.sort(rng.integers(0, genes + 1, (2, n)), axis=0)[..., None]
    at = np.arange(genes)
    children = np.where((at >= points[0]) & (at < points[1]), population[parents[1]], population[parents[0]])
    mutated: np.ndarray = children ^ (rng.random((n, genes)) < 1 / genes)
    return mutated
