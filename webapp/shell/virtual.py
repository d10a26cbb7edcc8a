"""Motion that is in no data set, under names like data sets have: ``~walk~<key>``, ``~blend~<key>~3~0.5,0.5``.

The Stage, the filmstrips and the exports take segments of clips of a data set. A feature that makes motion names its
kinds (``Feature.motion_kinds``), and what it makes is played, drawn and exported like any recording. A name
determines the content: equal names mean equal motion.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from core.caching import RecentCache
from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError, acting
from webapp.shell.feature import features

MARK = "~"  # no data set of a person begins with it


def virtual_name(kind: str, *parts: object) -> str:
    """The name of made-up motion: its kind and what determines it."""
    return MARK + MARK.join([kind, *map(str, parts)])


def open_any(workspace: Workspace, name: str) -> Dataset:
    """The data set of this name, from the workspace or made up. Raises WorkspaceError where there is none."""
    if not name.startswith(MARK):
        return workspace.open(name)
    if acting().is_guest:  # what others made may be of a dataset that guests may not see: opening that again tells
        return _make(workspace, name)
    return _opened.get_or_compute((workspace.path, name), lambda: _make(workspace, name))


def _make(workspace: Workspace, name: str) -> Dataset:
    kind, _, rest = name[1:].partition(MARK)
    opener = next((f.motion_kinds[kind] for f in features() if kind in f.motion_kinds), None)
    if opener is None:
        raise WorkspaceError("This motion cannot be made here: its link is damaged or from another version.")
    return opener(workspace, rest)


def opener(workspace: Workspace) -> Callable[[str], Dataset]:
    """:func:`open_any` for one workspace, as routes take it."""
    return partial(open_any, workspace)


_opened: RecentCache[tuple[Path, str], Dataset] = RecentCache(24)
