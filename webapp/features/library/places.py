"""Datasets and clips, for those who look for them by name (Ctrl+K)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from core.errors import MotionscapeError
from core.workspace import Workspace
from webapp.features.library.cards import duration
from webapp.shell.feature import Place
from webapp.shell.links import View, format_link


def places(workspace: Workspace, shown: View) -> Iterator[Place]:
    """All datasets, and the clips of the one that is shown, which play on the page that is open."""
    for info in workspace.datasets():
        facts = f"dataset, {info.clips:,} clips, {duration(info.seconds)}"
        yield Place(info.name, facts, format_link(View("library", info.name)))
    if shown.dataset is None:
        return
    try:
        dataset = workspace.open(shown.dataset)
    except MotionscapeError:
        return
    for clip in dataset.clips:
        link = replace(shown, selection={"clip": clip.name}, stage={})
        yield Place(clip.name, f"clip, {duration(clip.n_frames / clip.fps)}", format_link(link))
