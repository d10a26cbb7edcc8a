"""Postures mixed without shrinking: bone directions are averaged on the sphere, bone lengths stay (MAP section 3.3).

A model vector is a mean of joint positions; where limbs point different ways the mean of their ends lies between them
and the limb comes out short. Drawn and refined postures are rebuilt from directions and fixed lengths.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

_TINY = 1e-9


def bone_vectors(postures: np.ndarray, parents: Sequence[int]) -> np.ndarray:
    """From each joint's parent to the joint: ``(..., n_joints, 3)`` as the postures; parent -1 is the origin."""
    above = np.asarray(parents)
    ends = np.concatenate([postures, np.zeros((*postures.shape[:-2], 1, 3), postures.dtype)], axis=-2)
    vectors: np.ndarray = postures - ends[..., above, :]
    return vectors


def bone_lengths(postures: np.ndarray, parents: Sequence[int]) -> np.ndarray:
    """Median length ``(n_joints,)`` of each bone over real postures ``(n, n_joints, 3)``."""
    lengths: np.ndarray = np.median(np.linalg.norm(bone_vectors(postures, parents), axis=-1), axis=0)
    return lengths


def rebuild(vectors: np.ndarray, parents: Sequence[int], lengths: np.ndarray) -> np.ndarray:
    """Postures ``(..., n_joints, 3)`` whose bones point along ``vectors`` and have these lengths ``(n_joints,)``.

    A bone without direction (of length 0) points along the sum of the others above it, else up.
    """
    size = np.linalg.norm(vectors, axis=-1, keepdims=True)
    directions = np.where(size > _TINY, vectors / np.maximum(size, _TINY), [0.0, 1.0, 0.0])
    bones = directions * lengths[:, None]
    postures: np.ndarray = np.empty_like(bones)
    for joint, above in enumerate(parents):  # parents come before their children
        postures[..., joint, :] = bones[..., joint, :] + (postures[..., above, :] if above >= 0 else 0)
    return postures


def with_real_bones(postures: np.ndarray, parents: Sequence[int], lengths: np.ndarray) -> np.ndarray:
    """The postures ``(..., n_joints, 3)`` with every bone at its own length."""
    return rebuild(bone_vectors(postures, parents), parents, lengths)


def refine(weights: np.ndarray, parents: Sequence[int], lengths: np.ndarray, factor: int) -> np.ndarray:
    """The map on a grid ``factor`` times finer: virtual nodes between the real ones (MAP figure 5).

    weights: ``(nx, ny, n_joints, 3)``; gives ``((nx - 1) factor + 1, (ny - 1) factor + 1, n_joints, 3)`` float32. Bone
    directions are interpolated along great circles, first along x, then along y, and get real lengths. Where two
    directions are opposite the way between them is not defined: the straight mean is taken.
    """
    bones = bone_vectors(weights.astype(np.float64), parents)
    size = np.linalg.norm(bones, axis=-1, keepdims=True)
    directions = np.where(size > _TINY, bones / np.maximum(size, _TINY), [0.0, 1.0, 0.0])
    fine = _between(_between(directions, 0, factor), 1, factor)
    return rebuild(fine, parents, lengths).astype(np.float32)


def _between(directions: np.ndarray, axis: int, factor: int) -> np.ndarray:
    """Unit vectors with ``factor - 1`` more between every two along an axis."""
    moved = np.moveaxis(directions, axis, 0)
    a, b = moved[:-1], moved[1:]
    cosine = np.clip((a * b).sum(axis=-1, keepdims=True), -1, 1)
    angle = np.arccos(cosine)
    sine = np.sin(angle)
    flat = sine < 1e-6
    fine = np.empty(((len(moved) - 1) * factor + 1, *moved.shape[1:]))
    for step in range(factor):
        t = step / factor
        first = np.where(flat, 1 - t, np.sin((1 - t) * angle) / np.where(flat, 1, sine))
        second = np.where(flat, t, np.sin(t * angle) / np.where(flat, 1, sine))
        fine[step:-1:factor] = first * a + second * b
    fine[-1] = moved[-1]
    return np.moveaxis(fine, 0, axis)
