"""OpenSim's MOT and STO tables: coordinates over time, without the model that they move.

There are no places in such a file, so it is no figure: every coordinate is a joint of its own that turns (angles) or
shifts (all else), and the Clip page shows them as curves under the names of the model.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.errors import RecordingError
from core.mocap.points.tables import cells_of, divider_of, rate_of, read_table
from core.mocap.reports import Finding
from core.mocap.skeleton import Skeleton
from core.mocap.text import LARGEST, decoded, read_bytes, recording_format

_HEAD_LINES = 200
_LENGTH = re.compile(r"(_t[xyz]|trans[xyz]?|translation|_[xyz]|_[pv][xyz])$", re.I)
_FORCE = re.compile(r"(force|moment|torque|power|activation|_v[xyz])$", re.I)
_APART = 0.05  # metres between the joints that stand for coordinates
_SMALL = 0.001  # metres for a unit of what is neither an angle nor a length
_DEFAULT_FPS = 100.0


def read_opensim(path: str | Path, fps: float | None = None) -> tuple[Clip, ...]:
    """The coordinates of a MOT or STO file as one clip. Raises RecordingError."""
    data = read_bytes(path)
    lines = decoded(data[: 1 << 20]).split("\n")
    end = next((k for k, line in enumerate(lines[:_HEAD_LINES]) if line.strip(" ,;\t").lower() == "endheader"), None)
    if end is None:
        raise RecordingError(path, "no 'endheader'", "a MOT or STO file of OpenSim", 1)
    first = next((k for k in range(end + 1, min(len(lines), end + 20)) if lines[k].strip(" ,;\t")), None)
    if first is None:
        raise RecordingError(path, "no names of columns", "a line with 'time' and the coordinates", end + 1)
    divider = divider_of([lines[first]])
    names = cells_of(lines[first], divider)
    while names and not names[-1]:
        names.pop()
    if len(names) < 2 or names[0].lower() != "time" or len(set(names)) < len(names):
        raise RecordingError(
            path, "columns without 'time' in front", "a line with 'time' and the coordinates", first + 1
        )
    rest = data.split(b"\n", first + 1)
    table = read_table(path, rest[-1] if len(rest) > first + 1 else b"", first + 2, divider, len(names))
    if not len(table):
        raise RecordingError(path, "no rows of numbers", "a row for every moment", first + 2)
    if not (np.abs(table) < LARGEST).all():
        raise RecordingError(path, "cells without a number", "a number in every cell", first + 2)
    degrees = not any(re.match(r"\s*inDegrees\s*=\s*no", line, re.I) for line in lines[:end])
    rate = fps or rate_of(table[:, 0]) or _DEFAULT_FPS
    return (_clip(path, tuple(name[:256] for name in names[1:]), table[:, 1:], degrees, rate),)


def _clip(path: str | Path, names: tuple[str, ...], values: np.ndarray, degrees: bool, fps: float) -> Clip:
    root = "coordinates"
    while root in names:
        root += "_"
    offsets = np.zeros((len(names) + 1, 3))
    offsets[1:, 0] = _APART * (1 + np.arange(len(names)))
    turns = np.zeros((len(values), len(names) + 1, 3))
    tracks: dict[int, np.ndarray] = {}
    for k, name in enumerate(names, 1):
        if _LENGTH.search(name) or _FORCE.search(name):
            shift = values[:, k - 1] * (_SMALL if _FORCE.search(name) else 1.0)
            tracks[k] = (offsets[k] + shift[:, None] * [0.0, 1.0, 0.0]).astype(np.float32)
        else:
            turns[:, k, 0] = np.radians(values[:, k - 1]) if degrees else values[:, k - 1]
    words = "coordinates without the model that they move: each is a joint of its own, to be seen as curves"
    notes = [f"{len(names) - len(tracks)} angles in {'degrees' if degrees else 'radians'}, {len(tracks)} other columns"]
    if any(_FORCE.search(name) for name in names):
        notes.append("forces, moments and the like are shown as shifts: 1000 of their units as a metre")
    return Clip(
        name=recording_format(path)[0],
        skeleton=Skeleton((root, *names), (-1, *[0] * len(names)), offsets, body="other"),
        fps=float(fps),
        root_positions=np.zeros((len(values), 3), np.float32),
        rotations=quat.from_rotvec(turns).astype(np.float32),
        translations=tracks,
        notes=tuple(notes),
        findings=(Finding("body", words),),
    )
