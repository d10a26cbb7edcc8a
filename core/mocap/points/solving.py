"""From positions of joints to bones of fixed lengths that turn: rotations of least twist, and how well they fit.

Every bone gets its median length. A joint with one bone turns by the shortest way from its parent's pose to where the
bone points; a joint with several is turned so that they fit best in the sense of least squares (Kabsch 1976). Each bone
aims from where its joint came to lie, so errors do not add up along a limb.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.mocap import quaternions as quat

_PULL = 1e-3  # how strongly the parent's pose counts where several bones leave the turn about a line open
_ROUNDS = 3  # in which the rest shape of joints with several bones is found
_SAMPLED = 400  # frames for it
_SHORT = 1e-9
_BLOCK = 4096  # frames solved at a time


class Solution(NamedTuple):
    """offsets: (n_joints, 3) at rest; rotations: (n_frames, n_joints, 4), local; errors: (n_frames, n_joints) distance
    of each joint from its point, in the unit of the points."""

    offsets: np.ndarray
    rotations: np.ndarray
    errors: np.ndarray


def solve(positions: np.ndarray, parents: Sequence[int], directions: np.ndarray) -> Solution:
    """Bones for joints at ``positions`` (n_frames, n_joints, 3).

    parents: of each joint, parents first; directions: (n_joints, 3) unit vectors, where each bone points at rest.
    """
    lengths = bone_lengths(positions, parents)
    offsets = directions * lengths[:, None]
    at = np.unique(np.linspace(0, len(positions) - 1, min(len(positions), _SAMPLED)).astype(int))
    sample = positions[at]
    branches = [j for j in range(len(parents)) if list(parents).count(j) > 1]
    for _ in range(_ROUNDS):
        world, placed = _world(sample, parents, offsets)
        offsets = _reshaped(sample, placed, world, parents, offsets, branches, lengths)
    rotations = np.empty((*positions.shape[:2], 4), np.float32)
    errors = np.empty(positions.shape[:2], np.float32)
    for start in range(0, len(positions), _BLOCK):
        block = positions[start : start + _BLOCK]
        world, placed = _world(block, parents, offsets)
        errors[start : start + _BLOCK] = np.linalg.norm(placed - block, axis=2)
        rotations[start : start + _BLOCK, 0] = world[:, 0]
        for j, parent in enumerate(parents):
            if parent >= 0:
                rotations[start : start + _BLOCK, j] = quat.multiply(quat.conjugate(world[:, parent]), world[:, j])
    return Solution(offsets, rotations, errors)


def bone_lengths(positions: np.ndarray, parents: Sequence[int]) -> np.ndarray:
    """Median length of the bone that ends at each joint, ``(n_joints,)``; 0 for the root."""
    lengths = np.zeros(len(parents))
    for j, parent in enumerate(parents):
        if parent >= 0:
            lengths[j] = np.median(np.linalg.norm(positions[:, j] - positions[:, parent], axis=1))
    return lengths


def _world(positions: np.ndarray, parents: Sequence[int], offsets: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """World rotations ``(n, n_joints, 4)`` and where the joints come to lie ``(n, n_joints, 3)``."""
    n, joints = positions.shape[:2]
    world, placed = np.zeros((n, joints, 4)), np.empty((n, joints, 3))
    children: list[list[int]] = [[] for _ in parents]
    for j, parent in enumerate(parents):
        if parent >= 0:
            children[parent].append(j)
    still = np.tile([1.0, 0.0, 0.0, 0.0], (n, 1))
    for j, parent in enumerate(parents):
        before = world[:, parent] if parent >= 0 else still
        placed[:, j] = positions[:, 0] if parent < 0 else placed[:, parent] + quat.rotate(before, offsets[j][None])
        bones = [c for c in children[j] if np.linalg.norm(offsets[c]) > _SHORT]
        aims = positions[:, bones] - placed[:, j, None]
        if not bones:
            world[:, j] = before
        elif len(bones) == 1:
            world[:, j] = quat.multiply(_shortest(quat.rotate(before, offsets[bones[0]][None]), aims[:, 0]), before)
        else:
            world[:, j] = _best_turn(offsets[bones], aims, before)
    return world, placed


def _shortest(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Shortest rotations ``(n, 4)`` that turn vectors ``start`` (n, 3) to point along ``end`` (n, 3)."""
    a = start / np.maximum(np.linalg.norm(start, axis=1, keepdims=True), _SHORT)
    b = end / np.maximum(np.linalg.norm(end, axis=1, keepdims=True), _SHORT)
    turn = np.concatenate([1 + (a * b).sum(1, keepdims=True), np.cross(a, b)], axis=1)
    opposite = turn[:, 0] < 1e-6
    if opposite.any():  # half a turn, about any axis across
        across = np.cross(a[opposite], np.eye(3)[np.abs(a[opposite]).argmin(1)])
        turn[opposite] = np.concatenate([np.zeros((len(across), 1)), across], axis=1)
    turn[np.linalg.norm(end, axis=1) < _SHORT] = (1, 0, 0, 0)
    return quat.normalise(turn)


def _best_turn(rest: np.ndarray, aims: np.ndarray, before: np.ndarray) -> np.ndarray:
    """Rotations ``(n, 4)`` that bring the bones ``rest`` (k, 3) nearest to ``aims`` (n, k, 3)."""
    size = float((rest**2).sum())
    axes = np.stack([quat.rotate(before, axis[None]) for axis in np.eye(3)], axis=2)  # the parent's pose as matrices
    covariance = np.einsum("nki,kj->nij", aims, rest) + _PULL * size * axes
    u, _, vt = np.linalg.svd(covariance)
    sign = np.sign(np.linalg.det(u @ vt))
    u[:, :, 2] *= sign[:, None]
    return from_matrices(u @ vt)


def from_matrices(matrices: np.ndarray) -> np.ndarray:
    """Rotation matrices ``(n, 3, 3)`` to quaternions ``(n, 4)``, without a division by what may be 0."""
    m = matrices
    candidates = np.stack(
        [
            [
                1 + m[:, 0, 0] + m[:, 1, 1] + m[:, 2, 2],
                m[:, 2, 1] - m[:, 1, 2],
                m[:, 0, 2] - m[:, 2, 0],
                m[:, 1, 0] - m[:, 0, 1],
            ],
            [
                m[:, 2, 1] - m[:, 1, 2],
                1 + m[:, 0, 0] - m[:, 1, 1] - m[:, 2, 2],
                m[:, 0, 1] + m[:, 1, 0],
                m[:, 0, 2] + m[:, 2, 0],
            ],
            [
                m[:, 0, 2] - m[:, 2, 0],
                m[:, 0, 1] + m[:, 1, 0],
                1 - m[:, 0, 0] + m[:, 1, 1] - m[:, 2, 2],
                m[:, 1, 2] + m[:, 2, 1],
            ],
            [
                m[:, 1, 0] - m[:, 0, 1],
                m[:, 0, 2] + m[:, 2, 0],
                m[:, 1, 2] + m[:, 2, 1],
                1 - m[:, 0, 0] - m[:, 1, 1] + m[:, 2, 2],
            ],
        ],
        axis=0,
    ).transpose(2, 0, 1)
    best = np.argmax(np.einsum("nkk->nk", candidates), axis=1)
    return quat.normalise(candidates[np.arange(len(m)), best])


def _reshaped(
    positions: np.ndarray,
    placed: np.ndarray,
    world: np.ndarray,
    parents: Sequence[int],
    offsets: np.ndarray,
    branches: Sequence[int],
    lengths: np.ndarray,
) -> np.ndarray:
    """Rest offsets in which the bones of each joint that has several lie as they do in the motion, on average."""
    new = offsets.copy()
    for j in branches:
        bones = [c for c, parent in enumerate(parents) if parent == j]
        aims = positions[:, bones] - placed[:, j, None]
        seen = np.median(quat.rotate(quat.conjugate(world[:, j])[:, None], aims), axis=0)
        seen *= lengths[bones, None] / np.maximum(np.linalg.norm(seen, axis=1, keepdims=True), _SHORT)
        # turned back onto the T-pose, so that "no rotation" means the same for every recording
        back = _best_turn(seen, offsets[bones][None], np.array([[1.0, 0, 0, 0]]))
        new[bones] = quat.rotate(back, seen)
    return new
