"""Poses in a space whose squared distance is the pose distance of Lee et al. (SIGGRAPH 2002; SYN section 4.1).

Lee et al. add the squared differences of the joints, each with its weight, and, with a weight of their own, those of
their velocities; place on the ground and heading count for nothing when motion is to be rearranged. Ours: d(x, y) =
mean over joints of |posture difference|^2 + (height difference)^2 + tilt, plus the same for velocities. Postures are
``angles`` (rotation vectors of the joints) or ``positions`` (where the joints are, seen from the pelvis, facing
one way, on a body of one size: an angle then counts by how far it moves what hangs on it).
With mirroring a motion and its mirror image are the same: the distance is the smaller one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise

import numpy as np
from scipy.ndimage import uniform_filter1d

from core.editing.mirror import mirror, partners
from core.errors import AnalysisError
from core.grammar.cuts import pose_distances
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.mocap.kinematics import resample
from core.mocap.skeleton import Skeleton
from core.poses.body_frames import BodyFrames, body_frames
from core.poses.features import (
    SPEED_FPS,
    RawFeatures,
    Scales,
    principal_directions,
    projected,
    raw_features,
)
from core.poses.rows import Rows
from core.progress import Progress, Report, part_of, silent

_AROUND = 1 / 6  # seconds either side over which velocities are taken: a step is one movement, its tremor none
_KEPT = 0.99  # share of the variance that the axes of the space keep
_SAMPLED = 3000  # poses among which the largest distance is looked for
_RADIAN = 180 / np.pi
# what a unit of each kind counts, beside a metre by which all joints are off (positions) or a radian (angles)
_WEIGHTS = {"root height": 1.0, "pitch": 0.5, "roll": 0.5, "horizontal speed": 0.3, "yaw speed": 0.1}
_UNITS = Scales(  # metres, radians, and both per second
    height=1.0, speed=1 / SPEED_FPS, position=1.0, angle=_RADIAN, tilt=_RADIAN, yaw_speed=_RADIAN / SPEED_FPS
)


@dataclass(frozen=True, eq=False)
class PoseSpace:
    """Poses of all clips, by the order of their names, one after the other.

    values: ``(n, d)`` float32; mirrored: ``(n, d)`` the same bodies seen in a mirror, or None; clip_starts:
    ``(n_clips + 1,)``; clips, clip_fps, clip_frames: names, rates and numbers of frames; fps: rate of ``values``;
    largest: d_max, the largest pose distance in a seeded sample.
    """

    values: np.ndarray
    mirrored: np.ndarray | None
    clip_starts: np.ndarray
    clips: tuple[str, ...]
    clip_fps: tuple[float, ...]
    clip_frames: tuple[int, ...]
    fps: float
    largest: float

    @property
    def n(self) -> int:
        """Number of poses, the paper's T."""
        return len(self.values)

    @property
    def versions(self) -> tuple[np.ndarray, ...]:
        """The poses, and the mirrored ones where mirror images count as the same."""
        return (self.values,) if self.mirrored is None else (self.values, self.mirrored)

    def thinned(self, step: int) -> PoseSpace:
        """Every ``step``-th pose of each clip."""
        kept = np.concatenate([np.arange(start, end, step) for start, end in pairwise(self.clip_starts)])
        counts = -(-np.diff(self.clip_starts) // step)
        return replace(
            self,
            values=np.ascontiguousarray(self.values[kept]),
            mirrored=None if self.mirrored is None else np.ascontiguousarray(self.mirrored[kept]),
            clip_starts=np.concatenate([[0], np.cumsum(counts)]),
            fps=self.fps / step,
        )

    def unthinned(self, spans: np.ndarray, step: int, thin: PoseSpace) -> np.ndarray:
        """Spans ``(n, 2)`` of ``thin``, which is this space thinned by ``step``, as spans of this space."""
        clip = np.searchsorted(thin.clip_starts, spans[:, 0], side="right") - 1
        inside = (spans - thin.clip_starts[clip][:, None]) * step
        ends = self.clip_starts[clip + 1]
        frames: np.ndarray = np.minimum(inside + self.clip_starts[clip][:, None], ends[:, None])
        return frames

    def sampled(self, most: int, piece: int, rng: np.random.Generator) -> tuple[PoseSpace, np.ndarray]:
        """About ``most`` poses, drawn as pieces of clips of at most ``piece`` poses, each a clip of its own; all where
        there are no more. Also which pose of this space each of them is, ``(n,)``.
        """
        if self.n <= most:
            return self, np.arange(self.n)
        edges = [np.linspace(a, b, -(-int(b - a) // piece) + 1).astype(np.int64) for a, b in pairwise(self.clip_starts)]
        spans = np.concatenate([np.stack([edge[:-1], edge[1:]], axis=1) for edge in edges if len(edge) > 1])
        order = rng.permutation(len(spans))
        enough = int(np.searchsorted(np.cumsum(np.diff(spans[order])[:, 0]), most)) + 1
        spans = spans[np.sort(order[:enough])]
        rows = np.concatenate([np.arange(start, end) for start, end in spans])
        clip = np.searchsorted(self.clip_starts, spans[:, 0], side="right") - 1
        part = replace(
            self,
            values=np.ascontiguousarray(self.values[rows]),
            mirrored=None if self.mirrored is None else np.ascontiguousarray(self.mirrored[rows]),
            clip_starts=np.concatenate([[0], np.cumsum(np.diff(spans)[:, 0])]),
            clips=tuple(self.clips[k] for k in clip),
            clip_fps=tuple(self.clip_fps[k] for k in clip),
            clip_frames=tuple(self.clip_frames[k] for k in clip),
        )
        return part, rows

    def segment(self, start: int, end: int) -> Segment:
        """Poses ``[start, end)``, which lie in one clip, as a segment at the clip's own rate."""
        clip = int(np.searchsorted(self.clip_starts, start, side="right")) - 1
        first, frames = int(self.clip_starts[clip]), self.clip_frames[clip]
        own = [min(round((at - first) * self.clip_fps[clip] / self.fps), frames) for at in (start, end)]
        return Segment(self.clips[clip], own[0], frames if end == self.clip_starts[clip + 1] else own[1])


def pose_space(
    dataset: Dataset,
    *,
    analysis_fps: float = 30,
    pose: str = "positions",
    velocity: float = 0.25,
    mirrored: bool = True,
    seed: int = 0,
    report: Report = silent,
) -> PoseSpace:
    """The pose space of a data set.

    pose: "positions" or "angles"; velocity: seconds by which a speed counts as a difference of posture; mirrored:
    whether mirror images are the same (never on bodies whose joints have no partners on the other side). Raises
    AnalysisError as :func:`core.poses.features.pose_features` does.
    """
    clips = sorted(dataset.clips, key=lambda clip: clip.name)
    if not clips:
        raise AnalysisError("the dataset has no clips, so there are no poses")
    frames = _frames_to_mirror(clips) if mirrored else None
    rows = Rows()  # of every clip, and after each those of its mirror image
    weighting = _weighting(clips, frames, analysis_fps, pose, velocity, partial(report, "reading recordings"))
    counts = []
    for k, clip in enumerate(clips):
        sampled = resample(clip, analysis_fps)
        counts.append(sampled.n_frames)
        rows.add(weighting.of(sampled))
        if frames is not None:
            rows.add(weighting.of(_image(frames, sampled)))
        report("poses", 0.9 * (k + 1) / len(clips))
    heard, starts = partial(report, "poses"), np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    own, *images = _projected(rows.array(), starts, 1 if frames is None else 2, part_of(heard, 0.9, 1.0))
    return PoseSpace(
        values=own,
        mirrored=images[0] if images else None,
        clip_starts=starts,
        clips=tuple(clip.name for clip in clips),
        clip_fps=tuple(float(clip.fps) for clip in clips),
        clip_frames=tuple(clip.n_frames for clip in clips),
        fps=float(analysis_fps),
        largest=_largest(own, seed),
    )


def _frames_to_mirror(clips: Sequence[Clip]) -> dict[Skeleton, BodyFrames] | None:
    """The anatomical frames of each skeleton; None where a body cannot be mirrored."""
    clips_of: dict[Skeleton, list[Clip]] = {}
    for clip in clips:
        clips_of.setdefault(clip.skeleton, []).append(clip)
    frames = {skeleton: body_frames(group) for skeleton, group in clips_of.items()}
    try:
        for skeleton in frames:
            partners(skeleton)
    except AnalysisError:
        return None
    return frames


def _image(frames: Mapping[Skeleton, BodyFrames], clip: Clip) -> Clip:
    """The clip seen in a mirror."""
    return mirror(clip, frames=frames[clip.skeleton])


@dataclass(frozen=True, eq=False)
class _Weighting:
    """Raw features times their weights ``(f,)``, and the velocities of the columns ``still`` beside them; ``speeds``:
    columns that are averaged over as long as velocities are; velocity: seconds; half: frames either side."""

    features: RawFeatures
    weights: np.ndarray
    still: list[int]
    speeds: list[int]
    velocity: float
    half: int
    fps: float

    def of(self, clip: Clip) -> np.ndarray:
        """Features of a clip at the rate of the analysis, ``(n, f)`` float32."""
        raw = self.features.of(clip) * self.weights
        moving = np.float32(self.velocity) * _velocities(raw[:, self.still], self.fps, self.half)
        raw[:, self.speeds] = uniform_filter1d(raw[:, self.speeds], 2 * self.half + 1, axis=0, mode="nearest")
        return np.concatenate([raw, moving], axis=1)


def _weighting(
    clips: Sequence[Clip],
    frames: Mapping[Skeleton, BodyFrames] | None,
    fps: float,
    pose: str,
    velocity: float,
    progress: Progress,
) -> _Weighting:
    """The weighting that clips, and where there are ``frames`` also their mirror images, share."""
    image = None if frames is None else partial(_image, frames)
    features = raw_features(clips, fps, pose, _UNITS, image=image, progress=progress)
    names = features.names
    joints = sum(name not in _WEIGHTS for name in names) / 3
    weights = np.array([_WEIGHTS.get(name, joints**-0.5) for name in names], np.float32)
    if any(name.endswith("position x") for name in names):
        weights[[name in ("pitch", "roll") for name in names]] = 0  # joints seen from the pelvis turn with it
    still = [k for k, name in enumerate(names) if name not in _WEIGHTS or name == "root height"]
    speeds = [k for k, name in enumerate(names) if "speed" in name]
    return _Weighting(features, weights, still, speeds, velocity, max(1, round(_AROUND * fps)), fps)


def _projected(rows: np.ndarray, starts: np.ndarray, images: int, progress: Progress) -> list[np.ndarray]:
    """Rows ``(images * n, f)``, for each clip one image after the other, along the axes of the space: for each image
    the poses ``(n, d)`` of all clips."""
    mean, basis, _ = principal_directions(rows, _KEPT, part_of(progress, 0.0, 0.6))
    found = [np.empty((int(starts[-1]), basis.shape[1]), np.float32) for _ in range(images)]
    for start, end in pairwise(starts.tolist()):
        for k, values in enumerate(found):
            first = images * start + k * (end - start)
            values[start:end] = projected(rows[first : first + end - start], mean, basis)
        progress(0.6 + 0.4 * end / len(found[0]))
    return found


def _velocities(track: np.ndarray, fps: float, half: int) -> np.ndarray:
    """Change of ``(n, f)`` per second: central differences over ``half`` frames either side, one-sided at the ends."""
    at = np.arange(len(track))
    before, after = np.maximum(at - half, 0), np.minimum(at + half, len(track) - 1)
    rates = (fps / np.maximum(after - before, 1))[:, None].astype(np.float32)
    speed: np.ndarray = (track[after] - track[before]) * rates
    return speed


def _largest(values: np.ndarray, seed: int) -> float:
    """d_max among a seeded sample of poses; 1 where all poses are the same."""
    rng = np.random.default_rng(seed)
    sample = values[np.sort(rng.choice(len(values), min(_SAMPLED, len(values)), replace=False))]
    return float(pose_distances(sample, sample).max()) or 1.0
