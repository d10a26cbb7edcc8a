"""Steps: a cross-fade between two stances moves the feet by steps, one after the other, instead of sliding them."""

from __future__ import annotations

import numpy as np

from core.editing.contacts import foot_contacts
from core.editing.legs import place_ankles, smooth_step
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions

_FAR = 0.03  # body heights: a foot that the two stances put closer than this does not step
_RISE, _HIGHEST = 0.25, 0.07  # height of a step as a share of its length, and at most, in body heights
_OVERLAP = 0.1  # share of the cross-fade during which both feet may be on their way


def step_across(a: Clip, b: Clip, seam: Clip, floor: float | None = None) -> Clip:
    """The cross-fade ``seam`` of ``a`` and ``b`` (same frames) in which feet step from one stance to the other.

    A foot that stands in both motions, in places apart, is lifted over: the foot with the longer way first. Other feet
    are left to the cross-fade. floor: metres, or None to estimate it.
    """
    ankles = [ankle for ankle, _ in find_anatomy(seam.skeleton).feet]
    if len(ankles) != 2:
        return seam
    body = find_anatomy(seam.skeleton).body_height
    positions = [joint_positions(clip) for clip in (a, b)]
    stands = [foot_contacts(c, floor, p).mean(0) > 0.8 for c, p in zip((a, b), positions, strict=True)]
    paths = [p[:, ankles].astype(np.float64) for p in positions]
    way = np.linalg.norm((paths[1] - paths[0])[..., [0, 2]].mean(0), axis=1)
    feet = [int(f) for f in np.argsort(-way, kind="stable") if stands[0][f] and stands[1][f] and way[f] > _FAR * body]
    if not feet:
        return seam
    targets = np.full((seam.n_frames, 2, 3), np.nan)
    u = np.arange(1, seam.n_frames + 1) / (seam.n_frames + 1)
    share = 1.0 if len(feet) == 1 else 0.5 + _OVERLAP / 2
    for order, foot in enumerate(feet):
        begin = 0.0 if order == 0 else 1 - share
        w = smooth_step((u - begin) / share)[:, None]
        targets[:, foot] = paths[0][:, foot] * (1 - w) + paths[1][:, foot] * w
        targets[:, foot, 1] += min(_RISE * way[foot], _HIGHEST * body) * 16 * (w * (1 - w))[:, 0] ** 2
    return place_ankles(seam, targets)
