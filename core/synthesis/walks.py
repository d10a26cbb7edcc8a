"""Walks: new motion along a path through the motif graph (MMG sections 4 and 5.3)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from typing import NamedTuple

import numpy as np

from core.errors import AnalysisError, MotionscapeError, ParameterError
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.progress import Report, silent
from core.synthesis.footing import Skate
from core.synthesis.links import BRIDGE, FURTHER, Link, bridge_links
from core.synthesis.paths import (
    Between,
    NoWay,
    Random,
    Ways,
    fill_gaps,
    open_ways,
    parse_path,
    random_path,
    skeleton_families,
)
from core.synthesis.planning import Plan, lay_out, place_along, smoothest, visit_ends
from core.synthesis.stitching import Speeds, Stitched, stitch
from core.synthesis.timeline import schedule

TRANSITION = -1
"""The motif of a part between two motifs."""

_TRIES = 5  # at a random path of the length asked for
_FINE = 30.0  # frames a second at which its length is measured


class Part(NamedTuple):
    """Frames [start, end) of a walk: the motif they belong to, or TRANSITION, and the source frames they show.

    visit: where on the path that motif stands, -1 in a transition. fading: in a blend the other source, which counts
    for less; None elsewhere.
    """

    start: int
    end: int
    motif: int
    visit: int
    source: Segment
    fading: Segment | None = None


@dataclass(frozen=True, eq=False)
class Walk:
    """A walk.

    clip: the motion, floor at height 0. path: motif ids. links: how each motif passes into the next. parts: where every
    frame comes from, in order and without gaps. seams: half-open frames of the blends. contacts ``(n_frames, 2)`` bool:
    which foot stands. skate: the foot-skate meter. speeds: of the fastest joint. warnings: plain words.
    """

    clip: Clip
    path: tuple[int, ...]
    links: tuple[Link, ...]
    parts: tuple[Part, ...]
    seams: tuple[tuple[int, int], ...]
    contacts: np.ndarray
    skate: Skate
    speeds: Speeds
    warnings: tuple[str, ...] = ()


class Route(NamedTuple):
    """A path that can be walked: motif ids, the links between them, and what a person should know."""

    path: tuple[int, ...]
    links: tuple[Link, ...]
    warnings: tuple[str, ...] = ()


def make_walk(
    dataset: Dataset,
    graph: MotifGraph,
    path: str | Sequence[int] | Between | Random,
    *,
    further: bool = False,
    gaps: str = "refuse",
    dead_end: str = "jump",
    keep_feet: bool = True,
    name: str = "walk",
    report: Report = silent,
) -> Walk:
    """New motion along a path; see :func:`find_route` for the path and :func:`core.synthesis.stitching.stitch`.

    keep_feet: False for plain blending. Deterministic. Raises ValueError in plain words (NoWay where an edge is
    missing), KeyError where the graph belongs to other clips.
    """
    report("path", 0.0)
    route = find_route(dataset, graph, path, further=further, gaps=gaps, dead_end=dead_end)
    plan = lay_out(dataset, {motif.id: motif for motif in graph.motifs}, route.path, route.links)
    made = stitch(dataset, plan.pieces, plan.overlaps, keep_feet=keep_feet, name=name, report=report)
    return Walk(
        clip=made.clip,
        path=route.path,
        links=route.links,
        parts=walk_parts(made, plan, route.path),
        seams=tuple((int(a), int(b)) for a, b in made.timeline.seams),
        contacts=made.contacts,
        skate=made.skate,
        speeds=made.speeds,
        warnings=route.warnings + made.warnings,
    )


def find_route(
    dataset: Dataset,
    graph: MotifGraph,
    path: str | Sequence[int] | Between | Random,
    *,
    further: bool = False,
    gaps: str = "refuse",
    dead_end: str = "jump",
) -> Route:
    """The motifs and links of a path, given as text (:mod:`core.synthesis.paths`) or as what the text stands for.

    further: also pass at good transition points inside motifs that no edge joins. gaps, where no edge leads on:
    "refuse", "detour" by the shortest way, or "bridge" by a blend. dead_end: what a random walk does there, "jump" or
    "stop". A walk keeps to skeletons with the same joints, those of most motion where several could walk it.
    Raises as :func:`make_walk`.
    """
    for value, known in ((gaps, ("refuse", "detour", "bridge")), (dead_end, ("jump", "stop"))):
        if value not in known:
            raise ParameterError(f"expected one of {', '.join(known)}, not {value!r}")
    wanted = parse_path(path) if isinstance(path, str) else path
    families = skeleton_families(dataset, graph)
    if not families:
        raise AnalysisError("This motif graph has no motifs to walk through.")
    refusal: MotionscapeError | None = None
    for family in range(len(families)):
        try:
            return _route(dataset, open_ways(dataset, graph, further, family), wanted, gaps, dead_end)
        except MotionscapeError as error:
            refusal = refusal or error
    assert refusal is not None
    raise refusal


def _route(dataset: Dataset, ways: Ways, wanted: Between | Random | Sequence[int], gaps: str, dead_end: str) -> Route:
    """Raises ValueError where these ways do not allow it."""
    ended = ""
    if isinstance(wanted, Random):
        path, links, ended = _random(dataset, ways, wanted, dead_end)
    else:
        path = _path(ways, wanted, gaps)
        links = _smoothest(dataset, ways, path, gaps)
    warnings = [ended] if ended else []
    for kind, words in ((BRIDGE, "bridged by a blend"), (FURTHER, "made at further transition points")):
        steps = [f"{link.source} to {link.target}" for link in links if link.kind == kind]
        if steps:
            shown = ", ".join(steps[:6]) + (f" and {len(steps) - 6} more" if len(steps) > 6 else "")
            warnings.append(f"Not seen in the recordings, but {words}: {shown}.")
    if path[-1] in ways.dead_ends and not ended:
        warnings.append(f"Motif {path[-1]} is a dead end: no other motif follows it.")
    return Route(path, links, tuple(warnings))


def _path(ways: Ways, wanted: Between | Sequence[int], gaps: str) -> tuple[int, ...]:
    if isinstance(wanted, Between):
        path = ways.shortest(wanted)
        if path is None and gaps != "bridge":
            raise NoWay(wanted.start, wanted.target, None)
        return path or (wanted.start, wanted.target)
    if not wanted:
        raise ParameterError("A walk needs at least one motif.")
    for motif in wanted:
        ways.check(motif)
    return fill_gaps(ways, wanted) if gaps == "detour" else tuple(wanted)


def _random(
    dataset: Dataset, ways: Ways, wanted: Random, dead_end: str
) -> tuple[tuple[int, ...], tuple[Link, ...], str]:
    """A random path cut where its time is nearest: the mean lengths it is drawn by are not those of its motions.

    Raises ValueError where there is nothing to walk."""
    seconds = wanted.seconds
    for _ in range(_TRIES):
        path, ended = random_path(dataset, ways, wanted._replace(seconds=seconds), dead_end)
        links = _smoothest(dataset, ways, path, "bridge")  # where it jumps
        plan = lay_out(dataset, ways.motifs, path, links)
        rates = [dataset.clip(piece.clip).fps for piece in plan.pieces]
        ends = visit_ends(plan, schedule(plan.pieces, rates, plan.overlaps, _FINE)) / _FINE
        if ends[-1] >= wanted.seconds:
            n = int(np.abs(ends - wanted.seconds).argmin()) + 1
            return path[:n], links[: n - 1], ""
        if ended:
            break
        seconds *= 1.5  # the same seed takes the same way, and goes on
    return path, links, ended


def _smoothest(dataset: Dataset, ways: Ways, path: Sequence[int], gaps: str) -> tuple[Link, ...]:
    return smoothest(dataset, ways.motifs, [_choices(dataset, ways, step, gaps) for step in pairwise(path)])


def _choices(dataset: Dataset, ways: Ways, step: tuple[int, int], gaps: str) -> tuple[Link, ...]:
    if step in ways.links:
        return ways.links[step]
    source, target = step
    if gaps != "bridge":
        raise NoWay(source, target, ways.shortest(Between(source, target)) if source != target else None)
    return bridge_links(dataset, ways.motifs[source], ways.motifs[target], ways.clips)


def walk_parts(made: Stitched, plan: Plan, path: Sequence[int]) -> tuple[Part, ...]:
    """Where every frame of a walk comes from: runs of frames with the same motif and the same sources."""
    leading, frames = made.timeline.leading
    motif = np.full(len(leading), TRANSITION)
    visit = np.full(len(leading), -1)
    where = place_along(leading, frames)
    for k, (begin, end) in enumerate(plan.visits):
        inside = (where >= place_along(*begin)) & (where < place_along(*end))
        motif[inside], visit[inside] = path[k], k
    fading = np.where(made.timeline.pieces[:, 0] == leading, made.timeline.pieces[:, 1], made.timeline.pieces[:, 0])
    other = np.where(made.timeline.pieces[:, 0] == leading, made.timeline.frames[:, 1], made.timeline.frames[:, 0])
    rows = np.column_stack([visit, leading, fading])
    parts = []
    for _, group in groupby(range(len(rows)), key=lambda k: tuple(rows[k])):
        span = list(group)
        a, b = span[0], span[-1] + 1
        source = _shown(made.pieces[leading[a]].clip, frames[a:b])
        faded = None if leading[a] == fading[a] else _shown(made.pieces[fading[a]].clip, other[a:b])
        parts.append(Part(a, b, int(motif[a]), int(visit[a]), source, faded))
    return tuple(parts)


def _shown(clip: str, frames: np.ndarray) -> Segment:
    return Segment(clip, int(np.floor(frames[0])), int(np.floor(frames[-1])) + 1)
