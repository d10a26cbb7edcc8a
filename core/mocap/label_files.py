"""Label files beside recordings: which they are, which rows fit the clips, and a report of those that do not."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from core.mocap.clip import Label
from core.mocap.errors import RecordingError
from core.mocap.files import files_below
from core.mocap.labels import first_row, fit_label, label_columns, label_rows
from core.mocap.reports import FileReport
from core.mocap.text import decoded

_FIRST_BYTES = 1 << 16  # enough for any header
_MOST_NAMED_ROWS = 12  # rows that do not fit and are told one by one


class LabelFile(NamedTuple):
    """A label file; ``whole``: its labels are of whole clips; ``named``: its name says that it holds labels."""

    path: Path
    whole: bool
    named: bool


def find_label_files(folder: str | Path) -> tuple[LabelFile, ...]:
    """The label files of a folder: ``labels.csv``, those in ``labels/``, and all CSV files below with such columns.

    Those with frames come first, those of whole clips (an index) behind them.
    """
    folder = Path(folder)
    files = []
    for path in files_below(folder):
        if path.suffix.lower() == ".csv":
            named = path == folder / "labels.csv" or folder / "labels" in path.parents
            columns = _columns(path)
            if named or columns is not None:
                files.append(LabelFile(path, "start_frame" not in (columns or ()), named))
    return tuple(sorted(files, key=lambda file: (file.whole, file.path)))


def _columns(path: Path) -> Mapping[str, int] | None:
    """The columns of a label file, None where it is another kind of file; only its beginning is read."""
    try:
        with path.open("rb") as file:
            head = file.read(_FIRST_BYTES).removeprefix(b"\xef\xbb\xbf").replace(b"\r", b"\n")
        return label_columns(path, first_row(decoded(head)))
    except (RecordingError, OSError, csv.Error):
        return None


def take_labels(path: str | Path, frames: Mapping[str, int]) -> tuple[tuple[Label, ...], FileReport]:
    """The rows of a label file that fit the clips in ``frames`` (clip name -> number of frames), and a report.

    The report names the rows that do not fit, with their lines; its verdict is "error" where the file is no label file.
    """
    name = Path(path).name
    labels: list[Label] = []
    faults: list[str] = []
    unknown: dict[str, int] = {}
    try:
        for line, row in label_rows(path):
            if isinstance(row, RecordingError):
                faults.append(str(row))
            elif row.clip not in frames:
                unknown.setdefault(row.clip, line)
            else:
                fits, fault = fit_label(row, frames[row.clip])
                labels += [fits] if fits else []
                faults += [f"{name}:{line}: {fault}"] if fault else []
    except RecordingError as error:
        return (), FileReport(str(path), None, "error", (str(error),))
    doubts = _doubts(faults, unknown)
    return tuple(labels), FileReport(
        str(path), None, "ok" if labels and not doubts else "warning", (_taken(labels), *doubts)
    )


def _taken(labels: Sequence[Label]) -> str:
    clips = len({label.clip for label in labels})
    words = f"{len(labels)} labels" if len(labels) != 1 else "one label"
    return f"{words} of {clips} clip{'s' if clips != 1 else ''}" if labels else "no label in it fits these clips"


def _doubts(faults: Sequence[str], unknown: Mapping[str, int]) -> list[str]:
    doubts = [*faults[:_MOST_NAMED_ROWS]]
    if len(faults) > _MOST_NAMED_ROWS:
        doubts.append(f"{len(faults) - _MOST_NAMED_ROWS} more rows like these")
    if unknown:
        named = ", ".join(f"{clip} (line {line})" for clip, line in list(unknown.items())[:5])
        count = f"{len(unknown)} clips it names are" if len(unknown) > 1 else "one clip it names is"
        doubts.append(f"{count} not here: {named}{' ...' if len(unknown) > 5 else ''}")
    return doubts


def find_labels(
    folders: Iterable[str | Path], frames: Mapping[str, int]
) -> tuple[tuple[Label, ...], tuple[FileReport, ...]]:
    """The labels that lie in folders of recordings and fit the clips in ``frames``, and a report of each label file.

    Labels of whole clips are only taken for clips that have no others.
    """
    labels: dict[Label, None] = {}
    reports = []
    for file in (file for folder in folders for file in find_label_files(folder)):
        taken, report = take_labels(file.path, frames)
        done = {label.clip for label in labels} if file.whole else set()
        labels |= dict.fromkeys(label for label in taken if label.clip not in done)
        reports.append(report)
    return tuple(labels), tuple(reports)
