"""C3D recordings: a clip for each person, joints from markers or from the rotations of segments."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from core.mocap.c3d_file import RawC3d, parse_c3d
from core.mocap.clip import Clip
from core.mocap.points.figure import MOST_POINTS, Points, clip_of
from core.mocap.points.meaning import understood
from core.mocap.reports import Finding
from core.mocap.text import read_binary, recording_format
from core.mocap.units import UNITS

_NOT_PLACES = ("ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS", "REACTIONS")  # lists of labels that are no points
_ENDINGS = ("angles", "angle", "force", "moment", "power", "grf", "centreofmassfloor")
_UNITS = {"millimeters": "mm", "millimetres": "mm", "meters": "m", "metres": "m", "centimeters": "cm", "inches": "in"}
_SEGMENTS = {  # what Theia calls a segment whose origin is this joint
    **{"pelvis": "pelvis", "torso": "chest", "head": "head"},
    **{
        f"{s[0]}_{part}": f"{s}_{joint}"
        for s in ("left", "right")
        for part, joint in (
            *(("thigh", "hip"), ("shank", "knee"), ("foot", "ankle"), ("toes", "toe")),
            *(("uarm", "shoulder"), ("larm", "elbow"), ("hand", "wrist")),
        )
    },
}
_DEFAULT_FPS = 100.0


def read_c3d(
    path: str | Path, fps: float | None = None, preset: str | None = None, smooth: float | None = None
) -> tuple[Clip, ...]:
    """A clip for each person in a C3D file, told apart by what stands before ``:`` in the labels.

    fps, preset and smooth as for core.mocap.points.reading. Raises RecordingError.
    """
    raw = parse_c3d(path, read_binary(path))
    clips = []
    for points in _people(Path(path), raw):
        if fps:
            points = replace(points, fps=float(fps))
        clips.append(clip_of(understood(points, preset), smooth))
    return tuple(clips)


def _people(path: Path, raw: RawC3d) -> list[Points]:
    name = recording_format(path)[0]
    unit = _unit(raw)
    notes = tuple(_notes(raw))
    findings = tuple(_findings(raw))
    rate = raw.rate if raw.rate > 0 else _DEFAULT_FPS
    if raw.rotations is not None and not raw.points.shape[1]:
        return [_segments(path, name, raw, unit, notes)]
    labels = _labels(raw)
    groups: dict[str, list[int]] = {}
    for k, label in enumerate(labels):
        if label and not label.startswith("*"):
            groups.setdefault(label.rpartition(":")[0], []).append(k)
    if not groups:
        groups = {"": list(range(len(labels)))}
    people = {subject: which for subject, which in groups.items() if len(which) > 2} or groups
    if len(people) > 1:
        shown = ", ".join(subject or "no name" for subject in people)
        findings = (Finding("people", f"{len(people)} people in one file ({shown}): each is a clip"), *findings)
    found = []
    for k, (subject, which) in enumerate(people.items()):
        which = which[:MOST_POINTS]
        names = tuple(labels[j].rpartition(":")[2] or f"point {j + 1}" for j in which)
        title = name if k == 0 else f"{name} {subject or k + 1}"
        found.append(Points(path, title, names, raw.points[:, which], rate, unit, notes=notes, findings=findings))
    return found


def _labels(raw: RawC3d) -> list[str]:
    """A label for each point, empty for those that are no places."""
    n = raw.points.shape[1]
    labels = (raw.texts("POINT", "LABELS") + [""] * n)[:n]
    if not any(labels):
        return [f"point {k + 1}" for k in range(n)]
    others = {label for kind in _NOT_PLACES for label in raw.texts("POINT", kind)}
    return ["" if label in others or label.lower().endswith(_ENDINGS) else label for label in labels]


def _segments(path: Path, name: str, raw: RawC3d, unit: float | None, notes: tuple[str, ...]) -> Points:
    """The origins of segments, which are joints, where a file has rotations of segments and no points (Theia)."""
    assert raw.rotations is not None
    count = raw.rotations.shape[1]
    labels = (raw.texts("ROTATION", "LABELS") + [f"segment {k + 1}" for k in range(count)])[:count]
    names = [_SEGMENTS.get(label.lower().removesuffix("_4x4"), label) for label in labels]
    keep = [k for k, label in enumerate(labels) if not label.lower().startswith("world")]
    rate = raw.parameters.get(("ROTATION", "RATE"))
    fps = float(rate) if isinstance(rate, float) and rate > 0 else raw.rate or _DEFAULT_FPS
    note = f"{len(keep)} segments with their rotations: joints are where segments begin"
    places = raw.rotations[:, keep][:, :, :3, 3]
    return Points(path, name, tuple(names[k] for k in keep), places, fps, unit, notes=(*notes, note))


def _unit(raw: RawC3d) -> float | None:
    words = raw.texts("POINT", "UNITS")
    word = words[0].lower() if words else ""
    word = _UNITS.get(word, word)
    return UNITS[word][0] if word in UNITS else None


def _notes(raw: RawC3d) -> list[str]:
    """What else is in the file."""
    return [f"{raw.analog} analog values a frame are left out"] if raw.analog else []


def _findings(raw: RawC3d) -> list[Finding]:
    n = len(raw.points)
    if raw.points.shape[1] and n < raw.frames_stated:
        return [Finding("rows", f"the file says {raw.frames_stated} frames and ends after {n}: those were read")]
    return []
