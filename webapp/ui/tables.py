"""Rows and columns of the app's tables."""

from __future__ import annotations

import io
from collections import Counter
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any
from urllib.parse import quote, urlencode

import dash_ag_grid as dag
from dash import html

from core.mocap.clip import Label, Segment
from core.mocap.dataset import Dataset
from core.spreadsheets import SheetWriter
from core.workspace import MotifNote
from webapp.shell import theme
from webapp.shell.attributes import attributes

Row = dict[str, Any]

NUMBER: dict[str, Any] = {"cellClass": "number ag-right-aligned-cell", "headerClass": "ag-right-aligned-header"}

STRIP: dict[str, Any] = {
    "headerName": "Motion",
    "flex": 1,
    "minWidth": 136,
    "cellRenderer": "Filmstrip",
    "sortable": False,
    "cellClass": "strip-cell",
}
TEXT: dict[str, Any] = {"filter": "agTextColumnFilter"}


def decimals(digits: int) -> dict[str, Any]:
    """How a column of numbers is written: with so many decimals, a dash for a missing number."""
    words = f"params.value == null ? '–' : d3.format('.{digits}f')(params.value)"
    return {"valueFormatter": {"function": words}, **NUMBER}


SECONDS = decimals(1)
WRAPPED: dict[str, Any] = {"wrapHeaderText": True}


def column(field: str, name: str, width: int, tip: str = "", **more: Any) -> dict[str, Any]:
    """A column of AG Grid; ``tip`` is shown on hover over its head, ``more`` are AG Grid's own options."""
    tooltip = {"headerTooltip": tip} if tip else {}
    return {"field": field, "headerName": name, "width": width, **tooltip, **more}


MOTIF_COLUMNS = [
    column("id", "Motif", 76, **NUMBER),
    {"field": "strip", **STRIP},
    column("motions", "Motions", 108, "How many times it occurs", sort="desc", **NUMBER),
    column("seconds", "Seconds", 94, "Mean duration of its motions", **SECONDS),
    column("clips", "Clips", 78, "In how many clips it occurs", **NUMBER),
    column("label", "Mostly", 140, "The label that covers most of its frames", flex=1, minWidth=140),
    column("name", "Name", 130, "What people call it", flex=1, minWidth=110, tooltipField="note"),
    column("tags", "Tags", 100, flex=1, minWidth=90, tooltipField="tags"),
    column("note", "Note", 100, hide=True),
    column(
        "stability",
        "Stability",
        112,
        "How surely it is found again",
        hide=True,
        valueGetter={"function": "stabilityOf(params)"},
        cellRenderer="Share",
        cellClass="strip-cell",
    ),
]


def grid(
    table_id: str,
    columns: list[dict],
    rows: list[Row] | Mapping[str, Any] | None,
    label: str,
    *,
    row_height: int = 46,
    **options: Any,
) -> html.Div:
    """A table whose rows a click or Enter chooses (assets/shell/selecting.mjs). ``options``: more of AG Grid's own.

    rows: all of them, or of those that stay on the server (long_tables) the first block, if it is there.
    """
    table = dag.AgGrid(
        id=table_id,
        columnDefs=columns,
        **({"rowData": rows} if isinstance(rows, list) else {"rowModelType": "infinite", "getRowsResponse": rows}),
        defaultColDef={
            "sortable": True,
            "resizable": True,
            "suppressHeaderMenuButton": False,
            "tooltipComponent": None,
        },
        getRowId="params.data.key",
        rowClassRules={"row-chosen": "isChosen(params)"},
        dashGridOptions={
            "theme": theme.GRID_THEME,
            "rowHeight": row_height,
            "headerHeight": 36,
            "animateRows": False,
            "tooltipShowDelay": 400,
            "suppressCellFocus": False,
            "tabToNextCell": {"function": "leaveTable(params)"},  # arrows move within, Tab moves on
            "ensureDomOrder": True,
            "includeHiddenColumnsInQuickFilter": True,
            **options,
        },
        eventListeners={"rowClicked": ["chooseRow(params)"], "cellKeyDown": ["chooseRowByKey(params)"]},
        className="grid",
    )
    return html.Div(table, role="group", style={"--row-height": f"{row_height}px"}, **attributes(aria_label=label))


def strip_address(dataset: str, segment: Segment, n_poses: int = 6, fingerprint: str = "") -> str:
    """The URL of a filmstrip; ``fingerprint`` lets browsers keep it."""
    query = urlencode({"start": segment.start, "end": segment.end, "n": n_poses, "v": fingerprint[:8]})
    return f"/api/filmstrip/{quote(dataset, safe='')}/{quote(segment.clip, safe='')}?{query}"


def motif_rows(graph: Any, dataset: Dataset, notes: Mapping[int, MotifNote] = MappingProxyType({})) -> list[Row]:
    """A row for each motif: how often, how long, in how many clips, and the label that covers most of it."""
    by_clip = labels_by_clip(dataset)
    rates = {clip.name: clip.fps for clip in dataset.clips}
    rows = []
    for motif in graph.motifs:
        medoid = motif.segments[motif.medoid]
        seconds = [segment.n_frames / rates[segment.clip] for segment in motif.segments]
        rows.append(
            {
                "key": str(motif.id),
                "id": motif.id,
                "strip": strip_address(dataset.name, medoid, 6, dataset.fingerprint),
                "motions": len(motif.segments),
                "seconds": round(sum(seconds) / len(seconds), 2),
                "clips": len({segment.clip for segment in motif.segments}),
                "label": majority_label(motif.segments, by_clip),
                **_note_cells(notes.get(motif.id)),
                "selection": {"motif": motif.id},
            }
        )
    return rows


def motions_csv(dataset: Dataset, graph: Any, notes: Mapping[int, MotifNote] = MappingProxyType({})) -> str:
    """A line for each motion: motif, its name, frames (end exclusive), seconds and main label."""
    by_clip = labels_by_clip(dataset)
    text = io.StringIO()
    lines = SheetWriter(text)
    lines.writerow(["motif", "name", "tags", "clip", "start_frame", "end_frame", "seconds", "label"])
    for motif in graph.motifs:
        note = notes.get(motif.id, MotifNote())
        for segment in motif.segments:
            seconds = f"{segment.n_frames / dataset.clip(segment.clip).fps:.3f}"
            label = majority_label([segment], by_clip).rpartition(" (")[0]
            lines.writerow([motif.id, note.name, ";".join(note.tags), *segment, seconds, label])
    return text.getvalue()


def labels_by_clip(dataset: Dataset) -> dict[str, list[Label]]:
    """The labels of each clip that has any."""
    labels: dict[str, list[Label]] = {}
    for label in dataset.labels:
        labels.setdefault(label.clip, []).append(label)
    return labels


def _note_cells(note: MotifNote | None) -> Row:
    return {"name": note.name, "tags": ", ".join(note.tags), "note": note.note} if note else {"name": "", "tags": ""}


def motif_columns(dataset: Dataset) -> list[dict[str, Any]]:
    """The columns of the motif table; labels only where there are any."""
    return [column for column in MOTIF_COLUMNS if column["field"] != "label" or dataset.labels]


def main_label(segments: Iterable[Segment], labels: dict[str, list[Label]]) -> str:
    """The action whose labels cover most frames of the segments; empty where none does."""
    return _main_label(segments, labels)[0]


def majority_label(segments: Iterable[Segment], labels: dict[str, list[Label]]) -> str:
    """The action whose labels cover most frames of the segments, with its share; empty where none does."""
    action, share = _main_label(segments, labels)
    return f"{action} ({100 * share:.0f} %)" if action else ""


def _main_label(segments: Iterable[Segment], labels: dict[str, list[Label]]) -> tuple[str, float]:
    covered: Counter[str] = Counter()
    frames = 0
    for segment in segments:
        frames += segment.n_frames
        for label in labels.get(segment.clip, ()):
            covered[label.action] += max(0, min(label.end, segment.end) - max(label.start, segment.start))
    (action, most), *_ = covered.most_common(1) or [("", 0)]
    return (action, most / frames) if most else ("", 0.0)


def clock(seconds: float) -> str:
    """A moment of a clip: 0:07.3."""
    minutes, rest = divmod(round(float(seconds), 1), 60)
    return f"{int(minutes)}:{rest:04.1f}"
