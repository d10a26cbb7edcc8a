"""The body in parts."""

from __future__ import annotations

import math

import pytest

from core.demo import make_demo
from core.mocap.anatomy import find_anatomy
from core.poses.body_parts import (
    CHILDREN,
    LEAVES,
    LEVEL,
    NODES,
    PARENT,
    PRESETS,
    leaves_of,
    normalise_weights,
    part_joints,
)


def test_the_hierarchy_is_the_papers():
    assert len(NODES) == 18 and len(LEAVES) == 10
    assert [sum(LEVEL[n] == level for n in NODES) for level in (1, 2, 3, 4)] == [1, 2, 5, 10]
    assert all(LEVEL[child] > LEVEL[node] for node in NODES for child in CHILDREN[node])
    assert all(PARENT[child] == node for node in NODES for child in CHILDREN[node])
    assert NODES.index("whole_body") == 0 and leaves_of("whole_body") == LEAVES
    assert set(leaves_of("upper_body")) | set(leaves_of("lower_body")) == set(LEAVES)


def test_every_posture_joint_belongs_to_one_leaf():
    anatomy = find_anatomy(make_demo(minutes=0.5).clips[0].skeleton)
    parts = part_joints(anatomy)
    assert sorted(joint for joints in parts.values() for joint in joints) == sorted(anatomy.posture_joints)
    assert anatomy.joints["left_elbow"] in parts["left_arm"] and anatomy.joints["right_knee"] in parts["right_leg"]


def test_weights_sum_to_one_as_in_the_papers_example():
    found = normalise_weights({"left_arm": 35, "right_arm": 45, "lower_body": 20})
    assert found["left_arm"] == pytest.approx(0.35) and found["left_leg"] == pytest.approx(0.05)
    assert found["head"] == 0 and sum(found.values()) == pytest.approx(1)
    assert all(sum(weights.values()) == pytest.approx(1) for weights in PRESETS.values())


@pytest.mark.parametrize(
    ("weights", "words"),
    [
        ({"tail": 1}, "no part of the body"),
        ({"head": -1}, "positive number"),
        ({"head": math.nan}, "positive number"),
        ({"head": 0}, "all weights are zero"),
        ({}, "all weights are zero"),
    ],
)
def test_weights_that_mean_nothing_are_refused(weights, words):
    with pytest.raises(ValueError, match=words):
        normalise_weights(weights)
