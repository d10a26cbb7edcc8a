"""Ways from a motion of one motif to a motion of another: seen in the recordings, found by likeness, or forced.

Seen: one motion follows the other in a clip (MMG section 4). Further: moments inside two motions that are so alike that
one can pass into the other (MMG section 5.3). Bridge: the most alike end and beginning, however unlike they are.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import Motif, MotifGraph
from core.poses.features import principal_directions
from core.synthesis.postures import Moment, moments_apart
from core.synthesis.timeline import crossfade, smooth_warp

SEEN, FURTHER, BRIDGE = "seen", "further", "bridge"

_FADE, _LONGEST_FADE = 0.4, 0.8  # seconds: a cross-fade between alike moments, and between the most unlike
_PACE = 0.2  # metres a second at which the joints, in the mean, are carried across a cross-fade
_HALF_ROOM = 0.06  # seconds on either side of a motion's middle that cross-fades leave alone
_EVERY = 0.1  # seconds between two moments that are looked at for further links
_MARGIN = 0.3  # seconds on either side of a motion's middle that moments for further links keep from
_VARIANCE, _DIMENSIONS = 0.97, 16  # of the clouds that the tree holds: the variance kept, and dimensions at most
_NEIGHBOURS = 64
_MOMENTS = 48  # a motif's moments that are looked at, spread over its motions


_NONE = -1  # no motif
_Candidate = tuple[int, int, Moment]  # motif, motion and a moment of it


class Link(NamedTuple):
    """One way from motif ``source`` to motif ``target``.

    leave, enter: which motion of each; exit, entry: the moments that stand beside one another; for a seen link the end
    of the one motion and the start of the other, of one clip. cost: how unlike these two moments are, metres;
    seconds: of either motion that are cross-faded; lasts: seconds that this takes at least (all 0 where seen).
    """

    kind: str
    source: int
    target: int
    leave: int
    enter: int
    exit: Moment
    entry: Moment
    cost: float = 0.0
    seconds: float = 0.0
    lasts: float = 0.0


def seen_links(graph: MotifGraph, clips: Collection[str] | None = None) -> dict[tuple[int, int], tuple[Link, ...]]:
    """The successions behind every edge, by (source, target); only those in ``clips`` where these are given."""
    ends = {(s.clip, s.end): (motif.id, k) for motif in graph.motifs for k, s in enumerate(motif.segments)}
    starts = {(s.clip, s.start): (motif.id, k) for motif in graph.motifs for k, s in enumerate(motif.segments)}
    links_of_ends: dict[tuple[int, int], tuple[Link, ...]] = {}
    for edge in graph.edges:
        links = []
        for between in edge.transitions:
            source, leave = ends.get((between.clip, between.start), (_NONE, 0))
            target, enter = starts.get((between.clip, between.end), (_NONE, 0))
            if (source, target) == (edge.source, edge.target) and (clips is None or between.clip in clips):
                moments = Moment(between.clip, between.start), Moment(between.clip, between.end)
                links.append(Link(SEEN, source, target, leave, enter, *moments))
        if links:
            links_of_ends[edge.source, edge.target] = tuple(links)
    return links_of_ends


def bridge_links(
    dataset: Dataset, source: Motif, target: Motif, clips: Collection[str] | None = None, most: int = 6
) -> tuple[Link, ...]:
    """The ``most`` most alike pairs of an end of a motion of ``source`` and a beginning of one of ``target``.

    clips: only motions of these, where given; none may be left.
    """
    ends = [(k, Moment(s.clip, s.end - 1)) for k, s in _motions(source, clips)]
    starts = [(k, Moment(s.clip, s.start)) for k, s in _motions(target, clips)]
    if not ends or not starts:
        return ()
    features = moments_apart(dataset, [moment for _, moment in ends + starts])
    apart = np.linalg.norm(features[: len(ends), None] - features[None, len(ends) :], axis=2)
    best = np.argsort(apart, axis=None, kind="stable")[:most]
    rows, columns = np.unravel_index(best, apart.shape)
    return tuple(
        _link(dataset, BRIDGE, (source, *ends[i]), (target, *starts[k]), float(apart[i, k]))
        for i, k in zip(rows, columns, strict=True)
    )


def further_links(
    dataset: Dataset,
    graph: MotifGraph,
    clips: Collection[str] | None = None,
    limit: float | None = None,
    per_motif: int = 4,
) -> dict[tuple[int, int], tuple[Link, ...]]:
    """Links between moments inside motions of different motifs that no edge joins, best ``per_motif`` of each motif.

    clips: only motions of these, where given. limit: metres, how unlike two moments may be; where None, no more unlike
    than nine in ten moments that stand beside one another within the motifs. Candidates come from a k-d tree over point
    clouds, so the cost grows with the number of moments and not with its square.
    """
    exits, entries = _candidates(dataset, graph, clips)
    if not exits or not entries:
        return {}
    limit = typical_distance(dataset, graph) if limit is None else limit
    features = moments_apart(dataset, [row[2] for row in exits] + [row[2] for row in entries])
    mean, basis, _ = principal_directions(features, _VARIANCE)
    reduced = (features - mean) @ basis[:, :_DIMENSIONS]
    tree = cKDTree(reduced[len(exits) :])
    # a reduced distance is never larger than the whole one
    _, near = tree.query(reduced[: len(exits)], k=min(_NEIGHBOURS, len(entries)), distance_upper_bound=limit)
    near = near.reshape(len(exits), -1)
    i, column = np.nonzero(near < len(entries))
    k = near[i, column]
    apart = np.linalg.norm(features[i] - features[len(exits) + k], axis=1)
    motifs = {motif.id: motif for motif in graph.motifs}
    taken = {(edge.source, edge.target) for edge in graph.edges} | {(motif, motif) for motif in motifs}
    count: dict[int, int] = {}
    links: dict[tuple[int, int], tuple[Link, ...]] = {}
    for at in np.argsort(apart, kind="stable"):
        (source, leave, here), (target, enter, there) = exits[i[at]], entries[k[at]]
        if apart[at] > limit or (source, target) in taken or count.get(source, 0) >= per_motif:
            continue
        taken.add((source, target))
        count[source] = count.get(source, 0) + 1
        ends = (motifs[source], leave, here), (motifs[target], enter, there)
        links[source, target] = (_link(dataset, FURTHER, *ends, float(apart[at])),)
    return links


def typical_distance(dataset: Dataset, graph: MotifGraph, share: float = 0.9) -> float:
    """How unlike moments are that stand beside one another within motifs: the ``share`` quantile, metres."""
    apart = []
    for motif in graph.motifs:
        features = motion_features(dataset, motif)
        apart.append(
            np.linalg.norm(features - features[motif.medoid], axis=2)[np.arange(len(features)) != motif.medoid]
        )
    return float(np.quantile(np.concatenate([a.ravel() for a in apart]), share)) if apart else 0.0


def motion_features(dataset: Dataset, motif: Motif, samples: int = 5) -> np.ndarray:
    """Features of every motion of a motif at a few registered moments: ``(n_motions, samples, n_features)``, metres."""
    rows = np.linspace(0, len(motif.warps[0]) - 1, samples).round().astype(int)
    moments = [
        Moment(s.clip, s.start + round(float(warp[r])))
        for s, warp in zip(motif.segments, motif.warps, strict=True)
        for r in rows
    ]
    return moments_apart(dataset, moments).reshape(motif.n_motions, samples, -1)


def even_warp(dataset: Dataset, motif: Motif, motion: int) -> np.ndarray:
    """The warp of a motion, evened out, from its first frame to its last: ``(n_medoid_frames,)``, from its start."""
    warp = motif.warps[motion].astype(np.float64)
    warp[0], warp[-1] = 0.0, motif.segments[motion].n_frames - 1.0
    return smooth_warp(warp, dataset.clip(motif.segments[motif.medoid].clip).fps)


def _motions(motif: Motif, clips: Collection[str] | None) -> list[tuple[int, Segment]]:
    return [(k, s) for k, s in enumerate(motif.segments) if clips is None or s.clip in clips]


def _candidates(
    dataset: Dataset, graph: MotifGraph, clips: Collection[str] | None
) -> tuple[list[_Candidate], list[_Candidate]]:
    """(motif, motion, moment) rows: where motions may be left, in their second halves, and entered, in their first."""
    exits: list[_Candidate] = []
    entries: list[_Candidate] = []
    for motif in graph.motifs:
        leave: list[_Candidate] = []
        enter: list[_Candidate] = []
        for k, s in _motions(motif, clips):
            middle, fps = _middle(dataset, motif, k), dataset.clip(s.clip).fps
            step, margin = max(1, round(_EVERY * fps)), _MARGIN * fps
            leave += [(motif.id, k, Moment(s.clip, f)) for f in range(s.end - 1, int(middle + margin), -step)]
            enter += [(motif.id, k, Moment(s.clip, f)) for f in range(s.start, int(middle - margin) + 1, step)]
        exits += _spread(leave)
        entries += _spread(enter)
    return exits, entries


def _spread(rows: list[_Candidate]) -> list[_Candidate]:
    """At most a motif's share of moments, taken evenly."""
    return [rows[i] for i in np.unique(np.linspace(0, len(rows) - 1, _MOMENTS).round().astype(int))] if rows else []


def _link(
    dataset: Dataset, kind: str, left: tuple[Motif, int, Moment], entered: tuple[Motif, int, Moment], cost: float
) -> Link:
    """With a cross-fade that lasts the longer the more unlike the moments are. left, entered: a motion of a motif, and
    the moment of it.

    It stays in the second half of the motion that is left and in the first half of the one that is entered, so that a
    motion may be entered and left by any two links.
    """
    source, leave, here = left
    target, enter, there = entered
    a, b = dataset.clip(here.clip), dataset.clip(there.clip)
    room_a = (here.frame - _middle(dataset, source, leave)) / a.fps - _HALF_ROOM
    room_b = (_middle(dataset, target, enter) - there.frame) / b.fps - _HALF_ROOM
    least = min(source.segments[leave].n_frames / a.fps, target.segments[enter].n_frames / b.fps) / 3
    room = max(room_a, least), max(room_b, least)
    seconds = min(float(np.clip(cost / _PACE, _FADE, _LONGEST_FADE)), 2 * min(room))
    rows = crossfade(a, here.frame, b, there.frame, seconds)
    # near the end of a recording the cross-fade lies to one side
    if rows[0, 0] < here.frame - room[0] * a.fps or rows[-1, 1] > there.frame + room[1] * b.fps:
        seconds = min(seconds, *room)
    return Link(kind, source.id, target.id, leave, enter, here, there, cost, seconds, max(seconds, cost / _PACE))


def _middle(dataset: Dataset, motif: Motif, motion: int) -> float:
    """The frame of a motion's clip that stands beside the middle of the medoid."""
    warp = even_warp(dataset, motif, motion)
    return motif.segments[motion].start + float(warp[len(warp) // 2])
