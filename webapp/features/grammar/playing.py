"""What the Stage plays of actions: all occurrences of one, one alone, or a stretch of a clip in their colours."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.workspace import Workspace
from webapp.features.grammar import grammars
from webapp.features.grammar.figures import actions
from webapp.shell.feature import Shown
from webapp.shell.names import Figure, StageRequest
from webapp.shell.playback import MOST_FIGURES, clip_segment, item, overlay


def plays(workspace: Workspace, dataset: Dataset, shown: Shown) -> StageRequest | None:
    """What plays for a selection of this page; None where there is nothing to play."""
    return stage_request(workspace, dataset, shown.view, shown.selection)


def missing(workspace: Workspace, shown: Shown) -> str | None:
    """A sentence about what a selection names that does not exist; None where it exists or cannot be checked yet."""
    learned, selection = grammars.learned(workspace, shown.dataset, shown.view), shown.selection
    if learned is None or int(selection["action"]) < learned.terminals.n_terminals:
        return None
    return f"The result shown has no action {selection['action']}; it has {learned.terminals.n_terminals} actions."


def stage_request(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None, selection: Mapping[str, Any]
) -> StageRequest | None:
    """What plays for a selection of an action, or of a clip ``as`` actions; None where there is nothing to play."""
    learned = grammars.learned(workspace, dataset.name, view)
    if learned is None:
        return None
    notes = grammars.notes_of(workspace, dataset.name, view) or {}
    segments = learned.terminals.segments
    if "action" not in selection:
        return _stretch(dataset, segments, notes, selection)
    action, number = int(selection["action"]), selection.get("segment")
    if not 0 <= action < len(segments):
        return None
    occurrences, name = segments[action], actions.action_name(action, notes)
    if number is not None and 0 <= int(number) < len(occurrences):
        title = f"{name}, {int(number) + 1} of {len(occurrences)}"
        return overlay(dataset, [_item(occurrences[int(number)])], title, sync="start")
    shown = typical_first(occurrences, learned.terminals.medoids[action])
    count = f"{len(shown)} of {len(occurrences)}" if len(shown) < len(occurrences) else str(len(occurrences))
    title = f"{name}: {count} time{'s' if len(occurrences) != 1 else ''}"
    return overlay(dataset, [_item(segment) for segment in shown], title, sync="start")


def typical_first(occurrences: Sequence[Segment], typical: Segment, most: int = MOST_FIGURES) -> list[Segment]:
    """Segments that play together: all, or the typical one and others spread evenly over the list; it comes first."""
    others = [segment for segment in occurrences if segment != typical]
    if len(occurrences) > most:
        others = [others[round(i * (len(others) - 1) / (most - 2))] for i in range(most - 1)]
    return [typical, *others]


def _stretch(
    dataset: Dataset, segments: Sequence[Sequence[Segment]], notes: actions.Notes, selection: Mapping[str, Any]
) -> StageRequest | None:
    segment = clip_segment(dataset, selection)
    if segment is None:
        return None
    figure = _item(segment)
    figure["colours"] = actions.spans(segments, notes, segment)
    return overlay(dataset, [figure], segment.clip, sync="start")


def _item(segment: Segment) -> Figure:
    return item(*segment, segment.clip)
