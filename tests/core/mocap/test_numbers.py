"""The scanner's numbers against Python's own."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.mocap import numbers


def _scan(text: str, shape=(1, 1), largest: float = 1e308):
    out = np.full(shape, np.nan)
    found = numbers.scan_rows(np.frombuffer(text.encode(), np.uint8), 0, out, largest)
    return out, found


FORMS = ["%r", "%.6f", "%.3e", "%+.9g", "%.25f", "%E"]


@given(st.floats(-1e300, 1e300), st.sampled_from(FORMS))
@settings(max_examples=400, deadline=None)
def test_numbers_as_python_reads_them(value, form):
    text = form % value
    expected = float(text)
    out, (rows, status, _, _) = _scan(text, largest=np.finfo(float).max)
    assert (rows, status) == (1, numbers.OK)
    assert out[0, 0] == pytest.approx(expected, rel=1e-14, abs=5e-323)


@pytest.mark.parametrize("word", ["1", "-1", "+1", "1.", ".5", "-.5", "1e5", "1E+05", "3.64024e-015", "00012", "-0"])
def test_spellings(word):
    out, (_, status, _, _) = _scan(word)
    assert status == numbers.OK and out[0, 0] == pytest.approx(float(word), rel=1e-15)


@pytest.mark.parametrize(
    "word", ["", "nan", "inf", "e5", ".", "-", "+-1", "1-", "1e", "1e+", "1_0", "0x1", "1,5", "1d5", "²"]
)
def test_no_numbers(word):
    _, (rows, status, _, _) = _scan(word)
    assert rows == 0 and (status == numbers.NOT_A_NUMBER or not word)


@given(st.binary(max_size=200))
@settings(max_examples=200, deadline=None)
def test_any_bytes_are_taken_or_refused(data):
    """Never a value beyond the table, never an endless loop; an accepted text has the rows that Python sees."""
    guard = np.full((6, 2), -7.0)
    rows, status, offset, _ = numbers.scan_rows(np.frombuffer(data, np.uint8), 0, guard[1:5], 1e9)
    assert 0 <= rows <= 4 and 0 <= offset <= len(data)
    assert (guard[[0, 5]] == -7).all()
    if status == numbers.OK:
        text = data.decode("ascii")
        lines = [line.split() for line in text.replace("\x0b", " ").replace("\x0c", " ").replace("\r", " ").split("\n")]
        values = [[float(w) for w in words] for words in lines if words]
        np.testing.assert_allclose(guard[1 : 1 + rows], np.array(values).reshape(-1, 2), rtol=1e-14)
