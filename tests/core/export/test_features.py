"""The feature table: rows that mean the same as the recordings, and files that read back."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.export import feature_table, write_features
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Label
from core.mocap.kinematics import joint_positions
from tests.webapp.generated import walkers


@pytest.fixture(scope="module")
def dataset():
    made = walkers(("b_01", "a_01", "b_02"), seconds=2.0, fps=60.0)
    return replace(made, labels=(Label("b_01", 30, 60, "step"), Label("b_01", 50, 90, "stop")))


@pytest.fixture(scope="module")
def table(dataset):
    return feature_table(dataset)


def test_rows_are_frames_of_the_clips(dataset, table):
    assert table.clips == ("a_01", "b_01", "b_02") and table.fps == 30
    assert list(table.clip_starts) == [0, 60, 120, 180] and list(table.frames[60:63]) == [0, 2, 4]
    clip = dataset.clip("b_01")
    knee = find_anatomy(clip.skeleton).joints["left_knee"]
    expected = joint_positions(clip)[::2, knee]
    np.testing.assert_allclose(table.positions[60:120, table.joints.index("left_knee")], expected, atol=1e-5)


def test_knees_bend_and_labels_lie_where_they_were_given(table):
    bend = table.angles[60:120, table.angle_names.index("left_knee flexion")]
    assert 40 < np.nanmax(bend) < 60 and abs(np.nanmin(bend)) < 8  # the walk bends them by 0 to .9 radians
    labels = [table.actions[k] if k >= 0 else "" for k in table.labels[60:120]]
    assert labels == [""] * 15 + ["step"] * 10 + ["stop"] * 20 + [""] * 15
    assert np.all(table.labels[:60] == -1)


def test_people_are_split_not_clips(table):
    assert table.subjects == ("a", "b", "b") and sorted(set(table.splits)) == ["test", "train"]
    assert table.splits[1] == table.splits[2]


def test_npz_reads_back_without_pickles(tmp_path, table):
    write_features(tmp_path / "features.npz", table)
    with np.load(tmp_path / "features.npz", allow_pickle=False) as found:
        assert tuple(found["clips"]) == table.clips and tuple(found["actions"]) == table.actions
        np.testing.assert_array_equal(found["poses"], table.poses)
        assert found["positions"].shape == (180, len(table.joints), 3)
    assert [path.name for path in tmp_path.iterdir()] == ["features.npz"]


def test_parquet_has_a_row_a_frame(tmp_path, table):
    import pyarrow.parquet as pq

    path = tmp_path / "new" / "features.parquet"
    write_features(path, table)
    found = pq.read_table(path)
    assert found.num_rows == 180
    assert found["clip"].to_pylist()[::60] == ["a_01", "b_01", "b_02"]
    assert found["label"].to_pylist()[60:120:15] == [None, "step", "stop", None]
    np.testing.assert_array_equal(
        found["left_knee.y"].to_numpy(), table.positions[:, table.joints.index("left_knee"), 1]
    )


def test_another_suffix_is_refused(tmp_path, table):
    with pytest.raises(ValueError, match="npz or"):
        write_features(tmp_path / "features.csv", table)
