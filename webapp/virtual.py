"""Motion that is in no data set, under names like data sets have: ``~walk~<key>``, ``~blend~<key>~3~0.5,0.5``.

The Stage, the filmstrips and the exports take segments of clips of a data set; whatever makes motion registers its kind
here and is played, drawn and exported like any recording. Names tell the whole content: the same name, the same motion.
"""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from pathlib import Path

from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError

MARK = "~"  # no data set of a person begins with it
_KEPT = 24

Opener = Callable[[Workspace, str], Dataset]


def register_kind(kind: str, opener: Opener) -> None:
    """``opener(workspace, rest)`` makes the data set ``~kind~rest``; it raises WorkspaceError where there is none."""
    _openers[kind] = opener


def virtual_name(kind: str, *parts: object) -> str:
    """The name of made-up motion: its kind and what determines it."""
    return MARK + MARK.join([kind, *map(str, parts)])


def open_any(workspace: Workspace, name: str) -> Dataset:
    """The data set of this name, from the workspace or made up. Raises WorkspaceError where there is none."""
    if not name.startswith(MARK):
        return workspace.open(name)
    place = workspace.path, name
    with _lock:
        if place in _opened:
            _opened.move_to_end(place)
            return _opened[place]
    kind, _, rest = name[1:].partition(MARK)
    if kind not in _openers:
        raise WorkspaceError("This motion cannot be made here: its link is damaged or from another version.")
    dataset = _openers[kind](workspace, rest)
    with _lock:
        _opened[place] = dataset
        while len(_opened) > _KEPT:
            _opened.popitem(last=False)
    return dataset


_openers: dict[str, Opener] = {}
_opened: OrderedDict[tuple[Path, str], Dataset] = OrderedDict()
_lock = threading.Lock()
