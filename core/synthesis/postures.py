"""How alike two moments are, for passing from one to the other: point clouds over a short span of time.

After Kovar, Gleicher and Pighin, "Motion Graphs" (2002): joint positions over a window, place and facing taken out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from core.editing.blending import heading, turn_about_y
from core.errors import AnalysisError
from core.mocap.anatomy import CANONICAL, find_anatomy
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.synthesis.bodies import floor_of

_OFFSETS = (-0.15, 0.0, 0.15)  # seconds
_HEIGHT = 1.7  # metres; bodies are scaled to it


class Moment(NamedTuple):
    """A frame of a clip, at its own rate."""

    clip: str
    frame: int


def moments_apart(dataset: Dataset, moments: Sequence[Moment]) -> np.ndarray:
    """Features ``(n_moments, n_features)`` whose Euclidean distance is how far apart two moments are, in metres.

    That is the root mean square distance of the joints, of bodies 1.7 m tall that face the same way, over a third of a
    second. Only canonical joints that all skeletons of the data set have count. Linear in moments.
    Raises KeyError for a clip that is not there, ValueError where no joint is common to all.
    """
    names = _common_joints(dataset)
    features = np.empty((len(moments), len(_OFFSETS) * len(names) * 3), np.float32)
    clips = np.array([moment.clip for moment in moments])
    frames = np.array([moment.frame for moment in moments], np.int64)
    for name in dict.fromkeys(clips.tolist()):
        chosen = np.flatnonzero(clips == name)
        features[chosen] = _clouds(dataset.clip(name), frames[chosen], names)
    scaled: np.ndarray = features / np.sqrt(features.shape[1] / 3)
    return scaled


def _common_joints(dataset: Dataset) -> list[str]:
    bodies = [find_anatomy(skeleton).joints for skeleton in {clip.skeleton for clip in dataset.clips}]
    names = [name for name in CANONICAL if all(name in joints for joints in bodies)]
    if len(names) < 2:
        raise AnalysisError("the skeletons of this data set have no joints in common")
    return names


def _clouds(clip: Clip, frames: np.ndarray, names: list[str]) -> np.ndarray:
    window = np.round(np.array(_OFFSETS) * clip.fps).astype(np.int64)
    at = np.clip(frames[:, None] + window, 0, clip.n_frames - 1).ravel()
    sparse = replace(clip, root_positions=clip.root_positions[at], rotations=clip.rotations[at], translations={})
    anatomy = find_anatomy(clip.skeleton)
    positions = joint_positions(sparse)
    middle = len(window) // 2
    facing = heading(sparse, positions).reshape(-1, len(window))[:, middle]
    joints = [anatomy.joints[name] for name in names]
    cloud = positions[:, joints].reshape(len(frames), -1, 3).astype(np.float64)
    root = positions[:, 0].reshape(len(frames), len(window), 3)[:, middle] * [1, 0, 1]
    root[..., 1] = floor_of(clip)
    cloud = turn_about_y(-facing[:, None], cloud - root[:, None])
    return cloud.reshape(len(frames), -1) * (_HEIGHT / anatomy.body_height)
