"""Groups compared: use of items, transitions between them, figures of gait and posture, curves of each movement."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.groups.clusters import cluster_test
from core.groups.curves import POINTS, SPEED, all_curves, unit_curves
from core.groups.design import Design
from core.groups.figures import FIGURES, ByClip, figure_table, figures_by_clip
from core.groups.parameters import GroupParameters
from core.groups.permutation import benjamini_hochberg, compare_all, compare_two, smallest_p
from core.groups.tables import MEASURES, Item, transitions, use_table
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.progress import Report, silent, timed

Motions = Sequence[tuple[Segment, FloatArray]]
"""Motions of a motif with their warps: see core.motifs.graph.Motif."""


class Comparison(NamedTuple):
    """One row: what was compared of two groups, second minus first.

    kind: motif, action, routine, label, figure or transition. id, name: of what. measure: share, rate, duration, mean
    or probability.
    means, n: of the groups, and units with a value. low, high: 95 % interval of the difference. effect: Hedges' g, or
    paired. p: by permutation; q: after Benjamini and Hochberg over the rows of this kind.
    p_all: of all groups at once where there are more than two. nan where a group has fewer than two units with a value.
    """

    kind: str
    id: str
    name: str
    measure: str
    unit: str
    groups: tuple[str, str]
    means: tuple[float, float]
    n: tuple[int, int]
    difference: float
    low: float
    high: float
    effect: float
    p: float
    q: float
    p_all: float


class CurveDifference(NamedTuple):
    """A curve of a movement in two groups. means, spreads: ``(2, POINTS)`` of units; n: of units in each group.

    clusters: (start, end) in per cent of the movement, sign of second minus first, p over the whole curve, and q after
    Benjamini and Hochberg over all curves (the smallest p of a curve; 1 where it has no cluster).
    """

    item: str
    curve: str
    unit: str
    groups: tuple[str, str]
    n: tuple[int, int]
    means: FloatArray
    spreads: FloatArray
    clusters: tuple[tuple[float, float, int, float], ...]
    q: float


@dataclass(frozen=True)
class GroupComparison:
    """Everything that was compared.

    rows: of items and figures; transitions: what follows what; least_p: the smallest p-value that so few units can
    give; minutes: of motion in each group; by_clip: figures of every clip; seconds: stage -> time.
    """

    design: Design
    parameters: GroupParameters
    items: tuple[Item, ...]
    rows: tuple[Comparison, ...]
    transitions: tuple[Comparison, ...]
    curves: tuple[CurveDifference, ...]
    least_p: float
    minutes: Mapping[str, float]
    by_clip: ByClip = field(default_factory=dict)
    seconds: Mapping[str, float] = field(default_factory=dict)

    def found(self) -> tuple[Comparison, ...]:
        """Rows whose difference counts after the correction, largest effect first."""
        hits = [row for row in self.rows if row.q <= self.parameters.alpha]
        return tuple(sorted(hits, key=lambda row: -abs(row.effect)))


def compare_groups(
    dataset: Dataset,
    design: Design,
    items: Sequence[Item],
    motions: Mapping[str, Motions] | None = None,
    parameters: GroupParameters | None = None,
    report: Report = silent,
) -> GroupComparison:
    """Compares the groups of a design.

    items: motifs, actions or labels. motions: id of a motif -> its motions, for curves.
    Raises Cancelled from ``report``.
    """
    parameters = parameters or GroupParameters()
    seconds: dict[str, float] = {}
    clips = {clip.name: (clip.n_frames, clip.fps) for clip in dataset.clips}
    with timed("figures", seconds):
        by_clip = figures_by_clip(design, dataset, report)
        figures = figure_table(design, by_clip)
    with timed("tests", seconds):
        report("testing", 0.0)
        use = use_table(design, items, clips)
        rows = table_rows(design, [(item.kind, item.id, item.name) for item in items], use, figures, parameters)
        report("testing", 0.5)
        single = [item for item in items if item.kind != "routine"]  # routines are rows of actions themselves
        pairs, shares, _ = transitions(design, single)
        names = [(f"{single[a].id}>{single[b].id}", f"{single[a].name} to {single[b].name}") for a, b in pairs]
        of_pairs = [("transition", id, name, "probability", "") for id, name in names]
        following = _tested(design, of_pairs, shares, parameters)
    with timed("curves", seconds):
        curves = _curves(dataset, design, motions or {}, parameters, report)
    minutes = {
        group: sum(
            clips[clip][0] / clips[clip][1] / 60 for unit in design.units if unit.group == group for clip in unit.clips
        )
        for group in design.groups
    }
    least = min(smallest_p(design.pair(a, b), parameters.permutations) for a, b in combinations(design.groups, 2))
    return GroupComparison(
        design, parameters, tuple(items), rows, tuple(following), curves, least, minutes, by_clip, seconds
    )


def table_rows(
    design: Design,
    items: Sequence[tuple[str, str, str]],
    use: FloatArray,
    figures: FloatArray,
    parameters: GroupParameters,
) -> tuple[Comparison, ...]:
    """The rows of a table of use, ``(n_units, n_items, 3)``, and one of figures, ``(n_units, n_figures)``.

    items: kind, id and name of each. The correction is over all rows of a table, for all pairs of groups together.
    """
    columns = [(*item, measure, unit) for item in items for measure, unit in MEASURES]
    of_figures = [("figure", name, name, "mean", unit) for name, unit in FIGURES.items()]
    rows = _tested(design, columns, use.reshape(len(use), -1), parameters)
    return (*rows, *_tested(design, of_figures, figures, parameters))


def _tested(
    design: Design, columns: Sequence[tuple[str, str, str, str, str]], values: FloatArray, parameters: GroupParameters
) -> list[Comparison]:
    """A row for each column and pair of groups; the correction is over all of them."""
    if not columns:
        return []
    several = len(design.groups) > 2
    p_all = compare_all(design, values, parameters.permutations, parameters.seed)[0] if several else None
    rows = []
    for a, b in combinations(design.groups, 2):
        pair = design.pair(a, b)
        own = np.array([k for group in (a, b) for k, unit in enumerate(design.units) if unit.group == group])
        tested = compare_two(pair, values[own], parameters.permutations, parameters.resamples, parameters.seed)
        counts = [np.isfinite(values[own][pair.codes == group]).sum(0) for group in (0, 1)]
        for k, (kind, id, name, measure, unit) in enumerate(columns):
            own_means, own_counts = (tuple(float(m[k]) for m in tested.means), tuple(int(c[k]) for c in counts))
            row = Comparison(
                kind=kind,
                id=id,
                name=name,
                measure=measure,
                unit=unit,
                groups=(a, b),
                means=(own_means[0], own_means[1]),
                n=(own_counts[0], own_counts[1]),
                difference=float(tested.difference[k]),
                low=float(tested.low[k]),
                high=float(tested.high[k]),
                effect=float(tested.effect[k]),
                p=float(tested.p[k]),
                q=float("nan"),
                p_all=float(p_all[k]) if p_all is not None else float("nan"),
            )
            rows.append(row)
    corrected = benjamini_hochberg(np.array([row.p for row in rows]))
    return [row._replace(q=float(q)) for row, q in zip(rows, corrected, strict=True)]


def _curves(
    dataset: Dataset, design: Design, motions: Mapping[str, Motions], parameters: GroupParameters, report: Report
) -> tuple[CurveDifference, ...]:
    if not motions:
        return ()
    clips = list(dict.fromkeys(clip for unit in design.units for clip in unit.clips))
    curves = all_curves(dataset, clips, report)
    names = list(dict.fromkeys(name for own in curves.values() for name in own))
    found = []
    for number, (item, own) in enumerate(motions.items()):
        report("comparing curves", number / len(motions))
        for a, b in combinations(design.groups, 2):
            found += [one for name in names if (one := _curve(design.pair(a, b), curves, item, name, own, parameters))]
    least = [min((cluster[3] for cluster in one.clusters), default=1.0) for one in found]
    corrected = benjamini_hochberg(np.array(least))
    return tuple(one._replace(q=float(q)) for one, q in zip(found, corrected, strict=True))


def _curve(
    design: Design,
    curves: Mapping[str, Mapping[str, FloatArray]],
    item: str,
    name: str,
    motions: Motions,
    parameters: GroupParameters,
) -> CurveDifference | None:
    """A curve of a movement in two groups; None where a group has fewer than two units that do it."""
    values = unit_curves(design, curves, name, motions)
    there = [bool(np.isfinite(curve).all()) for curve in values]
    if design.paired:
        names = [unit.name for unit, has in zip(design.units, there, strict=True) if has]
        there = [names.count(unit.name) == 2 for unit in design.units]
    design = replace(design, units=tuple(unit for unit, has in zip(design.units, there, strict=True) if has))
    values = values[there]
    sizes = [int((design.codes == group).sum()) if design.units else 0 for group in (0, 1)]
    if min(sizes) < 2:
        return None
    test = cluster_test(design, values, parameters.permutations, parameters.alpha, parameters.seed)
    clusters = []
    for cluster in test.clusters:
        at = np.flatnonzero(cluster.where)
        start, end = (100.0 * int(k) / (POINTS - 1) for k in (at[0], at[-1]))
        clusters.append((start, end, cluster.sign, cluster.p))
    own = [values[design.codes == group] for group in (0, 1)]
    means, spreads = np.array([one.mean(0) for one in own]), np.array([one.std(0, ddof=1) for one in own])
    unit = "m/s" if name == SPEED else "°"
    return CurveDifference(
        item,
        name,
        unit,
        (design.groups[0], design.groups[1]),
        (sizes[0], sizes[1]),
        means,
        spreads,
        tuple(clusters),
        1.0,
    )
