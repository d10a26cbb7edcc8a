"""MVNX: segments of Xsens MVN with their places and rotations, one clip a subject."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.mocap.clip import Clip
from core.mocap.errors import RecordingError
from core.mocap.text import read_bytes, recording_format
from core.mocap.world_poses import clip_of_world

PARENTS = {  # of MVN's segments
    **{"L5": "Pelvis", "L3": "L5", "T12": "L3", "T8": "T12", "Neck": "T8", "Head": "Neck"},
    **{
        f"{side}{part}": parent if parent in ("T8", "Pelvis") else side + parent
        for side in ("Right", "Left")
        for part, parent in (
            *(("Shoulder", "T8"), ("UpperArm", "Shoulder"), ("ForeArm", "UpperArm"), ("Hand", "ForeArm")),
            *(("UpperLeg", "Pelvis"), ("LowerLeg", "UpperLeg"), ("Foot", "LowerLeg"), ("Toe", "Foot")),
        )
    },
}
_DEFAULT_FPS = 60.0


def read_mvnx(path: str | Path, fps: float | None = None) -> tuple[Clip, ...]:
    """A clip for each subject of an MVNX file; the joints are where segments begin. Raises RecordingError."""
    data = read_bytes(path)
    if b"<!DOCTYPE" in data[:100_000] or b"<!ENTITY" in data:
        raise RecordingError(path, "definitions of its own in the XML", "MVNX as MVN exports it")
    try:
        root = ElementTree.fromstring(data)
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise RecordingError(path, f"not XML ({error})", "MVNX as MVN exports it") from None
    subjects = [element for element in root.iter() if _tag(element) == "subject"]
    if not subjects:
        raise RecordingError(path, "no subject in it", "MVNX as MVN exports it")
    stem, clips = recording_format(path)[0], []
    for k, subject in enumerate(subjects):
        clip = _clip(path, subject, fps)
        title = stem if k == 0 else f"{stem} {subject.get('label') or k + 1}"
        clips.append(replace(clip, name=title))
    return tuple(clips)


def _tag(element: ElementTree.Element) -> str:
    return str(element.tag).rpartition("}")[2]


def _clip(path: str | Path, subject: ElementTree.Element, fps: float | None) -> Clip:
    names = [str(e.get("label")) for e in subject.iter() if _tag(e) == "segment" and e.get("label")]
    names = list(dict.fromkeys(name.replace(" ", "") for name in names))
    if "Pelvis" not in names or len(names) > 200:
        raise RecordingError(path, f"{len(names)} segments, none called Pelvis", "the segments of MVN")
    frames = [e for e in subject.iter() if _tag(e) == "frame" and e.get("type", "normal") == "normal"]
    places = _table(path, frames, "position", 3 * len(names)).reshape(-1, len(names), 3)
    turns = _table(path, frames, "orientation", 4 * len(names)).reshape(-1, len(names), 4)
    kept = [name for name in names if name == "Pelvis" or name in PARENTS]
    order = ["Pelvis"]
    for name in order:
        order += [n for n in kept if _above(n, kept) == name]
    index = [names.index(name) for name in order]
    parents = [-1, *(order.index(_above(name, kept)) for name in order[1:])]
    rate = fps or _number(subject.get("frameRate")) or _DEFAULT_FPS
    left = len(names) - len(kept)
    notes = ("unit: metres, as MVNX has it", *([f"{left} props and other segments are left out"] if left else []))
    return clip_of_world(path, order, parents, places[:, index], turns[:, index], rate, notes)


def _above(name: str, kept: list[str]) -> str:
    """The next segment above that is there."""
    above = PARENTS.get(name, "")
    while above and above not in kept:
        above = PARENTS.get(above, "")
    return above


def _table(path: str | Path, frames: list[ElementTree.Element], what: str, width: int) -> np.ndarray:
    """Numbers ``(n_frames, width)`` of an element of every frame."""
    rows = [next((e.text or "" for e in frame if _tag(e) == what), "").split() for frame in frames]
    if not rows or any(len(row) != width for row in rows):
        found = f"{len(rows[0])} numbers of {what} in a frame" if rows else "no frames"
        raise RecordingError(path, found, f"{width} in every frame")
    try:
        return np.array(rows, float)
    except ValueError:
        raise RecordingError(path, f"words among the numbers of {what}", "numbers") from None


def _number(word: str | None) -> float:
    try:
        value = float(word or 0)
    except ValueError:
        return 0.0
    return value if 0 < value < 1e5 else 0.0
