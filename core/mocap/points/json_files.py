"""Points in JSON: arrays with names, a list of frames, or one file a frame (OpenPose)."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from core.mocap.errors import RecordingError
from core.mocap.points.figure import MOST_POINTS, Points
from core.mocap.points.tables import rate_of
from core.mocap.points.text_files import DEFAULT_FPS
from core.mocap.reports import Finding
from core.mocap.text import decoded, read_bytes, recording_format

FRAME_FILE = re.compile(r"(?P<take>.*?)[_\-.]?(?P<frame>\d{3,})(_keypoints)?\.json$", re.I)
_FRAMES = (
    "frames",
    "data",
    "motion",
    "poses",
    "results",
    "sequence",
    "instance_info",
    "keypoints",
    "positions",
    "joints",
    "landmarks",
)
_POINTS = (
    *(
        "pose_keypoints_3d",
        "keypoints3d",
        "keypoints_3d",
        "pose_world_landmarks",
        "poseWorldLandmarks",
        "worldLandmarks",
    ),
    *("world_landmarks", "pose_keypoints_2d", "keypoints", "landmarks", "poseLandmarks", "pose_landmarks", "joints"),
    *("positions", "points", "markers", "skeleton", "bodies", "people", "persons", "instances", "pose"),
)
_NAMES = (
    "joint_names",
    "names",
    "jointNames",
    "keypoint_names",
    "keypointNames",
    "labels",
    "joints",
    "keypoints",
    "markers",
)
_RATES = ("fps", "frame_rate", "framerate", "frameRate", "rate", "sample_rate")
_TIMES = ("time", "timestamp", "t", "seconds")
_DEEP = 12  # levels that are looked through

Frame = dict[str, tuple[float, float, float]]


def take_of(path: Path) -> tuple[Path, str, bool] | None:
    """What the files of a take with one JSON file a frame share; None where the name does not end in a number."""
    match = FRAME_FILE.fullmatch(path.name)
    return (path.parent, match["take"], bool(match[3])) if match else None


def in_order(files: Iterable[Path]) -> list[Path]:
    """Files of a take in the order of their frames."""
    return sorted(files, key=lambda file: (_number(file), file))


def _number(path: Path) -> int:
    match = FRAME_FILE.fullmatch(path.name)
    return int(match["frame"]) if match else 0


def frame_files(path: Path) -> list[Path]:
    """The files of a take that has one JSON file a frame, in the order of their numbers; only ``path`` where it is
    alone."""
    take = take_of(path)
    return in_order(other for other in path.parent.glob("*.json") if take_of(other) == take) if take else [path]


def is_frame_file(path: Path) -> bool:
    """Whether a file is one frame of a take by its name: ``walk_000000000012_keypoints.json``."""
    match = FRAME_FILE.fullmatch(path.name)
    return match is not None and bool(match[3])


def holds_points(document: Any) -> bool:
    """Whether a JSON document is frames of points."""
    if _whole_array(document)[0] is not None:
        return True
    frames, _ = _list_of_frames(document)
    return sum(frame is not None for frame in frames) >= 2


def read_json(path: str | Path) -> tuple[Points, bool]:
    """Points of a JSON file, or of all files of its take, and whether they have names. Raises RecordingError."""
    path = Path(path)
    document, take = _document(path), take_of(path)
    if take and (is_frame_file(path) or not holds_points(document)):  # else it is numbered, and a recording by itself
        files = frame_files(path)
        if len(files) > 1 and _points_of_frame(_document(files[0])) is not None:
            frames = [_points_of_frame(_document(file)) for file in files]
            note = f"{len(files)} files, each a frame"
            return _of_frames(path, take[1] or path.parent.name, frames, None, None, (note,))
    name = recording_format(path)[0]
    fps = _rate(document)
    array, names = _whole_array(document)
    if array is not None:
        values, flat = _three(array)
        count = values.shape[1]
        known = names is not None and len(names) == count
        titles = (
            tuple(map(str, names)) if known and names is not None else tuple(f"point {k + 1}" for k in range(count))
        )
        return _points(path, name, titles, values, fps, flat), known
    frames, times = _list_of_frames(document)
    if not frames:
        raise RecordingError(path, "no points in this JSON", "frames of joints with x, y and z")
    return _of_frames(path, name, frames, fps or rate_of(np.array(times)), names, ())


def _document(path: Path) -> Any:
    try:
        return json.loads(decoded(read_bytes(path)))
    except (ValueError, RecursionError) as error:
        raise RecordingError(path, f"not JSON ({' '.join(str(error).split())[:80]})", "a JSON file") from None


def _rate(document: Any) -> float | None:
    places = (
        [document, *(document.get(k) for k in ("info", "meta", "metadata", "header"))]
        if isinstance(document, Mapping)
        else []
    )
    for place in (p for p in places if isinstance(p, Mapping)):
        for key in _RATES:
            value = place.get(key)
            if isinstance(value, int | float) and 0 < value < 1e5:
                return float(value)
    return None


def _whole_array(document: Any) -> tuple[np.ndarray | None, list[str] | None]:
    """Positions (n_frames, n_points, 2 to 4) where they are one array, and the names of the points."""
    if isinstance(document, list):
        return _array(document), None
    if not isinstance(document, Mapping):
        return None, None
    names = next((v for k in _NAMES if _are_names(v := document.get(k))), None)
    for key in (*_POINTS, *_FRAMES):
        if (array := _array(document.get(key))) is not None:
            return array, names
    columns = {k: a for k, v in document.items() if (a := _track(v)) is not None}  # a track for each joint
    lengths = {len(a) for a in columns.values()}
    if len(columns) >= 3 and len(lengths) == 1:
        return np.stack(list(columns.values()), axis=1), list(columns)
    for key in _FRAMES:
        if isinstance(document.get(key), Mapping):
            array, own = _whole_array(document[key])
            if array is not None:
                return array, own or names
    return None, names


def _are_names(value: Any) -> bool:
    return isinstance(value, list) and len(value) >= 3 and all(isinstance(v, str) for v in value)


def _array(value: Any) -> np.ndarray | None:
    """An array (n_frames, n_points, 2 to 4), or None."""
    if (
        not isinstance(value, list)
        or not value
        or not isinstance(value[0], list)
        or not value[0]
        or not isinstance(value[0][0], list)
    ):
        return None
    try:
        array = np.array(value, float)  # null becomes NaN
    except (ValueError, TypeError, OverflowError):
        return None
    return array if array.ndim == 3 and 2 <= array.shape[2] <= 4 else None


def _track(value: Any) -> np.ndarray | None:
    """The places (n_frames, 3) of a single joint, or None."""
    if not isinstance(value, list) or not value or not isinstance(value[0], list) or len(value[0]) != 3:
        return None
    try:
        array = np.array(value, float)
    except (ValueError, TypeError, OverflowError):
        return None
    return array if array.ndim == 2 else None


def _three(array: np.ndarray) -> tuple[np.ndarray, bool]:
    """Positions with three coordinates, and whether the third had to be made up. The fourth is how sure one was."""
    if array.shape[2] == 2:
        return np.concatenate([array, np.zeros((*array.shape[:2], 1))], axis=2), True
    return array[..., :3], False


def _list_of_frames(document: Any) -> tuple[list[Frame | None], list[float]]:
    entries = document
    if isinstance(document, Mapping):
        entries = next((document[k] for k in _FRAMES if isinstance(document.get(k), list)), None)
        if entries is None:
            inner = next((document[k] for k in _FRAMES if isinstance(document.get(k), Mapping)), document)
            numbered = [k for k in inner if str(k).isdigit()]
            entries = [inner[k] for k in sorted(numbered, key=int)] if len(numbered) >= 2 else None
    if not isinstance(entries, list):
        one = _points_of_frame(document)
        return ([one] if one else []), []
    times = [float(e[k]) for e in entries if isinstance(e, Mapping) for k in _TIMES if _is_time(e.get(k))]
    frames = [_points_of_frame(entry) for entry in entries]
    return (frames if any(frames) else []), times


def _is_time(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e15


def _points_of_frame(entry: Any, deep: int = 0) -> Frame | None:
    """The points of a frame by name (by number where they have none); of several people the first."""
    if deep > _DEEP:
        return None
    if isinstance(entry, list):
        return _points_of_list(entry, deep)
    if not isinstance(entry, Mapping):
        return None
    named = {str(k): p for k, v in entry.items() if (p := _point(v)) is not None}
    if len(named) >= 3:
        return named
    for key in (*_POINTS, "joint_positions", "data", "body"):
        if key in entry and (found := _points_of_frame(entry[key], deep + 1)):
            return found
    return None


def _points_of_list(entry: list[Any], deep: int) -> Frame | None:
    if len(entry) >= 9 and all(isinstance(v, int | float) for v in entry):
        return _flat(entry)
    points = [_point(v) for v in entry]
    if sum(p is not None for p in points) >= 3:
        named = [v.get("name") or v.get("joint") or v.get("label") if isinstance(v, Mapping) else None for v in entry]
        return {
            str(n or f"point {k + 1}"): p for k, (n, p) in enumerate(zip(named, points, strict=True)) if p is not None
        }
    return next((found for v in entry[:8] if (found := _points_of_frame(v, deep + 1))), None)


def _flat(numbers: list[float]) -> Frame | None:
    """Numbers in threes (x, y, z, or x, y and how sure) or fours (x, y, z and how sure)."""
    size = 4 if len(numbers) % 3 else 3
    if len(numbers) % size or len(numbers) // size > MOST_POINTS:
        return None
    rows = [numbers[k : k + size] for k in range(0, len(numbers), size)]
    sure = all(0 <= row[-1] <= 1.0001 for row in rows) and max(abs(row[0]) for row in rows) > 3
    points: Frame = {}
    for k, row in enumerate(rows):
        lost = not any(row[:2])
        third = 0.0 if size == 3 and sure else row[2]
        points[f"point {k + 1}"] = (np.nan,) * 3 if lost else (float(row[0]), float(row[1]), float(third))
    return points


def _point(value: Any) -> tuple[float, float, float] | None:
    """A point as [x, y, z] or {"x": ..}; NaN for what is null; None for what is no point."""
    if isinstance(value, Mapping):
        lower = {str(k).lower(): v for k, v in value.items()}
        if "x" not in lower or "y" not in lower:
            inner = next((lower[k] for k in ("position", "pos", "xyz", "coordinates", "location") if k in lower), None)
            return _point(inner) if inner is not None else None
        value = [lower["x"], lower["y"], lower.get("z", 0.0)]
    if not isinstance(value, list | tuple) or not 2 <= len(value) <= 4:
        return None
    if not all(v is None or (isinstance(v, int | float) and not isinstance(v, bool)) for v in value):
        return None
    x, y, z = (np.nan if v is None else _float(v) for v in (*value, 0.0)[:3])
    return x, y, z


def _float(value: int | float) -> float:
    try:
        return float(value)
    except OverflowError:
        return float("nan")


def _of_frames(
    path: str | Path,
    name: str,
    frames: Sequence[Frame | None],
    fps: float | None,
    names: Sequence[str] | None,
    notes: tuple[str, ...],
) -> tuple[Points, bool]:
    keys = list(dict.fromkeys(key for frame in frames if frame for key in frame))[: MOST_POINTS + 1]
    index = {key: k for k, key in enumerate(keys)}
    values = np.full((len(frames), len(keys), 3), np.nan)
    for f, frame in enumerate(frames):
        for key, point in (frame or {}).items():
            if key in index:
                values[f, index[key]] = point
    numbered = all(key.startswith("point ") for key in keys)
    if numbered and names is not None and len(names) == len(keys):
        keys, numbered = list(map(str, names)), False
    flat = bool((values[..., 2][~np.isnan(values[..., 2])] == 0).all())
    return _points(path, name, tuple(key[:256] for key in keys), values, fps, flat, notes), not numbered


def _points(
    path: str | Path,
    name: str,
    names: tuple[str, ...],
    values: np.ndarray,
    fps: float | None,
    flat: bool,
    notes: tuple[str, ...] = (),
) -> Points:
    if fps is None:
        notes = (*notes, f"frame rate: the file does not say it; taken as {DEFAULT_FPS:g} frames per second")
    findings = (
        (Finding("flat", "the points have two coordinates only, as in a picture: depth is taken as 0"),) if flat else ()
    )
    return Points(Path(path), name, names, values, fps or DEFAULT_FPS, notes=notes, findings=findings)
