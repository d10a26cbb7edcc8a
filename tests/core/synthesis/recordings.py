"""What the tests of synthesis walk through: a minute of the demo and its motif graph, and graphs of made-up edges."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np

from core.demo import make_demo
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.motifs.build import MotifParameters, find_motifs
from core.motifs.graph import Motif, MotifGraph, succession_edges


@lru_cache(maxsize=1)
def demo() -> tuple[Dataset, MotifGraph]:
    """A minute and a half of the demo, and its motif graph."""
    dataset = make_demo(minutes=1.5, seed=3)
    return dataset, find_motifs(dataset, MotifParameters(kappa=300, init="random"))


def graph_of(*motifs: list[Segment]) -> MotifGraph:
    """A graph of these motions: linear warps, edges where they follow one another."""
    made = tuple(
        Motif(k, tuple(segments), 0, tuple(_linear(segments[0].n_frames, s.n_frames) for s in segments))
        for k, segments in enumerate(motifs)
    )
    return MotifGraph(made, succession_edges(made), {}, {})


def string_graph(*strings: str, length: int = 40, gap: int = 0) -> tuple[Dataset, MotifGraph]:
    """Clips of the demo cut into motions by letters: ``"abac"`` is motif a, b, a, c; "." belongs to no motif."""
    source = demo()[0]
    clips, found = [], {}
    for k, letters in enumerate(strings):
        clip = source.clips[k % len(source.clips)]
        for place, letter in enumerate(letters):
            start = place * (length + gap)
            if letter != ".":
                found.setdefault(letter, []).append(Segment(f"take_{k}", start, start + length))
        clips.append(replace(clip, name=f"take_{k}").cut(0, len(letters) * (length + gap), f"take_{k}"))
    return Dataset("strings", tuple(clips)), graph_of(*(found[letter] for letter in sorted(found)))


def other_joints(clip: Clip) -> Clip:
    """The clip on a skeleton of the same shape whose joints have other names."""
    skeleton = replace(clip.skeleton, names=tuple(f"x{name}" for name in clip.skeleton.names))
    return replace(clip, skeleton=skeleton)


def _linear(n: int, m: int) -> np.ndarray:
    return np.linspace(0, m - 1, n).astype(np.float32)
