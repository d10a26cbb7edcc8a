"""Rows in memory and in a file are the same rows."""

from __future__ import annotations

import numpy as np
import pytest

from core.demo import make_demo
from core.poses import features
from core.poses.features import pose_features
from core.poses.rows import Rows


@pytest.mark.parametrize("in_memory", [0, 500, 10**6])
def test_rows_come_back_in_order_wherever_they_were(in_memory):
    blocks = list(np.random.default_rng(0).normal(size=(7, 5, 6)).astype(np.float32))
    rows = Rows(in_memory)
    for block in (*blocks, np.zeros((0, 6))):
        rows.add(block)
    found = rows.array()
    assert isinstance(found, np.memmap) == (in_memory < 10**6)
    np.testing.assert_array_equal(found, np.concatenate(blocks))


def test_no_rows_are_an_error():
    with pytest.raises(ValueError):
        Rows().array()


def test_features_kept_in_a_file_and_projected_in_pieces_are_the_same(monkeypatch):
    demo = make_demo(minutes=1)
    whole = pose_features(demo)
    monkeypatch.setattr(features, "_TOGETHER", 100)
    monkeypatch.setattr(features, "Rows", lambda: Rows(1000))
    pieces = pose_features(demo)
    np.testing.assert_allclose(pieces.values, whole.values, atol=1e-3)
    np.testing.assert_array_equal(pieces.clip_starts, whole.clip_starts)
    np.testing.assert_array_equal(pieces.basis, whole.basis)
