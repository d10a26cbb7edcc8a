"""The table over numbers of terminals: what may be asked, and that equal tables are equal."""

from __future__ import annotations

import json

import pytest

from core.errors import ParameterError
from core.grammar.table import MOST, TableParameters, part_report


def test_numbers_are_sorted_and_each_is_there_once():
    asked = TableParameters("20, 8 20,12", '{"weight": 0.3, "n_terminals": 5}')
    assert asked.numbers() == (8, 12, 20)
    assert asked == TableParameters("8,12,20", '{"weight": 0.3}')
    assert asked.points() == tuple({"weight": 0.3, "n_terminals": n} for n in (8, 12, 20))
    assert json.loads(asked.base) == {"weight": 0.3}


@pytest.mark.parametrize("counts", ["", " , ", "0", "501", "-3", "2.5", "many", ",".join(map(str, range(1, MOST + 2)))])
def test_what_is_no_list_of_numbers_is_refused(counts):
    with pytest.raises(ParameterError, match="expected"):
        TableParameters(counts)


@pytest.mark.parametrize("base", ["", "[]", "3", "{"])
def test_a_base_that_is_no_object_is_refused(base):
    with pytest.raises(ParameterError, match="JSON object"):
        TableParameters("8", base)


def test_progress_goes_on_through_all_parts():
    told = []
    for number in range(3):
        part_report(lambda stage, fraction: told.append((stage, fraction)), number, 3)("cutting", 0.5)
    assert told == [
        ("cutting (1 of 3)", pytest.approx(1 / 6)),
        ("cutting (2 of 3)", 0.5),
        ("cutting (3 of 3)", pytest.approx(5 / 6)),
    ]
