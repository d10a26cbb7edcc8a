"""Usual ways to segment motion and group the segments, as baselines: k-means with a hidden Markov model, change points
with clustering, and LoCoMotif. Each takes a data set and gives classes, which are sequences of segments."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.poses.features import Poses, pose_features

FPS = 15
PENALTIES = (1.0, 2.0, 4.0, 8.0, 16.0)  # of a change point; chosen on demos that are not reported
LARGEST = 20_000  # poses that LoCoMotif is given
WINDOW = 1.0  # seconds that a frame's mean and spread are taken over

Classes = Sequence[Sequence[Segment]]


def hidden_markov(dataset: Dataset, k: int, seed: int = 0) -> Classes:
    """k-means into ``k`` states, then a Gaussian hidden Markov model begun there, and Viterbi's path."""
    from hmmlearn.hmm import GaussianHMM

    poses, x = _described(dataset)
    lengths = np.diff(poses.clip_starts).tolist()
    model = GaussianHMM(k, "diag", n_iter=30, random_state=seed, min_covar=1e-2, init_params="mcs")
    model.startprob_ = np.full(k, 1 / k)
    stay = 1 - 1 / (2 * FPS)
    model.transmat_ = np.full((k, k), (1 - stay) / max(k - 1, 1))
    np.fill_diagonal(model.transmat_, stay if k > 1 else 1)
    model.init_params = "mc"  # means by k-means
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        model.fit(x, lengths)
    return _classes(poses, model.predict(x, lengths), k)


def change_points(dataset: Dataset, k: int, penalty: float, seed: int = 0) -> Classes:
    """Change points of kernel change point detection (ruptures, PELT), segments grouped by Ward's method into ``k``.

    seed: is not used, as nothing is random.
    """
    import ruptures
    from sklearn.cluster import AgglomerativeClustering

    poses, x = _described(dataset)
    spans = []
    for start, end in pairwise(poses.clip_starts):
        part = np.ascontiguousarray(x[start:end])
        ends = [len(part)]
        if len(part) > 2 * FPS:
            detector = ruptures.KernelCPD(kernel="rbf", params={"gamma": 1 / x.shape[1]}, min_size=FPS)
            ends = detector.fit(part).predict(pen=penalty)
        spans += [(start + a, start + b) for a, b in pairwise([0, *ends])]
    means = np.array([np.concatenate([x[a:b].mean(0), x[a:b].std(0)]) for a, b in spans])
    groups = np.arange(len(spans))
    if len(spans) > k:
        groups = AgglomerativeClustering(k).fit_predict(means)
    states = np.concatenate([np.full(b - a, group) for (a, b), group in zip(spans, groups, strict=True)])
    return _classes(poses, states, k)


def locomotif(dataset: Dataset) -> Classes:
    """Motifs of LoCoMotif, as in :mod:`benchmarks.bench_motifs`; at a lower rate where its memory would not do."""
    from benchmarks.bench_motifs import locomotif as document_of

    motifs = document_of(dataset, fps=30 if dataset.seconds * 30 < LARGEST else 10)["motifs"]
    return [[Segment(m["clip"], m["start"], m["end"]) for m in motif["motions"]] for motif in motifs]


def _described(dataset: Dataset) -> tuple[Poses, np.ndarray]:
    """Poses, and what each frame is described by: mean and spread of a second around it, ``(n, d)``, scaled."""
    from scipy.ndimage import uniform_filter1d

    poses = pose_features(dataset, analysis_fps=FPS)
    values = np.asarray(poses.values, np.float64)
    parts = []
    for start, end in pairwise(poses.clip_starts):
        own, size = values[start:end], round(WINDOW * FPS)
        mean = uniform_filter1d(own, size, axis=0, mode="nearest")
        square = uniform_filter1d(own**2, size, axis=0, mode="nearest")
        parts.append(np.concatenate([mean, np.sqrt(np.maximum(square - mean**2, 0))], axis=1))
    x = np.concatenate(parts)
    return poses, (x - x.mean(0)) / x.std()


def _classes(poses: Poses, states: np.ndarray, k: int) -> Classes:
    """Stretches of equal states ``(n,)`` as segments at the clips' own rates."""
    classes: list[list[Segment]] = [[] for _ in range(k)]
    for c, (start, end) in enumerate(pairwise(poses.clip_starts)):
        own = states[start:end]
        edges = [0, *(np.flatnonzero(np.diff(own)) + 1).tolist(), len(own)]
        for a, b in pairwise(edges):
            first, last = poses.frame_of(c, a), poses.frame_of(c, b) if b < len(own) else poses.clip_frames[c]
            classes[own[a]].append(Segment(poses.clips[c], int(first), int(last)))
    return classes
