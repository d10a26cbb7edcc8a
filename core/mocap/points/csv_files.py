"""Points in tables: a column for each coordinate of each point, or a row for each point of each frame.

Headers in one row (``nose_x``, ``LeftHand.X``, ``x_nose``), in several (DeepLabCut, Motive: names above axes), or none
where the number of columns speaks for itself.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np

from core.mocap.errors import RecordingError
from core.mocap.points.figure import Points
from core.mocap.points.naming import presets_of_count
from core.mocap.points.tables import cells_of, divider_of, is_number, rate_of, read_table
from core.mocap.points.text_files import DEFAULT_FPS
from core.mocap.reports import Finding
from core.mocap.text import decoded, read_bytes, recording_format
from core.mocap.units import UNITS

_HEAD_ROWS = 12  # in which a header may stand
_TIMES = ("time", "timestamp", "times", "t", "seconds", "sec", "timeseconds", "times)", "ms", "timems")
_FRAMES = ("frame", "framenumber", "frameno", "frameid", "fnum", "index", "frameindex")
_NAMES = ("keypoint", "joint", "landmark", "marker", "bodypart", "name", "point", "jointname", "keypointname", "label")
_AXIS_LAST = re.compile(
    r"(?P<name>.+?)[ _.:/|\-]*\(?(?P<axis>[xyz])\)?(?:[ _.]*[\[(]?(?P<unit>mm|cm|dm|m)[\])]?)?", re.I
)
_AXIS_FIRST = re.compile(r"(?P<axis>[xyz])[ _.:\-]+(?P<name>.+)", re.I)
_NO_POINT = re.compile(r"(rot|rotation|quat|q|euler|angle|velocity|vel|acc|std|var|err|error|score|conf)[ _.]*$", re.I)
_FEWEST = 3  # points that make a table of points


class Layout(NamedTuple):
    """Where points stand in a table. columns: (n_points, 3), -1 where an axis has none; first: rows of the header."""

    names: tuple[str, ...]
    columns: np.ndarray
    first: int
    divider: str
    width: int
    time: int = -1
    fps: float | None = None
    unit: float | None = None


def layout_of(head: str) -> Layout | None:
    """The layout of a table that begins with ``head``; None where it is no table of points in columns."""
    lines = head.split("\n")[: _HEAD_ROWS + 3]
    filled = [line for line in lines if line.strip()]
    if not filled:
        return None
    divider = divider_of(filled[-2:] if len(filled) > 2 else filled)
    rows = [cells_of(line, divider) for line in lines]
    first = next((k for k, row in enumerate(rows) if _is_data(row)), None)
    if first is None:
        return None
    width = max(len(row) for row in rows[: first + 3])
    if first == 0:
        return _without_header(rows, divider)
    return _one_row(rows, first, divider, width) or _several_rows(rows, first, divider, width)


def _is_data(row: Sequence[str]) -> bool:
    cells = [cell for cell in row if cell]
    return len(cells) >= 4 and sum(map(is_number, cells)) >= max(3, 0.6 * len(cells)) and not _many_integers(row)


def _many_integers(row: Sequence[str]) -> bool:
    """A row 0, 1, 2, 3 ... names columns."""
    cells = [cell for cell in row if cell]
    return all(cell.isdigit() for cell in cells) and [int(c) for c in cells] == list(
        range(int(cells[0]), int(cells[0]) + len(cells))
    )


def _without_header(rows: Sequence[Sequence[str]], divider: str) -> Layout | None:
    """Columns that are points of a known list, behind at most two others (a frame's number, a time)."""
    width = len(rows[0])
    for lead in (0, 1, 2):
        count, rest = divmod(width - lead, 3)
        if not rest and presets_of_count(count):
            columns = lead + np.arange(3 * count).reshape(count, 3)
            return Layout(tuple(f"point {k + 1}" for k in range(count)), columns, 0, divider, width)
    return None


def _one_row(rows: Sequence[Sequence[str]], first: int, divider: str, width: int) -> Layout | None:
    """Names and axes in one cell, in the last row before the numbers (empty rows aside)."""
    header = next((rows[k] for k in range(first - 1, -1, -1) if any(rows[k])), [])
    found: dict[str, list[int]] = {}
    unit = None
    for column, cell in enumerate(header):
        match = _AXIS_LAST.fullmatch(cell) or _AXIS_FIRST.fullmatch(cell)
        if not match or _NO_POINT.search(match["name"]):
            continue
        places = found.setdefault(match["name"].strip(" _.:-"), [-1, -1, -1])
        places["xyz".index(match["axis"].lower())] = column
        unit = unit or (match.groupdict().get("unit") or "").lower()
    return _layout(found, rows, header, first, divider, width, unit)


def _several_rows(rows: Sequence[Sequence[str]], first: int, divider: str, width: int) -> Layout | None:
    """A row of axes, and above it one with the names (DeepLabCut, Motive), which may stand once for three cells."""
    axes = next(
        (k for k in range(first - 1, -1, -1) if sum(c.lower() in ("x", "y", "z") for c in rows[k]) >= 3 * _FEWEST), -1
    )
    if axes < 0:
        return None
    above = [rows[k] for k in range(axes) if any(rows[k])]
    kinds = next((row for row in reversed(above) if sum(c.lower() in ("position", "rotation") for c in row) >= 3), None)
    best: dict[str, list[int]] = {}
    for row in (r for r in above if r is not kinds):
        found: dict[str, list[int]] = {}
        name = ""
        for column, axis in enumerate(rows[axes]):
            name = row[column] if column < len(row) and row[column] else name
            wanted = kinds is None or (column < len(kinds) and kinds[column].lower() == "position")
            if axis.lower() in ("x", "y", "z") and name and wanted:
                places = found.setdefault(name, [-1, -1, -1])
                if places["xyz".index(axis.lower())] < 0:
                    places["xyz".index(axis.lower())] = column
        whole = sum(min(p[:2]) >= 0 for p in found.values())
        if whole > sum(min(p[:2]) >= 0 for p in best.values()) or (whole == len(best) and _reads_better(found, best)):
            best = found
    best = {name.rsplit(":", 1)[-1] if kinds is not None else name: p for name, p in best.items()}
    return _layout(best, rows, rows[axes], first, divider, width, None)


def _reads_better(found: dict[str, list[int]], best: dict[str, list[int]]) -> bool:
    """Names rather than numbers of markers or long ids."""
    return sum(map(len, found)) < sum(map(len, best)) and not all(is_number(name) for name in found)


def _layout(
    found: dict[str, list[int]],
    rows: Sequence[Sequence[str]],
    header: Sequence[str],
    first: int,
    divider: str,
    width: int,
    unit: str | None,
) -> Layout | None:
    whole = {name: places for name, places in found.items() if min(places[:2]) >= 0}
    if len(whole) < _FEWEST:
        return None
    time = next((k for k, cell in enumerate(header) if re.sub(r"[^a-z]", "", cell.lower()) in _TIMES), -1)
    facts: dict[str, str] = {}
    for row in rows[:first]:  # Motive: names and values side by side in the first row
        facts |= {re.sub(r"[^a-z]", "", a.lower()): b for a, b in pairwise(row) if a}
    rate = next((facts[key] for key in ("exportframerate", "captureframerate", "framerate", "fps") if key in facts), "")
    word = {"meters": "m", "millimeters": "mm", "centimeters": "cm"}.get(
        facts.get("lengthunits", "").lower(), unit or ""
    )
    return Layout(
        tuple(whole),
        np.array(list(whole.values())),
        first,
        divider,
        max(width, len(header)),
        time,
        float(rate) if is_number(rate) and float(rate) > 0 else None,
        UNITS[word][0] if word in UNITS else None,
    )


def read_csv(path: str | Path) -> Points:
    """Points of a table. Raises RecordingError for what is no table of points."""
    data = read_bytes(path)
    head = decoded(data[: 1 << 18])
    name = recording_format(path)[0]
    if is_tidy(head):
        return _tidy(Path(path), name, data)
    layout = layout_of(head)
    if layout is None:
        expected = "columns such as nose_x, nose_y, nose_z, or a row for each joint with frame, name, x, y, z"
        raise RecordingError(path, "not a recording: no columns of points", expected, 1)
    body = data.split(b"\n", layout.first)[-1] if layout.first else data
    numeric = _numbers_only(body, layout.divider, layout.width)
    table = read_table(path, numeric, layout.first + 1, layout.divider, layout.width)
    if not len(table):
        raise RecordingError(path, "no frames below the header", "rows of numbers", layout.first + 1)
    values = np.where(layout.columns[None] >= 0, table[:, np.maximum(layout.columns, 0)], 0.0)
    flat = layout.columns.min() < 0
    findings = (Finding("flat", "some points have two coordinates only: the third is taken as 0"),) if flat else ()
    fps = layout.fps or (rate_of(table[:, layout.time]) if layout.time >= 0 else None)
    notes = () if fps else (f"frame rate: the file does not say it; taken as {DEFAULT_FPS:g} frames per second",)
    return Points(
        Path(path), name, layout.names, values, fps or DEFAULT_FPS, layout.unit, notes=notes, findings=findings
    )


def _numbers_only(body: bytes, divider: str, width: int) -> bytes:
    """The rows without the text of columns that are no numbers (a subject's name, a date)."""
    first = cells_of(decoded(body[: 1 << 16].split(b"\n", 1)[0]), divider)
    words = [
        k
        for k, cell in enumerate(first)
        if cell and not is_number(cell) and cell.lower() not in ("nan", "null", "none", "na")
    ]
    if not words or divider == " ":
        return body
    mark = divider.encode()
    rows = []
    for line in body.split(b"\n"):
        cells = line.split(mark)
        for k in words:
            if k < len(cells):
                cells[k] = b""
        rows.append(mark.join(cells))
    return b"\n".join(rows)


def is_tidy(head: str) -> bool:
    """Whether a table has a row for each point of each frame: frame, name, x, y, z."""
    return _tidy_columns(head) is not None


def _tidy_columns(head: str) -> tuple[str, dict[str, str]] | None:
    first = head.split("\n", 1)[0]
    divider = divider_of([first])
    plain = {re.sub(r"[^a-z]", "", cell.lower()): cell for cell in cells_of(first, divider)}
    frame = next((plain[word] for word in _FRAMES if word in plain), None)
    name = next((plain[word] for word in _NAMES if word in plain), None)
    if frame is None or name is None or not {"x", "y"} <= plain.keys() or divider == " ":
        return None
    columns = {"frame": frame, "name": name} | {axis: plain[axis] for axis in "xyz" if axis in plain}
    time = next((plain[word] for word in _TIMES if word in plain), None)
    return divider, columns | ({"time": time} if time else {})


def _tidy(path: Path, name: str, data: bytes) -> Points:
    import pyarrow as pa  # starts a thread, and a worker that forks may have none
    from pyarrow import csv

    found = _tidy_columns(decoded(data[: 1 << 16]))
    assert found is not None
    divider, columns = found
    kinds = {column: pa.string() if key == "name" else pa.float64() for key, column in columns.items()}
    try:
        table = csv.read_csv(
            pa.py_buffer(data),
            parse_options=csv.ParseOptions(delimiter=divider),
            convert_options=csv.ConvertOptions(column_types=kinds, include_columns=list(columns.values())),
        )
    except (pa.ArrowInvalid, pa.ArrowKeyError, pa.ArrowNotImplementedError) as error:
        raise RecordingError(path, " ".join(str(error).split())[:120], "numbers in frame, x, y, z") from None
    frame = table.column(columns["frame"]).to_numpy().astype(float)
    words = np.array(table.column(columns["name"]).to_pylist(), dtype=object)
    known = np.isfinite(frame) & np.array([bool(word) for word in words], bool)
    if not known.any():
        raise RecordingError(path, "no frames below the header", "rows of frame, name, x, y, z", 2)
    frames, row = np.unique(frame[known], return_inverse=True)
    names = list(dict.fromkeys(words[known]))
    index = {word: k for k, word in enumerate(names)}
    if len(frames) * len(names) > 40 * len(frame) + 1000:
        raise RecordingError(
            path, f"{len(names)} names and {len(frames)} frames in {len(frame)} rows", "most points in most frames"
        )
    values = np.full((len(frames), len(names), 3), np.nan)
    point = np.array([index[word] for word in words[known]])
    for axis, letter in enumerate("xyz"):
        values[row, point, axis] = table.column(columns[letter]).to_numpy()[known] if letter in columns else 0.0
    fps = None
    if "time" in columns:
        times = table.column(columns["time"]).to_numpy()[known]
        fps = rate_of(np.array([times[row == k][0] for k in range(min(len(frames), 200))]))
    notes = () if fps else (f"frame rate: the file does not say it; taken as {DEFAULT_FPS:g} frames per second",)
    return Points(path, name, tuple(map(str, names)), values, fps or DEFAULT_FPS, notes=notes)
