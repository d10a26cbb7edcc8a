"""Motifs, for those who look for one by its name, tags or label (Ctrl+K)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from core.workspace import MotifNote, Workspace
from webapp.shell import results
from webapp.shell.feature import Place
from webapp.shell.links import View, format_link
from webapp.ui.tables import labels_by_clip, majority_label


def places(workspace: Workspace, shown: View) -> Iterator[Place]:
    """The motifs of the dataset that is shown, where they have been found."""
    graph = results.motif_graph(workspace, shown.dataset, shown.view)
    if graph is None or shown.dataset is None:
        return
    by_clip = labels_by_clip(workspace.open(shown.dataset))
    notes = results.motif_notes(workspace, shown.dataset, shown.view)
    for motif in graph.motifs:
        note = notes.get(motif.id, MotifNote())
        label = majority_label(motif.segments, by_clip)
        parts = [f"motif {motif.id}", f"{len(motif.segments)} motions", label, *note.tags]
        link = replace(shown, page="motifs", selection={"motif": motif.id}, stage={})
        yield Place(note.name or f"Motif {motif.id}", ", ".join(filter(None, parts)), format_link(link))
