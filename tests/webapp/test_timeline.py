"""The rows of the timeline: labels and motions in seconds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.mocap.clip import Label, Segment
from core.motifs.graph import Motif, MotifGraph
from core.workspace import MotifNote
from tests.webapp.generated import walkers
from webapp.figures.timeline import motif_colour, timeline


def graph(*motifs: tuple[Segment, ...]) -> MotifGraph:
    made = tuple(Motif(i, segments, 0, tuple(np.zeros(3) for _ in segments)) for i, segments in enumerate(motifs))
    return MotifGraph(made, (), {}, {})


def test_a_row_tells_labels_and_motions_in_seconds():
    dataset = walkers(("walk", "stroll"), seconds=4.0, fps=60.0)
    dataset = replace(dataset, labels=(Label("walk", 60, 120, "step"), Label("walk", 0, 60, "idle")))
    found = timeline(dataset, graph((Segment("walk", 120, 180), Segment("stroll", 0, 60)), (Segment("walk", 0, 60),)))
    walk, stroll = found["rows"]
    assert found["actions"] == ["idle", "step"]
    assert walk["labels"] == [[0.0, 1.0, 0], [1.0, 2.0, 1]]
    assert walk["motions"] == [[0.0, 1.0, 1, 0], [2.0, 3.0, 0, 0]] and stroll["motions"] == [[0.0, 1.0, 0, 1]]
    assert (walk["share"], stroll["share"]) == (0.5, 0.25) and walk["seconds"] == 4.0


def test_names_of_people_stand_beside_the_number():
    dataset = walkers(("walk",))
    found = timeline(dataset, graph((Segment("walk", 0, 60),)), {0: MotifNote(name="stride")})
    assert found["motifs"]["0"]["name"] == "0 stride"
    assert found["motifs"]["0"]["colour"] == motif_colour(0) != motif_colour(1)
