"""Forward kinematics and resampling of clips."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.arrays import Float32Array, Int64Array
from core.compiled import njit
from core.mocap import quaternions as quat
from core.mocap.clip import Clip


def joint_positions(clip: Clip) -> np.ndarray:
    """World positions of all joints: ``(n_frames, n_joints, 3)`` float32, metres, Y up."""
    return forward_kinematics(clip)[0]


def forward_kinematics(clip: Clip) -> tuple[np.ndarray, np.ndarray]:
    """World positions ``(n_frames, n_joints, 3)``, metres, and world rotations ``(n_frames, n_joints, 4)``, float32."""
    parents = np.array(clip.skeleton.parents, np.int64)
    local = np.broadcast_to(clip.skeleton.offsets, (clip.n_frames, clip.skeleton.n_joints, 3))
    if clip.translations:
        local = local.copy()
        for joint, track in clip.translations.items():
            local[:, joint] = track
    return _forward(parents, local, np.asarray(clip.root_positions, np.float32), np.asarray(clip.rotations, np.float32))


@njit()
def _forward(
    parents: Int64Array, local: Float32Array, root: Float32Array, rotations: Float32Array
) -> tuple[Float32Array, Float32Array]:
    n, joints = rotations.shape[0], rotations.shape[1]
    positions = np.empty((n, joints, 3), np.float32)
    world = np.empty((n, joints, 4), np.float32)
    for f in range(n):
        for j in range(joints):
            w, x, y, z = rotations[f, j, 0], rotations[f, j, 1], rotations[f, j, 2], rotations[f, j, 3]
            p = parents[j]
            if p < 0:
                for k in range(3):
                    positions[f, j, k] = root[f, k]
                world[f, j, 0], world[f, j, 1], world[f, j, 2], world[f, j, 3] = w, x, y, z
                continue
            a, b, c, d = world[f, p, 0], world[f, p, 1], world[f, p, 2], world[f, p, 3]
            world[f, j, 0] = a * w - b * x - c * y - d * z
            world[f, j, 1] = a * x + b * w + c * z - d * y
            world[f, j, 2] = a * y - b * z + c * w + d * x
            world[f, j, 3] = a * z + b * y - c * x + d * w
            vx, vy, vz = local[f, j, 0], local[f, j, 1], local[f, j, 2]
            tx, ty, tz = 2 * (c * vz - d * vy), 2 * (d * vx - b * vz), 2 * (b * vy - c * vx)
            positions[f, j, 0] = positions[f, p, 0] + vx + a * tx + c * tz - d * ty
            positions[f, j, 1] = positions[f, p, 1] + vy + a * ty + d * tx - b * tz
            positions[f, j, 2] = positions[f, p, 2] + vz + a * tz + b * ty - c * tx
    return positions, world


def resample(clip: Clip, fps: float) -> Clip:
    """The clip at another frame rate: linear root, spherical rotations. A whole-number step only drops frames.

    Frame k of the result is the clip at k / fps seconds; the last frame is the last that lies inside the clip.
    Raises ValueError when fps is not positive.
    """
    if not fps > 0:
        raise ValueError(f"frame rate must be positive, not {fps}")
    if abs(clip.fps - fps) < 1e-3 * fps:
        return clip
    step = clip.fps / fps
    n = int((clip.n_frames - 1) / step + 1e-6) + 1
    at = np.arange(n) * step
    if abs(step - round(step)) < 1e-3:
        at = np.round(at)
    at = np.minimum(at, clip.n_frames - 1)
    return replace(
        clip,
        fps=fps,
        root_positions=_linear(clip.root_positions, at),
        rotations=_spherical(clip.rotations, at),
        translations={j: _linear(t, at) for j, t in clip.translations.items()},
    )


def _linear(track: np.ndarray, at: np.ndarray) -> np.ndarray:
    i = at.astype(np.int64)
    t = (at - i).astype(np.float32)[:, None]
    return track[i] if not t.any() else track[i] * (1 - t) + track[np.minimum(i + 1, len(track) - 1)] * t


def _spherical(rotations: np.ndarray, at: np.ndarray) -> np.ndarray:
    i = at.astype(np.int64)
    t = (at - i).astype(np.float32)
    if not t.any():
        return rotations[i]
    return quat.slerp(rotations[i], rotations[np.minimum(i + 1, len(rotations) - 1)], t[:, None]).astype(np.float32)
