"""Planted differences are found and said, and where there is none none is said."""

from __future__ import annotations

import re
from types import SimpleNamespace

import numpy as np
import pytest

from core.comparing import compared, design_json, design_of, routine_items
from core.demo.planted import person, planted_groups
from core.errors import ParameterError
from core.grammar.learned import Sentence
from core.grammar.trees import Node
from core.groups.design import Design, Unit, make_design
from core.groups.maps import densities, map_differences
from core.groups.parameters import GroupParameters
from core.groups.tables import Item, transitions, use_table
from core.mocap.clip import Segment


def document_of(difference: str, per_group: int, pieces: int = 6) -> dict:
    dataset, properties = planted_groups(difference, per_group, pieces=pieces)
    return compared(dataset, make_design(properties, dataset.names, "group"), None, GroupParameters())


def test_planted_differences_are_found_and_said():
    wider = " ".join(one["text"] for one in document_of("wider", 8, pieces=12)["words"])
    assert re.search("B holds the (left|right) arm .* wider", wider)
    slower = {row["name"]: row for row in document_of("slower", 8)["comparisons"] if row["kind"] == "figure"}
    speed = slower["Walking speed"]
    assert speed["difference"] < 0 and speed["p"] < 0.05 and speed["n"] == [8, 8]
    assert document_of("nothing", 4)["words"][0]["text"].startswith("A and B do not differ beyond chance in any of")


def test_one_person_moves_alike_whatever_is_planted():
    plain, labels = person(3, "nothing", pieces=4)
    wide, same = person(3, "wider", pieces=4)
    assert labels == same and np.array_equal(plain.root_positions, wide.root_positions)
    assert [label.action for label in person(3, "slower", pieces=4)[1]] == [label.action for label in labels]


CLIPS = {"a": (300, 30.0), "b": (600, 60.0), "c": (300, 30.0), "d": (300, 30.0)}
DESIGN = Design(
    "g", ("x", "y"), (Unit("1", "x", ("a", "b")), Unit("2", "x", ("c",)), Unit("3", "y", ("d",))), "subject"
)


def test_use_is_counted_in_seconds_of_each_units_clips():
    items = [
        Item("motif", "0", "zero", (Segment("a", 0, 30), Segment("a", 20, 60), Segment("b", 0, 60))),
        Item("motif", "1", "one", (Segment("d", 0, 300),)),
    ]
    table = use_table(DESIGN, items, CLIPS)
    assert table[0, 0] == pytest.approx([100 * 3 / 20, 60 * 3 / 20, 1.0])
    assert table[1, 0, :2].tolist() == [0, 0] and np.isnan(table[1, 0, 2])
    assert table[2, 1] == pytest.approx([100, 6, 10])


def test_transitions_are_shares_of_what_follows():
    items = [
        Item("motif", "0", "zero", (Segment("a", 0, 10), Segment("a", 40, 50), Segment("c", 5, 9))),
        Item("motif", "1", "one", (Segment("a", 20, 30), Segment("b", 0, 9), Segment("c", 20, 30))),
    ]
    pairs, shares, counts = transitions(DESIGN, items)
    assert pairs == [(0, 1), (1, 0)] and counts.tolist() == [[1, 1], [1, 0], [0, 0]]
    assert shares[0].tolist() == [1, 1] and shares[1, 0] == 1 and np.isnan(shares[1, 1]) and np.isnan(shares[2]).all()


def test_a_design_survives_as_text():
    assert design_of(design_json(DESIGN)) == DESIGN
    with pytest.raises(ParameterError, match="cannot be read"):
        design_of("[1, 2]")


def test_postures_are_compared_where_they_are_on_a_map():
    stays = [(clip, node, 50.0) for clip in "abc" for node in (0, 1)] + [("d", 8, 100.0)]
    shares = densities(DESIGN, stays, (3, 3))
    assert shares.shape == (3, 3, 3) and shares.sum((1, 2)) == pytest.approx(100)
    assert shares[2].argmax() == 8 and shares[0].argmax() in (0, 1)
    units = tuple(Unit(f"{g}{k}", g, (f"{g}{k}",)) for g in "xy" for k in range(6))
    rng = np.random.default_rng(0)
    many = [
        (unit.clips[0], int(node), 1.0)
        for unit in units
        for node in [*rng.integers(0, 64, 60), *([27] * 30 if unit.group == "y" else [])]
    ]
    design = Design("g", ("x", "y"), units, "subject")
    (found,) = map_differences(design, many, (8, 8), GroupParameters(permutations=300))
    assert found["clusters"][0]["sign"] == 1 and [3, 3] in found["clusters"][0]["nodes"]
    assert found["clusters"][0]["p"] < 0.05 and len(found["difference"]) == 64


def test_routines_are_rules_that_stand_for_several_actions():
    pieces = tuple((k % 2, Segment("a", 10 * k, 10 * k + 10)) for k in range(4))
    pair = [Node("B", 2 * k, 2 * k + 2, 1, (Node(0, 2 * k, 2 * k + 1), Node(1, 2 * k + 1, 2 * k + 2))) for k in (0, 1)]
    tree = Node("S", 0, 4, 0, tuple(pair))
    learned = SimpleNamespace(sentences=(Sentence("a", pieces), Sentence("a", pieces)), trees=(tree, tree))
    (routine,) = routine_items(learned)
    assert (routine.kind, routine.id, routine.name) == ("routine", "rule 1", "routine 0-1")
    assert routine.segments == (Segment("a", 0, 20),) * 2 + (Segment("a", 20, 40),) * 2
