"""Blend spaces: any mixture of the motions of one motif is a motion (MMG sections 4 and 5.4, in our own reading).

The paper blends between two motions of a motif and says that its motions support weighted blending; how is left open.
Ours: every motion runs along the motif's common time (its warps, smoothed so that no motion stops and starts), is
turned at each moment to face as the reference does, and is mixed there: rotations averaged on the sphere; steps of the
path, turning and durations by weighted sums. So a weight of 1 gives a motion back, and a mixture of a left and a right
turn walks straight, at full speed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.ndimage import gaussian_filter1d

from core.arrays import Float64Array
from core.compiled import njit
from core.editing.blending import blend, ground_fit, turn_about_y
from core.editing.contacts import floor_height, foot_contacts
from core.editing.legs import lift_from_floor, lock_feet, smooth_step
from core.errors import ParameterError
from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.mocap.skeleton import Skeleton
from core.motifs.graph import Motif

_SMOOTH = 0.12  # seconds over which time warps and turns are smoothed
_STEADY = 0.15  # share of even time in every warp: no motion ever stands still against the others
_PURE = 0.05  # a blend this near one motion is cleaned up less and less: a motion itself is left alone
_COMPARED = 12  # moments at which motions are compared


@dataclass(frozen=True, eq=False)
class Track:
    """One motion of a motif, ready to be mixed.

    clip: the motion alone, its root turned by -yaw. ticks: ``(n_ticks,)`` its frame at each tick of the motif's common
    time, rising from 0 to its last. yaw: ``(n_frames,)`` radians about Y by which it was turned away from the
    reference. path: ``(n_frames, 3)`` metres, the root's steps seen from the reference's side, summed up; height as it
    is. contacts: ``(n_frames, 2)`` bool, left right. floor, lowest: metres; lowest: how far a joint is below the floor.
    """

    clip: Clip
    ticks: np.ndarray
    yaw: np.ndarray
    path: np.ndarray
    contacts: np.ndarray
    floor: float
    lowest: float

    @property
    def seconds(self) -> np.ndarray:
        """The moment of the motion at each tick, ``(n_ticks,)`` seconds from its start."""
        return self.ticks / self.clip.fps


@dataclass(frozen=True, eq=False)
class BlendSpace:
    """Motions of one motif and one skeleton that can be mixed; made by :func:`blend_space`.

    tracks: by the motion's index in the motif; reference: index of the motion the others are laid upon; start ``(3,)``:
    metres, where it begins on the ground.
    """

    motif: Motif
    skeleton: Skeleton
    tracks: Mapping[int, Track]
    reference: int
    start: np.ndarray

    @property
    def motions(self) -> tuple[int, ...]:
        """Indices of the motions that can be mixed with one another, ascending."""
        return tuple(self.tracks)

    def most_different(self, n: int = 8) -> tuple[int, ...]:
        """Up to ``n`` motions that differ most from one another, the reference first: each next one is the farthest
        from all before it, by joint positions (root mean square) at equal moments."""
        postures, motions = self._postures, self.motions
        chosen = [motions.index(self.reference)]
        distance = np.full(len(motions), np.inf)
        while len(chosen) < min(n, len(motions)):
            distance = np.minimum(distance, ((postures - postures[chosen[-1]]) ** 2).mean(1))
            distance[chosen] = -1
            chosen.append(int(distance.argmax()))
        return tuple(motions[k] for k in chosen)

    @cached_property
    def _postures(self) -> np.ndarray:
        """Joint positions about the root at some moments, ``(n_motions, ...)``, metres."""
        rows = []
        for track in self.tracks.values():
            at = np.linspace(0, len(track.ticks) - 1, _COMPARED).round().astype(int)
            frames = track.ticks[at].round().astype(int)
            clip, root = track.clip, np.zeros((len(frames), 3), np.float32)
            root[:, 1] = clip.root_positions[frames, 1] - track.floor
            still = Clip(clip.name, clip.skeleton, clip.fps, root, clip.rotations[frames])
            rows.append(joint_positions(still).ravel())
        return np.stack(rows)

    def blend(self, weights: Mapping[int, float], clean: bool = True) -> Clip:
        """The mixture of motions by ``weights`` (motion -> share, scaled to sum 1), beginning where the reference does.

        Frame rate: the highest among those mixed; duration: the weighted mean. clean: standing feet stay where they
        stand (by vote of the motions mixed); less and less where one motion has nearly all the weight, so that all the
        weight on one motion gives that motion, turned and shifted on the ground only.
        Raises ValueError for a motion that is not in this space, a negative weight, or no weight at all.
        """
        tracks, w = self._chosen(weights)
        fps = max(track.clip.fps for track in tracks)
        seconds = np.einsum("k,kt->t", w, np.stack([track.seconds for track in tracks]))
        n = round(float(seconds[-1]) * fps) + 1
        ticks = np.interp(np.linspace(0, seconds[-1], n), seconds, np.arange(len(seconds)))
        frames = np.stack([np.interp(ticks, np.arange(len(track.ticks)), track.ticks) for track in tracks])
        turned = np.stack([_turned(track.clip.rotations, f) for track, f in zip(tracks, frames, strict=True)])
        yaw = _mixed(w, [track.yaw for track in tracks], frames)
        rotations = mean_rotations(w, turned)
        rotations[:, 0] = quat.multiply(quat.from_yaw(yaw), rotations[:, 0])
        root = self._path(_mixed(w, [track.path for track in tracks], frames), yaw)
        clip = Clip("blend", self.skeleton, fps, root.astype(np.float32), rotations.astype(np.float32))
        clip = replace(clip, translations=_translations(w, tracks, frames))
        rest = smooth_step((1 - w.max()) / _PURE)
        if not clean or rest == 0:
            return clip
        cleaned = _clean(clip, w, tracks, frames)
        if rest < 1:
            cleaned = blend(clip, cleaned, np.full(n, rest))
        return replace(cleaned, translations=clip.translations)

    def _chosen(self, weights: Mapping[int, float]) -> tuple[list[Track], np.ndarray]:
        for motion, weight in weights.items():
            if motion not in self.tracks:
                raise ParameterError(f"motion {motion + 1} of motif {self.motif.id} cannot be mixed with these motions")
            if not 0 <= weight < np.inf:
                raise ParameterError(f"the weight of motion {motion + 1} must be 0 or more, not {weight}")
        used = {motion: weight for motion, weight in sorted(weights.items()) if weight > 0}
        if not used:
            raise ParameterError("at least one motion needs a weight above 0")
        w = np.array(list(used.values()), np.float64)
        return [self.tracks[motion] for motion in used], w / w.sum()

    def _path(self, path: np.ndarray, yaw: np.ndarray) -> np.ndarray:
        """Steps seen from the reference's side, ``(n, 3)``, turned back by ``yaw`` ``(n,)`` and summed up."""
        steps = turn_about_y((yaw[1:] + yaw[:-1]) / 2, np.diff(path, axis=0))
        ground = np.concatenate([[self.start], self.start + np.cumsum(steps, axis=0)])
        whole: np.ndarray = ground * [1, 0, 1] + path * [0, 1, 0]
        return whole


def blendable(dataset: Dataset, motif: Motif) -> tuple[tuple[int, ...], ...]:
    """Motions of a motif in groups of one skeleton, largest first (of equals the one with the medoid): only motions of
    one skeleton can be mixed."""
    groups: dict[Skeleton, list[int]] = {}
    for motion, segment in enumerate(motif.segments):
        groups.setdefault(dataset.clip(segment.clip).skeleton, []).append(motion)
    return tuple(sorted(map(tuple, groups.values()), key=lambda g: (-len(g), motif.medoid not in g, g)))


def blend_space(dataset: Dataset, motif: Motif, motion: int | None = None) -> BlendSpace:
    """The motions of a motif that can be mixed: the largest group of one skeleton, or the group of ``motion``.

    Raises ParameterError where the motif has no such motion, KeyError where a clip is missing.
    """
    group = next((g for g in blendable(dataset, motif) if motion is None or motion in g), None)
    if group is None:
        raise ParameterError(f"motif {motif.id} has {motif.n_motions} motions, no motion {motion}")
    segments = {k: motif.segments[k] for k in group}
    clips = {k: dataset.clip(s.clip).cut(s.start, s.end) for k, s in segments.items()}
    floors = {name: floor_height(dataset.clip(name)) for name in {s.clip for s in segments.values()}}
    rate = dataset.clip(motif.segments[motif.medoid].clip).fps  # the warps have a value for each frame of the medoid
    ticks = {k: steady_warp(motif.warps[k], clip.n_frames, rate) for k, clip in clips.items()}
    reference = motif.medoid if motif.medoid in group else group[0]
    standard = clips[reference]
    points = _at(joint_positions(standard)[:, _posture(standard)], ticks[reference])
    turned = _turned(quat.continuous(np.asarray(standard.rotations)), ticks[reference])
    tracks = {k: _track(c, ticks[k], (points, turned), rate, floors[segments[k].clip]) for k, c in clips.items()}
    start = standard.root_positions[0] * np.array([1.0, 0, 1])
    return BlendSpace(motif, standard.skeleton, tracks, reference, start)


def steady_warp(warp: np.ndarray, n_frames: int, fps: float) -> np.ndarray:
    """A time warp ``(n_ticks,)`` made smooth and strictly rising, from frame 0 to frame ``n_frames - 1``; two ticks at
    least.

    Dynamic time warping gives stairs; played as they are, one motion would stop and start against another.
    fps: ticks per second.
    """
    n = len(warp)
    if n < 2:
        return np.array([0.0, n_frames - 1])
    even = np.linspace(0, n_frames - 1, n)
    off = np.asarray(warp, np.float64) - even
    off[[0, -1]] = 0
    reach = round(4 * _SMOOTH * fps)
    wide = np.pad(off, reach, mode="reflect", reflect_type="odd")  # so that the ends stay where they are
    off = gaussian_filter1d(wide, _SMOOTH * fps)[reach : reach + n]
    off[[0, -1]] = 0
    return even + (1 - _STEADY) * off


def mean_rotations(weights: np.ndarray, rotations: np.ndarray) -> np.ndarray:
    """Weighted mean on the sphere of k arrays of rotations: ``(..., 4)``.

    weights: ``(k,)``, of sum 1; rotations: ``(k, ..., 4)`` unit quaternions whose signs are chosen already: along the
    way a motion takes in time, not frame by frame, so that the mean moves on where motions come to face opposite ways.
    Minimises the weighted sum of squared arcs (Buss and Fillmore, "Spherical averages", 2001); of two: the slerp.
    """
    q = np.ascontiguousarray(rotations, np.float64)
    means = _mean_rotations(np.asarray(weights, np.float64), q.reshape(len(q), -1, 4))
    return means.reshape(q.shape[1:])


@njit()
def _mean_rotations(weights: Float64Array, rotations: Float64Array) -> Float64Array:
    heaviest, n = weights.argmax(), rotations.shape[1]
    means, step = np.empty((n, 4)), np.empty(4)
    for r in range(n):
        for c in range(4):
            step[c] = 0.0
            for i in range(len(weights)):
                step[c] += weights[i] * rotations[i, r, c]
        length = np.sqrt(step[0] ** 2 + step[1] ** 2 + step[2] ** 2 + step[3] ** 2)
        for c in range(4):
            means[r, c] = step[c] / length if length > 1e-3 else rotations[heaviest, r, c]
        for _ in range(20):  # from the chord's mean to the arc's: a step or two where rotations are alike
            if _move_to_mean(weights, rotations, r, means, step) < 1e-7:
                break
    return means


@njit()
def _move_to_mean(
    weights: Float64Array, rotations: Float64Array, r: int, means: Float64Array, step: Float64Array
) -> float:
    """Along the mean of the arcs to all rotations; how far, in radians of the unit sphere."""
    for c in range(4):
        step[c] = 0.0
    for i in range(len(weights)):
        dot = 0.0
        for c in range(4):
            dot += rotations[i, r, c] * means[r, c]
        angle = np.arccos(min(max(dot, -1.0), 1.0))
        sine = np.sin(angle)
        stretch = weights[i] * (angle / sine if sine > 1e-6 else 1.0)
        for c in range(4):
            step[c] += stretch * (rotations[i, r, c] - dot * means[r, c])
    length: float = np.sqrt(step[0] ** 2 + step[1] ** 2 + step[2] ** 2 + step[3] ** 2)
    if length > 1e-12:
        for c in range(4):
            means[r, c] = np.cos(length) * means[r, c] + np.sin(length) / length * step[c]
    return length


def _turned(rotations: np.ndarray, frames: np.ndarray) -> np.ndarray:
    """Rotations ``(n_frames, n_joints, 4)`` at fractional frames ``(n,)``: neighbours are near, so a chord is as good
    as an arc."""
    return quat.normalise(_at(rotations, frames.astype(np.float32)))


def _track(clip: Clip, ticks: np.ndarray, beside: tuple[np.ndarray, np.ndarray], rate: float, floor: float) -> Track:
    """One motion, turned at each moment as the reference faces. beside: the reference's points and rotations at the
    ticks, ``(n_ticks, n_points, 3)`` and ``(n_ticks, n_joints, 4)``; rate: ticks per second."""
    positions = joint_positions(clip)
    away = -np.unwrap(ground_fit(beside[0], _at(positions[:, _posture(clip)], ticks))[0])
    away = gaussian_filter1d(away, _SMOOTH * rate, mode="nearest")
    yaw = np.interp(np.arange(clip.n_frames), ticks, away)
    rotations = np.array(clip.rotations, np.float32)
    rotations[:, 0] = quat.multiply(quat.from_yaw(-yaw), rotations[:, 0])
    rotations = quat.continuous(rotations)
    alike = (_turned(rotations, ticks) * beside[1]).sum((0, 2))
    rotations *= np.where(alike < 0, -1, 1).astype(np.float32)[:, None]
    root = np.asarray(clip.root_positions, np.float64)
    steps = turn_about_y(-(yaw[1:] + yaw[:-1]) / 2, np.diff(root, axis=0))
    path = np.concatenate([np.zeros((1, 3)), np.cumsum(steps, axis=0)])
    path[:, 1] = root[:, 1]
    contacts = foot_contacts(clip, floor, positions)
    lowest = min(0.0, float(positions[..., 1].min()) - floor)
    # what is left of the turn: the motion as a whole is laid upon the reference
    return Track(replace(clip, rotations=rotations), ticks, yaw - away.mean(), path, contacts, floor, lowest)


def _clean(clip: Clip, weights: np.ndarray, tracks: Sequence[Track], frames: np.ndarray) -> Clip:
    """Standing feet held where they stand; no joint deeper below the floor than in the motions themselves."""
    contacts = _mixed(weights, [track.contacts.astype(np.float64) for track in tracks], frames) >= 0.5
    floor = float(weights @ [track.floor for track in tracks])
    lowest = float(weights @ [track.lowest for track in tracks])
    return lift_from_floor(lock_feet(clip, contacts, floor), floor + lowest)


def _mixed(weights: np.ndarray, values: Sequence[np.ndarray], frames: np.ndarray) -> np.ndarray:
    """Weighted sum of ``(n_frames, ...)`` arrays, each read at its own fractional ``frames`` ``(k, n)``."""
    total: np.ndarray = sum(w * _at(v, f) for w, v, f in zip(weights, values, frames, strict=True))
    return total


def _translations(weights: np.ndarray, tracks: Sequence[Track], frames: np.ndarray) -> dict[int, np.ndarray]:
    """Tracks of joints that shift; in a motion where a joint does not, it stays at its rest offset."""
    clips = [track.clip for track in tracks]
    shifting = sorted({joint for clip in clips for joint in clip.translations})
    rest = clips[0].skeleton.offsets
    values = {j: [c.translations.get(j, np.tile(rest[j], (c.n_frames, 1))) for c in clips] for j in shifting}
    return {joint: _mixed(weights, values[joint], frames).astype(np.float32) for joint in shifting}


def _at(values: np.ndarray, frames: np.ndarray) -> np.ndarray:
    """``(n_frames, ...)`` read at fractional frames ``(n,)``, linear."""
    low = np.clip(np.floor(frames).astype(int), 0, len(values) - 1)
    part = (frames - low).reshape(-1, *[1] * (np.ndim(values) - 1))
    read: np.ndarray = values[low] * (1 - part) + values[np.minimum(low + 1, len(values) - 1)] * part
    return read


def _posture(clip: Clip) -> list[int]:
    return [0, *find_anatomy(clip.skeleton).posture_joints]
