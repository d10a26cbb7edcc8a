"""The whole map of recordings."""

from __future__ import annotations

import itertools
import json

import numpy as np
import pytest

from core.demo import make_demo
from core.motion_map.build import MapParameters, build_motion_map, parse_grid
from core.motion_map.motion_map import unpack
from core.poses.postures import postures_of


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=1.0)


@pytest.fixture(scope="module")
def motion_map(demo):
    return build_motion_map(demo, MapParameters(grid="12x10", samples=800))


def test_every_frame_lies_on_its_nearest_node(demo, motion_map):
    postures = postures_of(demo)
    models = motion_map.weights.reshape(120, -1)
    rng = np.random.default_rng(0)
    nodes = np.concatenate([motion_map.nodes_of(clip) for clip in motion_map.clips])
    for k in rng.choice(len(postures.values), 50):
        best = np.argmin(((models - postures.vectors[k]) ** 2).sum(axis=1))
        assert tuple(nodes[k]) == divmod(int(best), 10)


def test_runs_cover_every_clip_once(motion_map):
    document = motion_map.to_json()
    json.dumps(document, allow_nan=False)
    assert document["grid"] == [12, 10]
    for clip in document["clips"]:
        runs = [(run["start"], run["end"]) for run in document["runs"] if run["clip"] == clip["name"]]
        assert runs[0][0] == 0 and runs[-1][1] == clip["frames"]
        assert all(before[1] == after[0] for before, after in itertools.pairwise(runs))
    assert sorted(tuple(node) for region in document["regions"] for node in region["nodes"]) == sorted(
        (i, j) for i in range(12) for j in range(10)
    )


def test_keys_of_a_known_stretch_find_it(demo, motion_map):
    clip = motion_map.clips[0]
    nodes = motion_map.nodes_of(clip)
    keys = [tuple(nodes[60]), tuple(nodes[100])]
    hits = motion_map.search(keys)
    assert any(segment.clip == clip for segment, _ in hits)
    wider = motion_map.search(keys, 0.3)
    assert len(wider) >= len(hits)


def test_a_trajectory_follows_the_nodes(demo, motion_map):
    clip = demo.clip(motion_map.clips[0])
    path = motion_map.trajectory(clip, 4)
    nodes = motion_map.nodes_of(clip.name)
    step = round(clip.fps / motion_map.fps)
    apart = np.linalg.norm(path[::step][: len(nodes)] - nodes, axis=1)
    assert np.median(apart) < 1.0


def test_a_clip_it_knows_fits_and_a_strange_one_does_not(demo, motion_map):
    clip = demo.clips[0]
    assert 0.5 < motion_map.fit(clip).ratio < 1.5
    from dataclasses import replace

    from core.mocap import quaternions as quat

    bent = quat.multiply(np.asarray(clip.rotations, float), quat.from_rotvec(np.array([1.2, 0.4, 0.8])))
    assert motion_map.fit(replace(clip, rotations=bent.astype(np.float32))).ratio > 2


def test_it_reads_back_and_is_the_same_again(demo, motion_map):
    document, arrays = motion_map.pack()
    back = unpack(json.loads(json.dumps(document)), arrays)
    assert back.to_json() == motion_map.to_json()
    again = build_motion_map(demo, MapParameters(grid="12x10", samples=800))
    np.testing.assert_array_equal(again.weights, motion_map.weights)
    with pytest.raises(ValueError, match="format"):
        unpack({"format": "x"}, {})


def test_icons_have_bones_of_real_length(motion_map):
    from core.motion_map.bones import bone_vectors

    lengths = np.linalg.norm(bone_vectors(motion_map.postures, motion_map.parents), axis=-1)
    np.testing.assert_allclose(lengths, np.broadcast_to(motion_map.lengths, lengths.shape), rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("text", ["21", "1x5", "5x1000", "ax b", ""])
def test_grids_that_are_none(text):
    with pytest.raises(ValueError, match="21x21"):
        parse_grid(text)
