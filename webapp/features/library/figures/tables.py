"""Rows and columns of the Library's tables: the clips of a dataset, and the files of its import report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from pathlib import PurePath
from typing import Any
from urllib.parse import quote, urlencode

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset, FileReport
from webapp.shell.advice import in_the_browser
from webapp.ui.doubts import counted, findings_by_clip
from webapp.ui.long_tables import OPTIONS, LongTable
from webapp.ui.tables import NUMBER, SECONDS, STRIP, TEXT, Row, column, strip_address

CLIP_COLUMNS = [
    column("clip", "Clip", 176, flex=2, minWidth=170, tooltipField="clip", cellRenderer="ClipLink", **TEXT),
    {"field": "strip", **STRIP, "minWidth": 128},
    column("seconds", "Seconds", 84, tooltipField="frames", **SECONDS),
    column("fps", "Rate", 56, "Frames per second", **NUMBER),
    column("labels", "Labels", 92, "Its labelled actions", flex=1, minWidth=84, tooltipField="counted", **TEXT),
    column(
        "doubts",
        "Doubts",
        88,
        "How many things were found odd; filter by their kinds",
        tooltipField="doubted",
        filter="agTextColumnFilter",
        filterValueGetter={"function": "params.data.doubted"},
        **NUMBER,
    ),
    column("verdict", "Import", 66, "Remarks of the import", cellRenderer="Mark", cellClass="strip-cell"),
]
REPORT_COLUMNS = [
    column("verdict", "Result", 118, cellRenderer="Verdict", cellClass="wrapped-cell"),
    column(
        "name", "File", 200, flex=2, minWidth=150, maxWidth=320, tooltipField="path", cellClass="wrapped-cell", **TEXT
    ),
    column(
        "messages",
        "What was found",
        240,
        flex=3,
        wrapText=True,
        autoHeight=True,
        cellClass="wrapped-cell wrapped-lines",
        **TEXT,
    ),
]
CHOICE: dict[str, Any] = {  # clips are chosen by their boxes; a click on the row plays the clip
    "rowSelection": {
        "mode": "multiRow",
        "checkboxes": True,
        "headerCheckbox": True,
        "enableClickSelection": False,
        "selectAll": "filtered",
    },
    "selectionColumnDef": {"width": 40, "minWidth": 40, "resizable": False, "cellClass": "choice-cell"},
}
LONG_CHOICE: dict[str, Any] = (
    CHOICE
    | OPTIONS
    | {  # "choose all" is a button there: the browser does not know all
        "rowSelection": {
            "mode": "multiRow",
            "checkboxes": True,
            "headerCheckbox": False,
            "enableClickSelection": False,
        },
    }
)


def long_columns(columns: list[dict]) -> list[dict]:
    """Columns of a table whose rows stay on the server: all rows are equally high, and the server filters."""
    return [_long_column(entry) for entry in columns]


def _long_column(entry: dict) -> dict:
    kept = {key: value for key, value in entry.items() if key not in ("autoHeight", "wrapText", "filterValueGetter")}
    return kept | {"cellClass": "ellipsis", "tooltipField": entry["field"]} if "autoHeight" in entry else kept


def clip_columns(dataset: Dataset) -> list[dict]:
    """The columns of the table of clips; labels only where there are any."""
    return [column for column in CLIP_COLUMNS if column["field"] != "labels" or dataset.labels]


class ClipRows:
    """The rows of the table of clips, in the dataset's order, each made when it is asked for."""

    def __init__(self, dataset: Dataset):
        self._dataset = dataset
        self._actions: dict[str, Counter[str]] = {}
        for label in dataset.labels:
            self._actions.setdefault(label.clip, Counter())[label.action] += 1
        self._reports = {file.clip: file for file in dataset.report.files if file.clip}
        self._found = findings_by_clip(dataset)

    def row(self, number: int) -> Row:
        """The row of a clip; ``selection`` is what a click selects, ``href`` opens the clip."""
        dataset, clip = self._dataset, self._dataset.clips[number]
        report, done = self._reports.get(clip.name), self._actions.get(clip.name, Counter())
        return {
            "key": clip.name,
            "clip": clip.name,
            "href": f"/clip?{urlencode({'dataset': dataset.name, 'clip': clip.name}, quote_via=quote)}",
            "strip": strip_address(dataset.name, Segment(clip.name, 0, clip.n_frames), 6, dataset.fingerprint),
            "seconds": round(clip.seconds, 2),
            "frames": f"{clip.n_frames:,} frames",
            "fps": round(clip.fps, 2),
            "labels": ", ".join(done),
            "counted": ", ".join(f"{action} ({n}\N{MULTIPLICATION SIGN})" for action, n in done.items()),
            "doubts": len(self._found.get(clip.name, ())) or None,
            "doubted": counted(self._found.get(clip.name, ())),
            "verdict": report.verdict if report else "ok",
            "messages": "\n".join(report.messages) if report else "",
            "selection": {"clip": clip.name},
        }

    def long_table(self) -> LongTable:
        """The rows as a table that stays on the server."""
        clips, found = self._dataset.clips, self._found
        reports = [self._reports.get(clip.name) for clip in clips]
        kinds = {name: counted(findings) for name, findings in found.items()}
        values: dict[str, list[Any]] = {
            "clip": [clip.name for clip in clips],
            "seconds": [clip.seconds for clip in clips],
            "fps": [clip.fps for clip in clips],
            "labels": [", ".join(self._actions.get(clip.name, ())) for clip in clips],
            "doubts": [len(found.get(clip.name, ())) or None for clip in clips],
            "verdict": [report.verdict if report else "ok" for report in reports],
        }
        return LongTable(values, self.row, {"doubts": [kinds.get(clip.name, "") for clip in clips]})


def clip_rows(dataset: Dataset) -> list[Row]:
    """A row for each clip, in the dataset's order."""
    rows = ClipRows(dataset)
    return [rows.row(number) for number in range(len(dataset.clips))]


def report_table(files: Iterable[FileReport], shown: str = "all") -> LongTable:
    """The files of an import report as a table that stays on the server. shown: as in layout.REPORTS."""
    files = list(files)
    newest, chosen = _newest(files), worst_first(files, shown)
    values: dict[str, list[str]] = {
        "verdict": [file.verdict for _, file in chosen],
        "name": [PurePath(file.path).name for _, file in chosen],
        "messages": [messages(file) for _, file in chosen],
    }
    return LongTable(values, lambda k: _report_row(*chosen[k], newest))


def report_rows(files: Iterable[FileReport]) -> list[Row]:
    """A row for each file of the import report, worst first; ``added``: it belongs to the latest addition."""
    files = list(files)
    newest = _newest(files)
    return [_report_row(number, file, newest) for number, file in worst_first(files)]


def worst_first(files: Iterable[FileReport], shown: str = "all") -> list[tuple[int, FileReport]]:
    """Files with their numbers, the worst first; those that ``shown`` (a key of layout.REPORTS) names."""
    files = list(files)
    newest = _newest(files)
    chosen = [
        (number, file)
        for number, file in enumerate(files)
        if shown in ("all", file.verdict) or (shown == "added" and newest and file.addition == newest)
    ]
    return sorted(chosen, key=lambda pair: ("error", "warning", "ok").index(pair[1].verdict))


def _newest(files: Iterable[FileReport]) -> int:
    return max((file.addition for file in files), default=0)


def _report_row(number: int, file: FileReport, newest: int) -> Row:
    return {
        "key": f"{number}",
        "verdict": file.verdict,
        "added": bool(newest) and file.addition == newest,
        "name": PurePath(file.path).name,
        "path": file.path,
        "messages": messages(file),
        **({"selection": {"clip": file.clip}} if file.clip else {}),
    }


def messages(file: FileReport) -> str:
    """What the report says of a file, in sentences, on separate lines where there are many."""
    sentences = [_sentence(in_the_browser(_without_file(message, file.path))) for message in file.messages]
    return ("\n" if len(sentences) > 3 else " ").join(sentences) or "Read without remarks."


def _without_file(message: str, path: str) -> str:
    """A message without the file, which has its own column: ``a.bvh:7: what`` becomes ``Line 7: what``."""
    place, _, what = message.partition(": ")
    name, _, line = place.partition(PurePath(path).name)
    if name or not what or place == line:
        return message
    return f"line {line[1:]}: {what}" if line[1:].isdigit() else what if not line else message


def _sentence(message: str) -> str:
    message = message.strip()
    message = message[:1].upper() + message[1:]
    return message if message.endswith((".", "!", "?")) else message + "."
