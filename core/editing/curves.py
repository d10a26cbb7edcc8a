"""The curves of a clip over time, with names and units, for charts and tables.

Angles are those of :mod:`core.poses.angles`. Speeds are of joints in the world, over about 1/30 s around each frame
(what is shorter is mostly noise of the recording). Contacts and foot heights are those of
:mod:`core.editing.contacts`; positions are metres in the world, Y up, as everywhere.
"""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.editing.contacts import floor_height, foot_contacts, heights, sole_points
from core.editing.gait import Gait, find_gait
from core.errors import ParameterError
from core.mocap.anatomy import SIDES, find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions
from core.poses.angles import JOINTS, channel_angles, joint_angles, known_joints
from core.poses.body_frames import BodyFrames
from core.spreadsheets import SheetWriter

SPEED_SPAN = 1 / 30
"""Seconds over which a speed is measured."""

TRAVEL = "travel"
"""The name of the pelvis's speed along the ground, among the joints that have speeds."""

_BLOCK = 2048  # rows of a table written at once


class Curve(NamedTuple):
    """One quantity over the frames of a clip: joint or part it belongs to, its name, unit, and values ``(n_frames,)``.

    step: whether it is a state (a foot on the floor) rather than a course.
    """

    part: str
    name: str
    unit: str
    values: np.ndarray
    step: bool = False

    @property
    def title(self) -> str:
        """Name for a column of a table: ``left_knee flexion [deg]``."""
        return f"{self.part} {self.name} [{self.unit}]"


class ClipCurves:
    """The curves of one clip, computed when first asked for and kept.

    frames: anatomical frames of the clip's skeleton (:func:`core.poses.body_frames.body_frames`).
    """

    def __init__(self, clip: Clip, frames: BodyFrames):
        self.clip, self.frames = clip, frames
        self._angles: dict[str, np.ndarray] = {}

    @property
    def angle_joints(self) -> tuple[str, ...]:
        """Joints that have angles."""
        return known_joints(self.frames)

    @property
    def joints(self) -> tuple[str, ...]:
        """Canonical joints that have positions and speeds."""
        return tuple(find_anatomy(self.clip.skeleton).joints)

    @property
    def turning_joints(self) -> tuple[int, ...]:
        """Indices of the skeleton's joints that turn, for :meth:`channels`."""
        skeleton = self.clip.skeleton
        return tuple(j for j in range(skeleton.n_joints) if not skeleton.end_sites[j])

    @cached_property
    def _feet_and_places(self) -> tuple[np.ndarray, np.ndarray, Gait, dict[str, np.ndarray]]:
        """Contacts and foot heights ``(n_frames, 2)``, gait, and places ``(n_frames, 3)`` of the canonical joints.

        All in one go: positions of every joint of a long clip are not for keeping.
        """
        clip, positions = self.clip, joint_positions(self.clip)
        contacts, floor = foot_contacts(clip, positions=positions), floor_height(clip, positions)
        lowest = np.zeros((clip.n_frames, 2), np.float32)
        for side, points in enumerate(sole_points(clip)):
            if points:
                lowest[:, side] = heights(clip, positions, points, floor).min(1)
        anatomy = find_anatomy(clip.skeleton)
        places = {name: np.ascontiguousarray(positions[:, j]) for name, j in anatomy.joints.items()}
        return contacts, lowest, find_gait(clip, contacts, positions), places

    @property
    def gait(self) -> Gait:
        """Heel strikes, toe-offs and measures."""
        return self._feet_and_places[2]

    @property
    def contacts(self) -> np.ndarray:
        """Which foot stands: ``(n_frames, 2)`` bool, left then right."""
        return self._feet_and_places[0]

    def place(self, joint: str) -> np.ndarray:
        """World positions of a canonical joint ``(n_frames, 3)``, metres; raises ParameterError for an unknown one."""
        places = self._feet_and_places[3]
        if joint not in places:
            raise ParameterError(f"this body has no {joint}; it has {', '.join(places)}")
        return places[joint]

    def angles(self, joints: Iterable[str] | None = None, channels: Sequence[str] | None = None) -> list[Curve]:
        """Angles of ``joints`` (all where None), degrees; only ``channels`` of these names where given.

        Raises ValueError for a joint without angles.
        """
        chosen = self.angle_joints if joints is None else tuple(joints)
        missing = [joint for joint in chosen if joint not in self._angles]
        if missing:
            self._angles |= joint_angles(self.clip, self.frames, missing)
        return [
            Curve(joint, channel.name, "deg", self._angles[joint][:, k])
            for joint in chosen
            for k, channel in enumerate(JOINTS[joint].channels)
            if channels is None or channel.name in channels
        ]

    def channels(self, joints: Iterable[int] | None = None) -> list[Curve]:
        """The file's own rotation channels of joints (indices; all that turn where None), degrees.

        Raises ParameterError for a joint that is not there or does not turn.
        """
        curves = []
        for joint in self.turning_joints if joints is None else joints:
            if joint not in self.turning_joints:
                raise ParameterError(f"there is no turning joint number {joint} in this skeleton")
            names, values = channel_angles(self.clip, joint)
            curves += [Curve(self.clip.skeleton.names[joint], n, "deg", values[:, k]) for k, n in enumerate(names)]
        return curves

    def speeds(self, joints: Iterable[str] | None = None) -> list[Curve]:
        """Speeds of canonical joints in the world, m/s, and of :data:`TRAVEL`; of all where None. Raises ValueError."""
        curves = []
        for joint in (TRAVEL, *self.joints) if joints is None else joints:
            place = self.place("pelvis")[:, [0, 2]] if joint == TRAVEL else self.place(joint)
            curves.append(Curve(joint, "speed", "m/s", speed(place, self.clip.fps)))
        return curves

    def positions(self, joints: Iterable[str] | None = None) -> list[Curve]:
        """Places of canonical joints in the world, metres, three curves each; of all where None. Raises ValueError."""
        chosen = self.joints if joints is None else joints
        return [Curve(joint, axis, "m", self.place(joint)[:, k]) for joint in chosen for k, axis in enumerate("xyz")]

    def feet(self) -> list[Curve]:
        """Height of each foot's lowest point above where it is when the foot stands (m), and whether it stands."""
        contacts, lowest, *_ = self._feet_and_places
        rise = [Curve(f"{side}_foot", "height", "m", lowest[:, k]) for k, side in enumerate(SIDES)]
        return rise + [Curve(f"{side}_foot", "on floor", "0/1", contacts[:, k], True) for k, side in enumerate(SIDES)]

    def events(self) -> list[Curve]:
        """Heel strikes and toe-offs: 1 in the frame of the event, 0 in all others."""
        curves = []
        for side in SIDES:
            for kind, name in (("strike", "heel strike"), ("off", "toe-off")):
                values = np.zeros(self.clip.n_frames, bool)
                values[[e.frame for e in self.gait.events if (e.side, e.kind) == (side, kind)]] = True
                curves.append(Curve(f"{side}_foot", name, "0/1", values, True))
        return curves


def speed(places: np.ndarray, fps: float) -> np.ndarray:
    """Speed ``(n_frames,)`` of a point ``(n_frames, d)``, units a second, over :data:`SPEED_SPAN` around each frame."""
    n, half = len(places), max(1, round(fps * SPEED_SPAN / 2))
    after, before = np.minimum(np.arange(n) + half, n - 1), np.maximum(np.arange(n) - half, 0)
    way: FloatArray = np.linalg.norm(places[after] - places[before], axis=-1)
    speed: np.ndarray = way * fps / np.maximum(after - before, 1)
    return speed.astype(np.float32)


def csv_blocks(clip: Clip, curves: Sequence[Curve], start: int = 0, end: int | None = None) -> Iterator[str]:
    """A table of curves as CSV text, in pieces: a header with units, then a row for each frame of ``[start, end)``.

    The first columns are the frame of the clip and its time in seconds. Raises ParameterError where these are out of
    range.
    """
    end = clip.n_frames if end is None else end
    if not 0 <= start < end <= clip.n_frames:
        raise ParameterError(f"{clip.name} has frames 0 to {clip.n_frames}; cannot write {start} to {end}")
    header = io.StringIO()
    SheetWriter(header).writerow(["frame", "time [s]", *(curve.title for curve in curves)])
    yield header.getvalue()
    form = ",".join(["%d", "%.6f", *("%d" if curve.step else "%.6g" for curve in curves)]) + "\n"
    for low in range(start, end, _BLOCK):
        at = np.arange(low, min(low + _BLOCK, end))
        rows = np.column_stack([at, at / clip.fps, *(curve.values[at] for curve in curves)])
        yield "".join(form % tuple(row) for row in rows.tolist())
