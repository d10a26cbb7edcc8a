"""Tables whose rows stay on the server: sorted, filtered and sent in blocks as AG Grid asks."""

from __future__ import annotations

import pytest

from webapp.ui.long_tables import LongTable

NAMES = ["walk 1", "Run 2", "walk 10", "kick", "run 1"]
COUNTS = [3, None, 1, 2, None]
KINDS = ["jump, rate", "", "rate", "up", ""]
TABLE = LongTable({"name": NAMES, "count": COUNTS}, lambda k: {"name": NAMES[k]}, {"count": KINDS})


def asked(filters=None, sort=(), start=0, end=100):
    sorting = [{"colId": column, "sort": way} for column, way in sort]
    block = TABLE.block({"startRow": start, "endRow": end, "filterModel": filters or {}, "sortModel": sorting})
    return [row["name"] for row in block["rowData"]], block["rowCount"]


def text(kind, word):
    return {"filterType": "text", "type": kind, "filter": word}


def test_a_block_is_a_part_of_all_rows():
    assert asked(start=1, end=3) == (["Run 2", "walk 10"], 5)
    assert asked(start=9, end=12) == ([], 5)


def test_rows_are_sorted_either_way_and_missing_values_are_last():
    assert asked(sort=[("name", "asc")])[0] == ["kick", "run 1", "Run 2", "walk 1", "walk 10"]
    assert asked(sort=[("count", "asc")])[0] == ["walk 10", "kick", "walk 1", "Run 2", "run 1"]
    assert asked(sort=[("count", "desc"), ("name", "asc")])[0] == ["walk 1", "kick", "walk 10", "run 1", "Run 2"]


@pytest.mark.parametrize(
    ("kind", "word", "left"),
    [
        ("contains", "RUN", ["Run 2", "run 1"]),
        ("notContains", "run", ["walk 1", "walk 10", "kick"]),
        ("equals", "kick", ["kick"]),
        ("startsWith", "walk", ["walk 1", "walk 10"]),
        ("endsWith", "1", ["walk 1", "run 1"]),
    ],
)
def test_filters_of_text(kind, word, left):
    assert asked({"name": text(kind, word)}) == (left, len(left))


def test_a_column_may_be_filtered_by_words_and_conditions_combine():
    assert asked({"count": text("contains", "rate")})[0] == ["walk 1", "walk 10"]
    assert asked({"count": text("blank", "")})[0] == ["Run 2", "run 1"]
    either = {"operator": "OR", "conditions": [text("equals", "kick"), text("startsWith", "run")]}
    assert asked({"name": either})[0] == ["Run 2", "kick", "run 1"]
    assert asked({"name": either, "count": text("notBlank", "")})[0] == ["kick"]


def test_what_is_no_request_of_the_table_is_no_fault():
    assert asked({"other": text("contains", "x"), "name": 7})[1] == 5
    assert TABLE.block({})["rowCount"] == 5
    assert TABLE.order([1], {"a": 1}).tolist() == [0, 1, 2, 3, 4]
