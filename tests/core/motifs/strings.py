"""Strings of letters made by hand or at random, and slow, plain versions of what the engine does fast."""

from __future__ import annotations

import numpy as np

from core.motifs.adjacency import Adjacency
from core.motifs.matching import Rule
from core.sequences.repeats import Runs, remove_runs


def runs_of(words: list[str], holds: list[list[int]] | None = None) -> Runs:
    """One clip a word; letter a is 0. holds: frames each letter lasts, one where not given."""
    holds = holds or [[1] * len(word) for word in words]
    labels = [np.repeat([ord(c) - ord("a") for c in word], hold) for word, hold in zip(words, holds, strict=True)]
    return remove_runs(np.concatenate(labels), np.cumsum([0, *map(len, labels)]))


def random_runs(rng: np.random.Generator, n_clips: int = 2, n: int = 14, kappa: int = 4) -> Runs:
    """Clips of about n runs each, without repetition, held for one to four frames."""
    words, holds = [], []
    for _ in range(n_clips):
        steps = rng.integers(1, kappa, int(rng.integers(3, n + 1)))
        words.append("".join(chr(ord("a") + c) for c in np.cumsum(steps) % kappa))
        holds.append(list(rng.integers(1, 5, len(steps))))
    return runs_of(words, holds)


def random_adjacency(rng: np.random.Generator, kappa: int = 4, density: float = 0.5) -> Adjacency:
    """Random distances, in steps of 1/64 so that sums are exact and ties are ties; the nearest pairs are adjacent."""
    points = rng.normal(size=(kappa, 2))
    distances = np.linalg.norm(points[:, None] - points[None], axis=2)
    distances = (np.round(distances * 64) / 64).astype(np.float32)
    radius = float(np.quantile(distances, density))
    return Adjacency(distances, np.where(distances <= radius, distances, np.inf).astype(np.float32), radius)


def naive_matches(runs: Runs, adjacency: Adjacency, rule: Rule) -> dict[tuple[int, int, int, int], float]:
    """{(seed first, last, match first, last): mean cost} by trying every path of every pair of substrings.

    The cheapest path counts, of equally cheap ones the shortest.
    """
    found = {}
    spans = [
        (a, b) for a in range(len(runs.letters)) for b in range(a + 1, int(runs.stops[a]))
    ]  # no substring crosses a clip's end
    for j, k in spans:
        if not rule.min_letters <= k - j + 1 <= rule.max_letters:
            continue
        for a, b in spans:
            if (a < k and j < b) or not _ends_fit(runs, adjacency, rule, (j, k), (a, b)):
                continue
            paths = list(_paths(runs, adjacency, rule, (j, k), (a, b)))
            if paths:
                cheapest = min(paths)[0]
                total, steps = min((p for p in paths if p[0] < cheapest + 1e-6), key=lambda p: p[1])
                if total <= rule.max_cost * steps:
                    found[j, k, a, b] = total / steps
    return found


def hangs_on_rounding(runs, adjacency, rule, spans: tuple[int, int, int, int]) -> bool:
    """Whether sums in another order may decide otherwise: paths about equally cheap, of which some keep the limit.

    spans: seed and match, each first and last letter.
    """
    j, k, a, b = spans
    paths = list(_paths(runs, adjacency, rule, (j, k), (a, b)))
    if not paths:
        return False
    cheapest = min(paths)[0]
    means = [total / steps for total, steps in paths if total < cheapest + 1e-4]
    return min(means) <= rule.max_cost * (1 + 1e-4) and max(means) >= rule.max_cost * (1 - 1e-4)


def _ends_fit(runs, adjacency, rule, seed, match) -> bool:
    widths = [runs.middles[b] - runs.middles[a] for a, b in (seed, match)]
    if min(widths) < rule.min_frames or max(widths) > rule.gamma * min(widths):
        return False
    return all(_nearest(runs, adjacency, runs.letters[seed[e]], match[e]) for e in (0, 1))


def _nearest(runs, adjacency, x, a) -> bool:
    here = adjacency.distances[x, runs.letters[a]]
    beside = [b for b in (a - 1, a + 1) if runs.firsts[a] <= b < runs.stops[a]]
    return bool(np.isfinite(adjacency.costs[x, runs.letters[a]])) and all(
        adjacency.distances[x, runs.letters[b]] > here for b in beside
    )


def _paths(runs, adjacency, rule, seed, match):
    """(cost, steps) of every valid path from the first letters of seed and match to their last ones."""
    (j, k), (a, b) = seed, match

    def inside(p, q):
        s, t = runs.middles[p] - runs.middles[j], runs.middles[q] - runs.middles[a]
        slack = rule.slack * (runs.lengths[p] + runs.lengths[q])
        return s <= rule.gamma * (t + slack) and t <= rule.gamma * s + slack

    def walk(p, q):
        cost = float(adjacency.costs[runs.letters[p], runs.letters[q]])
        if p > k or q > b or not np.isfinite(cost) or not inside(p, q):
            return
        if (p, q) == (k, b):
            yield cost, 1
            return
        for dp, dq in ((1, 1), (1, 0), (0, 1)):
            if p + dp <= k and q + dq <= b:
                for rest, steps in walk(p + dp, q + dq):
                    yield cost + rest, steps + 1

    yield from walk(j, a)


def naive_motif(runs: Runs, seed: tuple[int, int], matches: dict, cut: set[int]) -> list[tuple[int, int]]:
    """The seed and its unpartitioned matches, cheapest first, without those that overlap one taken before."""
    taken = [seed]
    offers = [(cost, a, b) for (j, k, a, b), cost in matches.items() if (j, k) == seed]
    for _, a, b in sorted(offers):
        if not cut & set(range(a, b)) and all(a >= d or b <= c for c, d in taken):
            taken.append((a, b))
    return taken


def naive_volume(runs: Runs, motif: list[tuple[int, int]], costs: list[float], rho: float, discount: float) -> float:
    """V = (B_h - 1) B_w^rho, each motion but the seed discounted by its cost."""
    width = np.mean([float(runs.middles[b] - runs.middles[a]) for a, b in motif])
    return sum(1 - discount * cost for cost in costs) * width**rho
