"""The kernels' sort against numpy's."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from core.sequences.ordering import ascending


@given(st.lists(st.integers(-5, 5), max_size=70))
def test_a_stable_sort(values):
    values = np.array(values, np.float32)
    np.testing.assert_array_equal(ascending(values), np.argsort(values, kind="stable"))
