"""From recordings to grammar.json, and from a grammar to motion."""

from __future__ import annotations

import itertools
import json

import numpy as np
import pytest

from core import analyses
from core.demo import make_demo
from core.grammar.build import GrammarParameters, grammar_of_terminals
from core.grammar.labelled import label_names, terminals_of_labels
from core.grammar.learned import from_json
from core.grammar.trees import leaves
from core.synthesis.derivations import choose_segments, derive, perform
from core.synthesis.kept_derivations import pack_derivation, unpack_derivation


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=1.5, seed=3)


@pytest.fixture(scope="module")
def learned(demo):
    return grammar_of_terminals(terminals_of_labels(demo))


def test_labels_are_terminals(demo, learned) -> None:
    names = label_names(demo)
    for sentence in learned.sentences:
        actions = [label.action for label in demo.labels if label.clip == sentence.clip]
        assert [names[t] for t in sentence.terminals] == actions
    with pytest.raises(ValueError, match="no labels"):
        terminals_of_labels(demo.select([]))


@pytest.mark.parametrize("changes", [{"sentences": "clips"}, {"candidates": 5}, {"repeats": "join"}])
def test_every_sentence_is_reconstructed_and_the_clips_are_covered(demo, changes) -> None:
    found = grammar_of_terminals(terminals_of_labels(demo), GrammarParameters(**changes))
    codes = [found.grammar.rule_indices(tree) for tree in found.trees]
    assert [found.grammar.reconstruct(code) for code in codes] == [s.terminals for s in found.sentences]
    for clip in demo.clips:
        pieces = [piece for s in found.sentences if s.clip == clip.name for _, piece in s.pieces]
        assert pieces[0].start == 0 and pieces[-1].end == clip.n_frames
        assert all(a.end == b.start for a, b in itertools.pairwise(pieces))
    if changes.get("repeats") == "join":
        assert all(a != b for s in found.sentences for a, b in itertools.pairwise(s.terminals))
    assert found.bits.total == pytest.approx(found.bits.grammar + found.bits.sentences)
    assert set(found.baselines) == {"state_machine", "sequitur"}


def test_grammar_json_comes_back(learned) -> None:
    document = json.loads(json.dumps(learned.to_json()))
    assert document["format"] == "motionscape/grammar/1"
    assert {"dataset", "clips", "parameters", "seconds", "terminals", "sentences", "rules", "bits", "objective"} <= set(
        document
    )
    assert set(document["rules"][0]) == {"left", "right", "count"}
    again = from_json(document)
    assert again.grammar == learned.grammar and again.sentences == learned.sentences and again.trees == learned.trees
    assert again.to_json()["terminals"] == document["terminals"]
    for broken in ({}, {**document, "rules": 3}, {**document, "derivations": document["derivations"][::-1]}):
        with pytest.raises(ValueError, match=r"grammar|rule"):
            from_json(broken)


def test_parameters_are_checked() -> None:
    for wrong in ({"sentences": "words"}, {"min_sentence": 0}, {"merge": "all"}, {"n_terminals": 0}):
        with pytest.raises(ValueError, match="must be"):
            GrammarParameters(**wrong)


def test_a_sentence_as_motion(demo, learned) -> None:
    made = derive(demo, learned, "random:5:12", seed=5)
    assert learned.grammar.accepts(made.terminals) and leaves(made.tree) == made.terminals
    assert len(made.pieces) == len(made.spans) == len(made.terminals) == len(made.jumps) + 1
    assert all(piece in learned.segments[t] for t, piece in zip(made.terminals, made.pieces, strict=True))
    assert made.spans[0][0] == 0 and made.spans[-1][1] == made.clip.n_frames
    assert all(a[1] == b[0] for a, b in itertools.pairwise(made.spans))
    assert made.skate.kept < made.skate.plain
    again = unpack_derivation(*pack_derivation(made))
    assert again.tree == made.tree and again.pieces == made.pieces and again.spans == made.spans
    assert np.array_equal(again.clip.rotations, made.clip.rotations)


def test_segments_are_chosen_greedily(demo, learned) -> None:
    terminals = learned.sentences[0].terminals
    chosen, jumps = choose_segments(demo, terminals, learned.segments, seed=1)
    for k in range(1, len(terminals)):
        others = learned.segments[terminals[k]]
        distances = [choose_segments(demo, (0, 1), {0: [chosen[k - 1]], 1: [other]})[1][0] for other in others]
        assert jumps[k - 1] == pytest.approx(min(distances), rel=1e-4)


def test_sentences_that_cannot_be_shown(demo, learned) -> None:
    with pytest.raises(ValueError, match="no actions"):
        perform(demo, (), learned.segments)
    with pytest.raises(ValueError, match="no recording shows action 99"):
        perform(demo, (99,), learned.segments)
    for text in ("", "random:x", "0.a"):
        with pytest.raises(ValueError, match="expected random:SEED:MOST"):
            derive(demo, learned, text)


def test_the_methods_follow_one_another(demo) -> None:
    short = demo.select([demo.names[0]])
    values = {"n_terminals": 6, "analysis_fps": 15.0}
    found = analyses.compute(short, "grammar", values)
    assert found.terminals.n_terminals == 6 and sum(len(s.pieces) for s in found.sentences) > 6
    code = ".".join(map(str, found.grammar.rule_indices(found.trees[0])))
    made = analyses.compute(short, "derive", {**values, "sentence": code})
    assert made.terminals == found.sentences[0].terminals
