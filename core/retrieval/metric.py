"""How far two motions are apart: bounded edit distance of their parts along their way, and how they travel."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from core.poses.body_parts import LEAVES
from core.retrieval.compose import active_columns, root_factor
from core.retrieval.descriptors import N_COLUMNS
from core.retrieval.frames import UNITS, FrameStore
from core.retrieval.path_length import resample_all
from core.sequences.edit_distance import bounded_edit_distances

SAMPLES = 32  # frames of a motion that are compared, at equal steps of its way
GAP = 0.3  # price of leaving a sample out; a replaced one costs at most 1
CAP = 0.75  # distance from which frames are simply different, in distances of two frames of unlike motions
CENTRE = 0.75  # share of a motion's mean posture that is taken off: how it changes counts more than where it is
TRAVEL = 0.4  # weight of the mean velocity over the ground
FASTEST = 3.0  # m/s and rad/s: how fast hardly matters beyond
_SPREAD = {"head": 0.6, "torso": 0.25, "arm": 2.1, "hand": 0.2, "leg": 0.5, "foot": 0.2}
"""Mean squared distance of two frames of unlike motions, per leaf: of unit vectors, so the same for all data."""

_PATH = [N_COLUMNS + 2, N_COLUMNS + 3, N_COLUMNS + 5]  # left, forward, turning


@dataclass(frozen=True, eq=False)
class Motions:
    """Motions ready to be compared: samples ``(k, SAMPLES, d)`` float32 and mean velocity ``(k, 3)``."""

    samples: np.ndarray
    travel: np.ndarray


class Metric:
    """The distance of motions under weights of the leaves that sum to 1."""

    def __init__(self, weights: Mapping[str, float]):
        self.weights = dict(weights)
        self.columns, self.factors, self.way = active_columns(weights, 1.0)
        self.root = root_factor(weights)
        spread = sum(len(LEAVES) * weights[leaf] * _SPREAD[leaf.split("_")[-1]] for leaf in LEAVES)
        self.cap = CAP * float(np.sqrt(spread))
        self.most = min(1.0, 2 * GAP) + TRAVEL * self.root

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

    def motions(self, codes: np.ndarray, starts: np.ndarray, ends: np.ndarray) -> Motions:
        """Stretches ``[start, end)`` of codes ``(n, ...)`` (see FrameStore)."""
        scales = UNITS[self.columns] * self.factors
        samples = resample_all(codes, self.columns, scales, self.way, starts, ends, SAMPLES)
        if self.root > 0:
            fastest = FASTEST * self.factors[self.way :]
            samples[..., self.way :] = np.clip(samples[..., self.way :], -fastest, fastest)
        samples[..., : self.way] -= CENTRE * samples[..., : self.way].mean(1, keepdims=True)
        return Motions(samples, mean_velocity(codes, starts, ends) if self.root > 0 else np.zeros((len(starts), 3)))

    def distances(self, query: Motions, others: Motions) -> np.ndarray:
        """Distance of one motion to each of ``others``, ``(k,)`` from 0 to 1."""
        edits = bounded_edit_distances(query.samples[0], others.samples, self.cap, GAP)
        return (edits + TRAVEL * self.root * self._travel(query, others)) / self.most

    def rough(self, query: Motions, others: Motions) -> np.ndarray:
        """Root mean squared distance of the samples, ``(k,)``: quick, and much the same order."""
        apart = others.samples.reshape(len(others.samples), -1) - query.samples.reshape(1, -1)
        edits = np.sqrt(np.einsum("ij,ij->i", apart, apart) / SAMPLES) / self.cap
        return edits + TRAVEL * self.root * self._travel(query, others)

    def _travel(self, query: Motions, others: Motions) -> np.ndarray:
        return np.minimum(np.linalg.norm(others.travel - query.travel, axis=1) / 2.0, 1.0)


def mean_velocity(codes: np.ndarray, starts: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Mean velocity of stretches ``[start, end)`` of codes (n, ...): ``(k, 3)`` m/s left and forward, rad/s turning."""
    limit = np.float32(FASTEST)
    velocity = np.clip(codes[:, _PATH] * UNITS[_PATH], -limit, limit).astype(np.float64)
    sums = np.concatenate([np.zeros((1, 3)), np.cumsum(velocity, axis=0)])
    lengths = (np.asarray(ends) - np.asarray(starts))[:, None]
    return (sums[ends] - sums[starts]) / lengths


def clip_motions(metric: Metric, store: FrameStore, clips: np.ndarray | None = None) -> Motions:
    """Whole clips, all or those numbered ``(k,)``, ready to be compared."""
    which = np.arange(len(store.clips)) if clips is None else clips
    return metric.motions(store.codes, store.starts[which], store.starts[which + 1])
