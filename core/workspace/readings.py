"""What someone said about recordings, from the words and files it was said with."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from core.mocap.corrections import BodyCorrections
    from core.mocap.reading import Reading


def reading_of(
    unit: str | float | None,
    up: str | None,
    fps: float | None,
    body: str | Path | BodyCorrections | None,
    points: str | None,
    smooth: float | None,
) -> Reading:
    """As core.mocap.dataset.reading, which brings numba along and is imported when there is something to read.

    Raises ParameterError, FormatError, OSError.
    """
    from core.mocap.dataset import reading

    file = Path(body) if isinstance(body, str | os.PathLike) else body
    return reading(unit or None, up or None, fps, file, points or None, smooth)
