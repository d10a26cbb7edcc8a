"""Four ways to make new motion, measured alike."""

from __future__ import annotations

import json
import math
from types import SimpleNamespace

import pytest

from core.demo import make_demo
from core.grammar.build import grammar_of_terminals
from core.grammar.labelled import terminals_of_labels
from core.mocap.clip import Segment
from core.motifs.build import MotifParameters, find_motifs
from core.synthesis.bakeoff import CONTENDERS, BakeoffParameters, bake_off
from core.synthesis.graph_paths import motif_paths
from core.synthesis.kept_bakeoff import bakeoff_json, pack_bakeoff, unpack_bakeoff

QUICK = BakeoffParameters(routines=1, shuffles=5, max_terminals=8)


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=1.5, seed=4)


@pytest.fixture(scope="module")
def learned(demo):
    return grammar_of_terminals(terminals_of_labels(demo))


@pytest.fixture(scope="module")
def found(demo, learned):
    return bake_off(demo, learned, find_motifs(demo, MotifParameters(kappa=60)), QUICK)


def test_all_four_are_measured(demo, learned, found) -> None:
    assert tuple(c.name for c in found.contenders) == CONTENDERS
    grammar, machine, sequitur, _ = found.contenders
    assert grammar.rules == len(learned.grammar.rules) and grammar.bits == learned.bits.total / len(learned.sentences)
    assert sequitur.accepted == 0 and sequitur.new == 0, "it makes the sentences it knows, and no others"
    assert machine.accepted >= grammar.accepted
    for contender in found.contenders:
        assert 0 <= contender.shuffled <= 1 and 0 <= contender.new <= 1 and contender.bits > 0
        if not math.isnan(contender.skate):
            assert contender.skate <= contender.skate_plain and contender.source_speed > 0
    assert found.sentences == len(learned.sentences) and 0 < found.shuffles <= 5 * found.sentences


def test_it_is_kept_whole(found) -> None:
    json.dumps(bakeoff_json(found), allow_nan=False)
    again = unpack_bakeoff(*pack_bakeoff(found))
    assert [c.name for c in again.clips] == [c.name for c in found.clips]
    assert repr(again.contenders) == repr(found.contenders) and again.notes == found.notes
    with pytest.raises(ValueError, match="not a bake-off"):
        unpack_bakeoff({}, {})


def test_one_sentence_cannot_be_compared(demo) -> None:
    alone = demo.select(demo.names[:1])
    learned = grammar_of_terminals(terminals_of_labels(alone))
    if len(learned.sentences) == 1:
        with pytest.raises(ValueError, match="only one"):
            bake_off(alone, learned, None, QUICK)
    with pytest.raises(ValueError, match="folds must be"):
        BakeoffParameters(folds=1)


def test_strings_of_motifs() -> None:
    motifs = (
        SimpleNamespace(id=0, segments=(Segment("a", 0, 9), Segment("a", 30, 39), Segment("b", 5, 9))),
        SimpleNamespace(id=1, segments=(Segment("a", 12, 20), Segment("b", 12, 20))),
    )
    paths = motif_paths(SimpleNamespace(motifs=motifs))
    assert paths.by_clip == {"a": (0, 1, 0), "b": (0, 1)} and paths.edges == 2
    assert paths.without("a")((0, 1)) and not paths.without("a")((0, 1, 0)) and paths.without("b")((0, 1, 0))
    assert (1, 0) in paths.known and (1, 1) not in paths.known
    # 2 edges of two motifs out of 2 or an end; a: first motif, then 2 ways each; b alike
    assert paths.bits == pytest.approx((4 * math.log2(3) + (1 + 3) + (1 + 2)) / 2)
