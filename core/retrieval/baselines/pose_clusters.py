"""Pose clusters and edit distance, after Liu, Zhang, Wang and McMillan 2005.

They cluster all postures, model each cluster as a linear space, and index a motion by the clusters it passes through;
two motions are alike where they pass through the same clusters in the same order. Softened here, which favours it: to
put one cluster for another costs as much as their centres lie apart, up to the price of strangers.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial.distance import cdist

from core.mocap.dataset import Dataset
from core.poses.postures import postures_of
from core.progress import Report, silent
from core.retrieval.baselines.recordings import in_order
from core.retrieval.baselines.warping import all_edit_distances
from core.retrieval.patterns import adaptive_k_means

CLUSTERS = 200
_GAP = 0.5


def pose_cluster_distances(dataset: Dataset, report: Report = silent) -> np.ndarray:
    """Distances of all pairs of clips ``(n, n)``, in the data set's order. Raises as core.poses.postures."""
    postures = postures_of(dataset, report=report)
    centres, labels = adaptive_k_means(postures.vectors, max_error=0.0, most=CLUSTERS)
    symbols, starts = _without_repeats(labels, postures.clip_starts)
    apart = cdist(centres, centres)
    prices = np.minimum(apart / np.median(apart[np.triu_indices(len(apart), 1)]), 1) if len(apart) > 1 else apart
    return in_order(all_edit_distances(symbols, starts, prices, _GAP, report), postures.clips, dataset)


def _without_repeats(labels: np.ndarray, starts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    new = np.ones(len(labels), bool)
    new[1:] = labels[1:] != labels[:-1]
    new[starts[:-1]] = True
    return labels[new], np.concatenate([[0], np.cumsum(new)])[starts]
