"""From a path through the motif graph to pieces of recordings: which motion is entered and left in each motif.

MMG section 4: the motion that an edge leads into and the motion that the next edge leads out of are two motions of one
motif, and the walk blends from the one to the other along their time warps.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import Motif
from core.synthesis.links import SEEN, Link, even_warp, motion_features
from core.synthesis.timeline import Overlap, Timeline, crossfade

_ROOM = 0.12  # seconds: the shortest blend along a motif
_HASTY = 0.3  # seconds of a blend where there is no room along the motif
_NEVER = 2**31  # later than any frame
_CRAMPED = 1e3  # metres: cost of leaving a motif before the blends in it have room


@dataclass(frozen=True)
class Plan:
    """What to stitch (:func:`core.synthesis.stitching.stitch`), and where the motifs lie in it.

    pieces, overlaps: as ``stitch`` takes them. visits: per motif of the path (piece, frame) of its beginning and of its
    end, frames of the pieces' clips; a motif that is entered or left in a cross-fade begins or ends with its piece.
    """

    pieces: tuple[Segment, ...]
    overlaps: tuple[Overlap, ...]
    visits: tuple[tuple[tuple[int, int], tuple[int, int]], ...]


def smoothest(dataset: Dataset, motifs: Mapping[int, Motif], choices: Sequence[Sequence[Link]]) -> tuple[Link, ...]:
    """One link a step, so that what is blended differs least: the motions inside each motif, and the links' ends.

    motifs: by id; choices: the links of each step, none empty. Dynamic programming over the steps.
    """
    if not choices:
        return ()
    apart: dict[int, np.ndarray] = {}
    total = np.array([link.cost for link in choices[0]])
    back = []
    for before, after in pairwise(choices):
        motif = motifs[before[0].target]
        if motif.id not in apart:
            apart[motif.id] = _apart(motion_features(dataset, motif))
        ends = [link.enter for link in before], [link.leave for link in after]
        cost = total[:, None] + apart[motif.id][np.ix_(*ends)] + _CRAMPED * _cramped(dataset, motif, before, after)
        back.append(cost.argmin(0))
        total = cost.min(0) + [link.cost for link in after]
    picked = [int(total.argmin())]
    for pointers in reversed(back):
        picked.append(int(pointers[picked[-1]]))
    return tuple(links[k] for links, k in zip(choices, reversed(picked), strict=True))


def lay_out(dataset: Dataset, motifs: Mapping[int, Motif], path: Sequence[int], links: Sequence[Link]) -> Plan:
    """The pieces of a walk along ``path`` (motif ids) by ``links``, one between every two.

    The walk begins and ends with a whole motion.
    """
    first = motifs[path[0]].segments[links[0].leave if links else motifs[path[0]].medoid]
    pieces, overlaps, visits = [], [], []
    clip, start = first.clip, first.start  # of the piece that is being laid

    def pass_over(overlap: Overlap, to: str) -> None:
        nonlocal clip, start
        pieces.append(Segment(clip, start, int(np.ceil(overlap.rows[-1, 0])) + 1))
        overlaps.append(overlap)
        clip, start = to, int(overlap.rows[0, 1])

    for motif_id, (into, out) in zip(path, pairwise([None, *links, None]), strict=True):
        motif = motifs[motif_id]
        begins = (len(pieces), into.entry.frame if into and into.kind == SEEN else 0)
        if into and out and into.enter != out.leave:
            pass_over(_inside(dataset, motif, into, out), motif.segments[out.leave].clip)
        last = motif.segments[into.enter] if into else first
        end = last.end if out is None else out.exit.frame if out.kind == SEEN else _NEVER
        visits.append((begins, (len(pieces), end)))
        if out and out.kind != SEEN:
            pass_over(Overlap(_fade(dataset, out), out.lasts, along=False), out.entry.clip)
    pieces.append(Segment(clip, start, last.end))
    return Plan(tuple(pieces), tuple(overlaps), tuple(visits))


def visit_ends(plan: Plan, timeline: Timeline) -> np.ndarray:
    """Output frame at which each motif of the path is over: ``(n_visits,)``, rising."""
    places = place_along(*timeline.leading)
    return np.searchsorted(places, [place_along(*end) for _, end in plan.visits])


def place_along(piece: np.ndarray | int, frame: np.ndarray | float) -> np.ndarray:
    """One rising number for places along the pieces, ``(...)``: a piece and a frame of its clip, both ``(...)``."""
    return np.asarray(piece, np.float64) * 2.0 * _NEVER + frame


def _inside(dataset: Dataset, motif: Motif, into: Link, out: Link) -> Overlap:
    """From the motion entered to the motion left, from where the one link's cross-fade is over to where the other's
    begins: along their warps, or in a short cross-fade where there is no room for that."""
    low, high = _row_after(dataset, motif, into), _row_before(dataset, motif, out)
    rows = np.arange(np.ceil(low), np.floor(high) + 1).astype(int)
    if len(rows) < 2:
        return Overlap(_hasty(dataset, motif, into, out), along=False)
    starts = [motif.segments[motion].start for motion in (into.enter, out.leave)]
    warps = [even_warp(dataset, motif, motion)[rows] for motion in (into.enter, out.leave)]
    return Overlap(np.column_stack(warps) + starts)


def _hasty(dataset: Dataset, motif: Motif, into: Link, out: Link) -> np.ndarray:
    """A short cross-fade from where the one motion may be left to where the other has to be reached, ``(k, 2)``."""
    a, b = (dataset.clip(motif.segments[motion].clip) for motion in (into.enter, out.leave))
    begin = into.entry.frame if into.kind == SEEN else _fade(dataset, into)[-1, 1]
    end = out.exit.frame - 1 if out.kind == SEEN else _fade(dataset, out)[0, 0]
    seconds = min(_HASTY, (a.n_frames - 1 - begin) / a.fps, end / b.fps)
    k = max(2, round(seconds * a.fps) + 1)
    return np.column_stack([np.linspace(begin, begin + seconds * a.fps, k), np.linspace(end - seconds * b.fps, end, k)])


def _cramped(dataset: Dataset, motif: Motif, before: Sequence[Link], after: Sequence[Link]) -> np.ndarray:
    """Whether there is no room in the motif between coming by one link and leaving by another: ``(n, m)`` bool."""
    rate = dataset.clip(motif.segments[motif.medoid].clip).fps
    low = np.array([_row_after(dataset, motif, link) for link in before])
    high = np.array([_row_before(dataset, motif, link) for link in after])
    same = np.equal.outer([link.enter for link in before], [link.leave for link in after])
    fits: np.ndarray = high[None] - low[:, None] < np.where(same, 0, min(_ROOM * rate, len(motif.warps[0]) - 1))
    return fits


def _row_after(dataset: Dataset, motif: Motif, link: Link) -> float:
    """Row of the motif's warps at which the way in by ``link`` is over."""
    return 0.0 if link.kind == SEEN else _row(dataset, motif, link.enter, _fade(dataset, link)[-1, 1])


def _row_before(dataset: Dataset, motif: Motif, link: Link) -> float:
    """Row of the motif's warps at which the way out by ``link`` begins."""
    return (
        len(motif.warps[0]) - 1.0 if link.kind == SEEN else _row(dataset, motif, link.leave, _fade(dataset, link)[0, 0])
    )


def _fade(dataset: Dataset, link: Link) -> np.ndarray:
    a, b = (dataset.clip(moment.clip) for moment in (link.exit, link.entry))
    return crossfade(a, link.exit.frame, b, link.entry.frame, link.seconds)


def _row(dataset: Dataset, motif: Motif, motion: int, frame: float) -> float:
    """Row of the warps, a frame of the medoid, at which ``motion`` is at ``frame`` of its clip."""
    warp = even_warp(dataset, motif, motion)
    rising = warp + 1e-6 * np.arange(len(warp))
    return float(np.interp(frame - motif.segments[motion].start, rising, np.arange(len(warp))))


def _apart(features: np.ndarray) -> np.ndarray:
    """Mean distance of every two motions over their samples, ``(n, n)``; features ``(n, samples, d)``."""
    total = np.zeros((len(features), len(features)))
    for sample in np.moveaxis(features.astype(np.float64), 1, 0):
        square = (sample**2).sum(1)
        total += np.sqrt(np.maximum(square[:, None] + square[None] - 2 * sample @ sample.T, 0))
    mean: np.ndarray = total / features.shape[1]
    return mean
