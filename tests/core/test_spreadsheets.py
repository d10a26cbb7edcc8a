"""No exported cell is taken for a formula, and what was written reads back."""

import csv
import io

import pytest

from core.mocap.clip import Label
from core.mocap.labels import read_labels, write_labels
from core.spreadsheets import SheetWriter, guarded, unguarded


@pytest.mark.parametrize("cell", ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", "\r=1"])
def test_a_formula_becomes_text(cell):
    assert guarded(cell) == "'" + cell and unguarded("'" + cell) == cell


@pytest.mark.parametrize("cell", ["walk", "", "'quoted'", "-1.5", "+2", "-.5e-3", -3, 2.5, None])
def test_everything_else_stays_as_it_is(cell):
    assert guarded(cell) == cell
    assert not isinstance(cell, str) or unguarded(cell) == cell


def test_rows_are_written_so():
    text = io.StringIO()
    writer = SheetWriter(text)
    writer.writerow(["clip", "=name"])
    writer.writerows([["-a", -1], ["b,c", "d"]])
    assert [*csv.reader(io.StringIO(text.getvalue()))] == [["clip", "'=name"], ["'-a", "-1"], ["b,c", "d"]]


def test_labels_read_back(tmp_path):
    labels = [Label("=clip", 0, 10, "@home"), Label("b", 2, 5, "-walk")]
    write_labels(tmp_path / "labels.csv", labels)
    assert "\n'=clip," in (tmp_path / "labels.csv").read_text()
    assert [*read_labels(tmp_path / "labels.csv")] == labels
