"""Time warping of joint positions and velocities: a simple baseline that is not from a paper."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from core.mocap.dataset import Dataset
from core.poses.postures import Postures, postures_of
from core.progress import Report, silent
from core.retrieval.baselines.recordings import in_order
from core.retrieval.baselines.warping import all_warping_distances

_SECONDS = 0.3  # a velocity counts as the way it makes in this time


def position_distances(dataset: Dataset, report: Report = silent) -> np.ndarray:
    """Distances of all pairs of clips ``(n, n)``, in the data set's order. Raises as core.poses.postures."""
    postures = postures_of(dataset, report=report)
    values = np.concatenate([postures.vectors, _SECONDS * _velocities(postures)], axis=1)
    return in_order(all_warping_distances(values, postures.clip_starts, report), postures.clips, dataset)


def _velocities(postures: Postures) -> np.ndarray:
    """Change a second of the postures, within each clip: ``(n, 3 n_joints)``."""
    vectors = np.zeros_like(postures.vectors)
    for start, end in pairwise(postures.clip_starts):
        if end - start > 1:
            vectors[start:end] = np.gradient(postures.vectors[start:end], axis=0) * postures.fps
    return vectors
