"""Labels: who does what from which frame to which, as CSV.

Columns ``clip, start_frame, end_frame, action``: frames of the clip's own rate, from 0, end exclusive. Without frame
columns a row labels a whole clip (an index of clips); ``action`` may then also be called label, content or category.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from core.mocap.clip import Label
from core.mocap.errors import RecordingError
from core.mocap.files import replacing
from core.mocap.text import decoded, quoted, read_bytes

WHOLE_CLIP = 2**53  # end of a label that lasts as long as its clip; fit_labels puts the clip's own end
_ACTIONS = ("action", "label", "content", "category")
_HEADER = ("clip", "start_frame", "end_frame", "action")


def read_labels(path: str | Path) -> tuple[Label, ...]:
    """Labels of a CSV file, or of all CSV files in a folder and below, in the order of the files.

    Raises RecordingError with the line of the first fault, and where a folder holds no CSV file.
    """
    path = Path(path)
    if not path.is_dir():
        return tuple(_read_file(path))
    files = sorted(p for p in path.rglob("*.csv") if not p.name.startswith("."))
    if not files:
        raise RecordingError(path, "no labels in this folder", "CSV files with clip, start_frame, end_frame, action")
    return tuple(label for file in files for label in _read_file(file))


def _read_file(path: Path) -> Iterable[Label]:
    text = decoded(read_bytes(path))
    header = text.partition("\n")[0]
    delimiter = max(",;\t", key=header.count)
    rows = csv.reader(io.StringIO(text), delimiter=delimiter)
    columns = _columns(path, [name.strip().lower() for name in next(rows)])
    line = 1
    try:
        for row in rows:
            line = rows.line_num
            if any(cell.strip() for cell in row):
                yield _label(path, line, columns, [cell.strip() for cell in row])
    except csv.Error as error:
        raise RecordingError(path, str(error), "rows of a CSV file", line) from None


def _columns(path: Path, header: list[str]) -> dict[str, int]:
    columns = {name: k for k, name in reversed(list(enumerate(header)))}
    action = next((name for name in _ACTIONS if name in columns), None)
    if "clip" not in columns or action is None:
        found = f"columns {quoted(', '.join(header))}"
        raise RecordingError(path, found, "clip, start_frame, end_frame, action in the first line", 1)
    if ("start_frame" in columns) != ("end_frame" in columns):
        raise RecordingError(path, "only one of start_frame and end_frame", "both, or none for whole clips", 1)
    return {**columns, "action": columns[action]}


def _label(path: Path, line: int, columns: Mapping[str, int], row: Sequence[str]) -> Label:
    needed = max(columns[name] for name in (*_HEADER, "clip") if name in columns)
    if len(row) <= needed:
        raise RecordingError(path, f"{len(row)} values", f"at least {needed + 1}", line)
    clip, action = row[columns["clip"]], row[columns["action"]]
    if not clip or not action:
        raise RecordingError(path, "no clip" if not clip else "no action", "a name in every row", line)
    if "start_frame" not in columns:
        return Label(clip, 0, WHOLE_CLIP, action)
    start, end = (_frame(path, line, row[columns[name]]) for name in ("start_frame", "end_frame"))
    if start >= end:
        raise RecordingError(path, f"frames {start} to {end}", "an end after the start", line)
    return Label(clip, start, end, action)


def _frame(path: Path, line: int, word: str) -> int:
    if not (word.isascii() and word.isdigit() and len(word) < 16):
        raise RecordingError(path, quoted(word), "a frame, a whole number from 0", line)
    return int(word)


def fit_labels(labels: Iterable[Label], frames: Mapping[str, int]) -> tuple[tuple[Label, ...], tuple[str, ...]]:
    """The labels of the clips in ``frames`` (clip name -> number of frames), cut to their ends, and what was odd."""
    fitted, unknown, beyond = [], {}, []
    for label in labels:
        n = frames.get(label.clip)
        if n is None:
            unknown[label.clip] = True
        elif label.start >= n:
            beyond.append(f"{label.action} in {label.clip} starts at frame {label.start} of {n}: left out")
        else:
            if n < label.end != WHOLE_CLIP:
                beyond.append(f"{label.action} in {label.clip} ends at frame {label.end} of {n}: cut")
            fitted.append(label._replace(end=min(label.end, n)))
    messages = beyond[:20]
    if unknown:
        some = ", ".join(list(unknown)[:5]) + (" ..." if len(unknown) > 5 else "")
        messages.append(f"{len(unknown)} labelled clips are not in this selection: {some}")
    return tuple(fitted), tuple(messages)


def write_labels(path: str | Path, labels: Iterable[Label]) -> None:
    """Write labels as one CSV file, whole or not at all. Raises OSError where it cannot be written."""
    with replacing(path) as fresh, fresh.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(_HEADER)
        writer.writerows(labels)
