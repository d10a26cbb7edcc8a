"""k-means: ours (faiss distances, k-means++ on a sample) against scikit-learn and faiss itself.

usage: python -m benchmarks.bench_kmeans
"""

from __future__ import annotations

import time
from collections.abc import Callable

import faiss
import numpy as np
from sklearn.cluster import KMeans

from benchmarks.recordings import all_recordings
from core.motifs.quantize import k_means
from core.poses.features import pose_features

KAPPA = 2000


def ours(x: np.ndarray) -> np.ndarray:
    """Centres by the engine's own k-means, for poses ``(n, d)``."""
    return k_means(x, KAPPA, seed=0).centres


def scikit(algorithm: str) -> Callable[[np.ndarray], np.ndarray]:
    """scikit-learn's k-means with one of its algorithms."""
    return lambda x: (
        KMeans(KAPPA, n_init=1, algorithm=algorithm, random_state=0, max_iter=25, tol=1e-4).fit(x).cluster_centers_
    )


def plain_faiss(x: np.ndarray) -> np.ndarray:
    """faiss as it comes: random seeding, its own subsampling; poses ``(n, d)``."""
    model = faiss.Kmeans(x.shape[1], KAPPA, niter=25, seed=0, max_points_per_centroid=10**6)
    model.train(x)
    return model.centroids


def inertia(x: np.ndarray, centres: np.ndarray) -> float:
    """Sum of squared distances of ``(n, d)`` to the nearest of ``(kappa, d)``."""
    return float(faiss.knn(x, np.ascontiguousarray(centres, np.float32), 1)[0].sum(dtype=np.float64))


def main() -> str:
    """The Markdown section, also printed."""
    dataset, source = all_recordings()
    x = np.ascontiguousarray(pose_features(dataset, analysis_fps=120).values)
    k_means(x[:3000], 20)
    runs = {
        "ours": ours,
        "scikit-learn, Elkan": scikit("elkan"),
        "scikit-learn, Lloyd": scikit("lloyd"),
        "faiss, random seeding": plain_faiss,
    }
    results = {}
    for name, run in runs.items():
        started = time.perf_counter()
        centres = run(x)
        results[name] = time.perf_counter() - started, inertia(x, centres)
    base_time, base_inertia = results["scikit-learn, Elkan"]
    rows = [
        f"| {name} | {seconds:.1f} | {seconds / base_time:.2f} | {value / base_inertia:.3f} |"
        for name, (seconds, value) in results.items()
    ]
    text = "\n".join(
        [
            "## K-means",
            "",
            f"{len(x)} poses of {x.shape[1]} numbers ({source}), kappa {KAPPA}, at most 25 iterations, one run each. "
            "`python -m benchmarks.bench_kmeans`",
            "",
            "| | seconds | time / Elkan | inertia / Elkan |",
            "|---|---|---|---|",
            *rows,
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
