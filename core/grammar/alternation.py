"""Search for terminals by alternation: medoids for given segments, then the best segments for given medoids."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from core.errors import AnalysisError
from core.grammar.cuts import best_cuts
from core.grammar.medoids import seed_medoids, swap_medoids
from core.grammar.objective import Clustering, clustering_of, span_distances
from core.grammar.pose_space import PoseSpace
from core.progress import Progress, part_of, unheard

_LITTLE = 1e-3  # the search stops at a turn that lowers the cost by a smaller share
_MOST = 1500  # segments whose distances to one another are looked at; beyond, a sample of them


def even_cuts(space: PoseSpace, length: float, limits: tuple[int, int]) -> np.ndarray:
    """Spans ``(n, 2)`` of about ``length`` poses within ``limits``, all of one clip equally long."""
    shortest, longest = limits
    spans = []
    for start, end in pairwise(space.clip_starts):
        n = int(end - start)
        pieces = max(1, min(max(round(n / length), -(-n // longest)), n // shortest))
        cuts = start + np.arange(pieces + 1) * n // pieces
        spans.append(np.stack([cuts[:-1], cuts[1:]], axis=1))
    return np.concatenate(spans)


def cut_by_medoids(
    space: PoseSpace,
    medoids: np.ndarray,
    limits: tuple[int, int],
    price: float = 0.0,
    only_from: int = 0,
    progress: Progress = unheard,
) -> tuple[np.ndarray, np.ndarray]:
    """Spans ``(n, 2)`` that have the least E' for given medoids, and the medoid of each ``(n,)``.

    medoids: ``(k, 2)`` spans; limits: poses of the shortest and the longest segment; price: of a segment, in pose
    distance times poses; only_from: the first clip that is cut; progress: hears how much of it is done.
    """
    models = [x[start:end] for x in space.versions for start, end in medoids]
    spans, labels = [], []
    for start, end in pairwise(space.clip_starts[only_from:]):
        cuts, nearest, _ = best_cuts(space.values[start:end], models, *limits, price)
        spans.append(start + np.stack([cuts[:-1], cuts[1:]], axis=1))
        labels.append(nearest % len(medoids))
        progress(end / space.n)
    return np.concatenate(spans), np.concatenate(labels)


def alternate(
    space: PoseSpace,
    k: int,
    weight: float,
    limits: tuple[int, int],
    rng: np.random.Generator,
    *,
    spans: np.ndarray,
    labels: np.ndarray | None = None,
    turns: int = 10,
    price: float = 0.0,
    surplus: Sequence[float] = (),
    progress: Progress = unheard,
) -> tuple[Clustering, float]:
    """The best clustering into ``k`` groups seen in at most ``turns`` turns from ``spans``, and its cost 1 / F.

    spans: ``(n, 2)``. A turn chooses medoids that no swap improves (starting from the groups ``labels (n,)`` of the
    spans, from a random choice where None), and cuts anew. surplus: turns before these with so many times ``k`` groups,
    of which each time those go that are missed least: it keeps rare motions from being swallowed before the cuts have
    found them. progress: hears how much of the turns is done. Raises ValueError where there are fewer than ``k`` spans.
    """
    begin = spans, labels
    for share in surplus:
        medoids, _ = _choose(space, spans, labels, min(len(spans), max(k, round(share * k))), weight, rng)
        spans, labels = cut_by_medoids(space, spans[medoids], limits, price)
        if len(spans) < k:
            spans, labels = begin
            break
    best: Clustering | None = None
    least = np.inf
    for turn in range(turns):
        heard = part_of(progress, turn / turns, (turn + 0.5) / turns)
        clustering = clustering_of(spans, *_choose(space, spans, labels, k, weight, rng, heard))
        cost = _cost(space, clustering, weight, price)
        before, least = least, min(cost, least)
        if cost == least:
            best = clustering
        if cost > (1 - _LITTLE) * before or turn == turns - 1:
            break
        heard = part_of(progress, (turn + 0.5) / turns, (turn + 1) / turns)
        spans, labels = cut_by_medoids(space, spans[clustering.medoids], limits, price, progress=heard)
        if len(spans) < k:
            break
    assert best is not None  # there is at least one turn
    return best, least


def recombine(
    space: PoseSpace,
    parents: Sequence[Clustering],
    k: int,
    weight: float,
    limits: tuple[int, int],
    rng: np.random.Generator,
    turns: int = 4,
) -> tuple[Clustering, float] | None:
    """The clustering from the medoids of several clusterings, and its cost; None where too few segments remain.

    The cuts are made anew for all medoids at once, those go that are missed least until ``k`` are left, and
    :func:`alternate` goes on from there: what one parent has got right and another wrong survives. Raises ValueError
    where there are no parents.
    """
    if not parents:
        raise ValueError("there must be clusterings to recombine")
    medoids = np.concatenate([parent.spans[parent.medoids] for parent in parents])
    spans, labels = cut_by_medoids(space, medoids, limits)
    if len(spans) < k:
        return None
    return alternate(space, k, weight, limits, rng, spans=spans, labels=labels, turns=turns)


def _cost(space: PoseSpace, found: Clustering, weight: float, price: float) -> float:
    return 1 / found.objective(space, weight)["F"] + (1 - weight) * price * len(found.spans) / space.n / space.largest


def _choose(
    space: PoseSpace,
    spans: np.ndarray,
    labels: np.ndarray | None,
    k: int,
    weight: float,
    rng: np.random.Generator,
    progress: Progress = unheard,
) -> tuple[np.ndarray, np.ndarray]:
    """Indices ``(k,)`` of the spans that serve best as medoids, and the distances ``(n, k)`` of all spans to them."""
    if len(spans) < k:
        raise AnalysisError(f"there are only {len(spans)} segments for {k} terminals; ask for fewer, or shorter pieces")
    sample = np.arange(len(spans))
    if len(spans) > max(_MOST, 2 * k):
        sample = np.sort(rng.choice(len(spans), max(_MOST, 2 * k), replace=False))
    distances = span_distances(space, spans[sample])
    progress(0.3)
    lengths = (spans[:, 1] - spans[:, 0])[sample].astype(np.float64)
    weights = (1 - weight) * lengths / lengths.sum() / space.largest
    prices = weight * lengths / space.n
    if labels is None:
        medoids = seed_medoids(distances, weights + 1e-12, k, rng)
    else:
        medoids = _central(distances, weights, prices, labels[sample], k)
    medoids = swap_medoids(distances, weights, prices, medoids)
    progress(0.6)
    if len(sample) == len(spans):
        return medoids, distances[:, medoids]
    return sample[medoids], span_distances(space, spans, spans[sample[medoids]])


def _central(distances: np.ndarray, weights: np.ndarray, prices: np.ndarray, labels: np.ndarray, k: int) -> np.ndarray:
    """The best medoid within each group; without the groups that are missed least, where there are more than ``k``, and
    with what is worst served, where there are fewer."""
    medoids: list[int] = []
    for label in np.unique(labels):
        members = np.flatnonzero(labels == label)
        costs = prices[members] + weights[members] @ distances[np.ix_(members, members)]
        medoids.append(int(members[costs.argmin()]))
    while len(medoids) > k:
        del medoids[_dispensable(distances[:, medoids], weights, prices[medoids])]
    while len(medoids) < k:
        served = weights * distances[:, medoids].min(1)
        served[medoids] = -1
        medoids.append(int(served.argmax()))
    return np.array(medoids, np.int64)


def _dispensable(to_medoids: np.ndarray, weights: np.ndarray, prices: np.ndarray) -> int:
    """The medoid whose removal costs least; to_medoids: distances ``(n, k)``, at least two medoids."""
    order = np.argsort(to_medoids, axis=1)[:, :2]
    first, second = np.take_along_axis(to_medoids, order, 1).T
    losses = np.bincount(order[:, 0], weights * (second - first), len(prices)) - prices
    return int(losses.argmin())
