"""Repairs of what inspection finds in a clip: frames filled, cut off or smoothed, the clip turned, scaled or mirrored.

Which repairs there are for a finding is said by :func:`repairs_for`; :func:`repaired` carries them out.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.ndimage import gaussian_filter1d

from core.editing.edits import FEWEST_FRAMES
from core.errors import ParameterError
from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip, Label
from core.mocap.gaps import fill_rotations, fill_track
from core.mocap.reading import Change, Reading, read_again
from core.mocap.reports import Finding
from core.mocap.units import UNITS, metres_of, other_heights
from core.mocap.upright import axis_along, axis_of

ACTIONS = ("fill", "smooth", "cut", "turn", "rescale", "mirror")
_ON_FRAMES = ("fill", "smooth", "cut")
_SOON_BACK = 0.5  # seconds within which a joint that jumped may jump back
_SOON_OVER = 2.0  # seconds before or behind a jump that may not belong to the motion
_SIGMA = 0.12  # seconds over which motion is smoothed: 2 m within it are no faster than a body can move
_REACH = 3  # times that long on either side
_USUAL_HEIGHT = 1.7  # metres


@dataclass(frozen=True)
class Repair:
    """What is to be done to a clip: one of ACTIONS.

    start, end: the frames that are filled, smoothed or cut off, ``[start, end)``. value: the axis that points up in
    the file (turn), or the metres in a unit of it (rescale). words: what it does, for a button.
    """

    action: str
    start: int = 0
    end: int = 0
    value: str = ""
    words: str = ""


def repairs_for(clip: Clip, finding: Finding, findings: Sequence[Finding] = ()) -> tuple[Repair, ...]:
    """The repairs of a finding, the usual one first; none where nothing is known to help.

    findings: all of the clip, because a joint that jumps away and soon comes back is filled in between.
    """
    if finding.kind == "up":
        axis = axis_along(clip)
        return (Repair("turn", value=axis, words=f"Turn: {axis.upper()} points up"),) if axis != clip.up else ()
    if finding.kind == "sides":
        return (Repair("mirror", words="Mirror back"),)
    if finding.kind == "size":
        return _rescalings(clip)
    if finding.start is None or finding.end is None:
        return ()
    start, end = max(finding.start, 0), min(finding.end, clip.n_frames)
    if finding.kind == "rest pose":
        return _cuts(clip, start, end)
    if finding.kind == "filled":
        return (*_cuts(clip, start, end), *_smoothings(clip, start, end))
    if finding.kind == "jump":
        there = finding.start + 1  # the finding holds the frame before the jump and the frame after it
        gap = next((pair for pair in _gaps(clip, findings) if there in pair), None)
        fill = (Repair("fill", *gap, words=f"Fill {_frames(*gap)}"),) if gap else ()
        return (*fill, *_smoothings(clip, start, end), *_cuts(clip, *_shorter_part(clip, there)))
    return ()


def _rescalings(clip: Clip) -> tuple[Repair, ...]:
    """In the other units in which the body has a likely height, and to the usual one."""
    offers = [
        Repair("rescale", value=f"{UNITS[name][0]:.9g}", words=f"In {UNITS[name][1]}: {metres:.2f} m tall")
        for name, metres in other_heights(clip.skeleton).items()
    ]
    height = find_anatomy(clip.skeleton).body_height
    if find_anatomy(clip.skeleton).body != "other" and height > 0:
        unit = clip.skeleton.unit * _USUAL_HEIGHT / height
        offers.append(Repair("rescale", value=f"{unit:.9g}", words=f"Make it {_USUAL_HEIGHT:g} m tall"))
    return tuple(offers)


def _cuts(clip: Clip, start: int, end: int) -> tuple[Repair, ...]:
    """Frames can be cut off at either end, where enough are left."""
    at_an_end = start < end and (start == 0) != (end == clip.n_frames)
    enough = clip.n_frames - (end - start) >= FEWEST_FRAMES
    return (Repair("cut", start, end, words=f"Cut off {_frames(start, end)}"),) if at_an_end and enough else ()


def _smoothings(clip: Clip, start: int, end: int) -> tuple[Repair, ...]:
    return (Repair("smooth", start, end, words="Smooth"),) if clip.n_frames > FEWEST_FRAMES else ()


def _gaps(clip: Clip, findings: Sequence[Finding]) -> list[tuple[int, int]]:
    """The frames between each jump and the jump back that soon follows it."""
    room = max(round(_SOON_BACK * clip.fps), 1)
    jumps = sorted({finding.start + 1 for finding in findings if finding.kind == "jump" and finding.start is not None})
    gaps: list[tuple[int, int]] = []
    for before, after in pairwise(jumps):
        if after - before <= room and (not gaps or gaps[-1][1] < before):
            gaps.append((before, after))
    return gaps


def _shorter_part(clip: Clip, frame: int) -> tuple[int, int]:
    """The frames before ``frame`` or from it on, whichever are fewer; none where both are many."""
    start, end = (0, frame) if frame <= clip.n_frames - frame else (frame, clip.n_frames)
    return (start, end) if end - start <= _SOON_OVER * clip.fps else (0, 0)


def _frames(start: int, end: int) -> str:
    return f"frame {start}" if end == start + 1 else f"frames {start} to {end - 1}"


def usual_repairs(clip: Clip, findings: Sequence[Finding], kinds: Iterable[str] = ()) -> list[Repair]:
    """The usual repair of each finding that has one, each once; only of these ``kinds`` of findings where given.

    What is scaled depends on which unit is meant, so "size" is left to a person.
    """
    wanted = set(kinds)
    repairs: dict[Repair, None] = {}
    for finding in findings:
        if finding.kind != "size" and (not wanted or finding.kind in wanted):
            repairs |= dict.fromkeys(repairs_for(clip, finding, findings)[:1])
    return list(repairs)


def repaired(clip: Clip, labels: Iterable[Label], repairs: Iterable[Repair]) -> tuple[Clip, tuple[Label, ...]]:
    """The clip with these repairs, and the ``labels`` that are its own, moved with their frames.

    What was found in frames that are mended is found no more. Raises ParameterError where a repair is none, or its
    frames are out of range.
    """
    own = tuple(label for label in labels if label.clip == clip.name)
    # frames that are cut off change the numbers of those behind them, so they go last, from the end
    ordered = sorted(repairs, key=lambda repair: (repair.action == "cut", -repair.start))
    for repair in ordered:
        if repair.action not in ACTIONS:
            raise ParameterError(f"There is no repair {repair.action[:20]!r}; there are {', '.join(ACTIONS)}.")
        if repair.action in _ON_FRAMES and not 0 <= repair.start < repair.end <= clip.n_frames:
            where = f"{repair.start} to {repair.end}"
            raise ParameterError(f"{clip.name} has frames 0 to {clip.n_frames}, so {where} cannot be repaired.")
        if repair.action == "cut":
            clip, own = _cut_off(clip, own, repair.start, repair.end)
        else:
            clip = _mended(clip, repair)
    return clip, own


def _mended(clip: Clip, repair: Repair) -> Clip:
    """All but cutting: the clip keeps its frames."""
    if repair.action == "turn":
        return read_again(clip, Change(Reading(up=axis_of(repair.value))))
    if repair.action == "rescale":
        return read_again(clip, Change(Reading(unit=metres_of(repair.value))))
    if repair.action == "mirror":
        return reflected(clip)
    change = filled if repair.action == "fill" else smoothed
    return _without_findings(change(clip, repair.start, repair.end), repair)


def _without_findings(clip: Clip, repair: Repair) -> Clip:
    """Without what the reader found within the frames, and with a note of the repair."""
    findings = tuple(
        finding
        for finding in clip.findings
        if finding.start is None or finding.start < repair.start or (finding.end or 0) > repair.end
    )
    done = "filled from the frames around" if repair.action == "fill" else "smoothed"
    note = f"{_frames(repair.start, repair.end)}: {done} by hand"
    return replace(clip, findings=findings, notes=tuple(dict.fromkeys([*clip.notes, note])))


def filled(clip: Clip, start: int, end: int) -> Clip:
    """Frames ``[start, end)`` as the shortest way from the frame before to the frame behind.

    Raises ParameterError where these are all frames of the clip.
    """
    lost = np.zeros(clip.n_frames, bool)
    lost[start:end] = True
    if lost.all():
        raise ParameterError(f"{clip.name} has no other frames to fill these from.")
    rotations = np.array(clip.rotations, np.float32)
    fill_rotations(rotations, lost)
    root, tracks = np.array(clip.root_positions), {j: np.array(track) for j, track in clip.translations.items()}
    for track in (root, *tracks.values()):
        fill_track(track, lost)
    return replace(clip, root_positions=root, rotations=rotations, translations=tracks)


def smoothed(clip: Clip, start: int, end: int) -> Clip:
    """Frames ``[start, end)`` and a third of a second on either side, smoothed, less so the further away."""
    sigma = max(_SIGMA * clip.fps, 0.5)
    reach = int(np.ceil(_REACH * sigma))
    first, last = max(start - reach, 0), min(end + reach, clip.n_frames)
    frames = np.arange(first, last)
    away = np.maximum(np.maximum(start - frames, frames - (end - 1)), 0)
    weight = 0.5 + 0.5 * np.cos(np.pi * away / (reach + 1))
    window = slice(first, last)
    turns = quat.continuous(np.asarray(clip.rotations[window], float))
    even = quat.normalise(gaussian_filter1d(turns, sigma, axis=0, mode="nearest"))
    rotations = np.array(clip.rotations, np.float32)
    rotations[window] = quat.slerp(turns, even, weight[:, None])
    root, tracks = np.array(clip.root_positions), {j: np.array(track) for j, track in clip.translations.items()}
    for track in (root, *tracks.values()):
        part = np.asarray(track[window], float)
        track[window] = part + weight[:, None] * (gaussian_filter1d(part, sigma, axis=0, mode="nearest") - part)
    return replace(clip, root_positions=root, rotations=rotations, translations=tracks)


def reflected(clip: Clip) -> Clip:
    """All coordinates with X turned round and no joint renamed: what a mirrored export needs to be right again."""
    flip = np.array([-1.0, 1.0, 1.0])
    tracks = {j: (np.asarray(track) * flip).astype(np.float32) for j, track in clip.translations.items()}
    return replace(
        clip,
        skeleton=replace(clip.skeleton, offsets=clip.skeleton.offsets * flip),
        root_positions=(np.asarray(clip.root_positions) * flip).astype(np.float32),
        rotations=(np.asarray(clip.rotations) * np.array([1.0, 1.0, -1.0, -1.0])).astype(np.float32),
        translations=tracks,
        notes=tuple(dict.fromkeys([*clip.notes, "mirrored back: left and right were swapped"])),
    )


def _cut_off(clip: Clip, labels: Sequence[Label], start: int, end: int) -> tuple[Clip, tuple[Label, ...]]:
    """Without frames ``[start, end)`` at either end. Raises ParameterError where they are in the middle."""
    if not _cuts(clip, start, end):
        raise ParameterError(f"Only frames at an end of {clip.name} can be cut off, and not all of them.")
    kept = (end, clip.n_frames) if start == 0 else (0, start)
    note = f"{_frames(start, end)} cut off"
    short = clip.cut(*kept, clip.name)
    moved = tuple(
        label._replace(start=max(label.start, kept[0]) - kept[0], end=min(label.end, kept[1]) - kept[0])
        for label in labels
        if label.start < kept[1] and label.end > kept[0]
    )
    return replace(short, notes=(*clip.notes, note)), moved
