"""What someone said about recordings, from the words and files it was said with."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from core.workspace.errors import WorkspaceError

if TYPE_CHECKING:
    from core.mocap.corrections import BodyCorrections
    from core.mocap.reading import Reading
    from core.workspace.importing import Recordings

Source = str | os.PathLike[str]


def reading_of(
    unit: str | float | None,
    up: str | None,
    fps: float | None,
    body: str | os.PathLike[str] | BodyCorrections | None,
    points: str | None,
    smooth: float | None,
) -> Reading:
    """As core.mocap.dataset.reading, which brings numba along and is imported when there is something to read.

    Raises ParameterError, FormatError, OSError.
    """
    from core.mocap.dataset import reading

    file = Path(body) if isinstance(body, str | os.PathLike) else body
    return reading(unit or None, up or None, fps, file, points or None, smooth)


def recordings_of(sources: Source | Sequence[Source], **how: object) -> Recordings:
    """What to import. Raises WorkspaceError where nothing is named."""
    from core.workspace.importing import Recordings

    paths = [sources] if isinstance(sources, str | os.PathLike) else list(sources)
    if not paths:
        raise WorkspaceError("Nothing to import: name at least one file or folder.")
    make: Callable[..., Recordings] = Recordings
    return make([Path(path) for path in paths], **how)
