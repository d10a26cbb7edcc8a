"""Pieces of recordings stitched into one motion: for walks of the motif graph, derivations of a grammar, and the like.

Pieces pass into one another along registered frames (a whole motif, MMG section 4) or in a short cross-fade. Each is
laid on the ground where the one before left off, rotations are blended along great arcs with smooth weights, and feet
are kept where they stand.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from core.editing.blending import at_frames, blend, joint_weights
from core.editing.contacts import slide
from core.editing.following import Placements, lay_once, lay_upon, travel
from core.errors import AnalysisError
from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.progress import Report, silent
from core.synthesis import footing
from core.synthesis.bodies import commonest_body, fit_to_body, grounded, same_joints
from core.synthesis.footing import Skate, Step
from core.synthesis.timeline import Overlap, Timeline, crossfade, schedule


class Speeds(NamedTuple):
    """Metres a second of the fastest joint: in the blends (0 where there are none), and in the recordings used."""

    seams: float
    sources: float

    @property
    def jump(self) -> bool:
        """Whether a blend is faster than anything in the recordings, but for rounding."""
        return self.seams > 1.01 * self.sources


FADE = 0.4  # seconds of a cross-fade where nothing else is said


@dataclass(frozen=True, eq=False)
class Stitched:
    """A made-up motion and where it comes from.

    clip: the motion, floor at height 0, beginning above the origin. pieces: the segments it is made of, in order.
    timeline: for every frame its one or two source frames. contacts: ``(n_frames, 2)`` bool, which foot stands, left
    then right. skate: the foot-skate meter. speeds: of the fastest joint. warnings: what a person should know, in plain
    words.
    """

    clip: Clip
    pieces: tuple[Segment, ...]
    timeline: Timeline
    contacts: np.ndarray
    skate: Skate
    speeds: Speeds
    warnings: tuple[str, ...] = ()


def stitch(
    dataset: Dataset,
    pieces: Sequence[Segment],
    overlaps: Sequence[Overlap | None] | None = None,
    *,
    fps: float | None = None,
    keep_feet: bool = True,
    name: str = "stitched",
    report: Report = silent,
) -> Stitched:
    """One motion out of segments of a data set, played one after another.

    overlaps: how neighbours pass into one another, or None for a cross-fade around the end of the one and the start of
    the other (none where the second goes on in the same clip at the same frame). fps: that of the first clip where
    None. keep_feet: False for plain blending.
    Clips of several bodies with the same joints are fitted to the one that most frames belong to.
    Raises ValueError for no pieces, frames outside their clips, joints that differ, or blends that do not fit; KeyError
    for a clip that is not there.
    """
    if not pieces:
        raise ValueError("nothing to stitch: no pieces were given")
    for piece in pieces:
        dataset.clip(piece.clip).cut(piece.start, piece.end)  # raises where it is not there
    overlaps = [
        found if given is None else given
        for given, found in zip(overlaps or [None] * (len(pieces) - 1), overlaps_between(dataset, pieces), strict=True)
    ]
    report("stitching", 0.0)
    sources, warnings = _sources(dataset, pieces)
    rates = [sources[piece.clip].fps for piece in pieces]
    fps = rates[0] if fps is None else float(fps)
    timeline = schedule(pieces, rates, overlaps, fps)
    contacts = footing.standing_feet(sources, pieces, timeline)
    plain, steps = _assemble(sources, pieces, overlaps, timeline, contacts, fps, name)
    report("feet", 0.6)
    slid = _rate(plain, contacts)
    clip = plain
    if keep_feet:
        body = find_anatomy(plain.skeleton).body_height
        contacts, lifts = footing.take_steps(contacts, steps, body)
        clip, held = footing.keep_feet(plain, contacts, lifts)
    skate = Skate(footing.source_skate(sources, pieces), slid, _rate(clip, contacts) if keep_feet else slid)
    contacts = held if keep_feet else contacts
    speeds = Speeds(seam_speed(clip, timeline.seams), _fastest(sources, pieces))
    if speeds.jump:
        warnings += (f"A blend is faster than the recordings: {speeds.seams:.1f} against {speeds.sources:.1f} m/s.",)
    report("feet", 1.0)
    return Stitched(clip, tuple(pieces), timeline, contacts, skate, speeds, warnings)


def overlaps_between(dataset: Dataset, pieces: Sequence[Segment], seconds: float = FADE) -> list[Overlap | None]:
    """Cross-fades of about ``seconds`` where pieces meet; None where one goes on in the next.

    A cross-fade takes in the frames that follow a piece in its clip and those before the next one, and at most half of
    either piece.
    """
    overlaps: list[Overlap | None] = []
    for a, b in pairwise(pieces):
        if a.clip == b.clip and a.end == b.start:
            overlaps.append(None)
            continue
        first, second = dataset.clip(a.clip), dataset.clip(b.clip)
        most = min(seconds, a.n_frames / first.fps / 2, b.n_frames / second.fps / 2)
        overlaps.append(Overlap(crossfade(first, a.end - 1, second, b.start, most), along=False))
    return overlaps


def joint_speeds(clip: Clip) -> np.ndarray:
    """Metres a second of every joint from each frame to the next: ``(n_frames - 1, n_joints)``."""
    speeds: np.ndarray = np.linalg.norm(np.diff(joint_positions(clip), axis=0), axis=-1) * clip.fps
    return speeds


def seam_speed(clip: Clip, seams: np.ndarray | Sequence[tuple[int, int]]) -> float:
    """Metres a second of the fastest joint in the blends, the steps into and out of them included; seams ``(n, 2)``."""
    fastest = joint_speeds(clip).max(1, initial=0.0)
    return max((float(fastest[max(0, a - 1) : b].max(initial=0.0)) for a, b in seams), default=0.0)


def _fastest(sources: Mapping[str, Clip], pieces: Sequence[Segment]) -> float:
    cuts = (sources[piece.clip].cut(piece.start, piece.end) for piece in pieces)
    return max(float(joint_speeds(cut).max(initial=0.0)) for cut in cuts)


def _sources(dataset: Dataset, pieces: Sequence[Segment]) -> tuple[dict[str, Clip], tuple[str, ...]]:
    """The clips by name, on floors at height 0, as one body would move."""
    clips = {piece.clip: dataset.clip(piece.clip) for piece in pieces}
    body = commonest_body([clips[p.clip] for p in pieces], [p.n_frames / clips[p.clip].fps for p in pieces])
    for name, clip in clips.items():
        if not same_joints(clip.skeleton, body):
            other = next(n for n, c in clips.items() if c.skeleton == body)
            raise AnalysisError(
                f"“{name}” and “{other}” have skeletons with different joints, and one motion needs one skeleton. "
                "Choose motions recorded with the same skeleton."
            )
    bodies = len({clip.skeleton for clip in clips.values()})
    fitted = f"Motions of {bodies} bodies of different size were fitted to one of them."
    return {n: fit_to_body(grounded(clip), body) for n, clip in clips.items()}, (fitted,) if bodies > 1 else ()


def _assemble(
    sources: Mapping[str, Clip],
    pieces: Sequence[Segment],
    overlaps: Sequence[Overlap | None],
    timeline: Timeline,
    contacts: np.ndarray,
    fps: float,
    name: str,
) -> tuple[Clip, list[Step]]:
    """The motion by blending alone, and the steps its feet need besides."""
    body = next(iter(sources.values())).skeleton
    weights, height = joint_weights(body), find_anatomy(body).body_height
    done: list[Clip] = []
    steps: list[Step] = []
    place: Placements | None = None  # of what comes next
    ends = [0, *timeline.seams.ravel().tolist(), len(timeline.weights)]
    # between the seams a piece may go on in the next one; runs of equal pairs are handled one by one
    changes = np.flatnonzero(np.diff(timeline.pieces, axis=0).any(1)) + 1
    for start, end in pairwise(sorted({*ends, *changes.tolist()})):
        leaving, entering = timeline.pieces[start]
        a = at_frames(sources[pieces[leaving].clip], timeline.frames[start:end, 0])
        if place is None:
            place = _at_origin(a)
        if leaving == entering:
            done.append(placed(a, place))
            continue
        b = at_frames(sources[pieces[entering].clip], timeline.frames[start:end, 1])
        share = timeline.weights[start:end]
        at_a, at_b = joint_positions(a), joint_positions(b)
        overlap = overlaps[leaving]
        assert overlap is not None  # only pieces that overlap stand beside one another
        fits = lay_upon(at_a, at_b, weights, fps) if overlap.along else lay_once(a, b, at_a, at_b, weights)
        way = travel(fits, place, a.root_positions, share)
        b = placed(b, fits)
        steps += footing.find_steps(
            contacts, (start, end), footing.ankles_apart(at_a, joint_positions(b), a), height, fps
        )
        done.append(placed(blend(a, b, share), way))
        place = way.last.after(fits.last)
    rotations = quat.continuous(np.concatenate([clip.rotations for clip in done]))
    root = np.concatenate([clip.root_positions for clip in done])
    return Clip(name, body, fps, root, rotations), steps


def placed(clip: Clip, at: Placements) -> Clip:
    """The clip with every frame turned and shifted as ``at`` says: one placement a frame, or one for all."""
    rotations = np.array(clip.rotations, np.float32)
    rotations[:, 0] = quat.multiply(quat.from_yaw(at.yaw), rotations[:, 0])
    return replace(clip, root_positions=at.of(clip.root_positions).astype(np.float32), rotations=rotations)


def _at_origin(clip: Clip) -> Placements:
    return Placements(np.zeros(1), -clip.root_positions[:1] * np.array([1.0, 0, 1]))


def _rate(clip: Clip, contacts: np.ndarray) -> float:
    metres, seconds = slide(clip, contacts, 0.0)
    return metres / seconds if seconds else 0.0
