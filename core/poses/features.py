"""A frame as numbers: pose features free of place and heading, reduced by PCA (MMG section 3.2).

Features of a frame, y up: for every posture joint its rotation against the next posture joint above, as a rotation
vector
in degrees about the joint's mean rotation (so no angle wraps in natural motion); height of the root in CMU's length
unit,
so that it weighs like a degree; pitch and roll of the pelvis in degrees; horizontal speed and yaw speed per 1/30 s in
the same units. ``positions`` replaces the angles by joint positions in the heading's frame, scaled to one body height.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from core.errors import AnalysisError
from core.mocap import quaternions as quat
from core.mocap.anatomy import CANONICAL, Anatomy, find_anatomy
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.kinematics import forward_kinematics, resample
from core.mocap.rigs import kinds_of, rigs_of
from core.mocap.skeleton import Skeleton
from core.poses.rows import Rows
from core.progress import Progress, Report, part_of, silent, unheard

CMU_UNIT = 0.056444
"""Metres per length unit of the CMU recordings."""

SPEED_FPS = 30.0
"""Speeds are per frame of this rate, whatever the analysis rate."""

_STANDARD_HEIGHT = 1.7  # metres; positions are scaled to this body
_MAX_YAW = 30.0  # degrees per 1/30 s: an upside-down pelvis has no heading, its yaw may jump
_KINDS = ("angles", "positions")
_TOGETHER = 131_072  # frames whose features are in memory at a time beside those of all


@dataclass(frozen=True)
class Scales:
    """Weight of each kind of feature: metres per unit of length (height, speed, positions), degrees per unit of
    angle."""

    height: float = CMU_UNIT
    speed: float = CMU_UNIT
    position: float = CMU_UNIT
    angle: float = 1.0
    tilt: float = 1.0
    yaw_speed: float = 1.0


_SCALES = Scales()


@dataclass(frozen=True, eq=False)
class Poses:
    """Pose features of many clips, one after the other, at one frame rate.

    values: (n, n_features) float32, in the PCA space, centred. clip_starts: (n_clips + 1,) offsets of the clips in
    values. clips: clip names; clip_fps, clip_frames: rate and number of frames of the clips themselves; fps: rate of
    ``values``.
    basis: (n_raw, n_features) principal directions; mean: (n_raw,) mean of the raw features; names: what each raw
    feature is; explained: share of the variance kept.
    """

    values: np.ndarray
    clip_starts: np.ndarray
    clips: tuple[str, ...]
    clip_fps: tuple[float, ...]
    clip_frames: tuple[int, ...]
    fps: float
    basis: np.ndarray
    mean: np.ndarray
    names: tuple[str, ...]
    explained: float

    def frame_of(self, clip: int, k: float) -> int:
        """Frame of clip number ``clip``, at its own rate, that pose ``k`` of that clip was taken from."""
        return min(round(k * self.clip_fps[clip] / self.fps), self.clip_frames[clip] - 1)

    @property
    def mean_distance(self) -> float:
        """Mean distance of a pose to the average pose."""
        return float(np.linalg.norm(self.values, axis=1).mean()) if len(self.values) else 0.0


def pose_features(
    dataset: Dataset,
    *,
    analysis_fps: float = 30,
    pose: str = "angles",
    variance: float = 0.97,
    scales: Scales = _SCALES,
    report: Report = silent,
) -> Poses:
    """Poses of all clips of a dataset, at ``analysis_fps``, in the PCA space that keeps ``variance`` of the variance.

    pose: "angles" or "positions". Skeletons with the same posture joints are compared joint by joint; otherwise only
    canonical joints that all of them have count. Clips come in the order of their names, so that nothing depends on the
    order they were read in. Time and memory are linear in frames. Raises ValueError for an unknown
    pose kind, a rate or a variance out of range, an empty dataset, or skeletons without a joint in common.
    """
    clips = sorted(dataset.clips, key=lambda clip: clip.name)
    if not 0 < variance <= 1:
        raise ValueError(f"variance must be between 0 and 1, not {variance}")
    heard = partial(report, "poses")
    features = raw_features(clips, analysis_fps, pose, scales, progress=part_of(heard, 0.0, 0.1))
    rows, counts = Rows(), []
    for i, clip in enumerate(clips):
        block = features.of(resample(clip, analysis_fps))
        rows.add(block)
        counts.append(len(block))
        heard(0.1 + 0.7 * (i + 1) / len(clips))
    starts = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    raw = rows.array()
    mean, basis, explained = principal_directions(raw, variance, part_of(heard, 0.8, 0.9))
    return Poses(
        values=projected(raw, mean, basis, part_of(heard, 0.9, 1.0)),
        clip_starts=starts,
        clips=tuple(clip.name for clip in clips),
        clip_fps=tuple(float(clip.fps) for clip in clips),
        clip_frames=tuple(clip.n_frames for clip in clips),
        fps=float(analysis_fps),
        basis=basis,
        mean=mean,
        names=features.names,
        explained=explained,
    )


@dataclass(frozen=True, eq=False)
class RawFeatures:
    """Features of clips before their principal directions are taken. names: what each is; pose, scales: as of
    :func:`pose_features`."""

    names: tuple[str, ...]
    pose: str
    scales: Scales
    _bodies: dict[Skeleton, _Body]
    _rest: dict[int, tuple[np.ndarray, np.ndarray]]

    def of(self, clip: Clip) -> np.ndarray:
        """The features of a clip at the rate of the analysis, ``(n, f)`` float32. Its skeleton must be a known one."""
        body = self._bodies[clip.skeleton]
        return _clip_features(clip, body, self._rest[body.family], self.pose, self.scales)


def raw_features(
    clips: Sequence[Clip],
    analysis_fps: float,
    pose: str = "angles",
    scales: Scales = _SCALES,
    *,
    image: Callable[[Clip], Clip] | None = None,
    progress: Progress = unheard,
) -> RawFeatures:
    """What computes the features of one clip after the other, so that no more than one is in memory.

    image: makes another clip of the same skeleton out of a clip, such as its mirror image; its rotations then count for
    the mean ones as well. Raises as :func:`pose_features`.
    """
    if pose not in _KINDS:
        raise ValueError(f"pose must be one of {', '.join(_KINDS)}, not {pose!r}")
    if not analysis_fps > 0:
        raise ValueError(f"analysis_fps must be positive, not {analysis_fps}")
    if not clips:
        raise AnalysisError("the dataset has no clips, so there are no poses")
    bodies = _bodies([clip.skeleton for clip in clips])
    rest = _mean_rotations(clips, image, bodies, progress)
    return RawFeatures(_names(bodies[clips[0].skeleton].names, pose), pose, scales, bodies, rest)


def _sparse(clip: Clip) -> Clip:
    """About three frames a second of a clip, which are plenty for a mean; its joints do not stretch."""
    step = max(1, round(clip.fps / 3))
    return Clip(clip.name, clip.skeleton, clip.fps / step, clip.root_positions[::step], clip.rotations[::step])


def principal_directions(
    raw: np.ndarray, variance: float, progress: Progress = unheard
) -> tuple[np.ndarray, np.ndarray, float]:
    """Mean ``(f,)``, fewest principal directions ``(f, k)`` that keep ``variance`` of the variance, and what they keep.

    raw: ``(n, f)``. Signs are fixed (largest entry positive); constant data gives one direction. The
    covariance is summed block by block: scikit-learn's PCA would need a copy of all values in double precision.
    """
    mean = raw.mean(0, dtype=np.float64)
    covariance = np.zeros((raw.shape[1],) * 2)
    for i in range(0, len(raw), 16_384):
        part = raw[i : i + 16_384] - mean
        covariance += part.T @ part
        progress(min((i + 16_384) / len(raw), 1.0))
    values, vectors = np.linalg.eigh(covariance)
    values, vectors = np.maximum(values[::-1], 0), vectors[:, ::-1]
    share = np.cumsum(values) / max(values.sum(), 1e-12)
    k = min(int(np.searchsorted(share, variance)) + 1, len(values))
    basis = vectors[:, :k]
    signs = np.sign(basis[np.abs(basis).argmax(0), np.arange(k)])
    return mean, basis * signs, float(share[k - 1])


def projected(raw: np.ndarray, mean: np.ndarray, basis: np.ndarray, progress: Progress = unheard) -> np.ndarray:
    """Raw features ``(n, f)`` about their mean along the directions ``(f, k)``, so many at a time: ``(n, k)``."""
    values = np.empty((len(raw), basis.shape[1]), np.float32)
    mean, basis = mean.astype(np.float32), basis.astype(np.float32)
    for i in range(0, len(raw), _TOGETHER):
        values[i : i + _TOGETHER] = (raw[i : i + _TOGETHER] - mean) @ basis
        progress(min((i + _TOGETHER) / len(raw), 1.0))
    return values


@dataclass(frozen=True)
class _Body:
    """Which joints of a skeleton are compared: their indices, the joint each is measured against, and the hips."""

    names: tuple[str, ...]
    joints: tuple[int, ...]
    above: tuple[int, ...]
    hips: tuple[int, int] | None
    height: float
    family: int  # skeletons of one rig share their rest rotations


def posture_joints(skeletons: Sequence[Skeleton]) -> dict[Skeleton, dict[str, int]]:
    """Per skeleton the joints of its posture vector: name -> index, the same names in the same order for all.

    Raises AnalysisError where bodies are among them that cannot be compared, or that have none in common.
    """
    unique = list(dict.fromkeys(skeletons))
    kinds = sorted(set(kinds_of(unique, parts_with_people=True).values()))
    if len(kinds) > 1:
        raise AnalysisError(f"bodies that cannot be compared: {', '.join(kinds[:4])}; analyse each kind on its own")
    anatomies = {s: find_anatomy(s) for s in unique}
    own = {s: {s.names[j]: j for j in anatomies[s].posture_joints} for s in unique}
    if len({tuple(names) for names in own.values()}) > 1:
        common = [n for n in CANONICAL if n != "pelvis" and all(n in anatomies[s].joints for s in unique)]
        own = {s: {n: anatomies[s].joints[n] for n in common} for s in unique}
    if not all(own.values()):
        raise AnalysisError("the skeletons of this dataset have no posture joint in common; analyse them separately")
    return own


def _bodies(skeletons: Sequence[Skeleton]) -> dict[Skeleton, _Body]:
    chosen = posture_joints(skeletons)
    _, rigs = rigs_of(skeletons)
    return {s: _body(s, find_anatomy(s), joints, rigs[s]) for s, joints in chosen.items()}


def _body(skeleton: Skeleton, anatomy: Anatomy, chosen: dict[str, int], rig: int) -> _Body:
    joints = tuple(chosen.values())
    above = []
    for j in joints:
        p = skeleton.parents[j]
        while p > 0 and p not in joints:
            p = skeleton.parents[p]
        above.append(max(p, 0))
    hips = anatomy.joints.get("left_hip", -1), anatomy.joints.get("right_hip", -1)
    return _Body(tuple(chosen), joints, tuple(above), hips if min(hips) >= 0 else None, anatomy.body_height, rig)


def _mean_rotations(
    clips: Sequence[Clip], image: Callable[[Clip], Clip] | None, bodies: dict[Skeleton, _Body], progress: Progress
) -> dict[int, tuple[np.ndarray, np.ndarray]]:
    """Per family: mean rotation of each joint ``(n_joints, 4)`` and mean pelvis rotation without heading ``(4,)``."""
    sums: dict[int, np.ndarray] = {}
    for k, clip in enumerate(clips):
        body, few = bodies[clip.skeleton], _sparse(clip)
        for one in (few,) if image is None else (few, image(few)):
            positions, world = forward_kinematics(one)
            local = np.concatenate([_relative(world, body), _without_heading(positions, world, body)[:, None]], axis=1)
            moments = np.einsum("fji,fjk->jik", local.astype(np.float64), local)
            sums[body.family] = sums.get(body.family, 0) + moments
        progress((k + 1) / len(clips))
    means = {family: np.linalg.eigh(moments)[1][..., -1] for family, moments in sums.items()}
    return {family: (mean[:-1], mean[-1]) for family, mean in means.items()}


def _relative(world: np.ndarray, body: _Body) -> np.ndarray:
    """Rotation of each posture joint against the posture joint above it: ``(n, n_joints, 4)``."""
    return quat.multiply(quat.conjugate(world[:, list(body.above)]), world[:, list(body.joints)])


def _without_heading(positions: np.ndarray, world: np.ndarray, body: _Body) -> np.ndarray:
    """World rotation of the pelvis ``(n, 4)`` turned so that its hips face z."""
    if body.hips is None:
        return quat.split_yaw(world[:, 0])[1]
    across = positions[:, body.hips[0]] - positions[:, body.hips[1]]
    return quat.multiply(quat.from_yaw(np.arctan2(across[:, 2], across[:, 0])), world[:, 0])


def _clip_features(
    clip: Clip, body: _Body, rest: tuple[np.ndarray, np.ndarray], pose: str, scales: Scales
) -> np.ndarray:
    positions, world = forward_kinematics(clip)
    yaw, tilt = quat.split_yaw(quat.multiply(world[:, 0], quat.conjugate(rest[1])))
    yaw = np.unwrap(yaw)
    if pose == "angles":
        posture = np.degrees(_rotation_vectors(_relative(world, body), rest[0])) / scales.angle
    else:
        offsets = positions[:, list(body.joints)] - positions[:, :1]
        size = _STANDARD_HEIGHT / body.height / scales.position
        posture = quat.rotate(quat.from_yaw(-yaw)[:, None], offsets) * size
    root = np.asarray(clip.root_positions, np.float64)
    travel = _speed(root[:, [0, 2]], clip.fps)
    columns = [
        posture.reshape(clip.n_frames, -1),
        root[:, 1:2] / scales.height,
        np.degrees(_rotation_vectors(tilt[:, None], None)[:, 0, [0, 2]]) / scales.tilt,
        np.linalg.norm(travel, axis=1, keepdims=True) / scales.speed,
        np.clip(np.degrees(_speed(yaw[:, None], clip.fps)), -_MAX_YAW, _MAX_YAW) / scales.yaw_speed,
    ]
    return np.concatenate(columns, axis=1).astype(np.float32)


def _rotation_vectors(q: np.ndarray, mean: np.ndarray | None) -> np.ndarray:
    """Rotation vectors ``(n, n_joints, 3)``, radians, about ``mean``, continuous in time.

    Each joint's track stays on one side of the double cover, the one that is nearer to the mean most of the time.
    """
    if mean is not None:
        q = quat.multiply(quat.conjugate(mean), q)
    q = quat.continuous(q)
    q = np.where(q[..., 0].sum(0)[:, None] < 0, -q, q)
    length = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(length, q[..., :1])
    return q[..., 1:] * np.where(length > 1e-8, angle / np.maximum(length, 1e-8), 2.0)


def _speed(track: np.ndarray, fps: float) -> np.ndarray:
    """Change per 1/30 s of ``(n, d)``: central difference over about 1/30 s either side, one-sided at the ends."""
    half = max(1, round(fps / SPEED_FPS))
    at = np.arange(len(track))
    before, after = np.maximum(at - half, 0), np.minimum(at + half, len(track) - 1)
    seconds = np.maximum(after - before, 1) / fps
    speed: np.ndarray = (track[after] - track[before]) / (seconds * SPEED_FPS)[:, None]
    return speed


def _names(joints: tuple[str, ...], pose: str) -> tuple[str, ...]:
    kind = "rotation" if pose == "angles" else "position"
    posture = [f"{joint} {kind} {axis}" for joint in joints for axis in "xyz"]
    return (*posture, "root height", "pitch", "roll", "horizontal speed", "yaw speed")
