"""What reading a file or a whole collection came to, in words for people."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Verdict = Literal["ok", "warning", "error"]


@dataclass(frozen=True)
class FileReport:
    """One file: its path, the clip it became (None where it could not be read), the verdict and why.

    ``addition``: 0 where it came with the import, n where the n-th addition to the dataset brought it.
    """

    path: str
    clip: str | None
    verdict: Verdict
    messages: tuple[str, ...] = ()
    addition: int = 0


@dataclass(frozen=True)
class ImportReport:
    """All files of an import, and what concerns the collection as a whole (labels, names)."""

    files: tuple[FileReport, ...] = ()
    messages: tuple[str, ...] = ()

    @property
    def last_addition(self) -> int:
        """Number of the newest addition; 0 where nothing was added since the import."""
        return max((file.addition for file in self.files), default=0)

    def count(self, verdict: Verdict) -> int:
        """Number of files with this verdict."""
        return sum(file.verdict == verdict for file in self.files)
