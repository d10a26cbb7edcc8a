"""Edits of a clip: trim, mirror, change the rate, split. Each makes new clips with their labels.

Labels keep their words: a mirrored "kick left" still says so, because nobody but its author knows whether it is meant.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

from core.editing.mirror import mirror
from core.errors import AnalysisError, ParameterError
from core.mocap.clip import Clip, Label
from core.mocap.kinematics import resample
from core.poses.body_frames import BodyFrames

FEWEST_FRAMES = 2  # of a part
MOST_PARTS = 500


class Edited(NamedTuple):
    """A new clip, its labels, and what was done, in words."""

    clip: Clip
    labels: tuple[Label, ...]
    summary: str


def trim(clip: Clip, labels: Iterable[Label], start: int, end: int) -> Edited:
    """Frames ``[start, end)`` as a clip of their own. Raises ParameterError where they are out of range or fewer than
    2.
    """
    if not 0 <= start < end <= clip.n_frames:
        raise ParameterError(f"{clip.name} has frames 0 to {clip.n_frames}; it cannot be trimmed to {start} to {end}")
    if end - start < FEWEST_FRAMES:
        raise ParameterError(f"A clip needs at least {FEWEST_FRAMES} frames; choose a longer range")
    part = clip.cut(start, end, f"{clip.name} {start}-{end}")
    return _edited(part, _within(labels, clip, start, end, part.name), f"frames {start} to {end} of {clip.name}")


def mirrored(clip: Clip, labels: Iterable[Label], frames: BodyFrames | None = None) -> Edited:
    """Left and right exchanged (:func:`core.editing.mirror.mirror`; raises ValueError as there)."""
    new = mirror(clip, frames=frames)
    return _edited(new, _within(labels, clip, 0, clip.n_frames, new.name), f"{clip.name} with left and right exchanged")


def at_rate(clip: Clip, labels: Iterable[Label], fps: float) -> Edited:
    """At ``fps`` frames a second: frames in between are interpolated, or dropped where the rate is a whole part.

    Raises ValueError as :func:`check_rate`.
    """
    check_rate(clip, fps)
    new = replace(resample(clip, fps), name=f"{clip.name} {fps:g} fps")
    ratio, n, kept = fps / clip.fps, new.n_frames, []
    for label in _within(labels, clip, 0, clip.n_frames, new.name):
        start = min(round(label.start * ratio), n - 1)
        kept.append(label._replace(start=start, end=min(max(round(label.end * ratio), start + 1), n)))
    return _edited(new, tuple(kept), f"{clip.name} at {fps:g} instead of {clip.fps:g} frames a second")


def check_rate(clip: Clip, fps: float) -> None:
    """Raises ParameterError where ``fps`` is not from 1 to 1000, is the clip's own rate, or leaves fewer than 2
    frames.
    """
    if not 1 <= fps <= 1000:
        raise ParameterError(f"A frame rate is from 1 to 1000 frames a second, not {fps:g}")
    if abs(clip.fps - fps) < 1e-3 * fps:
        raise ParameterError(f"{clip.name} has {clip.fps:g} frames a second already")
    if (clip.n_frames - 1) * fps < (FEWEST_FRAMES - 1 - 1e-6) * clip.fps:
        raise ParameterError(f"At {fps:g} frames a second, {clip.name} would have a single frame")


def split(clip: Clip, labels: Sequence[Label], cuts: Iterable[int]) -> tuple[Edited, ...]:
    """The clip in parts, cut before each frame of ``cuts``; no frame is lost.

    A part that is one label throughout is named after it, the others are numbered. Raises ParameterError where there is
    nothing to cut, or a part would have fewer than 2 frames.
    """
    inside = sorted({int(cut) for cut in cuts if 0 < cut < clip.n_frames})
    if not inside:
        raise ParameterError(
            f"There is nothing to cut: choose a frame inside {clip.name}, from 1 to {clip.n_frames - 1}"
        )
    if len(inside) >= MOST_PARTS:
        raise ParameterError(
            f"{clip.name} would fall into {len(inside) + 1} parts; at most {MOST_PARTS} are made at once"
        )
    edges = [0, *inside, clip.n_frames]
    short = next((start for start, end in pairwise(edges) if end - start < FEWEST_FRAMES), None)
    if short is not None:
        raise ParameterError(f"The part from frame {short} would have a single frame; cut elsewhere")
    parts: list[Edited] = []
    names: set[str] = set()
    for number, (start, end) in enumerate(pairwise(edges), 1):
        whole = next(
            (lab.action for lab in labels if lab.clip == clip.name and lab.start <= start and lab.end >= end), ""
        )
        name = free_name(f"{clip.name} {whole or f'part {number}'}", names)
        names.add(name)
        part = clip.cut(start, end, name)
        parts.append(_edited(part, _within(labels, clip, start, end, name), f"frames {start} to {end} of {clip.name}"))
    return tuple(parts)


def label_cuts(clip: Clip, labels: Iterable[Label]) -> tuple[int, ...]:
    """Frames at which labels of the clip begin or end, for :func:`split`, none closer than 2 to another or an end.

    Raises AnalysisError where the clip has no label inside it.
    """
    own = [label for label in labels if label.clip == clip.name]
    cuts: list[int] = []
    for cut in sorted({frame for label in own for frame in (label.start, label.end)}):
        if cut - (cuts[-1] if cuts else 0) >= FEWEST_FRAMES and clip.n_frames - cut >= FEWEST_FRAMES:
            cuts.append(cut)
    if not cuts:
        raise AnalysisError(f"{clip.name} has no label that begins or ends inside it")
    return tuple(cuts)


def free_name(wanted: str, taken: Iterable[str]) -> str:
    """``wanted``, with a number behind it where it is among ``taken``."""
    taken = set(taken)
    return next(n for n in (wanted, *(f"{wanted} ({k})" for k in range(2, len(taken) + 3))) if n not in taken)


def renamed(edited: Edited, name: str) -> Edited:
    """The edited clip, and its labels, under another name."""
    labels = tuple(label._replace(clip=name) for label in edited.labels)
    return edited._replace(clip=replace(edited.clip, name=name), labels=labels)


def _edited(clip: Clip, labels: tuple[Label, ...], summary: str) -> Edited:
    """Keeps the findings of the readers that concern the new clip, without what they repaired."""
    return Edited(replace(clip, notes=(summary,)), labels, summary)


def _within(labels: Iterable[Label], clip: Clip, start: int, end: int, name: str) -> tuple[Label, ...]:
    """Labels of ``clip`` cut to ``[start, end)`` and counted from there, for the clip called ``name``."""
    return tuple(
        Label(name, max(label.start, start) - start, min(label.end, end) - start, label.action)
        for label in labels
        if label.clip == clip.name and label.start < end and label.end > start
    )
