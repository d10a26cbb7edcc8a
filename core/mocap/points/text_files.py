"""Points in text files: TRC, tables with a header (CSV), and UTKinect's rows of numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np

from core.mocap.errors import RecordingError
from core.mocap.points.figure import Points
from core.mocap.points.tables import cells_of, divider_of, is_number, rate_of, read_table
from core.mocap.reports import Finding
from core.mocap.text import decoded, read_bytes, recording_format
from core.mocap.units import UNITS

DEFAULT_FPS = 30.0
_TRC_UNITS = {"meters": "m", "meter": "m", "metres": "m", "millimeters": "mm", "millimetres": "mm", "centimeters": "cm"}
_UTKINECT_NUMBERS_A_SECOND = 30.0
_MOST_ROWS = 2_000_000  # frames that gaps in the numbers of frames may grow to


def read_trc(path: str | Path) -> Points:
    """Points of a TRC file (Motion Analysis, OpenSim). Raises RecordingError for what is none."""
    data = read_bytes(path)
    lines = decoded(data[: 1 << 20]).split("\n")
    top = next((k for k, line in enumerate(lines[:12]) if re.match(r'\W*frame\s*#?"?\s*[\t, ;]', line, re.I)), None)
    if top is None or top < 1:
        raise RecordingError(path, "no line with the names of the markers", "a TRC file with 'Frame#' and 'Time'", 1)
    divider = divider_of(lines[top : top + 1])
    head = _trc_head(lines[:top])
    names, columns, first = _trc_columns(path, lines, top, divider)
    width = max([2, *(c + 3 for c in columns)])
    body = data.split(b"\n", first)[-1] if first < len(lines) else b""
    values = read_table(path, body, first + 1, divider, max(width, _widest(body, divider)))
    if not len(values):
        raise RecordingError(path, "no frames after the names of the markers", "rows of numbers", first + 1)
    findings = []
    stated = head.get("numframes")
    if stated is not None and stated.isdigit() and int(stated) != len(values):
        findings.append(Finding("rows", f"NumFrames says {stated}; the file has {len(values)}, and all were read"))
    fps = _number(head.get("datarate")) or rate_of(values[:, 1]) or DEFAULT_FPS
    points = np.stack([values[:, [c, c + 1, c + 2]] for c in columns], axis=1)
    return Points(Path(path), recording_format(path)[0], names, points, fps, _trc_unit(head), findings=tuple(findings))


def _trc_head(lines: Sequence[str]) -> dict[str, str]:
    """The values of the head by their names in small letters."""
    for names, values in pairwise(lines):
        if "datarate" in names.lower():
            divider = divider_of([names])
            keys = [cell.lower() for cell in cells_of(names, divider) if cell]
            cells = [cell for cell in cells_of(values, divider) if cell]
            return dict(zip(keys, cells, strict=False))
    return {}


def _trc_unit(head: dict[str, str]) -> float | None:
    word = head.get("units", "").lower()
    word = _TRC_UNITS.get(word, word)
    return UNITS[word][0] if word in UNITS else None


def _trc_columns(
    path: str | Path, lines: Sequence[str], top: int, divider: str
) -> tuple[tuple[str, ...], list[int], int]:
    """Names of the markers, where the X of each stands, and the number of lines before the first row."""
    cells = cells_of(lines[top], divider)
    named = [(c, cell) for c, cell in enumerate(cells) if cell and c >= 2]
    axes = cells_of(lines[top + 1], divider) if top + 1 < len(lines) else []
    has_axes = any(re.fullmatch(r"x\d*", cell, re.I) for cell in axes)
    first = top + 2 if has_axes else top + 1
    if has_axes:
        shift = 2 if divider == " " else 0  # blanks show no empty cells
        columns = [c + shift for c, cell in enumerate(axes) if re.fullmatch(r"x\d*", cell, re.I)]
        at_names = [c for c, _ in named]
        if divider != " " and set(columns) <= set(at_names):
            named = [(c, name) for c, name in named if c in columns]
    else:
        columns = [2 + 3 * k for k in range(len(named))]
    if not named:
        raise RecordingError(path, "no names of markers", "names after 'Frame#' and 'Time'", top + 1)
    if len(named) < len(columns):
        columns = columns[: len(named)]
    return tuple(name for _, name in named[: len(columns)]), columns, first


def _widest(body: bytes, divider: str) -> int:
    """Cells of the longest of the first rows."""
    return max((len(cells_of(line, divider)) for line in decoded(body[: 1 << 16]).split("\n")[:20]), default=0)


def _number(word: str | None) -> float | None:
    value = float(word) if word and is_number(word) else 0.0
    return value if value > 0 else None


def is_numbered_rows(head: str) -> bool:
    """Whether a text is rows of a frame's number and 20 points, as UTKinect writes them."""
    rows = [line.split() for line in head.split("\n")[:5] if line.strip()]
    return bool(rows) and all(len(row) == 61 and all(map(is_number, row)) for row in rows[:-1] or rows)


def read_numbered_rows(path: str | Path) -> Points:
    """UTKinect's text: a frame's number and 20 points a row.

    Numbers count at 30 a second and leave out frames, so every row is put at its own time, and what lies between is
    filled. Raises RecordingError.
    """
    data = read_bytes(path)
    if not is_numbered_rows(decoded(data[: 1 << 16])):
        raise RecordingError(path, "no rows of points", "a number and 20 times x, y, z in every row", 1)
    table = read_table(path, data, 1, " ", 61)
    numbers, points = table[:, 0], table[:, 1:].reshape(len(table), 20, 3)
    if np.isnan(numbers).any() or (np.diff(numbers) < 0).any() or numbers[-1] - numbers[0] > _MOST_ROWS:
        raise RecordingError(path, "numbers of frames that do not rise", "a frame's number in front of every row")
    whole, first, times_seen = np.unique(numbers, return_index=True, return_counts=True)
    once = np.add.reduceat(points, first, axis=0) / times_seen[:, None, None]
    times = np.arange(whole[0], whole[-1] + 1)
    flat = once.reshape(len(once), -1)
    even = np.stack([np.interp(times, whole, column) for column in flat.T], axis=1).reshape(len(times), 20, 3)
    note = (
        f"{len(table)} rows for frames {whole[0]:g} to {whole[-1]:g}: each stands at its number, counted from the "
        "first; frames between are filled"
    )
    findings = tuple(
        Finding("gap", f"no row for {(b - a) / _UTKINECT_NUMBERS_A_SECOND:.1f} s", int(a - whole[0]), int(b - whole[0]))
        for a, b in pairwise(whole)
        if b - a > _UTKINECT_NUMBERS_A_SECOND / 2
    )
    names = tuple(f"point {k + 1}" for k in range(20))
    fps = _UTKINECT_NUMBERS_A_SECOND
    return Points(Path(path), recording_format(path)[0], names, even, fps, notes=(note,), findings=findings)
