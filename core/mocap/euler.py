"""Euler angles of a whole skeleton to quaternions, in one jitted pass over the frames."""

from __future__ import annotations

import numpy as np

from core.arrays import Float32Array, Float64Array, Int64Array
from core.compiled import njit

AXES = "XYZ"


def rotations_from_angles(
    values: np.ndarray, columns: np.ndarray, axes: np.ndarray, frames: np.ndarray | None = None
) -> np.ndarray:
    """Unit quaternions (n_frames, n_joints, 4), float32, of intrinsic Euler angles.

    values: (n_frames, n_columns) float64; angles in degrees.
    columns, axes: (n_joints, 3) int: where the first, second, third angle of a joint stands, and its axis (0 X, 1 Y,
        2 Z); -1 for none. A joint's rotation is the product in this order, each about the axis turned by those before.
    frames: (n_joints, 4) unit quaternions C or None; the result is ``C R C^-1``: angles given in an axis frame of
        the joint's own, as in ASF.
    Raises ValueError where the shapes do not agree.
    """
    if columns.shape != axes.shape or columns.shape[1:] != (3,):
        raise ValueError(f"columns {columns.shape} and axes {axes.shape} must both be (n_joints, 3)")
    if frames is None:
        frames = np.tile([1.0, 0.0, 0.0, 0.0], (len(columns), 1))
    return _rotations(values, columns.astype(np.int64), axes.astype(np.int64), frames.astype(np.float64))


@njit(nogil=True)
def _rotations(values: Float64Array, columns: Int64Array, axes: Int64Array, frames: Float64Array) -> Float32Array:
    n, joints = values.shape[0], columns.shape[0]
    out = np.empty((n, joints, 4), np.float32)
    half = np.pi / 360
    v = np.zeros(3)
    for f in range(n):
        for j in range(joints):
            w, x, y, z = 1.0, 0.0, 0.0, 0.0
            for k in range(3):
                if columns[j, k] < 0:
                    continue
                angle = values[f, columns[j, k]] * half
                c, s = np.cos(angle), np.sin(angle)
                if axes[j, k] == 0:
                    w, x, y, z = w * c - x * s, w * s + x * c, y * c + z * s, z * c - y * s
                elif axes[j, k] == 1:
                    w, x, y, z = w * c - y * s, x * c - z * s, w * s + y * c, x * s + z * c
                else:
                    w, x, y, z = w * c - z * s, x * c + y * s, y * c - x * s, w * s + z * c
            a, b, c, d = frames[j, 0], frames[j, 1], frames[j, 2], frames[j, 3]
            if b != 0 or c != 0 or d != 0:  # turn the rotation's axis by C
                tx, ty, tz = 2 * (c * z - d * y), 2 * (d * x - b * z), 2 * (b * y - c * x)
                v[0] = x + a * tx + c * tz - d * ty
                v[1] = y + a * ty + d * tx - b * tz
                v[2] = z + a * tz + b * ty - c * tx
                x, y, z = v[0], v[1], v[2]
            out[f, j, 0], out[f, j, 1], out[f, j, 2], out[f, j, 3] = w, x, y, z
    return out
