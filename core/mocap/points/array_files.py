"""Arrays of points in NPY and NPZ files, never with pickled objects in them."""

from __future__ import annotations

import ast
import tokenize
import zipfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from core.mocap.errors import RecordingError
from core.mocap.points.figure import MOST_POINTS, Points
from core.mocap.points.text_files import DEFAULT_FPS
from core.mocap.text import recording_format

MOST_VALUES = 2**27  # numbers that an array may hold: 1 GB of them as they are worked with
RATES = ("mocap_framerate", "mocap_frame_rate", "fps", "framerate", "frame_rate", "rate", "sampling_rate", "frequency")
_NAMES = (
    "names",
    "joint_names",
    "joints_names",
    "keypoints",
    "keypoint_names",
    "bone_names",
    "labels",
    "bodyparts",
    "markers",
)
POINTS = (
    *("posed_joints", "joints", "joints3d", "joint_positions", "positions", "keypoints3d", "keypoints_3d", "poses_3d"),
    *("pose3d", "skeleton", "landmarks", "points", "motion", "markers", "xyz", "position", "jtr", "keypoints", "data"),
)
HUMANML3D, _HUMANML3D_JOINTS, _HUMANML3D_FPS = 263, 22, 20.0


def read_arrays(path: str | Path) -> dict[str, np.ndarray]:
    """The arrays ``(n, ...)`` of an ``.npz``, or the one of an ``.npy`` under "".

    Raises RecordingError; pickles are refused.
    """
    try:
        _check_sizes(Path(path))
        loaded: Any = np.load(path, allow_pickle=False)
        if isinstance(loaded, np.ndarray):
            return {"": loaded}
        with loaded:
            read = ((name, _plain(loaded, name)) for name in loaded.files)
            return {name: array for name, array in read if array is not None}
    except RecordingError:
        raise
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile, zlib.error, SyntaxError, TypeError) as error:
        if "pickle" in str(error).lower():
            words = "it holds Python objects, which may run code when opened and are never read"
            raise RecordingError(path, words, "plain arrays; save them with numpy.savez") from None
        raise RecordingError(path, f"cannot be read ({_short(error)})", "a NumPy file") from None
    except (
        NotImplementedError,
        RuntimeError,
        AttributeError,
        tokenize.TokenError,
        MemoryError,
        OverflowError,
        RecursionError,
    ) as error:
        raise RecordingError(path, f"cannot be read ({_short(error)})", "a NumPy file") from None


def _short(error: BaseException) -> str:
    return " ".join(str(error).split())[:80] or type(error).__name__


def _plain(archive: Any, name: str) -> np.ndarray | None:
    """An array of an archive; None where it holds objects, which are left out."""
    try:
        return np.asarray(archive[name])
    except ValueError as error:
        if "pickle" in str(error).lower() or "Object arrays" in str(error):
            return None
        raise


def _check_sizes(path: Path) -> None:
    """Refuses arrays that are larger than their file can hold, or than is reasonable, before they are made."""
    if not path.is_file():
        raise RecordingError(path, "there is no such file")
    if not zipfile.is_zipfile(path):
        with path.open("rb") as file:
            _check_header(path, file.read(4096))
        return
    with zipfile.ZipFile(path) as archive:
        for entry in archive.infolist():
            with archive.open(entry) as file:
                _check_header(path, file.read(4096))
            if entry.file_size > 8 * MOST_VALUES:
                raise RecordingError(path, f"an array of {entry.file_size >> 20:,} MB", "at most 1 GB")


def _check_header(path: Path, head: bytes) -> None:
    if not head.startswith(b"\x93NUMPY"):
        return
    start, end = head.find(b"{"), head.find(b"}")
    if start < 0 or end < 0:
        raise RecordingError(path, "the head of an array is damaged", "a NumPy file")
    try:
        shape = ast.literal_eval(head[start : end + 1].decode("latin-1"))["shape"]
        count = 1
        for size in shape:
            count *= int(size)
    except (ValueError, SyntaxError, KeyError, TypeError, MemoryError, RecursionError):
        raise RecordingError(path, "the head of an array is damaged", "a NumPy file") from None
    if not 0 <= count <= MOST_VALUES:
        raise RecordingError(path, f"an array of shape {str(shape)[:60]}", f"at most {MOST_VALUES:,} numbers")


def points_of_arrays(path: str | Path, arrays: dict[str, np.ndarray]) -> list[tuple[Points, bool]]:
    """Points of arrays such as ``(n_frames, n_points, 3)``, one for each person, and whether they have names.

    Raises RecordingError.
    """
    fps, said = _rate(arrays)
    stem = recording_format(path)[0]
    name, found = _chosen(path, arrays)
    if found.ndim == 2 and found.shape[1] == HUMANML3D:
        values = humanml3d_positions(found)
        note = "HumanML3D's 263 numbers a frame: joints from their places against the root and the root's path"
        return [(_points(path, stem, values, None, fps or _HUMANML3D_FPS, said, (note,)), False)]
    people = _people(path, found)
    names = _names(arrays, name, people[0].shape[1])
    if fps is None and names is None and people[0].shape[1] == _HUMANML3D_JOINTS:
        fps = _HUMANML3D_FPS
    titles = [stem, *(f"{stem} {k + 2}" for k in range(len(people) - 1))]
    return [
        (_points(path, title, values, names, fps or DEFAULT_FPS, said, ()), names is not None)
        for title, values in zip(titles, people, strict=True)
    ]


def _points(
    path: str | Path,
    title: str,
    values: np.ndarray,
    names: tuple[str, ...] | None,
    fps: float,
    said: bool,
    notes: tuple[str, ...],
) -> Points:
    if not said:
        notes = (*notes, f"frame rate: the file does not say it; taken as {fps:g} frames per second")
    return Points(
        Path(path), title, names or tuple(f"point {k + 1}" for k in range(values.shape[1])), values, fps, notes=notes
    )


def _rate(arrays: dict[str, np.ndarray]) -> tuple[float | None, bool]:
    for key in RATES:
        value = arrays.get(key)
        if (
            value is not None
            and value.size == 1
            and value.dtype.kind in "fiu"
            and 0 < float(value.reshape(-1)[0]) < 1e5
        ):
            return float(value.reshape(-1)[0]), True
    return None, False


def _names(arrays: dict[str, np.ndarray], points: str, count: int) -> tuple[str, ...] | None:
    for key in _NAMES:
        value = arrays.get(key)
        if key != points and value is not None and value.dtype.kind in "US" and value.size == count:
            words = [w.decode("latin-1") if isinstance(w, bytes) else str(w) for w in value.reshape(-1)]
            return tuple(word[:256] for word in words)
    return None


def _chosen(path: str | Path, arrays: dict[str, np.ndarray]) -> tuple[str, np.ndarray]:
    """The array that holds points: by its name, else the largest of a fitting shape."""
    fitting = {name: array for name, array in arrays.items() if _fits(array)}
    ranked = sorted(
        fitting, key=lambda name: (POINTS.index(name.lower()) if name.lower() in POINTS else 99, -fitting[name].size)
    )
    if not ranked:
        shapes = ", ".join(f"{name or 'array'} {array.shape}" for name, array in list(arrays.items())[:5])
        expected = "an array of shape (frames, joints, 3), or SMPL poses and trans"
        raise RecordingError(path, f"no array of points ({shapes or 'nothing'})"[:200], expected)
    return ranked[0], fitting[ranked[0]]


def _fits(array: np.ndarray) -> bool:
    if array.dtype.kind not in "fiu" or array.size == 0:
        return False
    if array.ndim == 2:
        return bool(array.shape[1] == HUMANML3D or (array.shape[1] % 3 == 0 and array.shape[1] >= 15))
    shape = array.shape
    return bool(array.ndim in (3, 4) and (shape[-1] in (3, 4) or 3 in shape[1:]) and max(shape) > 4)


def _people(path: str | Path, array: np.ndarray) -> list[np.ndarray]:
    """Arrays ``(n_frames, n_points, 3)``, one for each person."""
    values = as_floats(array)
    if values.ndim == 2:
        values = values.reshape(len(values), -1, 3)
    if values.ndim == 4:
        axis = 0 if values.shape[0] <= values.shape[1] else 1  # fewer people than frames
        several = [np.take(values, k, axis=axis) for k in range(values.shape[axis])]
        if len(several) > 50:
            raise RecordingError(
                path, f"an array of shape {array.shape}", "(frames, joints, 3), for one or a few people"
            )
        return [one for part in several for one in _people(path, part)]
    if values.shape[-1] == 4:  # the last is how sure the tracker was
        values = values[..., :3]
    if values.shape[-1] != 3:
        values = np.moveaxis(values, values.shape.index(3), -1)
        if values.shape[0] < values.shape[1] and values.shape[0] <= 60:
            values = values.swapaxes(0, 1)  # joints before frames
    if values.shape[1] > MOST_POINTS:
        raise RecordingError(
            path, f"an array of shape {array.shape}", f"(frames, joints, 3) with at most {MOST_POINTS} joints"
        )
    return [values]


def as_floats(array: np.ndarray) -> np.ndarray:
    """An array ``(...)`` of numbers as float64, without a word about those that are none."""
    with np.errstate(invalid="ignore", over="ignore"):
        return np.asarray(array, float)


def humanml3d_positions(vectors: np.ndarray) -> np.ndarray:
    """Joints ``(n_frames, 22, 3)``, metres, of HumanML3D's vectors ``(n_frames, 263)`` (Guo et al. 2022, CVPR).

    A vector is the root's turn and steps to the next frame, its height, 21 joints against the root and its facing, and
    what follows from these.
    """
    vectors = as_floats(vectors)
    half = np.concatenate([[0.0], np.cumsum(vectors[:-1, 0])])  # half the angle, as its authors store it
    cos, sin = np.cos(2 * half), np.sin(2 * half)

    def turned(x: np.ndarray, z: np.ndarray, c: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return c * x - s * z, s * x + c * z

    steps = np.concatenate([np.zeros((1, 2)), vectors[:-1, 1:3]])
    x, z = (np.cumsum(part) for part in turned(steps[:, 0], steps[:, 1], cos, sin))
    local = vectors[:, 4:67].reshape(-1, 21, 3)
    away_x, away_z = turned(local[..., 0], local[..., 2], cos[:, None], sin[:, None])
    joints = np.stack([away_x + x[:, None], local[..., 1], away_z + z[:, None]], axis=2)
    return np.concatenate([np.stack([x, vectors[:, 3], z], axis=1)[:, None], joints], axis=1)


def read_points(path: str | Path) -> list[tuple[Points, bool]]:
    """Points of an NPY or NPZ file. Raises RecordingError."""
    return points_of_arrays(path, read_arrays(path))
