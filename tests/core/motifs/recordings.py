"""Made-up recordings with motions that recur."""

from __future__ import annotations

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.skeleton import Skeleton

NAMES = ("Hips", "Spine", "Head", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot")
PARENTS = (-1, 0, 1, 0, 3, 4, 0, 6, 7)
OFFSETS = np.array(
    [(0, 0, 0), (0, 0.3, 0), (0, 0.3, 0)]
    + [(side * 0.1, 0, 0) if j == 0 else (0, -0.45, 0) for side in (1, -1) for j in range(3)],
    np.float32,
)
BODY = Skeleton(NAMES, PARENTS, OFFSETS)


def action(number: int, n: int) -> np.ndarray:
    """Rotation vectors ``(n, n_joints, 3)`` of action ``number``, stretched to n frames; begins and ends at rest."""
    rng = np.random.default_rng(1000 + number)
    size, turns = rng.normal(0, 0.5, (len(NAMES), 3)), rng.integers(1, 4, (len(NAMES), 3))
    time = np.linspace(0, 1, n)[:, None, None]
    return size * np.sin(np.pi * turns * time) * np.array([0.0] + [1.0] * (len(NAMES) - 1))[:, None]


def clip_of(name: str, actions: list[int], rng: np.random.Generator, fps: float = 30, noise: float = 0.01) -> Clip:
    """A clip that shows these actions one after the other, each for 0.8 to 1.2 s, with a pause of 0.2 s between."""
    parts = []
    for number in actions:
        parts += [action(number, int(fps * rng.uniform(0.8, 1.2))), np.zeros((int(fps / 5), len(NAMES), 3))]
    angles = np.concatenate(parts)
    angles = angles + rng.normal(0, noise, angles.shape)
    root = np.tile(np.float32([0, 0.9, 0]), (len(angles), 1))
    return Clip(name, BODY, fps, root, quat.from_rotvec(angles).astype(np.float32))


def recurring(seed: int = 0, n_clips: int = 3, n_actions: int = 4, length: int = 6, fps: float = 30) -> Dataset:
    """Clips of random actions out of ``n_actions``."""
    rng = np.random.default_rng(seed)
    clips = [clip_of(f"clip{i}", list(rng.integers(0, n_actions, length)), rng, fps) for i in range(n_clips)]
    return Dataset("recurring", tuple(clips))


def still(n: int = 50, name: str = "still", fps: float = 30) -> Clip:
    """Someone who does not move at all."""
    rotations = np.tile(np.float32([1, 0, 0, 0]), (n, len(NAMES), 1))
    return Clip(name, BODY, fps, np.tile(np.float32([0, 0.9, 0]), (n, 1)), rotations)
