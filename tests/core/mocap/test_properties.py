"""Properties of clips: kinds, tables with faults, patterns over names."""

from __future__ import annotations

import pytest

from core.errors import FormatError, ParameterError
from core.mocap.properties import Properties, from_json
from core.mocap.property_files import by_pattern, parse_properties, read_properties

CLIPS = ("walk_old_001", "walk_young_001", "run_young_002")


def test_a_table_is_read_with_the_kinds_of_its_columns(tmp_path):
    path = tmp_path / "clips.csv"
    path.write_bytes(
        b"\xef\xbb\xbfClip;subject;age;day\r\nwalk_old_001.bvh;Ana;71;2026-01-09\r\nrun_young_002;Ben;9.5;2026-01-10\r\n"
    )
    made, remarks = read_properties(path, CLIPS)
    assert made.columns == {"subject": "text", "age": "number", "day": "date"}
    assert made.values["walk_old_001"] == {"subject": "Ana", "age": "71", "day": "2026-01-09"}
    assert list(made.groups("age")) == ["9.5", "71"]
    assert remarks == tuple(f"“{name}” is missing for 1 clip (walk_young_001)." for name in ("subject", "age", "day"))
    assert from_json(made.to_json()) == made
    again, _ = parse_properties(made.to_csv(CLIPS), CLIPS)
    assert again == made


def test_rows_that_do_not_fit_are_told_with_their_lines():
    text = (
        "clip,age\nwalk_old_001,71\nnobody,3\nwalk_old_001,17\nwalk_old_001,71\nwalk_young_001,young\nrun_young_002,12"
    )
    made, remarks = parse_properties(text, CLIPS)
    assert made.column("age") == {"walk_old_001": "71", "walk_young_001": "young", "run_young_002": "12"}
    assert remarks == (
        "1 row (line 3: nobody) of clips that are not here.",
        "1 row (line 4: walk_old_001) that give other values for a clip named before; the first counts.",
        "“age” is text, for 1 of 3 values are no number: walk_young_001: young.",
    )


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "is empty"),
        ("name,age\nwalk,3", "has no column “clip”"),
        ("clip\nwalk_old_001", "needs columns beside"),
        ("clip,age,age\nwalk_old_001,1,2", "a name of its own"),
        ("clip,age\nnobody,3", "none of its 1 rows"),
        ("clip," + "x" * 70 + "\nwalk_old_001,1", "60 fit"),
    ],
)
def test_a_table_that_says_nothing_is_refused(text, words):
    with pytest.raises((FormatError, ParameterError), match=words):
        parse_properties(text, CLIPS)


def test_names_hold_properties():
    found, left = by_pattern("{action}_{age}_{take}", [*CLIPS, "odd"])
    assert found["run_young_002"] == {"action": "run", "age": "young", "take": "002"} and left == ("odd",)
    assert by_pattern("*_{age}_*", CLIPS)[0]["walk_old_001"] == {"age": "old"}
    assert by_pattern("walk_{age}_001", CLIPS)[1] == ("run_young_002",)
    assert by_pattern("{all}", ["a_b"])[0] == {"a_b": {"all": "a_b"}}


@pytest.mark.parametrize("pattern", ["walk", "{a}{b}", "{a", "{}_x", "{a}_{a}", "{clip}_{a}", "**{a}"])
def test_a_pattern_that_leaves_something_open_is_refused(pattern):
    with pytest.raises(ParameterError):
        by_pattern(pattern, CLIPS)


def test_values_are_written_over_and_taken_away():
    made = Properties().with_values({"a": {"age": "3", "who": "Ana"}, "b": {"age": "4"}})
    assert made.with_values({"a": {"age": ""}}).values == {"a": {"who": "Ana"}, "b": {"age": "4"}}
    assert made.with_values({"b": {"age": "four"}}).columns["age"] == "text"
    assert made.with_kind("age", "text").with_values({"c": {"age": "5"}}).columns["age"] == "text"
    with pytest.raises(ParameterError, match=r"no date for 2 clips \(a \(3\), b \(4\)\)"):
        made.with_kind("age", "date")
    assert made.without_column("age").values == {"a": {"who": "Ana"}}
    with pytest.raises(ParameterError, match="There is no property 'height'"):
        made.groups("height")
