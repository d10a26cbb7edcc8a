"""Clips from joints whose places and rotations in the world are both known."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.errors import RecordingError
from core.mocap.reports import Finding
from core.mocap.skeleton import Skeleton
from core.mocap.text import LARGEST, recording_format

_POOR_FIT = 0.05  # metres that a joint may lie away from where its rotations put it


def clip_of_world(
    path: str | Path,
    names: Sequence[str],
    parents: Sequence[int],
    places: np.ndarray,
    turns: np.ndarray,
    fps: float,
    notes: tuple[str, ...] = (),
) -> Clip:
    """A clip of joints at ``places`` (n_frames, n_joints, 3), metres, turned by ``turns`` (n_frames, n_joints, 4).

    Offsets are the medians of where joints lie against their parents; a note says how far they ever are from there.
    Raises RecordingError for numbers that are none.
    """
    if not (np.isfinite(places).all() and np.isfinite(turns).all() and np.abs(places).max(initial=0) < LARGEST):
        raise RecordingError(path, "joints or rotations that are no numbers", "finite numbers")
    lengths = np.linalg.norm(turns, axis=2, keepdims=True)
    if not len(places) or not (lengths > 1e-6).all():
        raise RecordingError(path, "rotations that are none", "rotations of every joint")
    turns = turns / lengths
    offsets, local, furthest = np.zeros((len(names), 3)), turns.copy(), 0.0
    for j, parent in enumerate(parents):
        if parent >= 0:
            back = quat.conjugate(turns[:, parent])
            local[:, j] = quat.multiply(back, turns[:, j])
            away = quat.rotate(back, places[:, j] - places[:, parent])
            offsets[j] = np.median(away, axis=0)
            furthest = max(furthest, float(np.linalg.norm(away - offsets[j], axis=1).max()))
    findings: tuple[Finding, ...] = ()
    if furthest > _POOR_FIT:
        words = f"joints lie up to {furthest * 1000:.0f} mm away from where their rotations put them"
        findings = (Finding("fit", words),)
    return Clip(
        name=recording_format(path)[0],
        skeleton=Skeleton(tuple(names), tuple(parents), offsets),
        fps=float(fps),
        root_positions=places[:, 0].astype(np.float32),
        rotations=local.astype(np.float32),
        notes=(f"joints with their rotations: bones of fixed lengths fit within {furthest * 1000:.1f} mm", *notes),
        findings=findings,
    )
