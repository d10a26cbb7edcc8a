"""Files of points: which they are, and the clips they become."""

from __future__ import annotations

import gzip
import json
import re
import tokenize
import zipfile
import zlib
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.mocap.clip import Clip
from core.mocap.points import array_files, csv_files, json_files, text_files
from core.mocap.points.figure import Points, clip_of
from core.mocap.points.meaning import understood
from core.mocap.text import decoded

FORMATS = (".trc", ".csv", ".tsv", ".txt", ".json", ".npy", ".npz")
MAYBE = (".csv", ".tsv", ".txt", ".json", ".npy", ".npz")
"""Endings that say nothing by themselves: such a file is a recording where its beginning is one."""
_LOOKED_AT = 1 << 18  # bytes
_POSES = {"poses", "smpl_poses", "pose_body", "full_pose", "body_pose", "posed_joints", "global_rot_mats"}
_TABLES = (".csv", ".tsv", ".txt")


def read_points(
    path: str | Path, ending: str, fps: float | None = None, preset: str | None = None, smooth: float | None = None
) -> tuple[Clip, ...]:
    """The clips of a file of points, one for each person in it.

    ending: of the file's name. fps: in place of what the file says. preset: which points they are
    (core.mocap.points.presets); smooth: cut-off in Hz. Raises RecordingError.
    """
    clips = []
    for points, named in _points(path, ending):
        if fps:
            points = _at_rate(points, fps)
        clips.append(clip_of(understood(points, preset, named), smooth))
    return tuple(clips)


def _at_rate(points: Points, fps: float) -> Points:
    notes = tuple(note for note in points.notes if not note.startswith("frame rate: "))
    return replace(points, fps=float(fps), notes=notes)


def _points(path: str | Path, ending: str) -> list[tuple[Points, bool]]:
    if ending == ".trc":
        return [(text_files.read_trc(path), True)]
    if ending == ".json":
        return [json_files.read_json(path)]
    if ending in (".npy", ".npz"):
        return array_files.read_points(path)
    if text_files.is_numbered_rows(_beginning(Path(path))):
        return [(text_files.read_numbered_rows(path), False)]
    points = csv_files.read_csv(path)
    return [(points, not all(re.fullmatch(r"point \d+", name) for name in points.names))]


def holds_points(path: Path, ending: str) -> bool:
    """Whether a file whose ending says nothing begins as a recording of points, or of poses, does."""
    if ending == ".json" and json_files.is_frame_file(path):
        return True
    try:
        if ending == ".npy":
            return _npy_fits(path)
        if ending == ".npz":
            return _npz_fits(path)
        head = _beginning(path)
    except (OSError, ValueError, EOFError, zipfile.BadZipFile, zlib.error, tokenize.TokenError, SyntaxError):
        return False
    if ending == ".json":
        return _json_fits(path, head)
    if text_files.is_numbered_rows(head) or csv_files.is_tidy(head):
        return True
    return csv_files.layout_of(_whole_lines(head)) is not None


def _beginning(path: Path) -> str:
    opener = gzip.open if path.name.lower().endswith(".gz") else open
    with opener(path, "rb") as file:
        data: bytes = file.read(_LOOKED_AT)
    if b"\0" in data[:4096] and not data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return ""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data[: len(data) // 2 * 2].decode("utf-16", "replace")
    return decoded(data.removeprefix(b"\xef\xbb\xbf").replace(b"\r\n", b"\n").replace(b"\r", b"\n"))


def _whole_lines(head: str) -> str:
    return head if len(head) < _LOOKED_AT else head.rpartition("\n")[0]


def _npy_fits(path: Path) -> bool:
    with path.open("rb") as file:
        if file.read(6) != b"\x93NUMPY":
            return False
        file.seek(0)
        version = np.lib.format.read_magic(file)
        shape, _, dtype = (
            np.lib.format.read_array_header_1_0(file)
            if version == (1, 0)
            else np.lib.format.read_array_header_2_0(file)
        )
    if dtype.kind not in "fiu":
        return False
    return (len(shape) in (3, 4) and 3 in shape[1:] and shape[0] > 1) or (
        len(shape) == 2 and shape[1] == array_files.HUMANML3D
    )


def _npz_fits(path: Path) -> bool:
    """By the names of its arrays: features that this product exports, for example, are no recording."""
    with zipfile.ZipFile(path) as archive:
        names = {name.removesuffix(".npy").lower() for name in archive.namelist()}
    if names & _POSES:
        return True
    if names & {"columns", "splits", "weights", "betas_only"}:
        return False
    return bool(names & {*array_files.POINTS, "arr_0"})


def _json_fits(path: Path, head: str) -> bool:
    """Whether a JSON file begins as frames of points do; small ones are read whole."""
    if re.match(r'\s*\{\s*"format"\s*:\s*"motionscape/', head) or not re.match(r"\s*[\[{]", head):
        return False
    if path.stat().st_size <= _LOOKED_AT:
        try:
            return json_files.holds_points(json.loads(head))
        except (ValueError, RecursionError):
            return False
    words = re.findall(r'"(\w+)"\s*:', head[:20000])
    numbers = len(re.findall(r"-?\d+\.\d+", head[:20000]))
    return numbers > 60 and (not words or numbers > len(words) / 4)
