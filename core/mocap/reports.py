"""What reading a file or a whole collection came to, in words for people."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Verdict = Literal["ok", "warning", "error"]


@dataclass(frozen=True)
class FileReport:
    """One file: its path, the clip it became (None where it could not be read), the verdict and why."""

    path: str
    clip: str | None
    verdict: Verdict
    messages: tuple[str, ...] = ()


@dataclass(frozen=True)
class ImportReport:
    """All files of an import, and what concerns the collection as a whole (labels, names)."""

    files: tuple[FileReport, ...] = ()
    messages: tuple[str, ...] = ()

    def count(self, verdict: Verdict) -> int:
        """Number of files with this verdict."""
        return sum(file.verdict == verdict for file in self.files)
