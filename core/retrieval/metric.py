"""Distance of two motions: an edit distance of their parts, and differences of the whole motions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType

import numpy as np

from core.poses.body_parts import LEAVES
from core.retrieval.compose import active_columns, root_factor
from core.retrieval.descriptors import BLOCKS
from core.retrieval.frames import UNITS, FrameStore
from core.retrieval.path_length import sample_all
from core.sequences.edit_distance import bounded_edit_distances

SAMPLES = 32  # frames of a motion that are compared, at equal steps of its way
GAP = 0.3  # price of leaving a sample out; a replaced one costs at most 1
CAP = 3.3  # distance from which samples are simply different, in sizes of the motion
CENTRE = MappingProxyType({"arm": 0.75})
"""Share of a leaf's mean posture that is taken off, by kind of leaf; 1 for all others. How people stand and stoop is
their style, where they hold their arms is half of what they do."""
FASTEST = 3.0  # m/s and rad/s: of a frame's velocity no more counts
TRAVEL, SIZE, SIDE = 0.8, 0.04, 0.1  # weights of what motions are on the whole, beside the edit distance

SPREAD = MappingProxyType({"head": 0.6, "torso": 0.25, "arm": 2.1, "hand": 0.2, "leg": 0.5, "foot": 0.2})
"""Mean squared distance of two frames of unlike motions, per leaf: of unit vectors, so the same for all data."""
POSTURE_CAP = 0.75  # distance from which postures are simply different, in distances of two frames of unlike motions

_SLOW = 0.25  # m/s: speeds above it are compared by their ratio
_TRAVEL_CAP, _SIZE_CAP = 2.0, 2.0  # differences from which travel and the logarithm of the size are simply different
SMALL = 0.15  # size below which a motion is no smaller: what is left is noise
_IDLE = 0.1  # way per second of an arm that hardly moves


@dataclass(frozen=True, eq=False)
class Motions:
    """Motions ready to be compared: samples ``(k, SAMPLES, d)`` divided by the motion's size, and of the whole travel
    ``(k, 3)``, the logarithm of the size ``(k,)``, and side ``(k,)`` from -1 (only the right arm moves) to 1 (only the
    left one), all float32."""

    samples: np.ndarray
    travel: np.ndarray
    size: np.ndarray
    side: np.ndarray

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
        return Motions(self.samples[which], self.travel[which], self.size[which], self.side[which])


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
        kinds = np.array([leaf.split("_")[-1] for leaf in leaves])
        self.centre = np.array([CENTRE.get(kind, 1.0) for kind in kinds], np.float32)[self.groups[: self.way]]
        spread = sum(len(LEAVES) * weights[leaf] * SPREAD[leaf.split("_")[-1]] for leaf in leaves)
        self.cap = POSTURE_CAP * float(np.sqrt(spread))  # of postures: see core.retrieval.locate
        self.arms = [leaves.index(leaf) for leaf in ("left_arm", "right_arm") if leaf in leaves]
        self.side = len(LEAVES) * min(weights["left_arm"], weights["right_arm"])
        self.most = min(1.0, 2 * GAP) + TRAVEL * self.root + SIZE + SIDE * self.side

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
        postures = values[..., :way]
        mean = postures.mean(1, keepdims=True)
        size = np.sqrt(((postures - mean) ** 2).sum(2).mean(1) + SMALL**2)
        postures -= self.centre * mean
        postures /= size[:, None, None]
        return Motions(values, self._travel_of(means[:, way:]), np.log(size), self._side_of(steps * store.fps))

    def clips(self, store: FrameStore) -> Motions:
        """All whole clips of a store."""
        return self.motions(store, store.codes, store.starts[:-1], store.starts[1:])

    def distances(self, query: Motions, others: Motions) -> np.ndarray:
        """Distance of one motion to each of ``others``, ``(k,)`` from 0 to 1."""
        edits = bounded_edit_distances(query.samples[0], others.samples, CAP, GAP)
        distances: np.ndarray = (edits + self._on_the_whole(query, others)) / self.most
        return distances

    def rough(self, query: Motions, others: Motions) -> np.ndarray:
        """Much the same order by the distance of a few samples one by one, ``(k,)``: quick."""
        squares = others.squares + query.squares - 2 * (others.coarse @ query.coarse[0])
        edits = np.sqrt(np.maximum(squares, 0) * (4 / SAMPLES)) / CAP
        distances: np.ndarray = edits + self._on_the_whole(query, others)
        return distances

    def _on_the_whole(self, query: Motions, others: Motions) -> np.ndarray:
        travel = np.linalg.norm(others.travel - query.travel, axis=1) / _TRAVEL_CAP
        size = np.abs(others.size - query.size) / _SIZE_CAP
        side = np.abs(others.side - query.side)
        parts = ((TRAVEL * self.root, travel), (SIZE, size), (SIDE * self.side, side))
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

    def _side_of(self, speeds: np.ndarray) -> np.ndarray:
        """Which arm does more, from the ways of the leaves per second ``(k, leaves)``: ``(k,)`` from -1 to 1."""
        if not self.side > 0:
            return np.zeros(len(speeds), np.float32)
        left, right = (speeds[:, arm] / np.sqrt(len(LEAVES) * self.shares[arm]) for arm in self.arms)
        side: np.ndarray = (left - right) / (left + right + _IDLE)
        return side
