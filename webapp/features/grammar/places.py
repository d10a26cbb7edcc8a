"""Actions, for those who look for one by its name or label (Ctrl+K)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from core.workspace import Workspace
from webapp.features.grammar import grammars
from webapp.features.grammar.figures import actions
from webapp.shell.feature import Place
from webapp.shell.links import View, format_link
from webapp.ui.tables import labels_by_clip, majority_label


def places(workspace: Workspace, shown: View) -> Iterator[Place]:
    """The actions of the dataset that is shown, where its grammar has been learned."""
    result = grammars.learned(workspace, shown.dataset, shown.view)
    if result is None or shown.dataset is None:
        return
    by_clip = labels_by_clip(workspace.open(shown.dataset))
    notes = grammars.notes_of(workspace, shown.dataset, shown.view) or {}
    for action, segments in enumerate(result.terminals.segments):
        parts = [f"action {action}", f"{len(segments)} times", majority_label(segments, by_clip)]
        link = replace(shown, page="grammar", selection={"action": action}, stage={})
        yield Place(actions.action_name(action, notes), ", ".join(filter(None, parts)), format_link(link))
