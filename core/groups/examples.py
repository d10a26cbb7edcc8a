"""What to look at: for a difference a typical and an extreme stretch of motion of either group."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from core.groups.comparison import Comparison, GroupComparison
from core.mocap.clip import Segment

Examples = dict[str, dict[str, tuple[str, int, int] | None]]
"""Group -> "typical" and "extreme" -> clip, start, end; None where there is nothing to show."""


def examples(found: GroupComparison, row: Comparison, frames: Mapping[str, int]) -> Examples:
    """Typical and extreme motion behind a row. frames: clip -> its number of frames.

    Of an item: the segment of median length, and the longest. Of a figure: the clip nearest the mean of its group, and
    the one furthest out in the direction of the difference.
    """
    return {group: _of_group(found, row, group, frames) for group in row.groups}


def _of_group(
    found: GroupComparison, row: Comparison, group: str, frames: Mapping[str, int]
) -> dict[str, tuple[str, int, int] | None]:
    clips = {clip for unit in found.design.units if unit.group == group for clip in unit.clips}
    if row.kind == "figure":
        return _of_figure(found, row, group, clips, frames)
    ids = row.id.split(">")
    segments = [segment for item in found.items if item.id in ids[:1] for segment in item.segments]
    own = sorted((s for s in segments if s.clip in clips), key=lambda s: (s.n_frames, s))
    if not own:
        return {"typical": None, "extreme": None}
    return {"typical": _plain(own[len(own) // 2]), "extreme": _plain(own[-1])}


def _of_figure(
    found: GroupComparison, row: Comparison, group: str, clips: Iterable[str], frames: Mapping[str, int]
) -> dict[str, tuple[str, int, int] | None]:
    values = {clip: found.by_clip[clip][row.id][0] for clip in sorted(clips) if row.id in found.by_clip.get(clip, {})}
    if not values:
        return {"typical": None, "extreme": None}
    mean, outwards = row.means[row.groups.index(group)], np.sign(row.difference) or 1.0
    outwards = outwards if group == row.groups[1] else -outwards
    typical = min(values, key=lambda clip: abs(values[clip] - mean))
    extreme = max(values, key=lambda clip: outwards * values[clip])
    return {"typical": (typical, 0, frames[typical]), "extreme": (extreme, 0, frames[extreme])}


def _plain(segment: Segment) -> tuple[str, int, int]:
    return segment.clip, int(segment.start), int(segment.end)
