"""What several baselines need of recordings."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.mocap.anatomy import find_anatomy
from core.mocap.dataset import Dataset


def in_order(distances: np.ndarray, clips: Sequence[str], dataset: Dataset) -> np.ndarray:
    """Distances ``(n, n)`` of ``clips`` in the order of the data set's clips, ``(n, n)``."""
    place = {name: k for k, name in enumerate(clips)}
    order = [place[name] for name in dataset.names]
    return distances[np.ix_(order, order)]


def canonical_names(dataset: Dataset) -> dict[str, str]:
    """Joint name -> canonical name, for all skeletons of a data set; canonical names stand for themselves."""
    names: dict[str, str] = {}
    for skeleton in {clip.skeleton for clip in dataset.clips}:
        for name, joint in find_anatomy(skeleton).joints.items():
            names |= {name: name, skeleton.names[joint]: name}
    return names
