"""The baselines of the paper (PCR section 5) and one more, for evaluation only.

Each takes the recordings as its own paper does, but for what stands in its module's docstring.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from core.mocap.dataset import Dataset
from core.progress import Report, silent
from core.retrieval.baselines.match_webs import match_web_distances
from core.retrieval.baselines.pose_clusters import pose_cluster_distances
from core.retrieval.baselines.position_warping import position_distances
from core.retrieval.baselines.weighted_pca import weighted_pca_distances

BASELINES: dict[str, Callable[[Dataset, Report], np.ndarray]] = {
    "weighted-pca": weighted_pca_distances,
    "pose-clusters": pose_cluster_distances,
    "position-dtw": position_distances,
    "match-webs": match_web_distances,
}
"""Name -> distances of all pairs of clips, ``(n, n)``, in the order of the data set's clips."""


def baseline_rankings(name: str, dataset: Dataset, report: Report = silent) -> dict[str, list[str]]:
    """Each clip's ranking of all the others, best first, by a baseline. Raises KeyError for an unknown name."""
    apart = BASELINES[name](dataset, report)
    names = dataset.names
    return {query: [names[j] for j in np.argsort(apart[i], kind="stable") if j != i] for i, query in enumerate(names)}
