"""Thinned curves keep their peaks."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.sequences.envelope import envelope


@given(st.integers(1, 3000), st.integers(4, 300), st.integers(0, 99))
def test_every_stretch_keeps_its_least_and_greatest(n, most, seed):
    values = np.random.default_rng(seed).normal(size=n).cumsum()
    kept = envelope(values, most)
    assert (np.diff(kept) > 0).all() and kept[0] == 0 and kept[-1] == n - 1
    assert len(kept) <= max(most, 4) + 4
    if n <= most:
        assert len(kept) == n
    width = -(-2 * n // most)
    for start in range(0, n, width) if n > most else ():
        stretch = values[start : start + width]
        inside = values[kept[(kept >= start) & (kept < start + width)]]
        assert inside.min() == stretch.min() and inside.max() == stretch.max()


def test_too_few_points_are_refused():
    with pytest.raises(ValueError, match="at least 4"):
        envelope(np.zeros(9), 3)
