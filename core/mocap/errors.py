"""Errors a person can act on: what happened, where, what was expected."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from core.errors import MotionscapeError


class RecordingError(MotionscapeError, ValueError):
    """A recording cannot be read: one line with file, line number, what was found and what was expected."""

    def __init__(self, path: str | os.PathLike[str], found: str, expected: str = "", line: int | None = None):
        self.path, self.line, self.found, self.expected = str(path), line, found, expected
        where = Path(path).name if line is None else f"{Path(path).name}:{line}"
        super().__init__(f"{where}: {found}" + (f"; expected {expected}" if expected else ""))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.path, self.found, self.expected, self.line)
