"""Known terminals in new recordings: strings of clips that the terminals were not learned from."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.errors import AnalysisError
from core.grammar.alternation import cut_by_medoids
from core.grammar.identification import limits_of, space_of
from core.grammar.parameters import TerminalParameters
from core.grammar.terminals import Terminals
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.progress import Report, silent


def encode(
    dataset: Dataset, terminals: Terminals, source: Dataset, report: Report = silent
) -> dict[str, tuple[tuple[int, Segment], ...]]:
    """Clip of ``dataset`` -> its segments in time order, each with the terminal whose medoid it is nearest to.

    The cuts are those with the least E' for the medoids, motions of ``source``, the data set that the terminals
    were found in. Raises AnalysisError where ``source`` lacks a medoid's clip, and for bodies without a joint in
    common.
    """
    lacking = sorted({m.clip for m in terminals.medoids} - set(source.names))
    if lacking:
        raise AnalysisError(f"these terminals come from other recordings: {source.name} has no clip {lacking[0]}")
    models = sorted({m.clip for m in terminals.medoids})
    clips = [source.clip(name) for name in models] + list(dataset.clips)
    named = tuple(replace(clip, name=f"{k:08d}") for k, clip in enumerate(clips))
    both = Dataset("known and new", named, digests=tuple(clip.name for clip in named))
    parameters = TerminalParameters(
        **{name: value for name, value in terminals.parameters.items() if name in TerminalParameters.__match_args__}
    )
    space = space_of(both, parameters, report)
    medoids = []
    for clip, start, end in terminals.medoids:
        k = models.index(clip)
        first, last = int(space.clip_starts[k]), int(space.clip_starts[k + 1])
        own = [first + round(at * space.fps / space.clip_fps[k]) for at in (start, end)]
        begin = min(own[0], last - 1)
        medoids.append((begin, min(max(own[1], begin + 1), last)))
    spans, labels = cut_by_medoids(space, np.array(medoids), limits_of(parameters, space.fps), only_from=len(models))
    by_clip: dict[str, list[tuple[int, Segment]]] = {clip.name: [] for clip in dataset.clips}
    for (start, end), label in zip(spans.tolist(), labels.tolist(), strict=True):
        segment = space.segment(start, end)
        name = clips[int(segment.clip)].name
        by_clip[name].append((label, Segment(name, segment.start, segment.end)))
    return {name: tuple(items) for name, items in by_clip.items()}
