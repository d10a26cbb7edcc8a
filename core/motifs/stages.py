"""The pipeline of MMG in stages, each with the parameters that it reads, so that analyses can share stages.

A result depends on its data set and on what its stages read, and on nothing else, so analyses whose parameters agree up
to some stage share all the work to there. One analysis goes through the stages one after the other (:mod:`build`), a
sweep goes through them as a tree (:mod:`sweep`); both give the same result.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict
from time import perf_counter
from typing import Any, NamedTuple, TypeVar

import numpy as np

from core.machine import check_fits
from core.mocap.dataset import Dataset
from core.motifs.adjacency import Adjacency, nearest_pairs_radius, radius_adjacency, sphere_adjacency
from core.motifs.alignment import AlignedMotif, align_motifs, entry_frames, spans_of
from core.motifs.discovery import Substrings, largest_first, random_seeds
from core.motifs.graph import MotifGraph, dataset_head
from core.motifs.leftovers import join_leftovers
from core.motifs.matching import Matcher, Matches, Rule
from core.motifs.parameters import MotifParameters
from core.motifs.quantize import Letters, automatic_kappa, k_means
from core.motifs.result import graph_of
from core.motifs.samples import sampled_first
from core.poses.features import Poses, pose_features
from core.progress import Report
from core.sequences.repeats import Runs, remove_runs

Part = TypeVar("Part")


class Work(NamedTuple):
    """An analysis between two stages: what later stages need; what none needs any more is None again.

    seconds: what each stage took, in the order they were done.
    """

    dataset: Dataset | None = None
    poses: Poses | None = None
    letters: Letters | None = None
    runs: Runs | None = None
    matcher: Matcher | None = None
    matches: Matches | None = None
    found: list[Substrings] | None = None
    aligned: list[AlignedMotif] | None = None
    graph: MotifGraph | None = None
    seconds: Mapping[str, float] = {}


class Stage(NamedTuple):
    """name: under which its time is counted; reads: names of the parameters it reads itself."""

    name: str
    reads: tuple[str, ...]
    do: Callable[[Work, MotifParameters, Report], Work]

    def after(self, work: Work, parameters: MotifParameters, report: Report) -> Work:
        """The work with this stage done; nothing of ``work`` changes. May raise what ``report`` raises."""
        started = perf_counter()
        done = self.do(work, parameters, report)
        taken = work.seconds.get(self.name, 0.0) + perf_counter() - started
        return done._replace(seconds={**work.seconds, self.name: taken})

    def key(self, parameters: MotifParameters) -> tuple[Any, ...]:
        """What this stage reads: equal keys, and equal ones of all stages before, mean equal work."""
        return tuple(getattr(parameters, name) for name in self.reads)


def made(part: Part | None) -> Part:
    """A part of the work that an earlier stage has made."""
    assert part is not None
    return part


def _poses(work: Work, parameters: MotifParameters, report: Report) -> Work:
    fps, pose = parameters.analysis_fps, parameters.pose
    return work._replace(poses=pose_features(made(work.dataset), analysis_fps=fps, pose=pose, report=report))


def _letters(work: Work, parameters: MotifParameters, report: Report) -> Work:
    poses, kappa = made(work.poses), parameters.kappa
    kappa = automatic_kappa(poses.values, poses.fps) if isinstance(kappa, str) else kappa
    letters = k_means(poses.values, kappa, parameters.seed, start=parameters.init, report=report)
    return work._replace(letters=letters, runs=remove_runs(letters.labels, poses.clip_starts))


def _neighbours(work: Work, parameters: MotifParameters, report: Report) -> Work:
    report("matching", 0.0)
    return work._replace(matcher=Matcher(made(work.runs), _adjacency(made(work.letters), parameters)))


def _matches(work: Work, parameters: MotifParameters, report: Report) -> Work:
    """All matches of a string that is no longer than a sample; of a longer one discovery finds what it needs."""
    matcher = made(work.matcher)
    if 0 < parameters.sample < len(made(work.runs).letters):
        return work
    rule = _rule(parameters, matcher.adjacency, parameters.strictness)
    return work._replace(matches=_all_matches(matcher, rule, report))


def _motifs(work: Work, parameters: MotifParameters, report: Report) -> Work:
    runs, matcher, matches, rho = made(work.runs), made(work.matcher), work.matches, parameters.rho
    rule, tightness = _rule(parameters, matcher.adjacency, parameters.strictness), parameters.tightness
    if parameters.seeding == "random":
        matches = matches or _all_matches(matcher, rule, report)
        found = random_seeds(runs, matches, rule, rho, parameters.seed, tightness=tightness, report=report)
    elif matches:
        found = largest_first(runs, matches, rule, rho, tightness=tightness, report=report)
    else:
        size, seed = parameters.sample, parameters.seed
        found = sampled_first(runs, matcher, rule, rho, size, seed, tightness=tightness, report=report)
    return work._replace(matches=None, found=found)


def _leftovers(work: Work, parameters: MotifParameters, report: Report) -> Work:
    found, matcher = made(work.found), made(work.matcher)
    if parameters.adjacency == "radius" and parameters.join > parameters.strictness:
        rule = _rule(parameters, matcher.adjacency, parameters.join)
        found = join_leftovers(made(work.runs), matcher, found, rule, report)
    return work._replace(matcher=None, found=found)


def _alignment(work: Work, parameters: MotifParameters, report: Report) -> Work:
    runs, found, poses = made(work.runs), made(work.found), made(work.poses).values
    frames = entry_frames(runs, found, poses, parameters.seed)
    spans = spans_of(runs, found, frames, round(parameters.hold * parameters.analysis_fps))
    return work._replace(aligned=align_motifs(spans, poses, report))


def _graph(work: Work, parameters: MotifParameters, report: Report) -> Work:
    used = asdict(parameters) | {"kappa": len(made(work.letters).centres)}
    return work._replace(graph=graph_of(made(work.poses), made(work.aligned), used, dataset_head(work.dataset)))


def _all_matches(matcher: Matcher, rule: Rule, report: Report) -> Matches:
    """All matches of all seeds. Raises TooLarge where there is not enough memory for them."""
    advice = "Leave sample at its default and seeding at largest, or take fewer clips or a lower frame rate."
    check_fits(matcher.expected_bytes(rule), "Matching all motions with all at once", advice)
    return matcher.all(rule, report)


def _adjacency(letters: Letters, parameters: MotifParameters) -> Adjacency:
    if parameters.adjacency == "spheres":
        return sphere_adjacency(letters.centres, letters.labels, letters.distances)
    return radius_adjacency(letters.centres, nearest_pairs_radius(letters.centres, parameters.reach))


def _rule(parameters: MotifParameters, adjacency: Adjacency, share: float) -> Rule:
    """The matching rule; the paper's spheres know no limit of the mean distance."""
    return Rule(
        parameters.min_letters,
        parameters.max_letters,
        parameters.gamma,
        parameters.slack,
        share * adjacency.radius if parameters.adjacency == "radius" else np.inf,
        parameters.min_seconds * parameters.analysis_fps,
    )


STAGES = (
    Stage("poses", ("analysis_fps", "pose"), _poses),
    Stage("quantisation", ("kappa", "seed", "init"), _letters),
    Stage("matching", ("adjacency", "reach"), _neighbours),
    Stage(
        "matching", ("min_letters", "max_letters", "gamma", "slack", "strictness", "min_seconds", "sample"), _matches
    ),
    Stage("discovery", ("rho", "tightness", "seeding"), _motifs),
    Stage("discovery", ("join",), _leftovers),
    Stage("alignment", ("hold",), _alignment),
    Stage("graph", (), _graph),
)
"""All stages in order. The seed is read by later ones too; the first that reads it already keeps seeds apart."""
