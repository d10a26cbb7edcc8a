"""Quaternions against scipy's rotations."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.mocap import quaternions as quat


def random_quaternions(seed: int, *shape: int) -> np.ndarray:
    return quat.normalise(np.random.default_rng(seed).standard_normal((*shape, 4)))


def as_scipy(q: np.ndarray) -> Rotation:
    return Rotation.from_quat(q, scalar_first=True)


@given(st.integers(0, 2**32 - 1))
def test_product_and_rotation_agree_with_matrices(seed):
    a, b = random_quaternions(seed, 5), random_quaternions(seed + 1, 5)
    v = np.random.default_rng(seed + 2).standard_normal((5, 3))
    np.testing.assert_allclose(
        as_scipy(quat.multiply(a, b)).as_matrix(), as_scipy(a).as_matrix() @ as_scipy(b).as_matrix(), atol=1e-12
    )
    np.testing.assert_allclose(quat.rotate(a, v), as_scipy(a).apply(v), atol=1e-12)
    np.testing.assert_allclose(quat.rotate(quat.conjugate(a), quat.rotate(a, v)), v, atol=1e-12)


@pytest.mark.parametrize("order", ["XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"])
def test_euler_round_trip(order):
    q = random_quaternions(3, 50)
    back = quat.from_euler(order, quat.to_euler(order, q))
    np.testing.assert_allclose(np.abs((q * back).sum(-1)), 1, atol=1e-9)


def test_euler_angles_are_intrinsic_first_axis_first():
    z, y, x = np.radians([30.0, 20.0, 10.0])
    expected = quat.multiply(
        quat.multiply(quat.from_rotvec([0, 0, z]), quat.from_rotvec([0, y, 0])), quat.from_rotvec([x, 0, 0])
    )
    np.testing.assert_allclose(quat.from_euler("ZYX", np.array([[z, y, x]]))[0], expected, atol=1e-12)


@given(st.integers(0, 2**32 - 1), st.floats(1e-12, 3.1))
def test_rotation_vector_round_trip(seed, angle):
    axis = np.random.default_rng(seed).standard_normal(3)
    v = axis / np.linalg.norm(axis) * angle
    np.testing.assert_allclose(quat.to_rotvec(quat.from_rotvec(v)), v, atol=1e-9)


def test_slerp_takes_the_short_way_at_constant_speed():
    a, b = random_quaternions(1, 4), random_quaternions(2, 4)
    total = np.linalg.norm(quat.to_rotvec(quat.multiply(quat.conjugate(a), b)), axis=-1)
    for t in (0.0, 0.25, 1.0):
        part = quat.to_rotvec(quat.multiply(quat.conjugate(a), quat.slerp(a, -b, t)))
        np.testing.assert_allclose(np.linalg.norm(part, axis=-1), t * total, atol=1e-9)


def test_continuous_never_jumps_hemisphere_and_keeps_the_rotation():
    q = random_quaternions(4, 100, 3)
    smooth = quat.continuous(q)
    assert ((smooth[1:] * smooth[:-1]).sum(-1) >= 0).all()
    np.testing.assert_allclose(np.abs((smooth * q).sum(-1)), 1, atol=1e-12)


def test_yaw_splits_off_the_vertical_twist():
    q = random_quaternions(5, 20)
    angle, tilt = quat.split_yaw(q)
    np.testing.assert_allclose(quat.multiply(quat.from_yaw(angle), tilt), q, atol=1e-12)
    np.testing.assert_allclose(tilt[:, 2], 0, atol=1e-12)
