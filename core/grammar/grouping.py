"""How many actions there are, and which pieces belong to which.

A search for a fixed number of terminals groups pieces by their postures from moment to moment. So it splits an action
that two people do differently, and joins actions of little movement. Here pieces are grouped by what their motion is
like as a whole: the mean posture and how far it swings. Neighbours that the search gave one terminal count as one
piece. Pieces are joined by Ward's method, weighted by their durations (Ward 1963).

The number of groups is the one that describes the pieces in the least space (minimum description length, Rissanen
1978). With K groups of N pieces a description takes, in nats, d / 2 per piece for each time that its squared distance
from the mean of its group holds the noise; ln K per piece to say its group; and d / 2 ln N for each mean. The noise is
measured in the recordings themselves: how much the first and the second half of a piece differ. d is the effective
number of dimensions of the noise. So nothing is set by hand, and no label is used.

Several searches are made. The number is that with the least mean description, the pieces are those of the search that
needs the least for this number.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from core.grammar.objective import Clustering, span_distances
from core.grammar.pose_space import PoseSpace
from core.progress import Progress, part_of, unheard

MOST_GROUPS = 60  # numbers of groups that are looked at
_JOINED = 600  # pieces that Ward's method looks at; beyond, a sample of them, and the others join the nearest mean
_OFTEN = 1000  # pieces between two reports
_CENTRAL = 400  # pieces among which the medoid of a group is looked for


@dataclass(frozen=True, eq=False)
class Pieces:
    """Stretches of motion to be grouped.

    spans: ``(n, 2)`` poses; of_span: for each span of the search its piece; features: ``(n, f)``, see
    :func:`describe`; lengths: ``(n,)`` poses; halves: ``(n, f)`` features of first halves minus those of second halves.
    """

    spans: np.ndarray
    of_span: np.ndarray
    features: np.ndarray
    lengths: np.ndarray
    halves: np.ndarray


@dataclass(frozen=True, eq=False)
class Choice:
    """labels: ``(n,)`` the group of each span of the chosen search; search: its index; description: number of groups ->
    mean nats a piece."""

    labels: np.ndarray
    search: int
    description: Mapping[int, float]


def choose_groups(
    space: PoseSpace, searches: Sequence[Clustering], seed: int = 0, progress: Progress = unheard
) -> Choice:
    """The number of groups, and the groups of the best of several searches. Raises ValueError where there are none."""
    if not searches:
        raise ValueError("there must be searches to choose from")
    pieces = [pieces_of(space, found) for found in searches]
    noise, dimensions = _noise(pieces)
    levels = []
    for k, part in enumerate(pieces):
        levels.append(_joined(part, np.random.default_rng(seed)))
        progress((k + 1) / len(pieces))
    most = min(len(own) for own in levels)
    costs = np.array(
        [[_description(part, own[k - 1], noise, dimensions) for k in range(1, most + 1)]
         for part, own in zip(pieces, levels, strict=True)]
    )  # fmt: skip
    mean = costs.mean(0)
    number = int(mean.argmin())
    best = int(costs[:, number].argmin())
    labels = levels[best][number][pieces[best].of_span]
    return Choice(labels, best, {k: float(cost) for k, cost in enumerate(mean, 1)})


def pieces_of(space: PoseSpace, found: Clustering, progress: Progress = unheard) -> Pieces:
    """Neighbours of one clip and one group as one piece each."""
    spans, clip = found.spans, np.searchsorted(space.clip_starts, found.spans[:, 0], side="right")
    new = np.ones(len(spans), bool)
    new[1:] = (found.labels[1:] != found.labels[:-1]) | (clip[1:] != clip[:-1]) | (spans[1:, 0] != spans[:-1, 1])
    firsts = np.flatnonzero(new)
    lasts = np.append(firsts[1:], len(spans)) - 1
    joined = np.stack([spans[firsts, 0], spans[lasts, 1]], axis=1)
    middle = np.clip(joined.mean(1).astype(np.int64), joined[:, 0] + 1, np.maximum(joined[:, 1] - 1, joined[:, 0] + 1))
    stretches = (
        joined,
        np.stack([joined[:, 0], middle], axis=1),
        np.stack([np.minimum(middle, joined[:, 1] - 1), joined[:, 1]], axis=1),
    )
    whole, first, second = (
        describe(space, spans, part_of(progress, k / 3, (k + 1) / 3)) for k, spans in enumerate(stretches)
    )
    lengths = (joined[:, 1] - joined[:, 0]).astype(np.float64)
    return Pieces(joined, np.cumsum(new) - 1, whole, lengths, first - second)


def describe(space: PoseSpace, spans: np.ndarray, progress: Progress = unheard) -> np.ndarray:
    """Mean pose and its standard deviation in each span, ``(n, f)``.

    Where mirror images count as the same, so that a span and its mirror image have the same features: the mean of both
    images, half the size of their difference, and the mean of both deviations.
    """
    rows = []
    for k, (start, end) in enumerate(spans):
        if k % _OFTEN == 0:
            progress(k / len(spans))
        mean, swing = space.values[start:end].mean(0), space.values[start:end].std(0)
        if space.mirrored is not None:
            other = space.mirrored[start:end]
            seen, swung = other.mean(0), other.std(0)
            mean, swing = np.concatenate([(mean + seen) / 2, np.abs(mean - seen) / 2]), (swing + swung) / 2
        rows.append(np.concatenate([mean, swing]))
    return np.array(rows, np.float64)


def ward(features: np.ndarray, weights: np.ndarray, most: int) -> list[np.ndarray]:
    """Ward's method with weights: groups ``(n,)`` of the rows of ``features (n, f)`` for 1, 2, ... ``most`` groups."""
    means, sizes, n = features.astype(np.float64), weights.astype(np.float64), len(features)
    label, costs = np.arange(n), np.full((n, n), np.inf)
    for i in range(n - 1):
        costs[i, i + 1 :] = _price(means[i], sizes[i], means[i + 1 :], sizes[i + 1 :])
    costs = np.minimum(costs, costs.T)
    levels = [_numbered(label)] if n <= most else []
    for count in range(n - 1, 0, -1):
        i, j = sorted(divmod(int(costs.argmin()), n))
        means[i] = (sizes[i] * means[i] + sizes[j] * means[j]) / (sizes[i] + sizes[j])
        sizes[i] += sizes[j]
        label[label == j] = i
        costs[j], costs[:, j] = np.inf, np.inf
        others = np.unique(label)
        others = others[others != i]
        costs[i, others] = _price(means[i], sizes[i], means[others], sizes[others])
        costs[others, i] = costs[i, others]
        if count <= most:
            levels.append(_numbered(label))
    return levels[::-1]


def nearest_groups(
    space: PoseSpace,
    everything: Clustering,
    part: PoseSpace,
    found: Clustering,
    labels: np.ndarray,
    progress: Progress = unheard,
) -> np.ndarray:
    """Groups ``(n,)`` of all spans of ``everything``: those of the pieces of a part that are most like them.

    found: clustering of ``part``, whose spans have the groups ``labels``.
    """
    known, pieces = pieces_of(part, found), pieces_of(space, everything, progress)
    of_piece = np.zeros(len(known.spans), np.int64)
    of_piece[known.of_span] = labels
    means = _means(known.features, known.lengths, of_piece)
    square = np.einsum("nf,nf->n", means, means)
    nearest: np.ndarray = (square - 2 * pieces.features @ means.T).argmin(1)[pieces.of_span]
    return _numbered(nearest)


def grouped(
    space: PoseSpace, spans: np.ndarray, labels: np.ndarray, seed: int = 0, progress: Progress = unheard
) -> Clustering:
    """The clustering of spans ``(n, 2)`` with these groups ``(n,)``, numbered from 0; medoids are the most central."""
    lengths, rng = spans[:, 1] - spans[:, 0], np.random.default_rng(seed)
    medoids, distances = [], np.zeros(len(spans))
    for label in range(number := int(labels.max()) + 1):
        members = np.flatnonzero(labels == label)
        some = members
        if len(members) > _CENTRAL:
            some = np.sort(rng.choice(members, _CENTRAL, replace=False))
        medoid = int(some[(span_distances(space, spans[some]) @ lengths[some]).argmin()])
        medoids.append(medoid)
        distances[members] = span_distances(space, spans[members], spans[[medoid]])[:, 0]
        progress((label + 1) / number)
    return Clustering(spans, np.array(medoids), labels, np.maximum(distances, 0))


def _joined(pieces: Pieces, rng: np.random.Generator) -> list[np.ndarray]:
    """Groups of all pieces for 1, 2, ... groups."""
    n = len(pieces.spans)
    some = np.arange(n) if n <= _JOINED else np.sort(rng.choice(n, _JOINED, replace=False))
    levels = ward(pieces.features[some], pieces.lengths[some], max(1, min(MOST_GROUPS, len(some) - 1)))
    if len(some) == n:
        return levels
    return [_nearest(pieces, some, level) for level in levels]


def _nearest(pieces: Pieces, some: np.ndarray, level: np.ndarray) -> np.ndarray:
    """The group ``(n,)`` of every piece, those not among ``some`` by the nearest mean."""
    means = _means(pieces.features[some], pieces.lengths[some], level)
    square = np.einsum("nf,nf->n", means, means)
    labels: np.ndarray = (square - 2 * pieces.features @ means.T).argmin(1)
    labels[some] = level
    return labels


def _noise(pieces: Sequence[Pieces]) -> tuple[float, float]:
    """Variance of a piece's features beside those that its action has, and its effective number of dimensions."""
    halves = np.concatenate([part.halves for part in pieces])
    weights = np.concatenate([part.lengths for part in pieces])
    covariance = (halves * weights[:, None]).T @ halves / weights.sum() / 4  # of the mean of two halves
    total = float(np.trace(covariance))
    if total <= 1e-12:
        return 1e-12, 1.0
    return total, total**2 / float((covariance**2).sum())


def _description(pieces: Pieces, labels: np.ndarray, noise: float, dimensions: float) -> float:
    """Nats a piece, see the top of this module."""
    n, k = len(labels), int(labels.max()) + 1
    means = _means(pieces.features, pieces.lengths, labels)
    apart = ((pieces.features - means[labels]) ** 2).sum(1) @ pieces.lengths / pieces.lengths.mean()
    return float(dimensions * apart / (2 * noise) + n * np.log(k) + k * dimensions / 2 * np.log(n)) / n


def _means(features: np.ndarray, weights: np.ndarray, labels: np.ndarray) -> np.ndarray:
    sums = np.zeros((int(labels.max()) + 1, features.shape[1]))
    np.add.at(sums, labels, features * weights[:, None])
    means: np.ndarray = sums / np.bincount(labels, weights)[:, None]
    return means


def _price(mean: np.ndarray, size: float, means: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """What it costs to join a group with each of others: the rise of the summed squared distance."""
    rise: np.ndarray = ((means - mean) ** 2).sum(1) * (sizes * size / (sizes + size))
    return rise


def _numbered(label: np.ndarray) -> np.ndarray:
    numbers: np.ndarray = np.unique(label, return_inverse=True)[1]
    return numbers
