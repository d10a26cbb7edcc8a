"""What reading a file or a whole collection came to, in words for people."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Verdict = Literal["ok", "warning", "error"]


@dataclass(frozen=True)
class Finding:
    """Something a person should look at in a clip.

    kind: a short word for what it is, the same for all findings of that sort (``filled``, ``jump``, ``up`` ...).
    message: one sentence. start, end: the frames it is about, ``[start, end)`` of the clip's own rate; None where it is
    about the whole clip.
    """

    kind: str
    message: str
    start: int | None = None
    end: int | None = None


@dataclass(frozen=True)
class FileReport:
    """One file: its path, the clip it became (None where it could not be read), the verdict and why.

    ``findings``: what is to be looked at in the clip; their sentences are among ``messages`` as well. ``addition``: 0
    where it came with the import, n where the n-th addition to the dataset brought it.
    """

    path: str
    clip: str | None
    verdict: Verdict
    messages: tuple[str, ...] = ()
    addition: int = 0
    findings: tuple[Finding, ...] = ()


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

    def findings_by_clip(self) -> dict[str, tuple[Finding, ...]]:
        """What was found in each clip that has findings."""
        found: dict[str, tuple[Finding, ...]] = {}
        for file in self.files:
            if file.clip and file.findings:
                found[file.clip] = (*found.get(file.clip, ()), *file.findings)
        return found
