"""Slow, plain versions of what the search for terminals computes."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from core.grammar.pose_space import PoseSpace


def distance(x, a, b, y=None):
    """Equation 1 word for word: half-open intervals a of x and b of y."""
    y = x if y is None else y
    first, second = x[a[0] : a[1]], y[b[0] : b[1]]
    if len(first) < len(second):
        first, second = second, first
    n, k = len(first), len(second)
    return sum(((first[m] - second[int(np.floor(m * k / n))]) ** 2).sum() for m in range(n)) / n


def segmentations(n, shortest, longest):
    """All ways to cut n poses into pieces of shortest to longest: lists of spans."""
    if n == 0:
        yield []
    for first in range(shortest, min(longest, n) + 1):
        for rest in segmentations(n - first, shortest, longest):
            yield [(0, first), *((a + first, b + first) for a, b in rest)]


def cost(space, spans, medoids, weight):
    """1 / F of equations 3 to 5; medoids: indices of spans, labels: the nearest."""
    total, images = space.n, [space.values] if space.mirrored is None else [space.values, space.mirrored]
    repetition = sum(spans[m][1] - spans[m][0] for m in medoids) / total
    error = 0.0
    for a in spans:
        nearest = min(distance(space.values, a, spans[m], y) for m in medoids for y in images)
        error += (a[1] - a[0]) / total * (0 if a in [spans[m] for m in medoids] else nearest) / space.largest
    return weight * repetition + (1 - weight) * error


def best_of_all(space, k, weight, shortest, longest):
    """The least cost over every segmentation of a space of one clip and every choice of k medoids."""
    least = np.inf
    for spans in segmentations(space.n, shortest, longest):
        for medoids in combinations(range(len(spans)), k):
            least = min(least, cost(space, spans, medoids, weight))
    return least


def toy_space(values, starts=None, mirrored=None, fps=10.0):
    """A pose space of made-up values, clips called a, b, c at its own rate."""
    values = np.ascontiguousarray(values, np.float32)
    starts = np.array(starts if starts is not None else [0, len(values)], np.int64)
    frames = tuple(int(n) for n in np.diff(starts))
    largest = float(((values[:, None] - values[None]) ** 2).sum(-1).max()) or 1.0
    names = tuple("abcdefgh"[: len(frames)])
    return PoseSpace(values, mirrored, starts, names, (fps,) * len(frames), frames, fps, largest)
