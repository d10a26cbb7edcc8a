"""From recordings to terminals (SYN section 4)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace
from functools import partial
from typing import Any

import numpy as np
from threadpoolctl import threadpool_limits

from core.grammar.alternation import alternate, cut_by_medoids, even_cuts, recombine
from core.grammar.fine_tuning import fine_tune
from core.grammar.genetic import GeneticSettings, genetic_spans
from core.grammar.grouping import choose_groups, grouped, nearest_groups
from core.grammar.objective import Clustering
from core.grammar.parameters import TerminalParameters
from core.grammar.pose_space import PoseSpace, pose_space
from core.grammar.terminals import Terminals
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.progress import Progress, Report, part_of, silent, timed, unheard

_ROUGH_FPS = 6.0  # results are recombined at about this rate; the search begins at half of it
_SURPLUS = (2.0, 1.6, 1.3)  # times as many groups as asked for, in the first turns
_FINE_TURNS = 3
_SEARCHED_SECONDS, _PIECE_SECONDS = 1200, 120  # longer recordings: search in so much of them, in pieces so long
_PARENTS = 3  # of a recombination
# where the number of terminals is chosen: searches, each for so many terminals, its random starts and recombinations
_SEARCHES, _FINE, _FEW = 6, 20, 4


def find_terminals(
    dataset: Dataset, parameters: TerminalParameters | None = None, report: Report = silent
) -> Terminals:
    """The terminals of a data set. Deterministic: the same clips and seed give the same terminals, in whatever order.

    Terminals are numbered by their frames, most first. Raises ValueError where there are no clips, no common joints, or
    fewer possible segments than terminals; ``report`` may raise to stop the work.
    """
    parameters = parameters or TerminalParameters()
    seconds: dict[str, float] = {}
    with timed("poses", seconds):
        space = space_of(dataset, parameters, report)
    with timed("search", seconds):
        clustering, description = chosen(space, parameters, report)
    return replace(terminals_of(space, clustering, parameters, dataset, seconds), description=description)


def find_several(
    dataset: Dataset, parameters: TerminalParameters, numbers: Sequence[int], report: Report = silent
) -> tuple[Terminals, ...]:
    """Terminals for each of several numbers of them, poses computed once; otherwise as :func:`find_terminals`.

    For charts of F, R and E' over the number of terminals. Raises ValueError as that does, also where ``numbers`` is
    empty.
    """
    if not numbers:
        raise ValueError("say for which numbers of terminals")
    seconds: dict[str, float] = {}
    with timed("poses", seconds):
        space = space_of(dataset, parameters, report)
    terminals_by_number = []
    for i, number in enumerate(numbers):
        chosen, own = replace(parameters, n_terminals=number), dict(seconds)

        def progress(stage: str, share: float, i: int = i) -> None:
            report(stage, (i + share) / len(numbers))

        with timed("search", own):
            clustering = search(space, chosen, progress)
        terminals_by_number.append(terminals_of(space, clustering, chosen, dataset, own))
    return tuple(terminals_by_number)


def space_of(dataset: Dataset, parameters: TerminalParameters, report: Report = silent) -> PoseSpace:
    """The pose space that ``parameters`` ask for."""
    return pose_space(
        dataset,
        analysis_fps=parameters.analysis_fps,
        pose=parameters.pose,
        velocity=parameters.velocity,
        mirrored=parameters.mirror,
        seed=parameters.seed,
        report=report,
    )


def search(space: PoseSpace, parameters: TerminalParameters, report: Report = silent) -> Clustering:
    """The clustering of ``space`` that the method of ``parameters`` finds. Raises ValueError as find_terminals does."""
    with threadpool_limits(1, user_api="blas"):  # thousands of small products: threads would wait for one another
        return (_alternation if parameters.method == "alternation" else _paper)(space, parameters, report)


def chosen(
    space: PoseSpace, parameters: TerminalParameters, report: Report = silent
) -> tuple[Clustering, dict[int, float]]:
    """The clustering of ``space``, and where the number of terminals is chosen, number -> nats that describe a piece.

    See :mod:`core.grammar.grouping`. With the paper's search the number is chosen so and the rest is the paper's.
    Raises ValueError as find_terminals does.
    """
    if parameters.n_terminals != "auto":
        return search(space, parameters, report), {}
    rng = np.random.default_rng(parameters.seed)
    part, rows = space.sampled(round(_SEARCHED_SECONDS * space.fps), round(_PIECE_SECONDS * space.fps), rng)
    room = len(even_cuts(part, 1, limits_of(parameters, part.fps)))
    fine = replace(
        parameters, n_terminals=max(1, min(_FINE, room // 2)), method="alternation", starts=_FEW, crossings=_FEW
    )
    found = []
    for number in range(_SEARCHES):

        def progress(stage: str, share: float, number: int = number) -> None:
            report(stage, (number + share) / _SEARCHES)

        found.append(search(part, replace(fine, seed=parameters.seed * _SEARCHES + number), progress))
    heard = partial(report, "grouping")
    choice = choose_groups(part, found, parameters.seed, part_of(heard, 0.0, 0.2))
    groups = int(choice.labels.max()) + 1
    if parameters.method != "alternation":
        return search(space, replace(parameters, n_terminals=groups), report), dict(choice.description)
    best, left = found[choice.search], part_of(heard, 0.8, 1.0)
    if part is space:
        return grouped(space, best.spans, choice.labels, parameters.seed, left), dict(choice.description)
    models = np.stack([rows[best.spans[best.medoids, 0]], rows[best.spans[best.medoids, 1] - 1] + 1], axis=1)
    limits = limits_of(parameters, space.fps)
    spans, terminals = cut_by_medoids(space, models, limits, progress=part_of(heard, 0.2, 0.6))
    everything = Clustering(spans, best.medoids, terminals, np.zeros(len(spans)))
    labels = nearest_groups(space, everything, part, best, choice.labels, part_of(heard, 0.6, 0.8))
    return grouped(space, spans, labels, parameters.seed, left), dict(choice.description)


def limits_of(parameters: TerminalParameters, fps: float) -> tuple[int, int]:
    """Poses of the shortest and the longest segment at ``fps``."""
    shortest = max(1, round(parameters.min_seconds * fps))
    return shortest, max(2 * shortest, round(parameters.max_seconds * fps))


def _alternation(space: PoseSpace, parameters: TerminalParameters, report: Report) -> Clustering:
    """Several random starts at a very low rate, their results recombined at a low one, the best of these at the
    full rate; all but the last on a sample of long recordings, so that its time does not grow with them."""
    step = max(1, int(space.fps // _ROUGH_FPS))
    thin = space.thinned(step)
    enough = max(_SEARCHED_SECONDS, 4 * parameters.number * parameters.max_seconds)
    rng = np.random.default_rng(parameters.seed)
    part, rows = thin.sampled(round(enough * thin.fps), round(_PIECE_SECONDS * thin.fps), rng)
    coarse = part.thinned(2)
    beginnings = [part.unthinned(_models(one), 2, coarse) for one in _beginnings(coarse, parameters, report)]
    refined = []
    for k, medoids in enumerate(beginnings):
        report("recombination", 0.3 * k / len(beginnings))
        refined.append(_refined(part, medoids, parameters, turns=1))
    best = _models(_recombined(part, parameters, refined, report))
    medoids = np.stack([rows[best[:, 0]], rows[best[:, 1] - 1] + 1], axis=1)
    fine = partial(report, "fine search")
    return _refined(space, space.unthinned(medoids, step, thin), parameters, _FINE_TURNS, fine)[0]


def _models(found: Clustering) -> np.ndarray:
    """Spans of the medoids, ``(k, 2)``."""
    models: np.ndarray = found.spans[found.medoids]
    return models


def _refined(
    space: PoseSpace, medoids: np.ndarray, parameters: TerminalParameters, turns: int, progress: Progress = unheard
) -> tuple[Clustering, float]:
    """The clustering that medoids ``(k, 2)`` found at a lower rate lead to at the rate of ``space``; its cost."""
    k, limits = parameters.number, limits_of(parameters, space.fps)
    labels: np.ndarray | None
    cut = 1 / (turns + 1)
    spans, labels = cut_by_medoids(space, medoids, limits, progress=part_of(progress, 0, cut))
    if len(spans) < k:
        spans, labels = even_cuts(space, limits[0], limits), None
    rng = np.random.default_rng(parameters.seed)
    left = part_of(progress, cut, 1)
    return alternate(space, k, parameters.weight, limits, rng, spans=spans, labels=labels, turns=turns, progress=left)


def _beginnings(space: PoseSpace, parameters: TerminalParameters, report: Report) -> list[Clustering]:
    """The clustering from each of ``starts`` random starts."""
    k, limits, beginnings = parameters.number, limits_of(parameters, space.fps), []
    for start in range(parameters.starts):
        report("random starts", start / parameters.starts)
        rng = np.random.default_rng([parameters.seed, start])
        spans = even_cuts(space, rng.uniform(1.3 * limits[0], 0.7 * limits[1]), limits)
        if len(spans) < k:
            spans = even_cuts(space, limits[0], limits)
        beginnings.append(alternate(space, k, parameters.weight, limits, rng, spans=spans, surplus=_SURPLUS)[0])
    return beginnings


def _recombined(
    space: PoseSpace, parameters: TerminalParameters, found: list[tuple[Clustering, float]], report: Report
) -> Clustering:
    """The best clustering after ``crossings`` recombinations; a better child takes the place of its worst parent."""
    rng, limits = np.random.default_rng(parameters.seed), limits_of(parameters, space.fps)
    for crossing in range(parameters.crossings if len(found) > 1 else 0):
        report("recombination", 0.3 + 0.7 * crossing / parameters.crossings)
        parents = rng.choice(len(found), min(_PARENTS, len(found)), replace=False)
        chosen = [found[i][0] for i in parents]
        child = recombine(space, chosen, parameters.number, parameters.weight, limits, rng)
        worst = max(parents, key=lambda i: found[i][1])
        if child is None or any(np.isclose(child[1], cost, rtol=1e-9, atol=0) for _, cost in found):
            continue
        if child[1] < found[worst][1]:
            found[worst] = child
    return min(found, key=lambda one: one[1])[0]


def _paper(space: PoseSpace, parameters: TerminalParameters, report: Report) -> Clustering:
    """The paper's way: a genetic search for cuts on a grid, then fine tuning."""
    rng = np.random.default_rng(parameters.seed)
    limits = limits_of(parameters, space.fps)
    settings = GeneticSettings(parameters.grid, parameters.population, parameters.generations)
    spans = genetic_spans(space, parameters.number, parameters.weight, limits, rng, settings, report)
    return fine_tune(
        space,
        spans,
        parameters.number,
        parameters.weight,
        limits,
        rng,
        iterations=parameters.iterations,
        furthest=max(1, parameters.grid // 2),
        annealing=parameters.method == "annealing",
        report=report,
    )


def terminals_of(
    space: PoseSpace,
    clustering: Clustering,
    parameters: TerminalParameters,
    dataset: Dataset,
    seconds: dict[str, float] | None = None,
) -> Terminals:
    """A clustering of ``space`` in frames of the clips' own rates."""
    frames = np.bincount(clustering.labels, weights=clustering.lengths, minlength=len(clustering.medoids))
    order = np.lexsort((clustering.medoids, -frames))
    everything = [space.segment(start, end) for start, end in clustering.spans.tolist()]
    segments: list[tuple[Segment, ...]] = []
    for label in order:
        segments.append(tuple(everything[i] for i in np.flatnonzero(clustering.labels == label)))
    used: dict[str, Any] = asdict(parameters) | {"mirror": space.mirrored is not None}
    return Terminals(
        segments=tuple(segments),
        medoids=tuple(everything[clustering.medoids[label]] for label in order),
        objective=clustering.objective(space, parameters.weight),
        parameters=used,
        seconds=seconds or {},
        clips=tuple(zip(space.clips, space.clip_frames, space.clip_fps, strict=True)),
        dataset={"name": dataset.name, "fingerprint": dataset.fingerprint},
    )
