"""The rows of the timeline: labels and motions in seconds."""

from __future__ import annotations

import re
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np

from core.mocap.clip import Label, Segment
from core.motifs.graph import Motif, MotifGraph
from core.workspace import MotifNote
from tests.webapp.generated import walkers
from tests.webapp.stored import misfit
from webapp.features.motifs import names
from webapp.features.motifs.figures.timeline_drawing import timeline_svg
from webapp.ui.brief_names import brief_names
from webapp.ui.timeline import motif_colour, timeline


def graph(*motifs: tuple[Segment, ...]) -> MotifGraph:
    made = tuple(Motif(i, segments, 0, tuple(np.zeros(3) for _ in segments)) for i, segments in enumerate(motifs))
    return MotifGraph(made, (), {}, {})


def test_a_row_tells_labels_and_motions_in_seconds():
    dataset = walkers(("walk", "stroll"), seconds=4.0, fps=60.0)
    dataset = replace(dataset, labels=(Label("walk", 60, 120, "step"), Label("walk", 0, 60, "idle")))
    found = timeline(dataset, graph((Segment("walk", 120, 180), Segment("stroll", 0, 60)), (Segment("walk", 0, 60),)))
    assert misfit(found | {"drawing": ""}, names.TIMELINE_DATA) is None
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


def boxes(svg: str, attribute: str, value: str) -> list[tuple[float, float]]:
    """Left and right of the rectangles with this attribute."""
    found = [e for e in ElementTree.fromstring(svg).iter() if e.tag.endswith("rect") and e.get(attribute) == value]
    return [(float(e.get("x", 0)), float(e.get("x", 0)) + float(e.get("width"))) for e in found]


def test_the_drawing_holds_every_block_where_it_belongs():
    dataset = walkers(("walk & run", "stroll"), seconds=4.0, fps=60.0)
    dataset = replace(dataset, labels=(Label("stroll", 0, 120, "<idle>"),))
    data = timeline(dataset, graph((Segment("walk & run", 120, 240), Segment("stroll", 0, 60))))
    svg = timeline_svg(data)
    (left, right), other = boxes(svg, "fill", motif_colour(0))
    whole = boxes(svg, "fill", "#dfe4ea")
    assert [round(right - left), round(left - whole[0][0])] == [round((whole[0][1] - whole[0][0]) / 2)] * 2
    assert other[0] == whole[1][0] and "walk &amp; run" in svg and "&lt;idle&gt;" in svg
    assert len(boxes(svg, "fill-opacity", ".38")) == 1
    assert len(re.findall('opacity=".3"', timeline_svg(data, motif=7))) == 2
    assert "<svg" in timeline_svg(timeline(replace(dataset, labels=(), clips=()), graph()))


def test_the_drawing_follows_order_and_scale():
    dataset = walkers(("a", "b"), seconds=4.0)
    dataset = replace(dataset, clips=(dataset.clips[0], replace_length(dataset.clips[1])))
    data = timeline(dataset, graph((Segment("b", 0, 10), Segment("b", 20, 30), Segment("a", 0, 60))))
    names = lambda svg: re.findall(r">(a|b)<title", svg)  # noqa: E731
    assert names(timeline_svg(data)) == ["a", "b"] and names(timeline_svg(data, "chosen", motif=0)) == ["b", "a"]
    widths = lambda svg: [round(b - a) for a, b in boxes(svg, "fill", "#dfe4ea")]  # noqa: E731
    (same, short), (full, filled) = widths(timeline_svg(data)), widths(timeline_svg(data, scale="fill"))
    assert short < same == full == filled


def replace_length(clip):
    return replace(clip, root_positions=clip.root_positions[:60], rotations=clip.rotations[:60])


def test_names_in_little_room_still_tell_clips_apart():
    assert brief_names(["dataset-1_bow_angry_001", "dataset-1_bye_angry_001"]) == ["bow_angry_001", "bye_angry_001"]
    assert brief_names(["13_29", "13_30"]) == ["13_29", "13_30"] and brief_names(["only one here"]) == ["only one here"]
    assert brief_names(["a very long name of a clip 001", "b"]) == ["a very lon…clip 001", "b"]
    assert brief_names(["subject-1_", "subject-1_walk"]) == ["subject-1_", "walk"] and brief_names([]) == []
