"""Frames without values of their own, filled from the frames around them."""

from __future__ import annotations

import numpy as np

from core.mocap import quaternions as quat


def fill_rotations(rotations: np.ndarray, lost: np.ndarray) -> None:
    """Gives the frames ``lost`` ``(n,)`` bool of ``rotations`` (n, n_joints, 4) the turn between their neighbours.

    In place; at either end the nearest frame is repeated. Raises ValueError where all frames are lost.
    """
    at, before, after, share = _neighbours(lost)
    if len(at):
        between = quat.slerp(rotations[before].astype(float), rotations[after].astype(float), share[:, None])
        rotations[at] = between.astype(rotations.dtype)


def fill_track(track: np.ndarray, lost: np.ndarray) -> None:
    """The same for places ``track`` (n, 3), on the straight line between the neighbours."""
    at, before, after, share = _neighbours(lost)
    if len(at):
        track[at] = track[before] * (1 - share[:, None]) + track[after] * share[:, None]


def _neighbours(lost: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """The lost frames, the last and the next that is there, and how far between the two each lies, 0 to 1."""
    at, there = np.flatnonzero(lost), np.flatnonzero(~lost)
    if not len(there):
        raise ValueError("no frame is left to fill the others from")
    following = np.searchsorted(there, at)
    before, after = there[np.maximum(following - 1, 0)], there[np.minimum(following, len(there) - 1)]
    before = np.where(before > at, after, before)
    share = (at - before) / np.maximum(after - before, 1)
    return at, before, after, np.clip(share, 0, 1)
