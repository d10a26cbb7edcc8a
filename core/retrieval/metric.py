"""Distance of two motions: an edit distance of their parts, and differences of the whole motions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.poses.body_parts import LEAVES
from core.retrieval.compose import active_columns, root_factor
from core.retrieval.descriptors import BLOCKS
from core.retrieval.frames import UNITS, FrameStore
from core.retrieval.path_length import sample_all
from core.sequences.edit_distance import bounded_edit_distances

SAMPLES = 32  # frames of a motion that are compared, at equal steps of its way
GAP = 0.3  # price of leaving a sample out; a replaced one costs at most 1
CAP = 0.75  # distance from which frames are simply different, in distances of two frames of unlike motions
CENTRE = 0.75  # share of a motion's mean posture that is taken off: how it changes counts more than where it is
FASTEST = 3.0  # m/s and rad/s: of a frame's velocity no more counts
TRAVEL, EFFORT, POSTURE = 0.5, 0.1, 0.1  # weights of what motions are on the whole, beside the edit distance

_SPREAD = {"head": 0.6, "torso": 0.25, "arm": 2.1, "hand": 0.2, "leg": 0.5, "foot": 0.2}
"""Mean squared distance of two frames of unlike motions, per leaf: of unit vectors, so the same for all data."""

_SLOW = 0.25  # m/s: speeds above it are compared by their ratio
_TRAVEL_CAP, _EFFORT_CAP = 2.0, 0.8  # differences from which travel and effort are simply different
_IDLE = 0.05  # way per second of a leaf that hardly moves


@dataclass(frozen=True, eq=False)
class Motions:
    """Motions ready to be compared: samples ``(k, SAMPLES, d)``, and of the whole travel ``(k, 3)``, effort ``(k,
    leaves)`` and posture ``(k, way)``, all float32."""

    samples: np.ndarray
    travel: np.ndarray
    effort: np.ndarray
    posture: np.ndarray

    @cached_property
    def coarse(self) -> np.ndarray:
        """Means of every four samples, side by side: ``(k, 8 d)``."""
        few = self.samples.reshape(len(self.samples), -1, 4, self.samples.shape[2]).mean(2)
        return np.ascontiguousarray(few.reshape(len(few), -1))

    @cached_property
    def squares(self) -> np.ndarray:
        """Squared lengths of ``coarse``, ``(k,)``."""
        squares: np.ndarray = np.einsum("ij,ij->i", self.coarse, self.coarse)
        return squares

    def __getitem__(self, which: np.ndarray | slice) -> Motions:
        """Those numbered ``(k,)``, or of a slice."""
        return Motions(self.samples[which], self.travel[which], self.effort[which], self.posture[which])


class Metric:
    """The distance of motions under weights of the leaves that sum to 1; only leaves with a weight are looked at."""

    def __init__(self, weights: Mapping[str, float]):
        self.weights = dict(weights)
        self.columns, self.factors, self.way = active_columns(weights)
        self.root = root_factor(weights)
        leaves = [leaf for leaf in LEAVES if weights[leaf] > 0]
        self.groups = np.full(len(self.columns), -1)
        for g, leaf in enumerate(leaves):
            block = BLOCKS[leaf]
            self.groups[(self.columns >= block.start) & (self.columns < block.stop)] = g
        self.shares = np.array([weights[leaf] for leaf in leaves], np.float32)
        spread = sum(len(LEAVES) * weights[leaf] * _SPREAD[leaf.split("_")[-1]] for leaf in leaves)
        self.cap = CAP * float(np.sqrt(spread))
        self.most = min(1.0, 2 * GAP) + TRAVEL * self.root + EFFORT + POSTURE

    @property
    def scales(self) -> np.ndarray:
        """What a code of each column of FrameStore counts, ``(width,)``: 0 for those without influence."""
        scales = np.zeros(len(UNITS), np.float32)
        scales[self.columns] = UNITS[self.columns] * self.factors
        return scales

    @property
    def key(self) -> bytes:
        """Equal for metrics that are equal."""
        return self.columns.tobytes() + self.factors.tobytes()

    def motions(self, store: FrameStore, codes: np.ndarray, starts: np.ndarray, ends: np.ndarray) -> Motions:
        """Stretches ``[start, end)`` of codes ``(n, ...)``, those of the store or such as it makes."""
        way, scales = self.way, UNITS[self.columns] * self.factors
        values, steps, means = sample_all(codes, self.columns, scales, self.groups, starts, ends, SAMPLES)
        if self.root > 0:
            fastest = FASTEST * self.factors[way:]
            values[..., way:] = np.clip(values[..., way:], -fastest, fastest)
        values[..., :way] -= CENTRE * values[..., :way].mean(1, keepdims=True)
        speeds = steps * store.fps / np.sqrt(len(LEAVES) * self.shares)
        return Motions(values, self._travel_of(means[:, way:]), np.log(_IDLE + speeds), means[:, :way])

    def clips(self, store: FrameStore) -> Motions:
        """All whole clips of a store."""
        return self.motions(store, store.codes, store.starts[:-1], store.starts[1:])

    def distances(self, query: Motions, others: Motions) -> np.ndarray:
        """Distance of one motion to each of ``others``, ``(k,)`` from 0 to 1."""
        edits = bounded_edit_distances(query.samples[0], others.samples, self.cap, GAP)
        distances: np.ndarray = (edits + self._on_the_whole(query, others)) / self.most
        return distances

    def rough(self, query: Motions, others: Motions) -> np.ndarray:
        """Much the same order by the distance of a few samples one by one, ``(k,)``: quick."""
        squares = others.squares + query.squares - 2 * (others.coarse @ query.coarse[0])
        edits = np.sqrt(np.maximum(squares, 0) * (4 / SAMPLES)) / self.cap
        distances: np.ndarray = edits + self._on_the_whole(query, others)
        return distances

    def _on_the_whole(self, query: Motions, others: Motions) -> np.ndarray:
        travel = np.linalg.norm(others.travel - query.travel, axis=1) / _TRAVEL_CAP
        effort = np.sqrt(((others.effort - query.effort) ** 2) @ self.shares) / _EFFORT_CAP
        posture = np.linalg.norm(others.posture - query.posture, axis=1) / self.cap
        parts = ((TRAVEL * self.root, travel), (EFFORT, effort), (POSTURE, posture))
        total: np.ndarray = sum(weight * np.minimum(apart, 1) for weight, apart in parts)
        return total

    def _travel_of(self, means: np.ndarray) -> np.ndarray:
        """Mean velocity left, forward and turning; its length over the ground grows with the logarithm of the speed."""
        if not self.root > 0:
            return np.zeros((len(means), 3), np.float32)
        velocity: np.ndarray = means[:, [0, 1, 3]] / self.factors[self.way :][[0, 1, 3]]
        speed = np.linalg.norm(velocity[:, :2], axis=1, keepdims=True)
        velocity[:, :2] *= np.log1p(speed / _SLOW) / np.maximum(speed, 1e-9)
        return velocity
