"""What was found odd about a clip, in the words of tables and charts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from types import MappingProxyType

from core.mocap.dataset import Dataset
from core.mocap.reports import Finding

WORDS: Mapping[str, str] = MappingProxyType(
    {
        "dof": "degrees of freedom",
        "duplicate": "same as another",
        "extra": "bones too many",
        "frames": "frame count",
        "glued": "glued numbers",
        "head": "no MOTION line",
        "missing": "bones missing",
        "names": "names twice",
        "rate": "frame rate",
        "roots": "several skeletons",
        "sides": "left and right",
        "still": "stands still",
        "text": "text after frames",
        "up": "way up",
    }
)
"""Kinds of findings that need more words than their own."""


def kind_words(kind: str) -> str:
    """A kind of finding in words."""
    return WORDS.get(kind, kind)


def counted(findings: Iterable[Finding]) -> str:
    """The kinds of findings, each with how often it occurs where that is more than once."""
    counts = Counter(kind_words(finding.kind) for finding in findings)
    return ", ".join(words if n == 1 else f"{words} ({n}\N{MULTIPLICATION SIGN})" for words, n in counts.items())


def findings_by_clip(dataset: Dataset) -> dict[str, tuple[Finding, ...]]:
    """What was found in each clip of a data set that has findings."""
    return dataset.report.findings_by_clip()
