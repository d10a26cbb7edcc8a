"""Large motif graphs: as many motifs are drawn as one can read, the others are reached by choosing."""

from __future__ import annotations

import numpy as np
import pytest

from core.mocap.clip import Segment
from core.motifs.graph import Motif, MotifGraph, succession_edges
from webapp.features.motifs import graph_parts


def motif(number: int, clips: list[str], start: int) -> Motif:
    segments = tuple(Segment(clip, start, start + 10) for clip in clips)
    return Motif(number, segments, 0, tuple(np.arange(10, dtype=np.float32) for _ in segments))


@pytest.fixture(scope="module")
def graph() -> MotifGraph:
    """Two rows of motifs, 300 and 100 long, in which each follows the one before; later ones occur more often."""
    motifs = []
    for row, length in enumerate((300, 100)):
        for k in range(length):
            times = 1 + k // 10
            motifs.append(motif(1000 * row + k, [f"{row} {n}" for n in range(times)], 20 * k))
    return MotifGraph(tuple(motifs), succession_edges(tuple(motifs)), {}, {})


def test_a_small_graph_is_drawn_whole(graph):
    small = graph_parts.part_of(graph, frozenset(range(20)))
    assert not graph_parts.is_large(small) and graph_parts.ids_of_part(small, "largest", None) == set(range(20))
    assert graph_parts.part_of(small, frozenset(range(20))) is small


def test_of_a_large_one_those_with_most_frames(graph):
    ids = graph_parts.ids_of_part(graph, graph_parts.LARGEST, None)
    assert len(ids) == graph_parts.MOST and min(ids) > 100 and max(ids) < 1000
    part = graph_parts.part_of(graph, ids)
    assert len(part.motifs) == graph_parts.MOST and 0 < len(part.edges) <= graph_parts.MOST_EDGES
    assert all(edge.source in ids and edge.target in ids for edge in part.edges)


def test_a_component_can_be_chosen(graph):
    values = [choice["value"] for choice in graph_parts.choices(graph)]
    assert values == ["largest", "around", "c0", "c1"]
    assert min(graph_parts.ids_of_part(graph, "c1", None)) >= 1000
    rubbish = graph_parts.ids_of_part(graph, "c99", None)
    assert rubbish == graph_parts.ids_of_part(graph, "none", None) == graph_parts.ids_of_part(graph, "largest", None)


def test_what_was_chosen_is_drawn_with_what_is_near(graph):
    ids = graph_parts.ids_of_part(graph, graph_parts.AROUND, 40)
    assert len(ids) == graph_parts.NEAR and 40 in ids and max(ids) < 100
    assert graph_parts.chosen_motif(graph, {"motif": 40}) == 40
    assert graph_parts.chosen_motif(graph, {"edge": "7-8"}) == 7
    assert graph_parts.chosen_motif(graph, {"motif": 5000}) is None and graph_parts.chosen_motif(graph, None) is None
