"""Terminals of whole recordings."""

from __future__ import annotations

import itertools
import json
from dataclasses import replace

import numpy as np
import pytest

from core.demo import make_demo
from core.evaluation.segmentation import frame_accuracy
from core.grammar.encoding import encode
from core.grammar.identification import find_several, find_terminals
from core.grammar.parameters import TerminalParameters
from core.grammar.terminals import from_json

PARAMETERS = TerminalParameters(n_terminals=12)


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=1.0, seed=3)


@pytest.fixture(scope="module")
def terminals(demo):
    return find_terminals(demo, PARAMETERS)


def test_every_frame_lies_in_one_segment(demo, terminals):
    assert set(terminals.strings) == set(demo.names)
    for clip in demo.clips:
        segments = [segment for _, segment in terminals.occurrences[clip.name]]
        assert segments[0].start == 0 and segments[-1].end == clip.n_frames
        assert all(a.end == b.start for a, b in itertools.pairwise(segments))
        for segment in segments:
            assert PARAMETERS.min_seconds - 0.05 <= segment.n_frames / clip.fps <= PARAMETERS.max_seconds + 0.05


def test_medoids_are_segments_of_their_terminals(terminals):
    assert terminals.n_terminals == 12
    for segments, medoid in zip(terminals.segments, terminals.medoids, strict=True):
        assert medoid in segments
    frames = [sum(s.n_frames for s in segments) for segments in terminals.segments]
    assert frames == sorted(frames, reverse=True)


def test_the_objective_is_that_of_the_paper(demo, terminals):
    measured = terminals.objective
    assert measured["F"] == pytest.approx(1 / (0.02 * measured["R"] + 0.98 * measured["E"]))
    length = sum(s.n_frames for s in terminals.medoids) / demo.n_frames
    assert measured["R"] == pytest.approx(length, rel=0.02)


def test_same_seed_same_terminals_whatever_the_order_of_clips(demo, terminals):
    turned = replace(demo, clips=demo.clips[::-1], digests=demo.digests[::-1])
    again = find_terminals(turned, PARAMETERS)
    assert again.segments == terminals.segments and again.medoids == terminals.medoids


def test_terminals_know_actions(demo, terminals):
    """Far better than cutting without looking: even pieces dealt out in turn."""
    shuffled = [[] for _ in range(12)]
    for i, segment in enumerate(s for items in terminals.occurrences.values() for _, s in items):
        shuffled[i % 12].append(segment)
    chance, found = frame_accuracy(shuffled, demo.labels), frame_accuracy(terminals.segments, demo.labels)
    assert found.many_to_one > 0.55 and found.one_to_one > chance.one_to_one + 0.2


def test_several_numbers_share_the_poses(demo, terminals):
    stages = []
    several = find_several(demo, PARAMETERS, [5, 12], lambda stage, share: stages.append((stage, share)))
    assert [t.n_terminals for t in several] == [5, 12]
    assert several[1].segments == terminals.segments
    assert several[0].objective["E"] > several[1].objective["E"]
    assert sum(stage == "poses" and share == 1 for stage, share in stages) == 1
    with pytest.raises(ValueError, match="which numbers"):
        find_several(demo, PARAMETERS, [])


def test_json(terminals):
    back = from_json(json.loads(json.dumps(terminals.to_json(), allow_nan=False)))
    assert back.segments == terminals.segments and back.strings == terminals.strings


def test_more_terminals_than_segments_are_refused(demo):
    short = replace(demo, clips=(demo.clips[0].cut(0, 200, "short"),), labels=(), digests=())
    with pytest.raises(ValueError, match=r"only \d segments for 20 terminals"):
        find_terminals(short, TerminalParameters(n_terminals=20))


@pytest.mark.parametrize(
    "values",
    [{"n_terminals": 0}, {"weight": 1.5}, {"min_seconds": 2.0, "max_seconds": 3.0}, {"method": "magic"}, {"pose": "x"}],
)
def test_parameters_out_of_range_are_refused(values):
    with pytest.raises(ValueError, match="must be"):
        TerminalParameters(**values)


def test_known_terminals_are_found_in_new_recordings(demo, terminals):
    known = encode(demo, terminals, demo)
    assert set(known) == set(demo.names)
    same = frames = 0
    for clip in demo.clips:
        spans = {"found": np.full(clip.n_frames, -1), "known": np.full(clip.n_frames, -2)}
        for name, items in (("found", terminals.occurrences[clip.name]), ("known", known[clip.name])):
            for terminal, segment in items:
                assert segment.clip == clip.name
                spans[name][segment.start : segment.end] = terminal
        assert (spans["known"] >= 0).all()
        same, frames = same + (spans["found"] == spans["known"]).sum(), frames + clip.n_frames
    assert same / frames > 0.9
    other = replace(demo, clips=demo.clips[:1], labels=(), digests=())
    assert set(encode(other, terminals, demo)) == {demo.clips[0].name}
    with pytest.raises(ValueError, match="other recordings"):
        encode(demo, terminals, replace(demo, clips=(), labels=(), digests=()))
