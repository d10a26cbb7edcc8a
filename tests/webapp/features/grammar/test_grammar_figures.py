"""The drawings of the Grammar page: trees, strings, rules, charts."""

from __future__ import annotations

import csv
import io
from xml.etree import ElementTree

import numpy as np
import pytest

from core.demo import make_demo
from core.grammar.motion_grammar import Grammar
from core.grammar.rules import Rule
from core.grammar.trees import at_path, preorder
from core.mocap.clip import Label, Segment
from core.mocap.dataset import Dataset
from core.workspace import MotifNote
from webapp.features.grammar.figures import actions, rules, table
from webapp.features.grammar.figures.parse_tree import PAGE, placed, tree_svg
from webapp.shell import theme

SVG = "{http://www.w3.org/2000/svg}"
GRAMMAR = Grammar(
    (
        Rule("S", (0, "X2", 1), 3),
        Rule("S", ("X2", "X10"), 1),
        Rule("X2", (2, 3), 2),
        Rule("X2", (4,), 1),
        Rule("X2", (), 1),
        Rule("X10", (5, "X10"), 2),
        Rule("X10", (5,), 1),
    )
)


def names(symbol) -> str:
    return symbol if isinstance(symbol, str) else f"<{symbol}>"


def nodes_of(svg: str) -> dict[str, ElementTree.Element]:
    root = ElementTree.fromstring(svg)
    return {node.get("data-path"): node for node in root.iter(f"{SVG}g")}


@pytest.fixture(scope="module")
def dataset() -> Dataset:
    demo = make_demo(1.0)
    return Dataset("demo", demo.clips[:2], tuple(label for label in demo.labels if label.clip in demo.names[:2]))


def test_every_node_with_actions_is_drawn_once_with_what_it_covers():
    tree = GRAMMAR.parse((0, 2, 3, 1))
    found = nodes_of(tree_svg(tree, names, actions.tones(6), pictures=list("abcd")))
    assert set(found) == {"", "0", "1", "1.0", "1.1", "2"}
    for path, node in found.items():
        there = at_path(tree, [int(step) for step in path.split(".") if step])
        assert (int(node.get("data-first")), int(node.get("data-end"))) == (there.start, there.end)
        assert ("tree-leaf" in node.get("class")) == there.is_leaf
    assert found["1.0"].find(f"{SVG}title").text == "<2>"  # names are escaped
    assert found["1"].find(f"{SVG}title").text == "X2: 2 actions"


def test_a_part_that_is_left_out_is_not_drawn():
    tree = GRAMMAR.parse((0, 1))
    assert sum(node.symbol == "X2" for node in preorder(tree)) == 1
    assert set(nodes_of(tree_svg(tree, names, {}))) == {"", "0", "2"}


def test_phrases_stand_over_the_middle_of_their_actions_and_children_below():
    tree = GRAMMAR.parse((2, 3, 5, 5, 5))
    places = {one.path: one for one in placed(tree)}
    leaves = sorted(one.x for one in places.values() if one.node.is_leaf)
    assert len(set(np.diff(leaves))) == 1
    for path, one in places.items():
        own = leaves[one.node.start : one.node.end]
        assert one.x == pytest.approx((own[0] + own[-1]) / 2) and one.level == len(path)


def test_the_chosen_phrase_has_a_ground_and_files_have_no_variables():
    tree = GRAMMAR.parse((0, 2, 3, 1))
    colours = theme.CANVAS["light"] | {"selected": "#e6eefb"}
    drawn = tree_svg(tree, names, actions.tones(6), colours=colours, marked=(1,), picked=2)
    assert "var(" not in drawn and "var(" in tree_svg(tree, names, actions.tones(6), colours=PAGE)
    ground = next(one for one in ElementTree.fromstring(drawn).iter(f"{SVG}rect") if one.get("class") == "tree-chosen")
    found = nodes_of(drawn)
    boxes = [found[path].find(f"{SVG}rect") for path in ("1.0", "1.1")]
    left, right = float(ground.get("x")), float(ground.get("x")) + float(ground.get("width"))
    assert left < float(boxes[0].get("x")) and float(boxes[1].get("x")) + float(boxes[1].get("width")) < right
    assert found["1.1"].find(f"{SVG}rect").get("stroke-width") == found["1"].find(f"{SVG}rect").get("stroke-width")
    assert found["1.0"].find(f"{SVG}rect").get("stroke-width") != found["1"].find(f"{SVG}rect").get("stroke-width")


def test_phrases_are_numbered_by_use_and_the_routine_comes_first():
    assert rules.phrase_names(GRAMMAR.rules, "S") == {"S": "Routine", "X2": "Phrase 1", "X10": "Phrase 2"}
    even = [Rule("S", ("X10", "X2")), Rule("X10", (1,)), Rule("X2", (2,))]
    assert rules.phrase_names(even, "S")["X2"] == "Phrase 1"  # 2 before 10


def test_rules_say_how_often_each_way_is_taken_and_what_contains_itself():
    found = {entry["id"]: entry for entry in rules.rules_data(GRAMMAR.rules, "S")}
    assert list(found) == ["S", "X2", "X10"]
    assert [way["count"] for way in found["X2"]["ways"]] == [2, 1, 1] and found["X2"]["seen"] == 4
    assert found["X2"]["ways"][1:] in ([{"parts": [], "count": 1}, {"parts": [4], "count": 1}],
                                       [{"parts": [4], "count": 1}, {"parts": [], "count": 1}])  # fmt: skip
    assert [entry["cyclic"] for entry in found.values()] == [False, False, True]
    around = [Rule("S", ("A",)), Rule("A", (1, "B")), Rule("B", ("A", 2)), Rule("B", (3,))]
    assert [entry["cyclic"] for entry in rules.rules_data(around, "S")] == [False, True, True]


def test_rules_as_a_file_name_what_they_speak_of():
    lines = list(csv.DictReader(io.StringIO(rules.rules_csv(GRAMMAR.rules, "S", {0: "walk, slow"}))))
    assert len(lines) == len(GRAMMAR.rules)
    assert lines[0] == {
        "phrase": "Routine",
        "symbol": "S",
        "may be": "walk, slow, Phrase 1, 1",
        "symbols": "0 X2 1",
        "times": "3",
    }
    assert any(line["may be"] == "nothing" and line["phrase"] == "Phrase 1" for line in lines)


def _segments(dataset: Dataset) -> list[list[Segment]]:
    """Three actions: thirds of both clips, the outer ones alike."""
    found: list[list[Segment]] = [[], [], []]
    for clip in dataset.clips:
        a, b = clip.n_frames // 3, 2 * clip.n_frames // 3
        found[0] += [Segment(clip.name, 0, a), Segment(clip.name, b, clip.n_frames)]
        found[1 if clip is dataset.clips[0] else 2].append(Segment(clip.name, a, b))
    return found


def test_rows_hold_every_piece_in_order_of_time(dataset):
    segments = _segments(dataset)
    rows = actions.string_rows(dataset, segments, {dataset.names[0]: [0, 90]})
    assert [row["clip"] for row in rows] == list(dataset.names)
    for row, clip in zip(rows, dataset.clips, strict=True):
        assert [piece[2] for piece in row["pieces"]] in ([0, 1, 0], [0, 2, 0])
        assert row["pieces"][0][0] == 0 and row["pieces"][-1][1] == pytest.approx(clip.seconds, abs=2e-3)
        for start, end, action, number in row["pieces"]:
            segment = segments[action][number]
            assert segment.clip == clip.name
            assert (start, end) == pytest.approx((segment.start / clip.fps, segment.end / clip.fps), abs=1e-3)
    assert rows[0]["cuts"] == [0, round(90 / dataset.clips[0].fps, 3)] and rows[1]["cuts"] == []


def test_actions_are_described_and_named(dataset):
    segments = _segments(dataset)
    plain = Dataset("demo", dataset.clips, (Label(dataset.names[0], *segments[1][0][1:], "spin"),))
    notes = {2: MotifNote(name="side step")}
    found = actions.actions_data(plain, segments, [own[0] for own in segments], notes)
    assert [entry["name"] for entry in found] == ["Action 0", "Action 1", "side step"]
    assert [entry["count"] for entry in found] == [4, 1, 1] and [entry["clips"] for entry in found] == [2, 1, 1]
    assert [entry["hint"] for entry in found] == ["", "spin", ""] and found[1]["label"] == "spin (100 %)"
    assert len({entry["colour"] for entry in found}) == 3


def test_spans_lie_within_what_plays(dataset):
    segments = _segments(dataset)
    first = dataset.clips[0]
    found = actions.spans(segments, {}, Segment(first.name, first.n_frames // 3 + 5, first.n_frames))
    assert [span["label"] for span in found] == ["1", "0"]


def test_ink_reads_on_its_ground():
    assert actions.ink_on("#ffffff") == "#10151d" and actions.ink_on("#202080") == "#ffffff"


def test_occurrences_as_a_file(dataset):
    segments = _segments(dataset)
    lines = list(csv.DictReader(io.StringIO(actions.segments_csv(dataset, segments, {1: MotifNote(name="turn")}))))
    assert len(lines) == 6 and [line["name"] for line in lines if line["action"] == "1"] == ["turn"]


def _points() -> list[table.Point]:
    return [
        table.Point(
            *(k, 9000, 300, 10 + k / 10, 0.1 + k / 500, 0.2 - k / 400, 100 - k, 20, 12, 900.0, 3.0, f"key{k}"),
            {"grammar-n_terminals": str(k)},
        )
        for k in (8, 20)
    ]


def test_charts_over_the_number_of_actions_hold_what_the_table_holds():
    points = _points()
    quality, counted = table.quality(points, "dark", 20), table.counts(points, "light")
    lines = {trace.name: list(trace.y) for trace in (*quality.data, *counted.data)}
    rows = table.rows(points)
    for label, field in (
        ("Reduced to R", "R"),
        ("Spread E'", "E"),
        ("Score F", "F"),
        ("Rules", "rules"),
        ("Routines", "sentences"),
    ):
        assert lines[label] == [row[field] for row in rows]
    assert rows[0]["repeats"] == pytest.approx(300 / 8, abs=0.01)
    assert [row["view"] for row in rows] == [{"grammar-n_terminals": "8"}, {"grammar-n_terminals": "20"}]
    assert len(quality.layout.shapes) == 3 and not counted.layout.shapes
    fields = {column["field"] for column in table.COLUMNS}
    assert fields <= set(rows[0])
