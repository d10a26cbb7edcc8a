"""Bodies for poses of the SMPL family: of average proportions, or the joints of the model that someone has.

Average proportions: shares of the stature after Drillis and Contini 1966, Body Segment Parameters (as in Winter 2009,
Biomechanics and Motor Control of Human Movement); what these do not give lies between.
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from core.mocap.errors import RecordingError
from core.mocap.points.array_files import read_arrays
from core.mocap.points.presets import PRESETS

ENVIRONMENT = "MOTIONSCAPE_SMPL"
STATURE = 1.70  # metres
NAMES = PRESETS["smpl24"].points
PARENTS = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19, 20, 21)
# From the parent, in shares of the stature: X to the left, Y up, Z forward, in a T-pose.
_LEFT = {
    "hip": (0.050, -0.030, 0),
    "knee": (0, -0.245, 0),
    "ankle": (0, -0.246, 0),
    "foot": (0, -0.030, 0.080),
    "collar": (0.040, 0.060, 0),
    "shoulder": (0.0895, 0.018, 0),
    "elbow": (0.186, 0, 0),
    "wrist": (0.146, 0, 0),
    "hand": (0.054, 0, 0),
}
_CENTRE = {"pelvis": 0.0, "spine1": 0.065, "spine2": 0.080, "spine3": 0.035, "neck": 0.120, "head": 0.055}


def average_offsets() -> np.ndarray:
    """Offsets ``(24, 3)`` of the joints from their parents, metres, of a body of average proportions."""
    offsets = np.zeros((len(NAMES), 3))
    for k, name in enumerate(NAMES):
        side, _, part = name.partition("_")
        if part:
            offsets[k] = np.array(_LEFT[part]) * (1 if side == "left" else -1, 1, 1)
        else:
            offsets[k, 1] = _CENTRE[name]
    return offsets * STATURE


def model_offsets(betas: np.ndarray | None) -> np.ndarray | None:
    """Offsets ``(n_joints, 3)``, metres, of the joints of the model that MOTIONSCAPE_SMPL names, in the shape of
    ``betas`` (n,); None where it names none. Raises RecordingError where that file is no such model."""
    given = os.environ.get(ENVIRONMENT, "")
    if not given:
        return None
    path = Path(given)
    if path.suffix.lower() != ".npz":
        raise RecordingError(path, f"{ENVIRONMENT} names no .npz", "the body model as .npz, which cannot run code")
    arrays = read_arrays(path)
    missing = [name for name in ("J_regressor", "v_template", "kintree_table") if name not in arrays]
    if missing:
        raise RecordingError(path, f"no {', '.join(missing)} in the body model", "a model of the SMPL family as .npz")
    vertices = np.asarray(arrays["v_template"], float)
    if betas is not None and "shapedirs" in arrays:
        n = min(len(betas), arrays["shapedirs"].shape[-1])
        vertices = vertices + arrays["shapedirs"][..., :n] @ betas[:n]
    try:
        joints = arrays["J_regressor"] @ vertices
        parents = arrays["kintree_table"][0].astype(np.int64)
        offsets = joints - np.where(parents[:, None] < len(joints), joints[np.clip(parents, 0, len(joints) - 1)], 0)
    except (ValueError, IndexError) as error:
        raise RecordingError(path, f"the body model does not fit together ({error})", "a whole model") from None
    offsets[0] = 0
    return offsets if len(offsets) >= 22 else None
