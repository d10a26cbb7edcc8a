"""All features of a data set's frames in one table: a row for each frame, at one frame rate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np

from core.editing.contacts import foot_contacts
from core.errors import FormatError
from core.export.splits import TEST_SHARE, motion_groups, split_groups
from core.mocap.anatomy import CANONICAL, find_anatomy
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions, resample
from core.mocap.skeleton import Skeleton
from core.poses.angles import JOINTS, joint_angles, known_joints
from core.poses.body_frames import BodyFrames, body_frames
from core.poses.features import pose_features
from core.progress import Report, silent

FORMAT = "motionscape/features/1"


@dataclass(frozen=True)
class FeatureParameters:
    """What a feature table holds: its frame rate, and the share of its frames that are kept for testing."""

    analysis_fps: float = field(
        default=30.0, metadata={"help": "Frames a second of the table.", "min": 5.0, "max": 240.0, "step": 5.0}
    )
    test_share: float = field(
        default=TEST_SHARE,
        metadata={"help": "Share of the frames kept for testing, by person.", "min": 0.0, "max": 0.9, "step": 0.05},
    )


@dataclass(frozen=True, eq=False)
class FeatureTable:
    """Frames of all clips, one after the other, by the order of the clips' names; ``n`` rows in all.

    clips, subjects, splits: per clip its name, its group (see core.export.splits) and "train" or "test".
    clip_starts: ``(n_clips + 1,)`` rows at which clips begin. fps: frames a second.
    frames: ``(n,)`` int32 frame of the clip at its own rate.
    positions: ``(n, n_joints, 3)`` float32, metres, world, Y up, of ``joints`` (canonical; NaN where there is none).
    angles: ``(n, n_angles)`` float32, degrees, of ``angle_names`` (``left_knee flexion``); NaN likewise.
    contacts: ``(n, 2)`` bool, left and right foot.
    poses: ``(n, n_features)`` float32, the PCA space of the motif graph.
    labels: ``(n,)`` int16 index into ``actions``, -1 where nobody labelled the frame.
    """

    clips: tuple[str, ...]
    subjects: tuple[str, ...]
    splits: tuple[str, ...]
    clip_starts: np.ndarray
    fps: float
    frames: np.ndarray
    joints: tuple[str, ...]
    positions: np.ndarray
    angle_names: tuple[str, ...]
    angles: np.ndarray
    contacts: np.ndarray
    poses: np.ndarray
    actions: tuple[str, ...]
    labels: np.ndarray


def feature_table(
    dataset: Dataset, parameters: FeatureParameters | None = None, report: Report = silent
) -> FeatureTable:
    """The table of a data set; time and memory are linear in its frames.

    Of overlapping labels the later in the list counts. Raises ValueError where there are no clips, no common joints, or
    a rate or share out of range.
    """
    parameters = parameters or FeatureParameters()
    analysis_fps, test_share = parameters.analysis_fps, parameters.test_share
    poses = pose_features(dataset, analysis_fps=analysis_fps, report=report)
    clips = [dataset.clip(name) for name in poses.clips]
    frames_of: dict[Skeleton, list[Clip]] = {}
    for clip in clips:
        frames_of.setdefault(clip.skeleton, []).append(clip)
    bodies = {skeleton: body_frames(group) for skeleton, group in frames_of.items()}
    n = len(poses.values)
    positions = np.empty((n, len(CANONICAL), 3), np.float32)
    angles = np.empty((n, len(ANGLE_NAMES)), np.float32)
    contacts, frames = np.empty((n, 2), bool), np.empty(n, np.int32)
    for k, clip in enumerate(clips):
        sampled, rows = resample(clip, analysis_fps), slice(poses.clip_starts[k], poses.clip_starts[k + 1])
        positions[rows] = _positions(sampled)
        angles[rows] = _angles(sampled, bodies[clip.skeleton])
        contacts[rows] = foot_contacts(sampled)
        frames[rows] = [poses.frame_of(k, i) for i in range(sampled.n_frames)]
        report("features", (k + 1) / len(clips))
    groups = motion_groups(clips)
    split = split_groups(groups, [clip.n_frames for clip in clips], test_share)
    table = FeatureTable(
        clips=poses.clips,
        subjects=groups,
        splits=tuple(split[group] for group in groups),
        clip_starts=poses.clip_starts,
        fps=poses.fps,
        frames=frames,
        joints=CANONICAL,
        positions=positions,
        angle_names=ANGLE_NAMES,
        angles=angles,
        contacts=contacts,
        poses=poses.values,
        actions=(),
        labels=np.full(n, -1, np.int16),
    )
    return labelled(table, dataset)


def labelled(table: FeatureTable, dataset: Dataset) -> FeatureTable:
    """The table with the current labels of the data set: labels may change while the motion does not."""
    actions = tuple(sorted({label.action for label in dataset.labels}))
    labels = np.full(len(table.frames), -1, np.int16)
    place, number = {name: k for k, name in enumerate(table.clips)}, {action: k for k, action in enumerate(actions)}
    for label in dataset.labels:
        k = place[label.clip]
        rows = slice(table.clip_starts[k], table.clip_starts[k + 1])
        own = table.frames[rows]
        labels[rows][(own >= label.start) & (own < label.end)] = number[label.action]
    return replace(table, actions=actions, labels=labels)


ANGLE_NAMES = tuple(f"{name} {channel.name}" for name, joint in JOINTS.items() for channel in joint.channels)


def _positions(clip: Clip) -> np.ndarray:
    world, known = joint_positions(clip), find_anatomy(clip.skeleton).joints
    positions = np.full((clip.n_frames, len(CANONICAL), 3), np.nan, np.float32)
    for place, name in enumerate(CANONICAL):
        if name in known:
            positions[:, place] = world[:, known[name]]
    return positions


def _angles(clip: Clip, frames: BodyFrames) -> np.ndarray:
    known = joint_angles(clip, frames, known_joints(frames))
    columns = [
        known[name] if name in known else np.full((clip.n_frames, len(joint.channels)), np.nan)
        for name, joint in JOINTS.items()
    ]
    return np.concatenate(columns, axis=1).astype(np.float32)


_TEXT = ("clips", "subjects", "splits", "joints", "angle_names", "actions")


def pack_features(table: FeatureTable) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """A table as a JSON document and its arrays, of the shapes they have in it ``(n, ...)``, to be kept."""
    document = {"format": FORMAT, "fps": table.fps} | {name: list(getattr(table, name)) for name in _TEXT}
    return document, {f.name: getattr(table, f.name) for f in fields(table) if f.name not in (*_TEXT, "fps")}


def unpack_features(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> FeatureTable:
    """The table back from the arrays ``(n, ...)`` of :func:`pack_features`. Raises FormatError for anything else."""
    if document.get("format") != FORMAT:
        raise FormatError(f"not a feature table: expected format {FORMAT}, found {document.get('format')}")
    kept: dict[str, Any] = {name: tuple(document[name]) for name in _TEXT} | dict(arrays)
    return FeatureTable(fps=float(document["fps"]), **kept)
