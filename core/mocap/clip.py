"""Clip and Segment: one recording, and an interval of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from core.errors import ParameterError
from core.mocap.reports import Finding
from core.mocap.skeleton import Skeleton


class Segment(NamedTuple):
    """Half-open frame interval ``[start, end)`` of the clip called ``clip``, in frames of the clip's own rate."""

    clip: str
    start: int
    end: int

    @property
    def n_frames(self) -> int:
        """Number of frames in the segment."""
        return self.end - self.start


class Label(NamedTuple):
    """An action that someone gave a segment; ``start`` and ``end`` as in :class:`Segment`."""

    clip: str
    start: int
    end: int
    action: str


@dataclass(frozen=True, eq=False)
class Clip:
    """One recording of one person. Y up, right-handed, metres.

    root_positions: (n_frames, 3) float32, metres, world.
    rotations: (n_frames, n_joints, 4) float32 unit quaternions (w, x, y, z), local to the parent.
    translations: joint index -> (n_frames, 3) float32, metres: positions in the parent's frame that replace the rest
        offset of a joint (other than the root) whose position channels move.
    notes: what the reader did, in plain words (unit guessed, joints folded).
    findings: what a person should look at, and in which frames.
    up: the axis that points up in the file the clip came from (``y``, ``z``, ``-x`` ...); the clip itself has Y up.
    rest_turned: whether the skeleton's rest pose was turned from that axis as well.
    Arrays may be memory-mapped. Raises ValueError where shapes do not agree or fps is not positive.
    """

    name: str
    skeleton: Skeleton
    fps: float
    root_positions: np.ndarray
    rotations: np.ndarray
    translations: Mapping[int, np.ndarray] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()
    up: str = "y"
    rest_turned: bool = False

    def __post_init__(self) -> None:
        n, shape = len(self.root_positions), (len(self.root_positions), self.skeleton.n_joints, 4)
        if self.root_positions.shape != (n, 3) or self.rotations.shape != shape:
            raise ValueError(f"{self.name}: expected root positions ({n}, 3) and rotations {shape}")
        if n == 0 or not self.fps > 0:
            raise ValueError(f"{self.name}: a clip needs at least one frame and a positive frame rate")

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a person should look at, in plain words."""
        return tuple(finding.message for finding in self.findings)

    @property
    def n_frames(self) -> int:
        """Number of frames."""
        return len(self.root_positions)

    @property
    def seconds(self) -> float:
        """Duration: frames over frames per second."""
        return self.n_frames / self.fps

    def cut(self, start: int, end: int, name: str | None = None) -> Clip:
        """Frames ``[start, end)`` as a clip (views, not copies). Raises ParameterError when out of range or empty."""
        if not 0 <= start < end <= self.n_frames:
            raise ParameterError(f"{self.name} has frames 0 to {self.n_frames}; cannot cut {start} to {end}")
        return replace(
            self,
            name=name or f"{self.name}:{start}-{end}",
            root_positions=self.root_positions[start:end],
            rotations=self.rotations[start:end],
            translations={j: t[start:end] for j, t in self.translations.items()},
            findings=tuple(_findings_within(self.findings, start, end)),
        )


def _findings_within(findings: tuple[Finding, ...], start: int, end: int) -> Iterator[Finding]:
    """Those that are about frames ``[start, end)``, counted from ``start``, or about the whole clip."""
    for finding in findings:
        if finding.start is None or finding.end is None:
            yield finding
        elif finding.start < end and finding.end > start:
            yield replace(finding, start=max(finding.start, start) - start, end=min(finding.end, end) - start)
