"""Real recordings: every sentence comes back from rules and rule indices."""

from __future__ import annotations

import pytest

from core.grammar.build import GrammarParameters, grammar_of_terminals
from core.grammar.identification import find_terminals
from core.grammar.parameters import TerminalParameters
from core.mocap.dataset import open_dataset

EXERCISES = ("13_29", "13_30", "13_31", "14_14", "14_20")


@pytest.mark.slow
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", ["86", "exercises", "bandai_namco_1"])
def test_every_sentence_is_reconstructed(shared_data, name) -> None:
    asfamc = shared_data / "cmu" / "asfamc"
    if name == "exercises":
        folders = [asfamc / "13", asfamc / "14"]
        dataset = open_dataset(folders, skeleton=asfamc / "86" / "86.asf", clips=EXERCISES)
    else:
        dataset = open_dataset(asfamc / "86" if name == "86" else shared_data / name)
    terminals = find_terminals(dataset, TerminalParameters(analysis_fps=15.0))
    for sentences in ("clips", "shortest"):
        found = grammar_of_terminals(terminals, GrammarParameters(sentences=sentences, candidates=10))
        codes = [found.grammar.rule_indices(tree) for tree in found.trees]
        assert [found.grammar.reconstruct(code) for code in codes] == [s.terminals for s in found.sentences]
        assert sum(len(s.pieces) for s in found.sentences) == sum(map(len, terminals.segments))
