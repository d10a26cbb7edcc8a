"""Corrections of the recordings: toes and wrists bend on the floor, feet stay, nothing goes below the floor."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.ndimage import gaussian_filter1d

from core.editing.contacts import foot_contacts
from core.editing.legs import lift_from_floor, lock_feet
from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics

_UPRIGHT = 0.22  # body heights: feet are locked only while the pelvis is higher than this
_UP = np.array([0.0, 1, 0])


def settle(clip: Clip) -> Clip:
    """The clip as a person on a floor at height 0 would move; its path starts at the origin."""
    clip = bend_wrists(bend_toes(clip))
    upright = clip.root_positions[:, 1] > _UPRIGHT * find_anatomy(clip.skeleton).body_height
    contacts = foot_contacts(clip, 0.0) & upright[:, None]
    clip = lift_from_floor(lock_feet(clip, contacts, 0.0), 0.0)
    return replace(clip, root_positions=clip.root_positions - clip.root_positions[0] * np.array([1, 0, 1], np.float32))


def bend_toes(clip: Clip) -> Clip:
    """The toes stay flat on the floor while the heel rises: the source's feet are stiff."""
    rotations = np.array(clip.rotations)
    positions, world = forward_kinematics(clip)
    for side in ("Left", "Right"):
        ball, tip = (clip.skeleton.index(f"{side}ToeBase{end}") for end in ("", "_end"))
        ahead = quat.rotate(world[:, ball], np.array([0, 0, 1], np.float32))
        steep = np.arcsin(np.clip(-ahead[:, 1], -1, 1))
        near = np.clip((0.12 - positions[:, [ball, tip], 1].min(1)) / 0.08, 0, 1)
        angle = np.clip(steep, 0, np.radians(50)) * near * near * (3 - 2 * near)
        rotations[:, ball] = quat.from_rotvec(-angle[:, None] * np.array([1, 0, 0], np.float32))
    return replace(clip, rotations=rotations)


def bend_wrists(clip: Clip, clearance: float = 0.01) -> Clip:
    """Hands that would reach into the floor bend up at the wrist, fingers pointing where the body faces.

    clearance: metres between finger tips and floor.
    """
    rotations = np.array(clip.rotations, np.float64)
    positions, world = (a.astype(np.float64) for a in forward_kinematics(clip))
    facing = quat.rotate(world[:, clip.skeleton.index("Chest")], np.array([0.0, 0, 1])) * [1, 0, 1]
    for side in ("Left", "Right"):
        forearm, hand, tip = (clip.skeleton.index(side + j) for j in ("ForeArm", "Hand", "Hand_end"))
        fingers = positions[:, tip] - positions[:, hand]
        length = np.linalg.norm(fingers[0])
        now = fingers / length
        lowest = np.clip((clearance - positions[:, hand, 1]) / length, -1, 0.5)
        if not (now[:, 1] < lowest).any():
            continue
        level = now * [1, 0, 1]
        flat = np.linalg.norm(level, axis=1, keepdims=True)
        # straight down points nowhere on the floor: there the body's facing decides
        level = quat.normalise(level + facing * np.maximum(0, 1 - flat / 0.4) + 1e-9)
        wanted = level * np.sqrt(1 - lowest**2)[:, None] + _UP * lowest[:, None]
        axis = np.cross(now, wanted)
        sine = np.linalg.norm(axis, axis=1, keepdims=True)
        angle = np.arctan2(sine, (now * wanted).sum(1, keepdims=True)) * (now[:, 1] < lowest)[:, None]
        turn = gaussian_filter1d(axis / np.maximum(sine, 1e-9) * angle, 3, axis=0, mode="nearest")
        bent = quat.multiply(quat.from_rotvec(turn), world[:, hand])
        rotations[:, hand] = quat.multiply(quat.conjugate(world[:, forearm]), bent)
    return replace(clip, rotations=quat.normalise(rotations).astype(np.float32))
