"""Forward kinematics and resampling against slow and obvious versions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics, joint_positions, resample
from core.mocap.skeleton import Skeleton

PARENTS = (-1, 0, 1, 1, 0, 4)


def random_clip(seed: int = 0, n_frames: int = 30, fps: float = 60.0, translations: bool = False) -> Clip:
    rng = np.random.default_rng(seed)
    skeleton = Skeleton(tuple("abcdef"), PARENTS, rng.standard_normal((6, 3)))
    rotations = quat.normalise(rng.standard_normal((n_frames, 6, 4))).astype(np.float32)
    root = rng.standard_normal((n_frames, 3)).astype(np.float32)
    tracks = {2: rng.standard_normal((n_frames, 3)).astype(np.float32)} if translations else {}
    return Clip("random", skeleton, fps, root, rotations, tracks)


def naive_positions(clip: Clip) -> np.ndarray:
    out = np.zeros((clip.n_frames, clip.skeleton.n_joints, 3))
    for f in range(clip.n_frames):
        matrices = {}
        for j, p in enumerate(clip.skeleton.parents):
            local = np.eye(4)
            local[:3, :3] = Rotation.from_quat(clip.rotations[f, j], scalar_first=True).as_matrix()
            offset = clip.translations[j][f] if j in clip.translations else clip.skeleton.offsets[j]
            local[:3, 3] = clip.root_positions[f] if p < 0 else offset
            matrices[j] = local if p < 0 else matrices[p] @ local
            out[f, j] = matrices[j][:3, 3]
    return out


@pytest.mark.parametrize("translations", [False, True])
def test_positions_agree_with_homogeneous_matrices(translations):
    clip = random_clip(translations=translations)
    np.testing.assert_allclose(joint_positions(clip), naive_positions(clip), atol=1e-5)


def test_world_rotations_are_products_down_the_tree():
    clip = random_clip()
    world = forward_kinematics(clip)[1]
    expected = quat.multiply(quat.multiply(clip.rotations[:, 0], clip.rotations[:, 1]), clip.rotations[:, 3])
    np.testing.assert_allclose(world[:, 3], expected, atol=1e-5)


def test_whole_number_steps_only_drop_frames():
    clip = random_clip(n_frames=31, fps=120)
    slow = resample(clip, 30)
    assert slow.n_frames == 8 and slow.fps == 30
    np.testing.assert_array_equal(slow.rotations, clip.rotations[::4])
    np.testing.assert_array_equal(slow.root_positions, clip.root_positions[::4])


def test_other_rates_interpolate_on_the_sphere():
    clip = random_clip(n_frames=5, fps=10)
    fast = resample(clip, 25)
    assert fast.n_frames == 11
    middle = quat.slerp(clip.rotations[0].astype(float), clip.rotations[1].astype(float), 0.4)
    np.testing.assert_allclose(np.abs((fast.rotations[1] * middle).sum(-1)), 1, atol=1e-6)
    np.testing.assert_allclose(
        fast.root_positions[1], 0.6 * clip.root_positions[0] + 0.4 * clip.root_positions[1], 1e-4
    )


def test_a_rate_must_be_positive():
    with pytest.raises(ValueError, match="positive"):
        resample(random_clip(), 0)


def test_cut_is_half_open_and_refuses_what_is_not_there():
    clip = random_clip(n_frames=10, translations=True)
    part = clip.cut(2, 5)
    assert part.n_frames == 3 and len(part.translations[2]) == 3
    np.testing.assert_array_equal(part.rotations, clip.rotations[2:5])
    for start, end in [(-1, 3), (3, 3), (4, 11)]:
        with pytest.raises(ValueError, match="cannot cut"):
            clip.cut(start, end)


@pytest.mark.parametrize(
    "names, parents", [("ab", (-1, 1)), ("ab", (0, -1)), ("aa", (-1, 0)), ("abc", (-1, 0)), ("ab", (-1, -1))]
)
def test_a_skeleton_that_is_no_tree_is_refused(names, parents):
    with pytest.raises(ValueError):
        Skeleton(tuple(names), parents, np.zeros((len(names), 3)))
