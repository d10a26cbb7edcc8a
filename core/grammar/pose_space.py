"""Poses in a space whose squared distance is the pose distance of Lee et al. (SIGGRAPH 2002; SYN section 4.1).

Lee et al. add the squared differences of the joints, each with its weight, and, with a weight of their own, those of
their velocities; place on the ground and heading count for nothing when motion is to be rearranged. Ours: d(x, y) =
mean over joints of |posture difference|^2 + (height difference)^2 + tilt, plus the same for velocities. Postures are
``angles`` (rotation vectors of the joints) or ``positions`` (where the joints are, seen from the pelvis, facing
one way, on a body of one size: an angle then counts by how far it moves what hangs on it).
With mirroring a motion and its mirror image are the same: the distance is the smaller one.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.ndimage import uniform_filter1d

from core.editing.mirror import mirror
from core.errors import AnalysisError
from core.grammar.cuts import pose_distances
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.mocap.kinematics import resample
from core.poses.body_frames import body_frames
from core.poses.features import SPEED_FPS, Poses, Scales, pose_features, principal_directions
from core.progress import Report, silent

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
    sampled = []
    for k, clip in enumerate(clips):
        report("reading recordings", k / len(clips))
        sampled.append(resample(clip, analysis_fps))
    images = _images(sampled, report) if mirrored else None
    bodies = _numbered(sampled, images or [])
    poses = pose_features(bodies, analysis_fps=analysis_fps, pose=pose, variance=1.0, scales=_UNITS, report=report)
    values = _weighted(poses, velocity)
    mean, basis, _ = principal_directions(values, _KEPT)
    values = np.ascontiguousarray((values - mean.astype(np.float32)) @ basis.astype(np.float32))
    n = int(poses.clip_starts[len(clips)])
    own = values[:n]
    return PoseSpace(
        values=own,
        mirrored=values[n:] if images else None,
        clip_starts=poses.clip_starts[: len(clips) + 1],
        clips=tuple(clip.name for clip in clips),
        clip_fps=tuple(float(clip.fps) for clip in clips),
        clip_frames=tuple(clip.n_frames for clip in clips),
        fps=float(analysis_fps),
        largest=_largest(own, seed),
    )


def _images(clips: list[Clip], report: Report) -> list[Clip] | None:
    """The clips seen in a mirror; None where a body cannot be mirrored."""
    frames = {}
    for clip in clips:
        if clip.skeleton not in frames:
            frames[clip.skeleton] = body_frames([c for c in clips if c.skeleton == clip.skeleton])
    try:
        images = []
        for k, clip in enumerate(clips):
            report("mirroring recordings", k / len(clips))
            images.append(mirror(clip, frames=frames[clip.skeleton]))
        return images
    except AnalysisError:
        return None


def _numbered(clips: list[Clip], images: list[Clip]) -> Dataset:
    """Clips, then their images, under names that keep this order."""
    everything = [*clips, *images]
    named = tuple(replace(clip, name=f"{k:08d}") for k, clip in enumerate(everything))
    return Dataset("poses", named, digests=tuple(clip.name for clip in named))


def _weighted(poses: Poses, velocity: float) -> np.ndarray:
    """Raw features times their weights, and the velocities of postures, height and tilt beside them: ``(n, f)``."""
    raw = poses.values @ poses.basis.T.astype(np.float32) + poses.mean.astype(np.float32)
    joints = sum(name not in _WEIGHTS for name in poses.names) / 3
    raw *= np.array([_WEIGHTS.get(name, joints**-0.5) for name in poses.names], np.float32)
    if any(name.endswith("position x") for name in poses.names):
        raw[:, [name in ("pitch", "roll") for name in poses.names]] = 0  # joints seen from the pelvis turn with it
    still = [k for k, name in enumerate(poses.names) if name not in _WEIGHTS or name == "root height"]
    speeds = [k for k, name in enumerate(poses.names) if "speed" in name]
    moving = np.empty((len(raw), len(still)), np.float32)
    half = max(1, round(_AROUND * poses.fps))
    for start, end in pairwise(poses.clip_starts):
        moving[start:end] = velocity * _velocities(raw[start:end, still], poses.fps, half)
        raw[start:end, speeds] = uniform_filter1d(raw[start:end, speeds], 2 * half + 1, axis=0, mode="nearest")
    return np.concatenate([raw, moving], axis=1)


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
