"""The layout of the Library page."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from core.mocap.reports import ImportReport
from core.workspace import DatasetInfo
from core.workspace.datasets import is_version
from webapp.features.library import adding, body_editor, names, reading, repairs
from webapp.features.library.cards import duration
from webapp.jobs.names import UNDO
from webapp.shell.attributes import attributes
from webapp.shell.buttons import sends
from webapp.shell.icons import icon
from webapp.shell.uploads import Limits
from webapp.ui.page_head import page_head

REPORTS = (("all", "All"), ("added", "Added last"), ("error", "Not read"), ("warning", "Warnings"), ("ok", "Fine"))


def page() -> Component:
    """The page before any data is loaded."""
    limits = Limits.from_environment()
    return html.Div(
        className="library",
        children=[
            page_head(
                "Library",
                dmc.Button(
                    "Trash", id=names.TRASH_OPEN, variant="subtle", color="gray", leftSection=icon("restore", 16)
                ),
                dmc.Button(
                    "Add recordings", id=names.UPLOAD_OPEN, className="for-editors", leftSection=icon("upload", 16)
                ),
            ),
            html.Div(id=names.DATASET_CARDS),
            html.Div(id=names.DATASET_DETAIL),
            dcc.Store(id=names.DETAIL_SHOWN),
            adding.dialog(limits),
            reading.dialog(),
            repairs.dialog(),
            body_editor.dialog(),
            _rename_dialog(),
            dmc.Modal(id=names.TRASH_DIALOG, title="Trash", size="lg", children=html.Div(id=names.TRASH_LIST)),
            dcc.Store(id=names.DATASET_ACTION),  # {"action": "rename" | "trash" | "empty", "dataset"}
            dcc.Store(id=names.CLIPS_ACTION),  # {"action": "remove" | "reread" | "repair" | "properties" | "clear"}
            dcc.Store(id=names.REREAD_OF),  # {"dataset": name, "clips": [names]}: open the dialog for them
            dcc.Store(id=names.PROPERTIES_OF),  # {"dataset": name, "clips": [names]}: open the dialog for them
            dcc.Store(id=names.REPAIR_OF),  # {"dataset": name, "clips": [names]}: open the dialog for them
            dcc.Store(id=names.BODY_OF),  # {"dataset": name}: open the editor of its bodies
            dcc.Store(id=names.UPLOAD_INTO),  # {"dataset": name}: open the dialog for it
            dcc.Store(id=names.UPLOAD, data={}),  # written by assets/library/upload.mjs
            dcc.Store(id=names.UPLOAD_SUGGESTED),  # a name for the upload; "" where there is none
            dcc.Store(id=names.UPLOADED),  # the token whose import was started
        ],
    )


def detail(
    name: str, tables: dict[str, Component], report: ImportReport, tab: str, files: str, action: Component | None
) -> Component:
    """The chosen dataset: its clips, and its import report, of which ``files`` are shown; action: beside its tabs."""
    doubtful = report.count("warning") + report.count("error")
    badge = dmc.Badge(doubtful, size="sm", color="orange", variant="light") if doubtful else None
    chips = report_chips(report)
    chosen = files if files in {chip["value"] for chip in chips} else "all"
    return dmc.Tabs(
        id=names.DATASET_TABS,
        value=tab,
        className="section dataset-tabs",
        keepMounted=True,
        children=[
            dmc.TabsList(
                [
                    dmc.TabsTab(f"Clips of {name}", value="clips", className="clips-tab"),
                    dmc.TabsTab("Import report", value="report", rightSection=badge),
                    html.Div(id=names.CLIPS_CHOSEN, className="clips-chosen"),
                ]
            ),
            *([action] if action else []),
            dmc.TabsPanel(
                [tables["clips"], dcc.Store(id=names.CLIPS_MARKED), dcc.Store(id=names.CLIPS_ALL)],
                value="clips",
                pt="sm",
            ),
            dmc.TabsPanel(
                [
                    dmc.SegmentedControl(id=names.REPORT_FILTER, data=chips, value=chosen, size="xs", mb="xs"),
                    *(dmc.Text(message, size="sm", c="dimmed", mb="xs") for message in report.messages),
                    tables["report"],
                    tables["rows"],
                ],
                value="report",
                pt="sm",
            ),
        ],
    )


def analyse_button(name: str, expected: Sequence[str]) -> Component:
    """Computes all that pages show of a dataset; expected: what each will take, shown on hover."""
    return html.Div(
        dmc.Button(
            "Analyse everything",
            className="for-editors",
            size="compact-sm",
            variant="default",
            leftSection=icon("spark", 14),
            **sends(names.DATASET_ACTION, {"action": "analyse", "dataset": name}, every_time=True),
        ),
        className="analyse-everything",
        title="\n".join(expected),
    )


def report_chips(report: ImportReport) -> list[dict[str, str]]:
    """Filters of the import report that match any files, each with the number of files."""
    counts: Counter[str] = Counter(file.verdict for file in report.files)
    counts["all"] = len(report.files)
    newest = report.last_addition
    counts["added"] = sum(file.addition == newest for file in report.files) if newest else 0
    choices = [(key, label) for key, label in REPORTS if counts[key] or key == "all"]
    return [{"value": key, "label": f"{label} {counts[key]:,}"} for key, label in choices]


def clips_chosen(chosen: int, matching: int | None = None) -> Component | None:
    """Buttons for the chosen clips; None where none is chosen.

    matching: how many clips a long table shows, which has no box for choosing all.
    """
    if not chosen and matching:
        return _choose_all(matching)
    if not chosen:
        return None
    words = f"{chosen:,} clip{'s' if chosen != 1 else ''} chosen"
    return dmc.Group(
        [
            html.Span(words, className="muted number", role="status"),
            _for_clips("Remove", "remove", color="red", variant="light", leftSection=icon("trash", 14)),
            _for_clips("Read otherwise", "reread"),
            _for_clips("Properties", "properties"),
            _for_clips("Repair", "repair"),
            dmc.Button(
                "Clear",
                size="compact-sm",
                variant="subtle",
                color="gray",
                **sends(names.CLIPS_ACTION, {"action": "clear"}, every_time=True),
            ),
        ],
        gap=8,
        wrap="nowrap",
    )


def _for_clips(words: str, action: str, **looks: Any) -> Component:
    """A button that does something with the chosen clips."""
    looks = {"className": "for-editors", "size": "compact-sm", "variant": "default"} | looks
    return dmc.Button(words, **looks, **sends(names.CLIPS_ACTION, {"action": action}, every_time=True))


def _choose_all(matching: int) -> Component:
    action = sends(names.CLIPS_ACTION, {"action": "all"}, every_time=True)
    return dmc.Group(
        [
            html.Span(f"{matching:,} clip{'s' if matching != 1 else ''}", className="muted number", role="status"),
            dmc.Button("Choose all", size="compact-sm", variant="subtle", **action),
        ],
        gap=8,
        wrap="nowrap",
    )


def _rename_dialog() -> Component:
    return dmc.Modal(
        id=names.RENAME_DIALOG,
        title="Rename dataset",
        children=[
            dcc.Store(id=names.RENAME_OLD),
            dmc.TextInput(id=names.RENAME_NAME, label="New name", **attributes(data_autofocus=True)),
            html.Div(id=names.RENAME_PROBLEM, className="form-problem", role="alert"),
            dmc.Group(dmc.Button("Rename", id=names.RENAME_SAVE), justify="flex-end", mt="md"),
        ],
    )


def trash_list(trashed: Sequence[DatasetInfo]) -> Component:
    """The contents of the trash, newest first, each with a button to restore it."""
    if not trashed:
        return dmc.Text("The trash is empty.", c="dimmed", size="sm")
    rows = [
        html.Li(
            className="trash-row",
            children=[
                html.Span(
                    [
                        html.Span(info.name, className="dataset-name"),
                        html.Span("before its last change", className="muted trash-note") if is_version(info) else None,
                    ],
                    className="ellipsis",
                    title=info.name,
                ),
                html.Span(f"{info.clips:,} clips · {duration(info.seconds)}", className="muted number"),
                dmc.Button(
                    "Restore",
                    className="for-editors",
                    size="compact-sm",
                    variant="default",
                    **sends(UNDO, {"restore": info.id}, every_time=True),
                ),
            ],
        )
        for info in trashed
    ]
    empty = dmc.Button(
        "Empty the trash for good",
        className="for-owners",
        color="red",
        variant="light",
        size="compact-sm",
        **sends(names.DATASET_ACTION, {"action": "empty"}, every_time=True),
    )
    return html.Div([html.Ul(rows, className="trash-list"), dmc.Group(empty, justify="flex-end", mt="md")])
