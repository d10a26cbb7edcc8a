"""Gait: heel strikes and toe-offs where a person walks or runs, and measures of the gait.

A foot's stance is a contact (:mod:`core.editing.contacts`) widened at both ends to where the foot still is low and no
faster than a foot that has just struck or is about to leave; judged on recorded walks that lies within about 20 ms of
the moment the heel stops and the toe goes, which contacts alone, made to find feet that stand still, miss by 40 ms.

Not every row of contacts is gait. Strikes must come from left and right in turn, at the pace of steps, each foot set
down ahead of the other in the direction in which the pelvis travels meanwhile, and that must be where the body faces,
or the contrary. What does not is left out, so jogging on the spot, sidesteps and dances have no gait events.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.ndimage import median_filter

from core.editing.blending import heading
from core.editing.contacts import floor_height, foot_contacts, ground_speeds, heights, runs, sole_points
from core.mocap.anatomy import SIDES, find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions

# In body heights, and body heights a second.
_LOW, _SLOW = 0.04, 0.75  # a foot between strike and toe-off
_TRAVEL = 0.1  # way of the pelvis in a step
_AHEAD = 0.06  # of the foot that strikes, before the other
_STEP = (0.18, 1.3)  # seconds from one strike to the next
_FEWEST = 3  # strikes in a row that make it gait: one whole stride
_FACING = np.cos(np.radians(50))  # between travel and facing; further off it is a sidestep
NO_FEET = "This body has no two legs with feet, so there is no gait to look for."
NO_GAIT = "No gait here: no three steps in a row, left and right in turn, carry the body forward."


class GaitEvent(NamedTuple):
    """A heel strike (``"strike"``) or toe-off (``"off"``) of the ``"left"`` or ``"right"`` foot at a frame of the clip.

    bout: number of the :class:`GaitBout` it belongs to.
    """

    frame: int
    side: str
    kind: str
    bout: int


class Measure(NamedTuple):
    """A figure of a bout: mean and standard deviation over ``n`` strides or steps, and the means of either side.

    asymmetry: right over left in per cent of their mean (Robinson et al. 1987), None where a side has none.
    """

    name: str
    unit: str
    mean: float
    spread: float
    n: int
    left: float | None = None
    right: float | None = None

    @property
    def asymmetry(self) -> float | None:
        """Right minus left in per cent of their mean; None where a side is missing."""
        if self.left is None or self.right is None or self.left + self.right == 0:
            return None
        return 200 * (self.right - self.left) / (self.right + self.left)


@dataclass(frozen=True)
class GaitBout:
    """Steps in a row, from the first strike to the last: frames ``[start, end)`` of the clip.

    kind: "walk", or "run" where both feet are off the floor for longer than both are on it.
    backward: whether the body faces away from where it goes.
    """

    start: int
    end: int
    kind: str
    backward: bool
    measures: tuple[Measure, ...]


@dataclass(frozen=True)
class Gait:
    """Events and bouts of a clip in the order of time; ``why`` says why there are none."""

    events: tuple[GaitEvent, ...]
    bouts: tuple[GaitBout, ...]
    why: str = ""


class _Strike(NamedTuple):
    frame: int
    off: int | None  # the toe-off that ends this stance, if it lies in the clip
    side: int


class _Walker(NamedTuple):
    """What the checks need, all on the ground: pelvis ``(n, 2)``, ankles ``(n, 2, 2)`` metres, facing ``(n, 2)``."""

    fps: float
    height: float
    pelvis: np.ndarray
    ankles: np.ndarray
    facing: np.ndarray


def find_gait(clip: Clip, contacts: np.ndarray | None = None, positions: np.ndarray | None = None) -> Gait:
    """Heel strikes, toe-offs and measures of every stretch of walking or running in a clip.

    contacts: ``(n_frames, 2)`` bool of :func:`core.editing.contacts.foot_contacts`, positions: ``(n_frames, n_joints,
    3)`` metres, if they are at hand.
    """
    anatomy = find_anatomy(clip.skeleton)
    ankles = [anatomy.joints[f"{side}_ankle"] for side in SIDES if f"{side}_ankle" in anatomy.joints]
    if len(ankles) < len(SIDES) or not {"left_hip", "right_hip"} <= set(anatomy.joints):
        return Gait((), (), NO_FEET)
    positions = joint_positions(clip) if positions is None else positions
    contacts = foot_contacts(clip, positions=positions) if contacts is None else contacts
    stances = stance_phases(clip, contacts, positions)
    yaw = heading(clip, positions)
    walker = _Walker(
        clip.fps,
        anatomy.body_height,
        positions[:, 0][:, [0, 2]].astype(np.float64),
        positions[:, ankles][..., [0, 2]].astype(np.float64),
        np.stack([np.sin(yaw), np.cos(yaw)], axis=1),
    )
    rows = list(_bouts(walker, _strikes(stances)))
    events = {event[:3]: event for number, row in enumerate(rows) for event in _events(row, number)}
    bouts = tuple(_bout(walker, row, stances) for row in rows)
    return Gait(tuple(sorted(events.values())), bouts, "" if bouts else NO_GAIT)


def stance_phases(clip: Clip, contacts: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Contacts ``(n_frames, 2)`` widened to whole stances, from strike to toe-off: ``(n_frames, 2)`` bool.

    positions: ``(n_frames, n_joints, 3)``, metres.
    """
    body = find_anatomy(clip.skeleton).body_height
    floor = floor_height(clip, positions)
    stances = np.array(contacts, bool)
    for column, points in enumerate(sole_points(clip)):
        if not points:
            continue
        height = heights(clip, positions, points, floor)
        low = height < _LOW * body
        near = (low & (ground_speeds(positions[:, points], clip.fps) < _SLOW * body)).any(1)
        for start, end in runs(near | stances[:, column]):
            stances[start:end, column] = contacts[start:end, column].any()
    return stances


def _strikes(stances: np.ndarray) -> list[_Strike]:
    """All strikes in the order of time; a stance that the clip begins with has none."""
    n, strikes = len(stances), []
    for side in (0, 1):
        strikes += [
            _Strike(int(start), int(end) if end < n else None, side) for start, end in runs(stances[:, side]) if start
        ]
    return sorted(strikes, key=lambda strike: strike.frame)


def _bouts(walker: _Walker, strikes: list[_Strike]) -> Iterable[list[_Strike]]:
    """Rows of strikes that are steps of one kind; where walking turns into running, the strike belongs to both."""
    row: list[_Strike] = []
    for strike in strikes:
        if row and not _is_step(walker, row[-1], strike):
            yield from _of_one_kind(row)
            row = []
        row.append(strike)
    yield from _of_one_kind(row)


def _of_one_kind(row: list[_Strike]) -> Iterable[list[_Strike]]:
    if len(row) < _FEWEST:
        return
    flight = np.array([a.off is not None and a.off < b.frame for a, b in pairwise(row)])
    flight = median_filter(flight.astype(np.int8), 3, mode="nearest")  # one doubtful step is no change
    turns = [0]
    for k in np.flatnonzero(np.diff(flight)) + 1:
        if min(k - turns[-1], len(flight) - k) >= _FEWEST - 1:
            turns.append(int(k))
    for start, end in pairwise([*turns, len(row) - 1]):
        yield row[start : end + 1]


def _is_step(walker: _Walker, before: _Strike, after: _Strike) -> bool:
    """Whether the body steps from one strike to the next."""
    seconds = (after.frame - before.frame) / walker.fps
    travel = walker.pelvis[after.frame] - walker.pelvis[before.frame]
    way = float(np.linalg.norm(travel))
    if before.side == after.side or not _STEP[0] <= seconds <= _STEP[1] or way < _TRAVEL * walker.height:
        return False
    ahead = (walker.ankles[after.frame, after.side] - walker.ankles[after.frame, before.side]) @ travel / way
    facing = walker.facing[before.frame : after.frame].mean(0) @ travel / way
    return bool(ahead > _AHEAD * walker.height and abs(facing) > _FACING)


def _events(strikes: list[_Strike], bout: int) -> list[GaitEvent]:
    events = [GaitEvent(s.frame, SIDES[s.side], "strike", bout) for s in strikes]
    return events + [GaitEvent(s.off, SIDES[s.side], "off", bout) for s in strikes if s.off is not None]


def _bout(walker: _Walker, strikes: list[_Strike], stances: np.ndarray) -> GaitBout:
    start, end = strikes[0].frame, strikes[-1].frame
    seconds, feet = (end - start) / walker.fps, stances[start:end].sum(1)
    both, none = 100 * float((feet == 2).mean()), 100 * float((feet == 0).mean())
    way = sum(float(np.linalg.norm(walker.pelvis[b.frame] - walker.pelvis[a.frame])) for a, b in pairwise(strikes))
    over_all = (
        ("Cadence", "steps/min", 60 * (len(strikes) - 1) / seconds),
        ("Speed", "m/s", way / seconds),
        ("Both feet down", "%", both),
        ("Both feet off", "%", none),
    )
    travel = walker.pelvis[end] - walker.pelvis[start]
    return GaitBout(
        start=start,
        end=end,
        kind="run" if none > both else "walk",
        backward=bool((walker.facing[start:end] @ travel).mean() < 0),
        measures=(*(Measure(*m, 0.0, 1) for m in over_all), *_sided_measures(walker, strikes)),
    )


def _sided_measures(walker: _Walker, strikes: list[_Strike]) -> Iterable[Measure]:
    """Measures of strides (from a strike to the next of that foot) and steps (to the next of either foot)."""
    values: dict[tuple[str, str], tuple[list[float], list[float]]] = {}

    def note(name: str, unit: str, side: int, value: float) -> None:
        values.setdefault((name, unit), ([], []))[side].append(float(value))

    for a, b in pairwise(strikes):
        travel = walker.pelvis[b.frame] - walker.pelvis[a.frame]
        apart = walker.ankles[b.frame, b.side] - walker.ankles[a.frame, a.side]
        note("Step length", "m", b.side, apart @ travel / np.linalg.norm(travel))
        note("Step time", "s", b.side, (b.frame - a.frame) / walker.fps)
    for a, b in zip(strikes, strikes[2:], strict=False):
        way = walker.ankles[b.frame, a.side] - walker.ankles[a.frame, a.side]
        note("Stride length", "m", a.side, float(np.linalg.norm(way)))
        note("Stride time", "s", a.side, (b.frame - a.frame) / walker.fps)
        if a.off is not None:
            note("Stance", "% of stride", a.side, 100 * (a.off - a.frame) / (b.frame - a.frame))
    for (name, unit), (left, right) in values.items():
        both, sides = left + right, [float(np.mean(side)) if side else None for side in (left, right)]
        yield Measure(name, unit, float(np.mean(both)), float(np.std(both)), len(both), *sides)
