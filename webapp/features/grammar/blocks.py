"""What boards and reports show of a grammar: every clip as a string of actions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from core.mocap.dataset import Dataset
from core.workspace import Workspace
from webapp.features.grammar import grammars
from webapp.features.grammar.figures import actions
from webapp.ui.tables import labels_by_clip, majority_label

MOST_SEGMENTS = 12  # of an action that play together


def action_string(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any] | None:
    """``actions``: id, name, colour, ink, count, label (of most of it), segments; ``rows``: as grammar/strings.mjs
    has them."""
    result = grammars.learned(workspace, dataset.name, view)
    if result is None:
        return None
    notes = grammars.notes_of(workspace, dataset.name, view) or {}
    found = result.terminals.segments
    by_clip = labels_by_clip(dataset)
    cuts: dict[str, list[int]] = {}
    for routine in grammars.routines(result):
        cuts.setdefault(routine.span.clip, []).append(routine.span.start)
    return {
        "actions": [
            {
                "id": action,
                "name": actions.action_name(action, notes),
                "short": actions.short_name(action, notes),
                "colour": actions.action_colour(action),
                "ink": actions.ink_on(actions.action_colour(action)),
                "count": len(own),
                "label": majority_label(own, by_clip),
                "segments": [list(segment) for segment in own[:MOST_SEGMENTS]],
            }
            for action, own in enumerate(found)
        ],
        "rows": actions.string_rows(dataset, found, cuts),
    }


def segments(content: Mapping[str, Any]) -> Iterator[tuple[str, int, int]]:
    """The first segment of every action, then the second of each, and so on."""
    for k in range(MOST_SEGMENTS):
        yield from (tuple(action["segments"][k]) for action in content["actions"] if k < len(action["segments"]))
