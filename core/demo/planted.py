"""Groups of people that differ in one known way, to see whether a comparison finds it."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from core.demo.performers import Performer
from core.demo.routines import perform_sentence
from core.mocap import quaternions as quat
from core.mocap.clip import Clip, Label
from core.mocap.dataset import Dataset, ImportReport
from core.mocap.properties import Properties
from core.mocap.reports import FileReport
from core.progress import Report, silent

Difference = Literal["nothing", "kicks", "slower", "wider"]
DIFFERENCES: tuple[Difference, ...] = ("nothing", "kicks", "slower", "wider")
SLOWER, WIDER, KICKS = 0.9, 15.0, 2  # of the tempo; degrees; times as often
_FILLING = ("idle", "jump", "punch", "squat", "idle")
PIECES = 24  # actions of a routine beside walking


def person(number: int, difference: Difference, seed: int = 0, pieces: int = PIECES) -> tuple[Clip, tuple[Label, ...]]:
    """A routine of a minute or two by someone with a body and a manner of their own.

    pieces: actions beside walking. kicks: kicks twice as often as others; slower: moves a tenth slower; wider: holds
    the arms 15 degrees wider. The same number and seed give the same person, whatever the difference.
    """
    rng = np.random.default_rng([seed, number])
    size, tempo, amplitude, lean = rng.normal([1.05, 1, 1, 0], [0.05, 0.04, 0.06, 1.5])
    one = Performer(f"p{number:03d}", float(size), tempo=float(tempo), amplitude=float(amplitude), lean=float(lean))
    if difference == "slower":
        one = replace(one, tempo=one.tempo * SLOWER)
    often = 0.2 * (KICKS if difference == "kicks" else 1)
    sentence = ["walk"]
    for k in range(pieces):
        sentence.append("kick" if rng.uniform() < often else _FILLING[int(rng.integers(len(_FILLING)))])
        if k % 3 == 2:
            sentence.append("walk")
    clip, labels, _ = perform_sentence(tuple(sentence), one, rng, one.name)
    return (with_wider_arms(clip) if difference == "wider" else clip), labels


def with_wider_arms(clip: Clip, degrees: float = WIDER) -> Clip:
    """The clip of a demo performer with both upper arms turned outwards by some degrees, about the chest's own axis."""
    rotations = np.array(clip.rotations)
    for side, sign in (("Left", 1), ("Right", -1)):
        joint, half = clip.skeleton.names.index(f"{side}Arm"), np.radians(sign * degrees) / 2
        turn = np.array([np.cos(half), 0, 0, np.sin(half)], np.float32)
        rotations[:, joint] = quat.multiply(turn, rotations[:, joint])
    return replace(clip, rotations=rotations)


def planted_groups(
    difference: Difference, per_group: int, seed: int = 0, pieces: int = PIECES, report: Report = silent
) -> tuple[Dataset, Properties]:
    """Two groups of people, A without and B with a difference, one clip each, and their properties ``subject`` and
    ``group``. Raises Cancelled from ``report``."""
    clips: list[Clip] = []
    labels: list[Label] = []
    values: dict[str, dict[str, str]] = {}
    for number in range(2 * per_group):
        report("making people", number / (2 * per_group))
        group = "A" if number < per_group else "B"
        clip, own = person(number, difference if group == "B" else "nothing", seed, pieces)
        clips.append(clip)
        labels += own
        values[clip.name] = {"subject": clip.name, "group": group}
    files = tuple(FileReport(clip.name, clip.name, "ok") for clip in clips)
    dataset = Dataset("groups", tuple(clips), tuple(labels), ImportReport(files))
    return dataset, Properties().with_values(values)
