"""The data sets of the Library as cards, each with its menu."""

from __future__ import annotations

from collections.abc import Sequence

import dash_mantine_components as dmc
from dash import html
from dash.development.base_component import Component

from core.workspace import DatasetInfo
from webapp.features.library import names
from webapp.shell.attributes import attributes
from webapp.shell.buttons import sends
from webapp.shell.icons import icon
from webapp.shell.messages import empty_state
from webapp.shell.names import DATASET_CHOICE


def dataset_cards(datasets: Sequence[DatasetInfo], chosen: str | None) -> Component:
    """All datasets as cards; an invitation where there are none."""
    if not datasets:
        demo = dmc.Button(
            "Open the demo", id=names.DEMO("empty"), className="for-editors", leftSection=icon("spark", 16)
        )
        add = dmc.Button(
            "Add recordings",
            id=names.ADD("empty"),
            className="for-editors",
            variant="default",
            leftSection=icon("upload", 16),
        )
        return html.Div(
            empty_state(
                "person",
                "No recordings yet",
                "Drop BVH or AMC files, whole folders or a zip of them anywhere on this page; "
                "or look at the demo: six minutes of labelled motion.",
                demo,
                add,
            ),
            className="card",
        )
    return html.Div([_card(info, info.name == chosen) for info in datasets], className="dataset-cards", role="list")


def _card(info: DatasetInfo, chosen: bool) -> Component:
    return html.Div(
        id=names.CARD(info.name),
        className=card_class(chosen),
        role="listitem",
        **attributes(data_dataset=info.name),
        children=[
            html.Button(
                id=names.CARD_OPEN(info.name),
                className="dataset-open",
                title=info.name,
                children=card_facts(info),
                **sends(DATASET_CHOICE, {"dataset": info.name}, every_time=True),
                **attributes(aria_current=current(chosen)),
            ),
            _card_menu(info.name),
        ],
    )


def card_class(chosen: bool) -> str:
    """The class of a card."""
    return "card dataset-card" + (" chosen" if chosen else "")


def current(chosen: bool) -> str:
    """Whether a card is the chosen one, for those who cannot see it."""
    return "true" if chosen else "false"


def card_facts(info: DatasetInfo) -> list[Component]:
    """Name, size and doubts of a data set."""
    facts = f"{info.clips:,} clip{'s' if info.clips != 1 else ''} · {duration(info.seconds)}"
    pills = []
    if info.errors:
        pills.append(html.Span(f"{info.errors:,} not read", className="verdict verdict-error"))
    if info.warnings:
        words = f"{info.warnings:,} warnings" if info.warnings > 1 else "1 warning"
        pills.append(html.Span(words, className="verdict verdict-warning"))
    pills = pills or [html.Span("All files read", className="verdict verdict-ok")]
    if info.labels:
        words = f"{info.labels:,} labels" if info.labels > 1 else "1 label"
        pills.append(html.Span(words, className="verdict verdict-plain"))
    return [
        html.Span(info.name, className="dataset-name ellipsis"),
        html.Span(facts, className="muted number"),
        html.Span(pills, className="dataset-doubts"),
    ]


def _card_menu(name: str) -> Component:
    def item(words: str, symbol: str, store: str, value: dict[str, str], **more: str) -> Component:
        send = sends(store, {"dataset": name} | value, every_time=True)
        return dmc.MenuItem(words, leftSection=icon(symbol, 16), **more, **send)

    editors = {"className": "for-editors"}
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
                    **attributes(aria_label=f"More for {name}"),
                )
            ),
            dmc.MenuDropdown(
                [
                    item("Add recordings or labels", "upload", names.UPLOAD_INTO, {}, **editors),
                    item("Rename", "edit", names.DATASET_ACTION, {"action": "rename"}, **editors),
                    item("Change how it was read ...", "retry", names.REREAD_OF, {}, **editors),
                    item("Which joint is which ...", "person", names.BODY_OF, {}, **editors),
                    dmc.MenuItem("Properties of clips ...", leftSection=icon("note", 16), **{"data-properties": name}),
                    dmc.MenuItem("Report ...", leftSection=icon("board", 16), **{"data-report": name}),
                    item("Features (npz)", "download", names.FEATURES_CHOICE, {"suffix": ".npz"}),
                    item("Features (Parquet)", "download", names.FEATURES_CHOICE, {"suffix": ".parquet"}),
                    item("Delete", "trash", names.DATASET_ACTION, {"action": "trash"}, color="red", **editors),
                ]
            ),
        ],
    )


def duration(seconds: float) -> str:
    """Length of motion in words: 42 s, 17.7 min, 3.2 h."""
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.1f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
