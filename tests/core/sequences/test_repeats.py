"""Runs of letters."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from core.sequences.repeats import remove_runs


@given(st.lists(st.lists(st.integers(0, 3), min_size=1, max_size=20), min_size=1, max_size=4))
def test_runs_spell_the_labels_again(clips):
    labels, starts = np.concatenate(clips), np.cumsum([0, *map(len, clips)])
    runs = remove_runs(labels, starts)
    np.testing.assert_array_equal(np.repeat(runs.letters, runs.ends - runs.starts), labels)
    for j in range(len(runs.letters)):
        clip = np.searchsorted(starts, runs.starts[j], side="right")
        assert starts[clip - 1] <= runs.starts[j] < runs.ends[j] <= starts[clip]
        assert runs.starts[runs.firsts[j]] == starts[clip - 1] and runs.ends[runs.stops[j] - 1] == starts[clip]
        if j + 1 < runs.stops[j]:
            assert runs.letters[j] != runs.letters[j + 1]


def test_run_times():
    runs = remove_runs(np.array([5, 5, 5, 2, 2, 5]), np.array([0, 6]))
    assert runs.middles.tolist() == [1.0, 3.5, 5.0] and runs.lengths.tolist() == [3, 2, 1]
