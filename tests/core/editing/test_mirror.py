"""Mirroring: twice gives the motion back, and bones point where their partners' reflections do, on rigs of any kind."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.editing.contacts import foot_contacts
from core.editing.mirror import mirror, partners
from core.mocap.anatomy import find_anatomy
from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions
from core.mocap.skeleton import Skeleton
from tests.core.editing.figures import action, going, rerigged, standing

REFLECT = np.array([-1, 1, 1])


def reflected(clip: Clip) -> np.ndarray:
    """Where every joint should be: its partner's place, reflected."""
    return joint_positions(clip)[:, list(partners(clip.skeleton))] * REFLECT


def bones(clip: Clip, positions: np.ndarray) -> np.ndarray:
    """Unit vectors along the bones of trunk and limbs that have a length."""
    posture = np.array(find_anatomy(clip.skeleton).posture_joints)
    long = posture[np.linalg.norm(clip.skeleton.offsets[posture], axis=1) > 0.02]
    bone = positions[:, long] - positions[:, np.array(clip.skeleton.parents)[long]]
    return bone / np.linalg.norm(bone, axis=-1, keepdims=True)


def check(clip: Clip, tolerance: float = 1e-4) -> None:
    """Bones reflected exactly, all joints where the reflection has them for equal sides, and the way back."""
    once = mirror(clip)
    assert once.skeleton == clip.skeleton and once.name == f"{clip.name} mirrored"
    assert np.abs(bones(clip, joint_positions(once)) - bones(clip, reflected(clip))).max() < 2e-3
    lengths = np.linalg.norm(clip.skeleton.offsets, axis=1)
    uneven = np.abs(lengths - lengths[list(partners(clip.skeleton))]).sum()
    assert np.abs(joint_positions(once) - reflected(clip)).max() < tolerance + uneven
    twice = mirror(once)
    assert np.abs(joint_positions(twice) - joint_positions(clip)).max() < tolerance
    alike = np.abs((twice.rotations * clip.rotations).sum(-1))[:, ~np.array(clip.skeleton.end_sites)]
    assert alike.min() > 1 - 1e-5


def test_a_walk_is_reflected_and_comes_back():
    clip = going(("walk", 2.0), turn=1.0)
    check(clip, 1e-5)
    feet = foot_contacts(mirror(clip))
    assert (feet[:, ::-1] != foot_contacts(clip)).mean() < 0.01


@settings(max_examples=5)
@given(seed=st.integers(0, 1000))
def test_any_rig_will_do(seed):
    """Turned joint frames, no two alike: the rest pose is nobody's mirror image, the motion still is."""
    check(rerigged(going(("walk", 1.5), seed=seed), seed))


def test_mirrored_numbers_stay_natural_on_a_rig_with_odd_frames():
    """A joint's mean turn is what it was in the motion itself, so that poses of the two can be compared by numbers."""
    clip = rerigged(going(("walk", 4.0)), 5)
    once = mirror(clip)
    for name in ("LeftUpLeg", "LeftLeg", "RightForeArm", "RightUpLeg"):
        joint = clip.skeleton.index(name)
        a, b = (
            np.linalg.eigh(np.einsum("ni,nj->ij", c.rotations[:, joint], c.rotations[:, joint]))[1][:, -1]
            for c in (clip, once)
        )
        assert np.degrees(2 * np.arccos(min(1.0, abs(float(a @ b))))) < 15, name


def test_bones_of_uneven_sides_keep_their_lengths_and_point_as_reflected():
    clip = action("kick")
    offsets = np.array(clip.skeleton.offsets)
    offsets[clip.skeleton.index("LeftLeg")] *= 1.1
    offsets[clip.skeleton.index("RightHand")] *= 0.9
    old = clip.skeleton
    check(replace(clip, skeleton=Skeleton(old.names, old.parents, offsets, old.end_sites)))


def test_moving_joints_are_reflected_too():
    clip = standing(20)
    hand = clip.skeleton.index("LeftHand")
    track = clip.skeleton.offsets[hand] + np.outer(np.linspace(0, 0.2, 20), [1, 0.5, 0.3]).astype(np.float32)
    clip = replace(clip, translations={hand: track.astype(np.float32)})
    once = mirror(clip)
    assert list(once.translations) == [clip.skeleton.index("RightHand")]
    assert np.abs(joint_positions(once) - reflected(clip)).max() < 1e-5
    assert np.abs(mirror(once).translations[hand] - track).max() < 1e-5


def test_partners_are_found_by_anatomy_name_and_place():
    skeleton = standing(1).skeleton
    pairs = {skeleton.names[j]: skeleton.names[k] for j, k in enumerate(partners(skeleton))}
    assert pairs["LeftUpLeg"] == "RightUpLeg" and pairs["RightHand_end"] == "LeftHand_end" and pairs["Neck"] == "Neck"


def test_a_joint_without_a_partner_is_named():
    names = ("Hips", "LeftUpLeg", "LeftLeg", "LeftFoot", "Spine", "Head")
    offsets = np.array([[0, 0, 0], [0.1, 0, 0], [0, -0.4, 0], [0, -0.4, 0], [0, 0.4, 0], [0, 0.3, 0]])
    skeleton = Skeleton(names, (-1, 0, 1, 2, 0, 4), offsets)
    with pytest.raises(ValueError, match="LeftUpLeg is on the left, but there is no such joint on the right"):
        partners(skeleton)


def test_recorded_bodies(shared_data):
    """Rest poses that are standing (CMU), lying on no axis (an avatar with legs up), and no mirror image at all."""
    cmu = shared_data / "cmu"
    recordings = [
        read_amc(cmu / "asfamc/02/02_01.amc", read_asf(cmu / "asfamc/02/02.asf")),
        read_bvh(next(cmu.rglob("002_01.bvh"))),
        read_bvh(next(shared_data.rglob("*walk_normal_001.bvh"))),
    ]
    for clip in recordings:
        check(clip.cut(0, 150, clip.name))
