"""Acclaim ASF skeletons and AMC motions, as the CMU database publishes them.

A joint of ours is the START of an ASF bone and is named after it: its offset is its parent bone's direction times
length, zero for the bones that hang from the root; the end of a leaf bone is an end site ``<bone>_end``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.mocap import numbers
from core.mocap import quaternions as quat
from core.mocap.amc_repair import AmcTable, repaired_frames
from core.mocap.asf_parser import RawAsf, parse_asf
from core.mocap.clip import Clip
from core.mocap.errors import RecordingError
from core.mocap.euler import rotations_from_angles
from core.mocap.gaps import fill_rotations, fill_track
from core.mocap.reports import Finding
from core.mocap.skeleton import Skeleton
from core.mocap.text import LARGEST, decoded, read_bytes, recording_format, token_at

INCH = 0.0254
DEFAULT_FPS = 120.0  # AMC stores no rate; this is the rate of the CMU recordings
_ROTATION = ("Zrotation", "Yrotation", "Xrotation")
_ROOT = ("Xposition", "Yposition", "Zposition", *_ROTATION)


@dataclass(frozen=True, eq=False)
class AsfSkeleton:
    """A skeleton and what is needed to read motions made for it.

    bones: ASF names ("root" first) in the order of their values; first_value: (n_bones + 1,) where each begins.
    columns, axes: (n_joints, 3) angles of every joint, see :func:`core.mocap.euler.rotations_from_angles`.
    frames: (n_joints, 4) quaternions of the bones' axes. root_columns: where TX, TY, TZ stand, -1 for none.
    turns: number of a bone that may also shift or stretch -> which of its values are turns.
    root_position: (3,) metres, added to the root's path. findings: what was odd about the file and has been mended.
    """

    path: str
    skeleton: Skeleton
    bones: tuple[str, ...]
    first_value: np.ndarray
    columns: np.ndarray
    axes: np.ndarray
    frames: np.ndarray
    root_columns: tuple[int, int, int]
    turns: Mapping[int, tuple[int, ...]]
    root_position: np.ndarray
    notes: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()


def read_asf(path: str | Path) -> AsfSkeleton:
    """Skeleton from an ``.asf`` (or ``.asf.gz``) file, in metres: value / length unit * 0.0254.

    Raises RecordingError for anything that is no complete, consistent skeleton.
    """
    encoding: list[str] = []
    raw = parse_asf(path, decoded(read_bytes(path, encoding)))
    raw.findings += [Finding("encoding", note) for note in encoding]
    unit = INCH / raw.length_unit
    order = _depth_first(raw)
    names: list[str] = []
    parents: list[int] = []
    offsets: list[np.ndarray] = []
    ends: list[bool] = []
    index: dict[str, int] = {}
    for bone in order:
        index[bone] = len(names)
        parent = raw.parents.get(bone)
        names.append(bone)
        parents.append(-1 if parent is None else index[parent])
        offsets.append(_vector(raw, parent) * unit)
        ends.append(False)
        if bone not in raw.children and bone != "root":
            names.append(_free(f"{bone}_end", raw))
            parents.append(index[bone])
            offsets.append(_vector(raw, bone) * unit)
            ends.append(True)
    channels = tuple(() if end else _ROTATION if j else _ROOT for j, end in enumerate(ends))
    skeleton = Skeleton(tuple(names), tuple(parents), np.array(offsets), tuple(ends), channels, unit)
    return _with_channels(path, raw, skeleton, index, unit)


def _with_channels(
    path: str | Path, raw: RawAsf, skeleton: Skeleton, index: dict[str, int], unit: float
) -> AsfSkeleton:
    """What an AMC for this skeleton holds, and where."""
    columns, axes = np.full((skeleton.n_joints, 3), -1), np.full((skeleton.n_joints, 3), -1)
    frames = np.tile([1.0, 0.0, 0.0, 0.0], (skeleton.n_joints, 1))
    first, bones = [0], {"root": raw.root, **raw.bones}
    for name, bone in bones.items():
        joint, start = index[name], first[-1]
        # An axis order XYZ means: about X first, then Y, then Z, all fixed; read backwards it is intrinsic.
        turns = [(axis, start + bone.dof.index(f"r{axis}")) for axis in reversed(bone.order) if f"r{axis}" in bone.dof]
        for k, (axis, column) in enumerate(turns):
            axes[joint, k], columns[joint, k] = "xyz".index(axis), column
        angles = np.array([[bone.axis["xyz".index(a)] for a in reversed(bone.order)]])
        frames[joint] = quat.from_euler(bone.order[::-1], angles if raw.radians else np.radians(angles))[0]
        first.append(start + len(bone.dof))
    x, y, z = (raw.root.dof.index(t) if t in raw.root.dof else -1 for t in ("tx", "ty", "tz"))
    moved = np.any(raw.root_position) or np.any(raw.root.axis)
    notes = (*(["the skeleton's own root position and orientation were applied"] if moved else []), *raw.notes)
    return AsfSkeleton(
        path=str(path),
        skeleton=skeleton,
        bones=tuple(bones),
        first_value=np.array(first),
        columns=columns,
        axes=axes,
        frames=frames,
        root_columns=(x, y, z),
        turns={
            k: tuple(place for place, dof in enumerate(bone.dof) if dof.startswith("r"))
            for k, bone in enumerate(bones.values())
            if k and not all(dof.startswith("r") for dof in bone.dof)
        },
        root_position=np.array(raw.root_position) * unit,
        notes=notes,
        findings=tuple(raw.findings),
    )


def _depth_first(raw: RawAsf) -> list[str]:
    order, stack = [], ["root"]
    while stack:
        bone = stack.pop()
        order.append(bone)
        stack.extend(reversed(raw.children.get(bone, ())))
    return order


def _vector(raw: RawAsf, bone: str | None) -> np.ndarray:
    """From the start to the end of a bone, in file units; zero for the root, which has no length."""
    if bone is None or bone == "root":
        return np.zeros(3)
    direction = np.array(raw.bones[bone].direction)
    return direction * raw.bones[bone].length / max(float(np.linalg.norm(direction)), 1e-9)


def _free(name: str, raw: RawAsf) -> str:
    while name in raw.bones:
        name += "_"
    return name


def read_amc(path: str | Path, asf: AsfSkeleton, fps: float = DEFAULT_FPS) -> Clip:
    """Motion from an ``.amc`` or ``.amc.gz`` file for the skeleton ``asf``, at ``fps`` frames per second.

    Raises RecordingError for a file that is damaged or does not fit the skeleton, ValueError where fps is not positive.
    """
    encoding: list[str] = []
    data = read_bytes(path, encoding)
    start, radians = _head(path, data)
    table = _frames(path, data, start, asf)
    values, skeleton = table.values, asf.skeleton
    if radians:
        values[:, [c for c in asf.columns.ravel() if c >= 0]] *= 180 / np.pi
    root = np.tile(asf.root_position, (len(values), 1))
    for k, column in enumerate(asf.root_columns):
        if column >= 0:
            root[:, k] += values[:, column] * skeleton.unit
    rotations = rotations_from_angles(values, asf.columns, asf.axes, asf.frames)
    if table.lost.any():
        fill_rotations(rotations, table.lost)
        fill_track(root, table.lost)
    return Clip(
        name=recording_format(path)[0],
        skeleton=skeleton,
        fps=float(fps),
        root_positions=root.astype(np.float32),
        rotations=rotations,
        notes=asf.notes,
        findings=(*(Finding("encoding", note) for note in encoding), *asf.findings, *table.findings),
    )


def _head(path: str | Path, data: bytes) -> tuple[int, bool]:
    """Byte offset of the first frame and whether angles are in radians."""
    offset, radians = 0, False
    for line, text in enumerate(data[: 1 << 16].split(b"\n"), 1):
        word = text.strip().upper()
        if word[:1].isdigit() or word[:1] in (b"-", b"+"):
            return offset, radians
        if word.startswith(b":"):
            radians = radians or word.startswith(b":RADIANS")
        elif word and not word.startswith(b"#"):
            raise RecordingError(path, token_at(text, 0), "a comment, a :KEYWORD or the first frame's number", line)
        offset += len(text) + 1
    raise RecordingError(path, "no frames", "a frame's number and its bones")


def _frames(path: str | Path, data: bytes, start: int, asf: AsfSkeleton) -> AmcTable:
    """All values, (n_frames, n_values) float64."""
    raw = np.frombuffer(data, np.uint8)
    encoded = [bone.encode() for bone in asf.bones]
    name_at = np.cumsum([0, *map(len, encoded)])
    names = np.frombuffer(b"".join(encoded), np.uint8)
    # Every numbered line that has its bones takes at least two bytes a value: no count in the file is believed.
    n = min(numbers.count_numbered_lines(raw, start), len(data) // max(2 * int(asf.first_value[-1]), 1) + 1)
    out = np.empty((n, int(asf.first_value[-1])))
    found, status, _, _ = numbers.scan_frames(raw, start, names, name_at, asf.first_value, out, LARGEST)
    if status == numbers.OK:
        return AmcTable(out[:found], np.zeros(found, bool))
    return repaired_frames(path, data, start, asf.bones, asf.first_value, asf.turns, Path(asf.path).name)
