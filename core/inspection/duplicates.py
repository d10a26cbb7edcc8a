"""Recordings that are one motion: copies, and conversions to other skeletons, frame rates and formats."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.mocap.anatomy import SIDES, find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics

_SAMPLES = 96
_SAME_LENGTH = 0.02  # of the duration, plus a tenth of a second
_ALIKE = 0.9  # correlation of two signatures
_SHORTEST = 0.5  # seconds: anything shorter looks alike
_PARTS = tuple(f"{side}_{part}" for side in SIDES for part in ("wrist", "ankle", "knee", "elbow"))


def signature(clip: Clip, skip: int = 0) -> np.ndarray | None:
    """A motion as (n_features, 96) numbers that do not depend on skeleton, rate or place, of unit length.

    Distances between the ends of the limbs and from them to the pelvis, over time. skip: frames in front to leave out
    (a rest pose). None where the skeleton is no body, the clip too short, or nothing moves.
    """
    joints = find_anatomy(clip.skeleton).joints
    if any(part not in joints for part in _PARTS) or (clip.n_frames - skip) / clip.fps < _SHORTEST:
        return None
    at = np.linspace(skip, clip.n_frames - 1, _SAMPLES).round().astype(int)
    positions = forward_kinematics(_at(clip, at))[0]
    tips = positions[:, [joints[part] for part in _PARTS]]
    pairs = [(0, 4), (0, 1), (1, 5), (4, 1), (0, 5), (2, 6)]  # wrists, wrist to ankle, ankles, across, knees
    features = [np.linalg.norm(tips[:, a] - tips[:, b], axis=-1) for a, b in pairs]
    features += list(np.linalg.norm(tips - positions[:, :1], axis=-1).T)
    curves = np.array(features)
    curves -= curves.mean(axis=1, keepdims=True)
    size = np.linalg.norm(curves)
    return curves / size if size > 1e-3 * np.sqrt(curves.size) else None


def _at(clip: Clip, at: np.ndarray) -> Clip:
    """Only these frames, so that the cost does not depend on the length."""
    tracks = {j: t[at] for j, t in clip.translations.items()}
    return Clip(clip.name, clip.skeleton, clip.fps, clip.root_positions[at], clip.rotations[at], tracks)


def find_duplicates(clips: Sequence[Clip], digests: Sequence[str], skips: Sequence[int]) -> dict[int, list[int]]:
    """For every clip that has any, the indices of the clips that look like the same motion.

    digests: equal for equal motion; skips: frames in front of each clip to leave out. Clips are only compared with
    those of nearly the same duration.
    """
    copies: dict[int, set[int]] = {}

    def join(a: int, b: int) -> None:
        copies.setdefault(a, set()).add(b)
        copies.setdefault(b, set()).add(a)

    first: dict[str, int] = {}
    for k, digest in enumerate(digests):
        if first.setdefault(digest, k) != k:
            join(first[digest], k)
    seconds = np.array([(c.n_frames - skip) / c.fps for c, skip in zip(clips, skips, strict=True)])
    order = [int(k) for k in np.argsort(seconds, kind="stable")]
    signatures = [signature(clips[k], skips[k]) for k in order]
    usable = [k for k, s in zip(order, signatures, strict=True) if s is not None]
    if not usable:
        return {k: sorted(others) for k, others in copies.items()}
    table = np.array([s.ravel() for s in signatures if s is not None], np.float32)
    length = seconds[usable]
    ends = np.searchsorted(length, length * (1 + _SAME_LENGTH) + 0.1, side="right")
    for a, end in enumerate(ends):
        for b in np.flatnonzero(table[a + 1 : end] @ table[a] > _ALIKE):
            join(usable[a], usable[a + 1 + int(b)])
    return {k: sorted(others) for k, others in copies.items()}
