"""Labels: who does what from which frame to which, as CSV.

Columns ``clip, start_frame, end_frame, action``: frames of the clip's own rate, from 0, end exclusive. Without frame
columns a row labels a whole clip (an index of clips). ``action`` may also be called label, content or category.
"""

from __future__ import annotations

import _csv
import csv
import io
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from core.mocap.clip import Label
from core.mocap.errors import RecordingError
from core.mocap.files import replacing
from core.mocap.text import decoded, quoted, read_bytes
from core.spreadsheets import SheetWriter, unguarded

WHOLE_CLIP = 2**53  # end of a label that lasts as long as its clip; fit_labels puts the clip's own end
_ACTIONS = ("action", "label", "content", "category")
_HEADER = ("clip", "start_frame", "end_frame", "action")


def read_labels(path: str | Path) -> tuple[Label, ...]:
    """Labels of a CSV file, or of all CSV files in a folder and below, in the order of the files.

    Raises RecordingError with the line of the first fault, and where a folder holds no CSV file.
    """
    path = Path(path)
    files = sorted(p for p in path.rglob("*.csv") if not p.name.startswith(".")) if path.is_dir() else [path]
    if not files:
        raise RecordingError(path, "no labels in this folder", "CSV files with clip, start_frame, end_frame, action")
    labels: list[Label] = []
    fault: RecordingError | None = None
    for _, row in (row for file in files for row in label_rows(file)):
        if isinstance(row, Label):
            labels.append(row)
        else:
            fault = fault or row
    if fault:
        raise fault
    return tuple(labels)


def label_rows(path: str | Path) -> Iterator[tuple[int, Label | RecordingError]]:
    """Line and label of every row of a CSV file, or what is wrong with the row.

    Raises RecordingError where the file cannot be read or its first line names no columns of labels.
    """
    path = Path(path)
    rows = _reader(decoded(read_bytes(path)))
    columns, line = label_columns(path, next(rows)), 1
    try:
        for row in rows:
            line = rows.line_num
            if not any(cell.strip() for cell in row):
                continue
            try:
                yield line, _label(path, line, columns, [unguarded(cell.strip()) for cell in row])
            except RecordingError as error:
                yield line, error
    except csv.Error as error:
        raise RecordingError(path, str(error), "rows of a CSV file", line) from None


def first_row(text: str) -> list[str]:
    """The cells of the first line of a CSV file; raises csv.Error where they are no cells."""
    return next(_reader(text.partition("\n")[0]), [])


def _reader(text: str) -> _csv.Reader:
    header = text.partition("\n")[0]
    return csv.reader(io.StringIO(text), delimiter=max(",;\t", key=header.count))


def label_columns(path: str | Path, header: Sequence[str]) -> dict[str, int]:
    """Where the columns stand in the first row of a label file: clip, action, and both or none of the frames.

    Raises RecordingError for the header of another file; ``path`` is named there.
    """
    header = [name.strip().lower() for name in header]
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
        if label.clip not in frames:
            unknown[label.clip] = True
            continue
        fits, fault = fit_label(label, frames[label.clip])
        fitted += [fits] if fits else []
        beyond += [fault] if fault else []
    messages = beyond[:20]
    if unknown:
        some = ", ".join(list(unknown)[:5]) + (" ..." if len(unknown) > 5 else "")
        messages.append(f"{len(unknown)} labelled clips are not in this selection: {some}")
    return tuple(fitted), tuple(messages)


def fit_label(label: Label, n_frames: int) -> tuple[Label | None, str]:
    """The label cut to a clip of ``n_frames`` (None where nothing is left of it), and what was odd, in words."""
    if label.start >= n_frames:
        return None, f"{label.action} in {label.clip} starts at frame {label.start} of {n_frames}: left out"
    beyond = n_frames < label.end != WHOLE_CLIP
    message = f"{label.action} in {label.clip} ends at frame {label.end} of {n_frames}: cut" if beyond else ""
    return label._replace(end=min(label.end, n_frames)), message


def write_labels(path: str | Path, labels: Iterable[Label]) -> None:
    """Write labels as one CSV file, whole or not at all. Raises OSError where it cannot be written."""
    with replacing(path) as fresh, fresh.open("w", encoding="utf-8", newline="") as file:
        writer = SheetWriter(file)
        writer.writerow(_HEADER)
        writer.writerows(labels)
