"""The readers of all formats, and which files they are for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

from core.mocap.bvh import read_bvh_clips
from core.mocap.c3d import read_c3d
from core.mocap.clip import Clip
from core.mocap.gltf import read_gltf
from core.mocap.mvnx import read_mvnx
from core.mocap.opensim import read_opensim
from core.mocap.points import reading as points
from core.mocap.points.array_files import read_arrays
from core.mocap.points.json_files import in_order, is_frame_file, take_of
from core.mocap.reading import Reading
from core.mocap.smpl import holds_poses, read_poses
from core.mocap.text import recording_format

Reader = Callable[[Path, str, Reading], tuple[Clip, ...]]


def _bvh(path: Path, _ending: str, how: Reading) -> tuple[Clip, ...]:
    return read_bvh_clips(path, fps=how.fps)


def _points(path: Path, ending: str, how: Reading) -> tuple[Clip, ...]:
    return points.read_points(path, ending, how.fps, how.points, how.smooth)


def _npz(path: Path, ending: str, how: Reading) -> tuple[Clip, ...]:
    arrays = read_arrays(path)
    return (read_poses(path, arrays, how.fps),) if holds_poses(set(arrays)) else _points(path, ending, how)


def _c3d(path: Path, _ending: str, how: Reading) -> tuple[Clip, ...]:
    return read_c3d(path, how.fps, how.points, how.smooth)


def _gltf(path: Path, _ending: str, how: Reading) -> tuple[Clip, ...]:
    return read_gltf(path, how.fps)


def _mvnx(path: Path, _ending: str, how: Reading) -> tuple[Clip, ...]:
    return read_mvnx(path, how.fps)


def _opensim(path: Path, _ending: str, how: Reading) -> tuple[Clip, ...]:
    return read_opensim(path, how.fps)


READERS: dict[str, Reader] = {
    ".bvh": _bvh,
    ".c3d": _c3d,
    **dict.fromkeys((".glb", ".gltf", ".vrm", ".vrma"), _gltf),
    **dict.fromkeys(points.FORMATS, _points),
    ".npz": _npz,
    ".mvnx": _mvnx,
    ".mot": _opensim,
    ".sto": _opensim,
}
"""How a file's name ends -> its reader. AMC files, which need a skeleton beside them, have their own way."""
FORMATS = (*READERS, ".amc")
BESIDE = (".asf", ".bin")  # skeletons of AMC, buffers of glTF
_MAYBE = points.MAYBE  # endings that many other files have
NAMED = "BVH, ASF/AMC, C3D, glTF (GLB, VRM, VRMA), MVNX, MOT, STO, TRC, CSV, NPY, NPZ or JSON"
"""The formats in words, for messages."""


def is_recording(path: str | Path) -> bool:
    """Whether a file is a recording: by its name and, where that may be anything, by how it begins."""
    ending = recording_format(path)[1]
    if ending not in _MAYBE:
        return ending in FORMATS
    try:
        facts = Path(path).stat()
    except OSError:
        return False
    return _begins_as_one(str(path), ending, facts.st_mtime_ns, facts.st_size)


@lru_cache(maxsize=4096)
def _begins_as_one(path: str, ending: str, _changed: int, size: int) -> bool:
    return size > 0 and points.holds_points(Path(path), ending)


def without_later_frames(paths: Sequence[Path]) -> list[Path]:
    """``paths`` with only the first file of each take that has one file a frame."""
    takes: dict[Any, list[Path]] = {}
    for path in filter(is_frame_file, paths):
        takes.setdefault(take_of(path), []).append(path)
    later = {path for files in takes.values() for path in in_order(files)[1:]}
    return [path for path in paths if path not in later]


def read_clips(path: Path, how: Reading) -> tuple[Clip, ...]:
    """The clips of a file of any format but AMC, as its reader gives them. Raises RecordingError."""
    ending = recording_format(path)[1]
    return READERS[ending](path, ending, how)
