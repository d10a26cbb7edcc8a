"""From recordings to the motion-motif graph: the whole pipeline of MMG, stage by stage."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.motifs.parameters import MotifParameters
from core.motifs.stages import STAGES, Stage, Work, made
from core.poses.features import Poses
from core.progress import Report, silent

__all__ = ["MotifParameters", "find_motifs", "motifs_of_poses"]


_DEFAULT = MotifParameters()


def find_motifs(dataset: Dataset, parameters: MotifParameters = _DEFAULT, report: Report = silent) -> MotifGraph:
    """The motion-motif graph of a data set. Deterministic: the same clips, in any order, and seed give the same graph.

    Raises ValueError where there are no clips or no common joints. ``report`` is called several times a second and may
    raise to stop the work.
    """
    return _through(STAGES, Work(dataset=dataset), parameters, report)


def motifs_of_poses(poses: Poses, parameters: MotifParameters, report: Report = silent) -> MotifGraph:
    """The graph from pose features that are already there."""
    return _through(STAGES[1:], Work(poses=poses), parameters, report)


def _through(stages: Sequence[Stage], work: Work, parameters: MotifParameters, report: Report) -> MotifGraph:
    for stage in stages:
        work = stage.after(work, parameters, report)
    return replace(made(work.graph), seconds=dict(work.seconds))
