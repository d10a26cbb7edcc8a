"""Repairs of several clips: each doubt of the chosen kinds gets its usual repair, in a job that can be undone."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Output, State, html
from dash.development.base_component import Component

from core import requests
from core.editing.repairs import usual_repairs
from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.workspace import Workspace
from webapp.features.library import dialogs, names
from webapp.ui.doubts import findings_by_clip, kind_words

DOES = {
    "fill": "filled from the frames around",
    "smooth": "smoothed",
    "cut": "cut off at the ends",
    "turn": "turned",
    "mirror": "mirrored back",
}
_LOOKED_AT = 500  # clips whose repairs are counted; of more, a job says it when it is done


def dialog() -> Component:
    """The dialog that says what would be done, by kinds of doubts."""
    return dmc.Modal(
        id=names.REPAIR_DIALOG,
        title="Repair what was found",
        size="lg",
        children=[
            html.Div(id=names.REPAIR_WHAT, className="muted reading-hint"),
            dmc.CheckboxGroup(id=names.REPAIR_KINDS, children=[], value=[]),
            html.Div(
                "A wrong unit is not repaired here, because only a person knows which is meant: Read otherwise changes "
                "it. Single doubts have further repairs on the Clip page.",
                className="muted reading-hint",
            ),
            html.Div(id=names.REPAIR_PROBLEM, className="form-problem", role="alert"),
            dmc.Group(dmc.Button("Repair", id=names.REPAIR_DO), justify="flex-end", mt="md"),
        ],
    )


def counted_repairs(dataset: Dataset, clips: Collection[str]) -> dict[str, Counter[str]]:
    """For each kind of doubts in ``clips``: how often each action of a usual repair is what it gets."""
    found = findings_by_clip(dataset)
    counts: dict[str, Counter[str]] = {}
    for clip in [clip for clip in clips if clip in found][:_LOOKED_AT]:
        for kind in dict.fromkeys(finding.kind for finding in found[clip]):
            repairs = usual_repairs(dataset.clip(clip), found[clip], [kind])
            if repairs:
                counts.setdefault(kind, Counter()).update(repair.action for repair in repairs)
    return counts


def _fill(dataset: Dataset, asked: dict[str, Any]) -> list[Any]:
    clips = asked.get("clips") or ()
    counts = counted_repairs(dataset, [clip for clip in clips if clip in dataset.names])
    n = f"{len(clips):,} clip{'s' if len(clips) != 1 else ''} of {dataset.name}"
    boxes = [
        dmc.Checkbox(
            value=kind,
            label=f"{kind_words(kind).capitalize()}: "
            + ", ".join(f"{count:,} {DOES[action]}" for action, count in actions.most_common()),
            mt=6,
        )
        for kind, actions in sorted(counts.items())
    ]
    words = f"{n}. What is ticked is repaired; labels move with their frames." if boxes else ""
    return [words or f"{n}: nothing that was found in them has a usual repair.", boxes, sorted(counts), None]


def _request(dataset: Dataset, asked: dict[str, Any], kinds: list[str]) -> requests.Request:
    if not kinds:
        raise ParameterError("Nothing is ticked.")
    return requests.usual_repairs_request(dataset.name, asked.get("clips") or (), kinds)


def register(app: Dash, workspace: Workspace) -> None:
    """The callbacks of the dialog."""
    filled = [
        Output(names.REPAIR_WHAT, "children"),
        Output(names.REPAIR_KINDS, "children"),
        Output(names.REPAIR_KINDS, "value"),
        Output(names.REPAIR_PROBLEM, "children"),
    ]
    dialogs.opens(app, workspace, names.REPAIR_DIALOG, names.REPAIR_OF, filled, _fill)
    dialogs.starts(
        app,
        workspace,
        names.REPAIR_DIALOG,
        names.REPAIR_DO,
        names.REPAIR_PROBLEM,
        names.REPAIR_OF,
        [State(names.REPAIR_KINDS, "value")],
        _request,
    )
