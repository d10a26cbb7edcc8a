"""What the Library page consists of."""

from __future__ import annotations

from collections.abc import Sequence

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from core.workspace import DatasetInfo
from webapp.api.uploads import SUFFIXES, Limits
from webapp.components.actions import sends
from webapp.components.errors import empty_state
from webapp.components.icons import icon

VERDICTS = (("all", "All"), ("error", "Not read"), ("warning", "Warnings"), ("ok", "Fine"))


def page(limits: Limits) -> Component:
    """The page before it knows what the workspace holds."""
    return html.Div(
        className="library",
        children=[
            html.Div(
                className="page-head",
                children=[
                    html.H1("Library"),
                    html.Div(className="spacer"),
                    dmc.Button(
                        "Trash", id="trash-open", variant="subtle", color="gray", leftSection=icon("restore", 16)
                    ),
                    dmc.Button("Add recordings", id="upload-open", leftSection=icon("upload", 16)),
                ],
            ),
            html.Div(id="dataset-cards"),
            html.Div(id="dataset-detail"),
            upload_dialog(limits),
            _rename_dialog(),
            dmc.Modal(id="trash-dialog", title="Trash", size="lg", children=html.Div(id="trash-list")),
            dcc.Store(
                id="dataset-action"
            ),  # {"action": "rename" | "trash" | "restore" | "empty", "dataset" or "token"}
            dcc.Store(id="trash-revision"),
            dcc.Store(id="upload", data={}),  # written by assets/upload.js
            dcc.Store(id="uploaded"),  # the token whose import was asked for
        ],
    )


def dataset_cards(datasets: Sequence[DatasetInfo], chosen: str | None) -> Component:
    """All datasets as cards; an invitation where there are none."""
    if not datasets:
        demo = dmc.Button("Open the demo", id={"type": "demo", "at": "empty"}, leftSection=icon("spark", 16))
        add = dmc.Button(
            "Add recordings", id={"type": "add", "at": "empty"}, variant="default", leftSection=icon("upload", 16)
        )
        return html.Div(
            empty_state(
                "person",
                "No recordings yet",
                "Drop BVH or AMC files, or whole folders, anywhere on this page; "
                "or look at the demo: six minutes of labelled motion.",
                demo,
                add,
            ),
            className="card",
        )
    return html.Div([_card(info, info.name == chosen) for info in datasets], className="dataset-cards", role="list")


def _card(info: DatasetInfo, chosen: bool) -> Component:
    facts = [f"{info.clips:,} clip{'s' if info.clips != 1 else ''}", duration(info.seconds)]
    if info.labels:
        facts.append(f"{info.labels:,} labels")
    doubts = []
    if info.errors:
        doubts.append(html.Span(f"{info.errors} not read", className="verdict verdict-error"))
    if info.warnings:
        doubts.append(
            html.Span(
                f"{info.warnings} warnings" if info.warnings > 1 else "1 warning", className="verdict verdict-warning"
            )
        )
    return html.Div(
        className="card dataset-card" + (" chosen" if chosen else ""),
        role="listitem",
        children=[
            html.Button(
                className="dataset-open",
                title=info.name,
                children=[
                    html.Span(info.name, className="dataset-name ellipsis"),
                    html.Span(
                        " · ".join(fact.replace(" ", "\N{NO-BREAK SPACE}") for fact in facts), className="muted number"
                    ),
                    html.Span(
                        doubts or html.Span("All files read", className="verdict verdict-ok"),
                        className="dataset-doubts",
                    ),
                ],
                **sends("dataset-choice", {"dataset": info.name}, every_time=True),
                **{"aria-current": "true" if chosen else "false"},
            ),
            _card_menu(info.name),
        ],
    )


def _card_menu(name: str) -> Component:
    return dmc.Menu(
        position="bottom-end",
        shadow="md",
        children=[
            dmc.MenuTarget(
                dmc.ActionIcon(
                    icon("dots"),
                    variant="subtle",
                    color="gray",
                    className="dataset-menu",
                    **{"aria-label": f"More for {name}"},
                )
            ),
            dmc.MenuDropdown(
                [
                    dmc.MenuItem(
                        "Rename",
                        leftSection=icon("edit", 16),
                        **sends("dataset-action", {"action": "rename", "dataset": name}, every_time=True),
                    ),
                    dmc.MenuItem(
                        "Delete",
                        color="red",
                        leftSection=icon("trash", 16),
                        **sends("dataset-action", {"action": "trash", "dataset": name}, every_time=True),
                    ),
                ]
            ),
        ],
    )


def duration(seconds: float) -> str:
    """Length of motion in words: 42 s, 17.7 min, 3.2 h."""
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.1f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def detail(name: str, tables: dict[str, Component], counts: dict[str, int]) -> Component:
    """The chosen dataset: its clips, and its import report."""
    files = sum(counts.values())
    doubtful = counts.get("warning", 0) + counts.get("error", 0)
    chips = [
        {"value": key, "label": f"{label} {files if key == 'all' else counts.get(key, 0)}"} for key, label in VERDICTS
    ]
    return dmc.Tabs(
        value="clips",
        className="section dataset-tabs",
        keepMounted=True,
        children=[
            dmc.TabsList(
                [
                    dmc.TabsTab(f"Clips of {name}", value="clips"),
                    dmc.TabsTab(
                        "Import report",
                        value="report",
                        rightSection=dmc.Badge(doubtful, size="sm", color="orange", variant="light")
                        if doubtful
                        else None,
                    ),
                ]
            ),
            dmc.TabsPanel([tables["clips"], dcc.Store(id="clips-marked")], value="clips", pt="sm"),
            dmc.TabsPanel(
                [
                    dmc.SegmentedControl(id="report-filter", data=chips, value="all", size="xs", mb="xs"),
                    tables["report"],
                ],
                value="report",
                pt="sm",
            ),
        ],
    )


def upload_dialog(limits: Limits) -> Component:
    """Choose or drop files, see each arrive, name the dataset, import."""
    return dmc.Modal(
        id="upload-dialog",
        title="Add recordings",
        size="xl",
        keepMounted=True,
        closeOnClickOutside=False,
        children=[
            html.Div(
                id="drop-zone",
                className="drop-zone",
                children=[
                    icon("upload", 30),
                    html.Div("Drop files or folders here", className="drop-title"),
                    html.Div(
                        [
                            dmc.Button(
                                "Choose files", variant="default", size="compact-sm", **{"data-chooses": "files"}
                            ),
                            dmc.Button(
                                "Choose a folder", variant="default", size="compact-sm", **{"data-chooses": "folder"}
                            ),
                        ],
                        className="drop-buttons",
                    ),
                    html.Div(limits.sentence(), className="muted drop-limits"),
                ],
                **{
                    "data-file-bytes": limits.file_bytes,
                    "data-total-bytes": limits.total_bytes,
                    "data-files": limits.files,
                    "data-suffixes": " ".join(SUFFIXES),
                },
            ),
            html.Div(html.Div(id="upload-bar"), id="upload-progress", className="upload-progress hidden"),
            html.Div(id="upload-summary", className="muted upload-summary", role="status", **{"aria-live": "polite"}),
            html.Ul(id="upload-list", className="upload-list", tabIndex="0", **{"aria-label": "Files"}),
            dmc.Group(
                align="flex-end",
                mt="md",
                children=[
                    dmc.TextInput(
                        id="upload-name",
                        label="Name of the dataset",
                        placeholder="Walks in the park",
                        style={"flex": 1},
                    ),
                    dmc.NumberInput(
                        id="upload-fps",
                        label="Frames per second of AMC files",
                        description=None,
                        placeholder="120",
                        min=1,
                        max=1000,
                        w=220,
                        debounce=False,
                    ),
                    dmc.Button("Import", id="upload-import", disabled=True),
                ],
            ),
            html.Div(id="upload-problem", className="form-problem", role="alert"),
        ],
    )


def _rename_dialog() -> Component:
    return dmc.Modal(
        id="rename-dialog",
        title="Rename dataset",
        children=[
            dcc.Store(id="rename-old"),
            dmc.TextInput(id="rename-name", label="New name", **{"data-autofocus": True}),
            html.Div(id="rename-problem", className="form-problem", role="alert"),
            dmc.Group(dmc.Button("Rename", id="rename-save"), justify="flex-end", mt="md"),
        ],
    )


def trash_list(trashed: Sequence[DatasetInfo]) -> Component:
    """What lies in the trash, newest first, each with a way back."""
    if not trashed:
        return dmc.Text("The trash is empty.", c="dimmed", size="sm")
    rows = [
        html.Li(
            className="trash-row",
            children=[
                html.Span(info.name, className="ellipsis dataset-name"),
                html.Span(f"{info.clips:,} clips · {duration(info.seconds)}", className="muted number"),
                dmc.Button(
                    "Restore",
                    size="compact-sm",
                    variant="default",
                    **sends("dataset-action", {"action": "restore", "token": info.id}, every_time=True),
                ),
            ],
        )
        for info in trashed
    ]
    empty = dmc.Button(
        "Empty the trash for good",
        color="red",
        variant="light",
        size="compact-sm",
        **sends("dataset-action", {"action": "empty"}, every_time=True),
    )
    return html.Div([html.Ul(rows, className="trash-list"), dmc.Group(empty, justify="flex-end", mt="md")])
