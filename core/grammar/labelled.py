"""Labels as terminals: what a grammar makes of actions that people marked, instead of ones that were found."""

from __future__ import annotations

from core.errors import AnalysisError
from core.grammar.terminals import Terminals
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset


def label_names(dataset: Dataset) -> tuple[str, ...]:
    """The actions that the labels name, in alphabetical order: a terminal each."""
    return tuple(sorted({label.action for label in dataset.labels}))


def terminals_of_labels(dataset: Dataset) -> Terminals:
    """Every label a segment, every action a terminal, numbered as :func:`label_names`.

    The objective is not theirs: it is nan. Raises AnalysisError where there are no labels.
    """
    names = label_names(dataset)
    if not names:
        raise AnalysisError("this data set has no labels")
    segments = tuple(
        tuple(
            sorted(
                (Segment(label.clip, label.start, label.end) for label in dataset.labels if label.action == name),
                key=lambda segment: (segment.clip, segment.start),
            )
        )
        for name in names
    )
    return Terminals(
        segments=segments,
        medoids=tuple(own[0] for own in segments),
        objective=dict.fromkeys("FRE", float("nan")),
        clips=tuple((clip.name, clip.n_frames, clip.fps) for clip in dataset.clips),
        dataset={"name": dataset.name, "fingerprint": dataset.fingerprint},
    )
