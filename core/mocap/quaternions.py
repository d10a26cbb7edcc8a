"""Unit quaternions (w, x, y, z) as numpy arrays ``(..., 4)``. Angles are in radians."""

from __future__ import annotations

from typing import Literal, cast

import numpy as np
from scipy.spatial.transform import Rotation


def multiply(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Hamilton product ``a b`` (rotate by b, then by a), shapes ``(..., 4)``, broadcast."""
    aw, ax, ay, az = np.moveaxis(np.asarray(a), -1, 0)
    bw, bx, by, bz = np.moveaxis(np.asarray(b), -1, 0)
    return np.stack(
        (
            aw * bw - ax * bx - ay * by - az * bz,
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
        ),
        axis=-1,
    )


def conjugate(q: np.ndarray) -> np.ndarray:
    """Inverse of unit quaternions ``(..., 4)``."""
    inverse: np.ndarray = np.asarray(q) * np.array([1, -1, -1, -1], np.asarray(q).dtype)
    return inverse


def normalise(q: np.ndarray) -> np.ndarray:
    """Quaternions ``(..., 4)`` scaled to unit length."""
    unit: np.ndarray = q / np.linalg.norm(q, axis=-1, keepdims=True)
    return unit


def rotate(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Vectors ``(..., 3)`` rotated by quaternions ``(..., 4)``, broadcast."""
    u, w = q[..., 1:], q[..., :1]
    t = 2 * np.cross(u, v)
    rotated: np.ndarray = v + w * t + np.cross(u, t)
    return rotated


def from_euler(order: str, angles: np.ndarray) -> np.ndarray:
    """Intrinsic Euler angles ``(n, len(order))``, radians, to ``(n, 4)``; order: such as ``"ZYX"``."""
    return np.roll(Rotation.from_euler(order.upper(), angles).as_quat(), 1, axis=-1)


def to_euler(order: str, q: np.ndarray) -> np.ndarray:
    """``(n, 4)`` to intrinsic Euler angles ``(n, 3)``, radians; inverse of :func:`from_euler`."""
    axes = cast("Literal['XYZ']", order.upper())  # one of the 24 orders that scipy knows
    return np.asarray(_rotation(q).as_euler(axes, suppress_warnings=True))


def from_rotvec(v: np.ndarray) -> np.ndarray:
    """Rotation vectors ``(..., 3)``, radians, to ``(..., 4)``."""
    v = np.asarray(v)
    angle = np.linalg.norm(v, axis=-1, keepdims=True)
    return np.concatenate([np.cos(angle / 2), v * np.sinc(angle / (2 * np.pi)) / 2], axis=-1)


def to_rotvec(q: np.ndarray) -> np.ndarray:
    """``(..., 4)`` to rotation vectors ``(..., 3)``, radians, of length at most pi."""
    q = np.where(q[..., :1] < 0, -q, q)
    s = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(s, q[..., :1])
    return q[..., 1:] * np.where(s > 1e-8, angle / np.maximum(s, 1e-8), 2.0)


def slerp(a: np.ndarray, b: np.ndarray, t: np.ndarray | float) -> np.ndarray:
    """Shortest great arc from ``a`` to ``b``, both ``(..., 4)``; ``t`` in [0, 1] broadcasts over ``(...)``."""
    d = to_rotvec(multiply(conjugate(a), b))
    return multiply(a, from_rotvec(d * np.asarray(t)[..., None]))


def continuous(q: np.ndarray) -> np.ndarray:
    """Signs flipped so that neighbours along the first axis of ``(n_frames, ..., 4)`` lie on the same hemisphere."""
    flip = np.cumsum((q[1:] * q[:-1]).sum(-1) < 0, axis=0) % 2 == 1
    return np.concatenate([q[:1], np.where(flip[..., None], -q[1:], q[1:])])


def split_yaw(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Twist about vertical Y and the rest, ``q = yaw * tilt``: ``(..., 4)`` to angle ``(...)``, tilt ``(..., 4)``."""
    angle = 2 * np.arctan2(q[..., 2], q[..., 0])
    return angle, multiply(conjugate(from_yaw(angle)), q)


def from_yaw(angle: np.ndarray | float) -> np.ndarray:
    """Rotation by ``angle`` ``(...)``, radians, about the vertical Y axis, as ``(..., 4)``."""
    angle = np.asarray(angle)
    zero = np.zeros_like(angle)
    return np.stack([np.cos(angle / 2), zero, np.sin(angle / 2), zero], axis=-1)


def _rotation(q: np.ndarray) -> Rotation:
    return Rotation.from_quat(np.roll(q, -1, axis=-1))
