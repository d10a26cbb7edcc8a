"""Feet of a stitched motion: which one stands, where one has to step, and how much standing feet slide."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from core.editing.contacts import foot_contacts, slide
from core.editing.legs import lock_feet
from core.mocap.anatomy import SIDES, find_anatomy
from core.mocap.clip import Clip, Segment
from core.synthesis.timeline import Timeline

_RETOUCH = 0.02  # body heights that the second pass moves a foot at most: more would hurry bridges of unlike postures
_FAR = 0.03  # body heights: feet that two motions put closer than this need no step
_STEP = 0.4  # seconds a step takes
_STANDS = 0.6  # a foot that stands for a smaller share of that time has left the floor anyway
_RISE, _HIGHEST = 0.25, 0.07  # height of a step as a share of its length, and at most, in body heights


class Skate(NamedTuple):
    """Metres that standing feet slide per second of contact.

    source: in the recordings the motion is made of, as they are; plain: after blending alone; kept: in the result.
    """

    source: float
    plain: float
    kept: float


class Step(NamedTuple):
    """A foot (0 left, 1 right) that is lifted over from one stance to another during output frames [start, end)."""

    foot: int
    start: int
    end: int
    length: float  # metres


def standing_feet(sources: Mapping[str, Clip], pieces: Sequence[Segment], timeline: Timeline) -> np.ndarray:
    """Which foot stands in each output frame, ``(n, 2)`` bool: as in the source that weighs more.

    sources: the clips, with their floors at height 0.
    """
    own = {name: foot_contacts(clip, 0.0) for name, clip in sources.items()}
    share = np.zeros((len(timeline.weights), 2))
    for side, weights in enumerate((1 - timeline.weights, timeline.weights)):
        for i, piece in enumerate(pieces):
            at = np.flatnonzero(timeline.pieces[:, side] == i)
            rows = np.clip(np.round(timeline.frames[at, side]).astype(int), 0, len(own[piece.clip]) - 1)
            share[at] += weights[at, None] * own[piece.clip][rows]
    return share > 0.5


def find_steps(contacts: np.ndarray, seam: tuple[int, int], apart: np.ndarray, body: float, fps: float) -> list[Step]:
    """Steps that one blend needs: feet that stand in its middle, in places too far apart to be held in one.

    contacts: ``(n, 2)`` bool, of the whole motion; seam: its half-open frames of the blend; apart ``(k, 2)``: metres
    between the two motions' ankles on the ground, over the blend; body: height, metres. The foot with the longer way
    goes first; where both step, each takes its half of the time.
    """
    start, end = seam
    middle, length = (start + end) // 2, min(round(_STEP * fps), end - start)
    way = apart[max(0, middle - start - length // 2) :][:length].mean(0)
    stands = contacts[max(start, middle - length // 2) : middle + length - length // 2].mean(0) >= _STANDS
    feet = [f for f in range(2) if way[f] > _FAR * body and stands[f]]
    if len(feet) == 2:
        first, second = sorted(feet, key=lambda f: -way[f])
        low = max(start, middle - length)
        return [
            Step(first, low, middle, float(way[first])),
            Step(second, middle, min(end, middle + length), float(way[second])),
        ]
    return [Step(f, middle - length // 2, middle - length // 2 + length, float(way[f])) for f in feet]


def take_steps(contacts: np.ndarray, steps: Sequence[Step], body: float) -> tuple[np.ndarray, np.ndarray]:
    """Contacts without the stepping feet, ``(n, 2)`` bool, and how high feet are lifted, ``(n, 2)`` metres."""
    contacts, lifts = contacts.copy(), np.zeros(contacts.shape)
    for step in steps:
        u = (np.arange(step.start, step.end) - step.start + 1) / (step.end - step.start + 1)
        contacts[step.start : step.end, step.foot] = False
        arc = min(_RISE * step.length, _HIGHEST * body) * 16 * (u * (1 - u)) ** 2
        lifts[step.start : step.end, step.foot] = np.maximum(lifts[step.start : step.end, step.foot], arc)
    return contacts, lifts


def keep_feet(clip: Clip, contacts: np.ndarray, lifts: np.ndarray) -> tuple[Clip, np.ndarray]:
    """The clip with its feet held where they stand, and which foot is held, ``(n, 2)`` bool.

    contacts: ``(n, 2)`` bool; lifts: ``(n, 2)`` metres by which stepping feet are raised. A foot that stands in neither
    source may come to rest in their blend, and one that is eased into a stand moves slowly before: what then looks as
    if it stood is held, too, in a second, slighter pass, which also takes out what is left of the slide.
    """
    once = lock_feet(clip, contacts, 0.0, lifts=lifts)
    held = contacts | (foot_contacts(once, 0.0) & (lifts == 0))
    return lock_feet(once, held, 0.0, farthest=_RETOUCH), held


def ankles_apart(a: np.ndarray, b: np.ndarray, clip: Clip) -> np.ndarray:
    """Metres on the ground between the ankles in two motions of one body: ``(n, 2)``, 0 for a foot that is not there.

    a, b: joint positions ``(n, n_joints, 3)``.
    """
    joints = find_anatomy(clip.skeleton).joints
    apart = np.zeros((len(a), 2))
    for column, side in enumerate(SIDES):
        if f"{side}_ankle" in joints:
            ankle = joints[f"{side}_ankle"]
            apart[:, column] = np.linalg.norm((a[:, ankle] - b[:, ankle])[:, [0, 2]], axis=1)
    return apart


def source_skate(sources: Mapping[str, Clip], pieces: Sequence[Segment]) -> float:
    """Metres a second that standing feet slide in the pieces as they were recorded; sources: floors at height 0."""
    metres = seconds = 0.0
    for name in dict.fromkeys(piece.clip for piece in pieces):
        clip = sources[name]
        used = np.zeros(clip.n_frames, bool)
        for piece in pieces:
            if piece.clip == name:
                used[piece.start : piece.end] = True
        slid, stood = slide(clip, foot_contacts(clip, 0.0) & used[:, None], 0.0)
        metres, seconds = metres + slid, seconds + stood
    return metres / seconds if seconds else 0.0
