"""Band-limited noise: its strength, its band, and what it leaves alone."""

from __future__ import annotations

import numpy as np
import pytest

from core.editing.noise import band_limited, shake_dataset, shake_joints
from core.mocap import quaternions as quat
from core.mocap.dataset import Dataset
from tests.core.editing.figures import standing


@pytest.mark.parametrize(("n", "fps", "band"), [(6000, 60, (0.5, 5)), (100_000, 120, (1, 10)), (4001, 30, (0, 40))])
def test_noise_has_the_deviation_and_the_band_that_were_asked_for(n, fps, band):
    noise = band_limited(n, fps, band, np.random.default_rng(1), 6)
    assert noise.shape == (n, 6) and noise.dtype == np.float32
    assert noise.std() == pytest.approx(1, abs=0.05) and abs(noise.mean()) < 0.05
    power = (np.abs(np.fft.rfft(noise * np.hanning(n)[:, None], axis=0)) ** 2).sum(1)
    frequencies = np.fft.rfftfreq(n, 1 / fps)
    outside = (frequencies < band[0] - 0.1) | (frequencies > band[1] + 0.1)
    assert power[outside].sum() < 1e-3 * power.sum()
    inside = power[(frequencies >= band[0]) & (frequencies <= min(band[1], fps / 2))]
    halves = inside[: len(inside) // 2].sum(), inside[len(inside) // 2 :].sum()
    assert 0.6 < halves[0] / halves[1] < 1.7  # flat within the band


def test_short_clips_get_noise_of_the_same_strength():
    rng = np.random.default_rng(0)
    values = np.concatenate([band_limited(20, 60, (0.5, 5), rng, 3) for _ in range(2000)])
    assert values.std() == pytest.approx(1, abs=0.03)


@pytest.mark.parametrize("band", [(5, 5), (6, 2), (-1, 4), (40, 50)])
def test_an_impossible_band_is_refused(band):
    with pytest.raises(ValueError, match="Hz is not possible"):
        band_limited(100, 60, band, np.random.default_rng(0), 1)


def test_joints_turn_by_so_many_degrees_and_the_root_stays():
    clip = standing(3000)
    shaken = shake_joints(clip, 3.0, (0.5, 5), np.random.default_rng(0))
    assert np.array_equal(shaken.root_positions, clip.root_positions)
    assert np.array_equal(shaken.rotations[:, 0], clip.rotations[:, 0])
    turned = np.degrees(quat.to_rotvec(quat.multiply(quat.conjugate(clip.rotations), shaken.rotations)))
    ends = np.flatnonzero(clip.skeleton.end_sites)
    joints = np.setdiff1d(np.arange(1, clip.skeleton.n_joints), ends)
    assert np.abs(turned[:, joints].std(0) - 3).max() < 0.5
    assert len(ends) and np.abs(turned[:, ends]).max() < 0.01
    assert np.allclose(np.linalg.norm(shaken.rotations, axis=-1), 1, atol=1e-5)
    steps = np.abs(np.diff(turned[:, joints], axis=0)).max()
    assert steps < 2 * np.pi * 5 * 3 * 5 / 60  # no faster than the highest frequency at five deviations


def test_noise_of_a_clip_depends_on_seed_and_name_alone():
    clip = standing(200)
    alone = Dataset("d", (clip,))
    other = Dataset("d", (standing(100, bend=0.2).cut(0, 90, "first"), clip))
    one, two = (shake_dataset(d, 2.0, (0.5, 5), 7) for d in (alone, other))
    assert np.array_equal(one.clip("standing").rotations, two.clip("standing").rotations)
    assert not np.array_equal(one.clips[0].rotations, shake_dataset(alone, 2.0, (0.5, 5), 8).clips[0].rotations)
    assert one.fingerprint != alone.fingerprint
