"""Search for motion by a sequence of key postures (MAP section 4)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.errors import ParameterError


class Runs(NamedTuple):
    """Stays of clips on nodes: successive frames of a clip on the same node, ordered by clip, then start.

    clip, start, end, node: each ``(n_runs,)`` int; clip is an index, frames are analysis frames, end exclusive, node
    counts row by row in the grid. distance: ``(n_runs,)`` mean distance of the frames to the node's model vector.
    ahead, aside: ``(n_runs,)`` mean velocity over the ground, m/s, to where the body faces and to its left.
    """

    clip: np.ndarray
    start: np.ndarray
    end: np.ndarray
    node: np.ndarray
    distance: np.ndarray
    ahead: np.ndarray
    aside: np.ndarray

    @property
    def speed(self) -> np.ndarray:
        """Mean speed over the ground ``(n_runs,)``, m/s."""
        speed: np.ndarray = np.hypot(self.ahead, self.aside)
        return speed


WAYS = ("any", "forward", "backward", "left", "right")


@dataclass(frozen=True)
class Pace:
    """How the body must travel while it passes a key: equal postures may stand, walk or run (MAP section 6).

    slowest, fastest: m/s over the ground; way: one of WAYS, as seen by the body, to within 45 degrees. Raises
    ParameterError for another way or a range that is none.
    """

    slowest: float = 0.0
    fastest: float = math.inf
    way: str = "any"

    def __post_init__(self) -> None:
        if self.way not in WAYS or not 0 <= self.slowest <= self.fastest:
            raise ParameterError(f"a pace needs speeds that rise from 0 and one of {', '.join(WAYS)}")

    def allows(self, runs: Runs) -> np.ndarray:
        """Which runs ``(n_runs,)`` bool travel like this."""
        speed = runs.speed
        fits: np.ndarray = (speed >= self.slowest) & (speed <= self.fastest)
        if self.way == "any":
            return fits
        along, across = (runs.ahead, runs.aside) if self.way in ("forward", "backward") else (runs.aside, runs.ahead)
        along = -along if self.way in ("backward", "right") else along
        fits = fits & (along > 0) & (along >= np.abs(across))
        return fits


class KeyHit(NamedTuple):
    """A stretch of a clip that passes through all keys in order; frames as in :class:`Runs`.

    distance: sum over the keys of the distance between the key's model vector and that of the node passed; runs: the
    run of each key.
    """

    clip: int
    start: int
    end: int
    distance: float
    runs: tuple[int, ...]


def runs_of(
    nodes: np.ndarray, distances: np.ndarray, clip_starts: np.ndarray, velocity: np.ndarray | None = None
) -> Runs:
    """The table of runs from the node ``(n,)``, distance ``(n,)`` and velocity ``(n, 2)`` of every frame.

    clip_starts: ``(n_clips + 1,)``; without velocities nothing moves.
    """
    n = len(nodes)
    velocity = np.zeros((n, 2)) if velocity is None else velocity
    first = np.ones(n, bool)
    first[1:] = nodes[1:] != nodes[:-1]
    first[np.asarray(clip_starts[:-1])[np.asarray(clip_starts[:-1]) < n]] = True
    starts = np.flatnonzero(first)
    ends = np.append(starts[1:], n)
    clips = np.searchsorted(clip_starts, starts, side="right") - 1
    offset = np.asarray(clip_starts)[clips]
    every = np.column_stack([distances, velocity])
    means = np.add.reduceat(every, starts) / (ends - starts)[:, None] if n else np.zeros((0, 3))
    return Runs(clips, starts - offset, ends - offset, np.asarray(nodes)[starts], *means.T)


def key_nodes(weights: np.ndarray, key: tuple[int, int], threshold: float) -> tuple[np.ndarray, np.ndarray]:
    """Nodes that count as the key, ``(k,)`` row by row, and the distance of their model vectors to the key's.

    The key's own node always counts, and all nodes nearer than ``threshold`` (the paper's T). weights: (nx, ny, d).
    """
    models = weights.reshape(-1, weights.shape[-1])
    own = key[0] * weights.shape[1] + key[1]
    apart = np.linalg.norm(models - models[own], axis=1)
    nodes = np.flatnonzero((apart < threshold) | (np.arange(len(models)) == own))
    return nodes, apart[nodes]


def search_keys(runs: Runs, keys: Sequence[tuple[np.ndarray, np.ndarray]], pace: Pace | None = None) -> list[KeyHit]:
    """Stretches that pass through all ``keys`` in order, best first: by summed distance, then by duration.

    keys: per key its nodes ``(k,)`` and their distances ``(k,)`` (see :func:`key_nodes`). Each run of the first key is
    extended to the earliest-ending later run of the next key in the same clip, and dropped where there is none; of
    stretches that end in the same run the shortest stays (ours: the others only begin earlier). A run serves one key
    only, so the same posture twice as a key asks for two visits. With ``pace`` only runs that travel like that count.
    """
    if not keys:
        return []
    allowed = np.ones(len(runs.node), bool) if pace is None else pace.allows(runs)
    passes = [_passes(runs, nodes, distances, allowed) for nodes, distances in keys]
    rows, apart = passes[0]
    chains, sums = rows[:, None], apart.copy()
    if not len(rows):
        return []
    for rows, apart in passes[1:]:
        # runs are in the order of their clips and starts: the first later row of the key is the earliest-ending one
        follower = np.searchsorted(rows, chains[:, -1], side="right")
        there = follower < len(rows)
        follower = np.minimum(follower, max(len(rows) - 1, 0))
        if len(rows):
            there &= runs.clip[rows[follower]] == runs.clip[chains[:, -1]]
        chains, sums, follower = chains[there], sums[there], follower[there]
        if not len(chains):
            return []
        chains = np.column_stack([chains, rows[follower]])
        sums = sums + apart[follower]
    # of chains with the same end the latest start is the shortest; chains come by start
    last = np.append(chains[1:, -1] != chains[:-1, -1], True)
    hits = [
        KeyHit(
            int(runs.clip[chain[0]]), int(runs.start[chain[0]]), int(runs.end[chain[-1]]), float(total),
            tuple(map(int, chain)),
        )
        for chain, total in zip(chains[last], sums[last], strict=True)
    ]  # fmt: skip
    return sorted(hits, key=lambda hit: (round(hit.distance, 9), hit.end - hit.start, hit.clip, hit.start))


def _passes(runs: Runs, nodes: np.ndarray, distances: np.ndarray, allowed: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rows of the allowed runs on these nodes, ascending, and the distance of their node to the key."""
    n_nodes = int(max(runs.node.max(initial=0), nodes.max(initial=0))) + 1
    apart = np.full(n_nodes, np.inf)
    apart[nodes] = distances
    distance_of_run = apart[runs.node]
    rows = np.flatnonzero(np.isfinite(distance_of_run) & allowed)
    return rows, distance_of_run[rows]
