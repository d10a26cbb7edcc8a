"""The object that holds terminals."""

from __future__ import annotations

import json

import pytest

from core.grammar.terminals import Terminals, from_json
from core.mocap.clip import Segment

TERMINALS = Terminals(
    segments=(
        (Segment("a", 0, 10), Segment("a", 30, 40), Segment("b", 8, 20)),
        (Segment("a", 10, 18), Segment("a", 18, 30)),
        (Segment("b", 0, 8),),
    ),
    medoids=(Segment("a", 30, 40), Segment("a", 10, 18), Segment("b", 0, 8)),
    objective={"F": 4.0, "R": 0.3, "E": 0.2},
    parameters={"n_terminals": 3},
    clips=(("a", 40, 60.0), ("b", 20, 30.0)),
    dataset={"name": "toy", "fingerprint": "x"},
)


def test_strings_are_the_terminals_in_time_order():
    assert dict(TERMINALS.strings) == {"a": (0, 1, 1, 0), "b": (2, 0)}
    assert [segment.start for _, segment in TERMINALS.occurrences["a"]] == [0, 10, 18, 30]


def test_runs_join_neighbours_of_one_terminal():
    assert TERMINALS.runs("a") == ((0, Segment("a", 0, 10)), (1, Segment("a", 10, 30)), (0, Segment("a", 30, 40)))


def test_json_brings_everything_back():
    back = from_json(json.loads(json.dumps(TERMINALS.to_json(), allow_nan=False)))
    for name in ("segments", "medoids", "objective", "parameters", "clips", "dataset"):
        assert getattr(back, name) == getattr(TERMINALS, name)


@pytest.mark.parametrize(
    "document", [{}, [], {"format": "motionscape/motifs/1"}, {"format": "motionscape/terminals/1"}]
)
def test_other_documents_are_refused(document):
    with pytest.raises(ValueError, match="terminals"):
        from_json(document)
