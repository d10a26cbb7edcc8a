"""Weighted principal components and time warping, after Forbes and Fiume 2005.

Their features are joint rotations as exponential maps, each joint with a weight; a weighted PCA keeps few dimensions,
in which motions are warped onto each other. Weights here fall with a joint's distance from the trunk, as in their
default. They find stretches of long motions by a characteristic pose first; here whole clips are compared.
"""

from __future__ import annotations

import numpy as np

from core.mocap.dataset import Dataset
from core.poses.body_parts import leaf_of
from core.poses.features import pose_features, principal_directions
from core.progress import Report, silent
from core.retrieval.baselines.recordings import canonical_names, in_order
from core.retrieval.baselines.warping import all_warping_distances

DIMENSIONS = 8
_WEIGHTS = {"torso": 1.0, "arm": 0.7, "leg": 1.0, "head": 0.3, "hand": 0.1, "foot": 0.3}


def weighted_pca_distances(dataset: Dataset, report: Report = silent) -> np.ndarray:
    """Distances of all pairs of clips ``(n, n)``, in the data set's order. Raises as core.poses.features."""
    poses = pose_features(dataset, pose="angles", variance=1.0, report=report)
    raw = poses.values @ poses.basis.T + poses.mean  # all features again: a full basis loses nothing
    known = canonical_names(dataset)
    chosen = [k for k, name in enumerate(poses.names) if " rotation " in name]
    weights = np.array([_weight(known.get(poses.names[k].rpartition(" rotation ")[0])) for k in chosen])
    weighted = raw[:, chosen] * np.sqrt(weights)
    mean, basis, _ = principal_directions(weighted.astype(np.float32), 1.0)
    values = (weighted - mean) @ basis[:, :DIMENSIONS]
    return in_order(all_warping_distances(values, poses.clip_starts, report), poses.clips, dataset)


def _weight(canonical: str | None) -> float:
    leaf = leaf_of(canonical) if canonical else None
    return _WEIGHTS[leaf.rpartition("_")[2]] if leaf else _WEIGHTS["torso"]
