"""Paces, drawn paths, new clips and layers against what is slow but obvious."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.demo import make_demo
from core.mocap import quaternions as quat
from core.mocap.clip import Segment
from core.motion_map import layers
from core.motion_map.assign import assign_clips
from core.motion_map.build import MapParameters, build_motion_map
from core.motion_map.key_poses import Pace, Runs, runs_of, search_keys
from core.motion_map.path_queries import CAP, FARTHEST, even_steps, follow, search_path
from core.poses.postures import postures_of


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=1.0)


@pytest.fixture(scope="module")
def motion_map(demo):
    return build_motion_map(demo, MapParameters(grid="10x12", samples=600))


def test_velocities_are_those_of_the_root_seen_by_the_body(demo):
    postures = postures_of(demo)
    clip = demo.clip(postures.clips[0])
    turned = replace(clip, root_positions=clip.root_positions.copy(), rotations=clip.rotations.copy())
    half_turn = quat.from_yaw(np.array(2.1))
    turned.root_positions[:] = quat.rotate(half_turn, np.asarray(clip.root_positions, float))
    turned.rotations[:, 0] = quat.multiply(half_turn, np.asarray(clip.rotations[:, 0], float))
    again = postures_of(replace(demo, clips=(turned,), labels=()))
    n = len(again.velocity)
    np.testing.assert_allclose(again.velocity, postures.velocity[:n], atol=2e-3)
    step = round(clip.fps / postures.fps)
    travelled = np.linalg.norm(np.diff(np.asarray(clip.root_positions, float)[::step][:n, [0, 2]], axis=0), axis=1)
    speeds = np.linalg.norm(postures.velocity[:n], axis=1)
    assert np.corrcoef(travelled * postures.fps, speeds[1:])[0, 1] > 0.95


def test_people_mostly_walk_where_they_look(demo):
    walking = np.concatenate(
        [
            postures_of(demo.select([label.clip])).velocity[label.start // 2 : label.end // 2]
            for label in demo.labels
            if label.action == "walk"
        ]
    )
    assert (walking[:, 0] > np.abs(walking[:, 1])).mean() > 0.9


def some_runs(seed: int, n: int = 200) -> Runs:
    rng = np.random.default_rng(seed)
    return runs_of(rng.integers(0, 6, n), np.zeros(n), np.array([0, n // 3, n]), rng.normal(size=(n, 2)))


@settings(max_examples=30)
@given(
    st.integers(0, 1000),
    st.floats(0, 1),
    st.floats(0, 2),
    st.sampled_from(["any", "forward", "backward", "left", "right"]),
)
def test_a_pace_leaves_out_runs_that_travel_otherwise(seed, slowest, more, way):
    runs = some_runs(seed)
    pace = Pace(slowest, slowest + more, way)
    ahead, aside = runs.ahead, runs.aside
    directions = {"forward": (1, 0), "backward": (-1, 0), "left": (0, 1), "right": (0, -1)}
    wanted = []
    for k in range(len(runs.node)):
        speed = float(np.hypot(ahead[k], aside[k]))
        fits = slowest <= speed <= slowest + more
        if way != "any":
            a, b = directions[way]
            fits = fits and speed > 0 and (a * ahead[k] + b * aside[k]) / speed >= np.cos(np.pi / 4) - 1e-12
        wanted.append(fits)
    np.testing.assert_array_equal(pace.allows(runs), wanted)
    key = (np.array([2]), np.zeros(1))
    hits = search_keys(runs, [key], pace)
    assert len(hits) == sum(fits and node == 2 for fits, node in zip(wanted, runs.node, strict=True))


def test_paces_that_are_none():
    for bad in ((2.0, 1.0, "any"), (-1.0, 1.0, "any"), (0.0, 1.0, "up")):
        with pytest.raises(ValueError, match="pace"):
            Pace(*bad)


def brute_warp(nodes, path):
    """All of the path onto a stretch that ends at each node: best over every beginning, by the textbook recursion."""
    n, m = len(nodes), len(path)
    best = np.full(n, np.inf)
    for begin in range(n):
        table = np.full((m, n), np.inf)
        for i in range(m):
            for j in range(begin, n):
                cost = min(float(np.linalg.norm(nodes[j] - path[i])), CAP)
                if i == 0:
                    before = 0.0 if j == begin else np.inf
                else:
                    before = min(
                        table[i - 1, j],
                        table[i - 1, j - 1] if j > begin else np.inf,
                        table[i, j - 1] if j > begin else np.inf,
                    )
                table[i, j] = cost + before
        best = np.minimum(best, table[m - 1])
    return best


@settings(max_examples=25)
@given(st.integers(0, 10_000), st.integers(1, 14), st.integers(2, 7))
def test_a_path_is_warped_as_the_textbook_says(seed, n, m):
    from core.motion_map.path_queries import _warped

    rng = np.random.default_rng(seed)
    nodes, path = rng.integers(0, 6, (n, 2)).astype(float), rng.uniform(0, 6, (m, 2))
    cost, first = _warped(nodes, path)
    np.testing.assert_allclose(cost, brute_warp(nodes, path))
    assert (first <= np.arange(n)).all()


def test_the_way_of_a_clip_finds_that_clip(motion_map):
    nodes = motion_map.nodes_of(motion_map.clips[1])[30:90]
    found = search_path(motion_map, nodes)
    segment, hit = found[0]
    assert segment.clip == motion_map.clips[1] and hit.distance < 1
    assert hit.start < 90 and hit.end > 30
    assert all(h.distance <= FARTHEST for _, h in found)
    assert [h.distance for _, h in found] == sorted(h.distance for _, h in found)
    assert follow(runs_of(np.zeros(0, int), np.zeros(0), np.array([0])), 5, even_steps([[0, 0], [3, 3]])) == []


def test_paths_that_are_none():
    assert len(even_steps([[0, 0], [0, 4]])) == 5
    for bad in ([[1, 1]], [], [[0, 0], [np.nan, 1]], [[0, 1, 2], [1, 2, 3]]):
        with pytest.raises(ValueError, match="two"):
            even_steps(bad)
    with pytest.raises(ValueError, match="near"):
        even_steps([[1e300, 1], [1, 1e300]])


def test_new_clips_lie_where_they_would_have_been_and_strange_ones_far_off(demo, motion_map):
    again = assign_clips(motion_map, demo)
    for name in Runs._fields:
        np.testing.assert_allclose(getattr(again.runs, name), getattr(motion_map.runs, name), atol=1e-5)
    assert 0.5 < np.median(again.fits) < 2
    clip = demo.clips[0]
    bent = quat.multiply(np.asarray(clip.rotations, float), quat.from_rotvec(np.array([1.2, 0.4, 0.8])))
    strange = replace(clip, name="strange", rotations=bent.astype(np.float32))
    more = assign_clips(motion_map, replace(demo, clips=(*demo.clips, strange)))
    assert more.weights is motion_map.weights and more.clips[-1] == "strange"
    assert more.fits[-1] > 2 > more.fits[0]
    key = tuple(more.nodes_of("strange")[10])
    assert any(segment.clip == "strange" for segment, _ in more.search([key]))
    with pytest.raises(ValueError, match="no clips"):
        assign_clips(motion_map, replace(demo, clips=(), labels=()))


def test_a_map_with_a_model_keeps_its_postures(demo, motion_map):
    laid = build_motion_map(demo, MapParameters(model="0123456789abcdef"), model=motion_map)
    assert laid.weights is motion_map.weights and laid.parameters["model"] == "0123456789abcdef"
    with pytest.raises(ValueError, match="key"):
        MapParameters(model="../x")


def test_layers_count_what_lies_where(demo, motion_map):
    groups = [[Segment(clip.name, 0, clip.n_frames)] for clip in demo.clips]
    np.testing.assert_allclose(layers.seconds_on_nodes(motion_map, groups).sum(axis=0), motion_map.density, atol=1e-9)
    by_name = {clip.name: k for k, clip in enumerate(demo.clips)}
    per_clip = layers.seconds_of_clips(motion_map)
    for k, name in enumerate(motion_map.clips):
        np.testing.assert_allclose(per_clip[k], layers.seconds_on_nodes(motion_map, groups)[by_name[name]])
    clip = motion_map.clips[0]
    scale = demo.clip(clip).fps / motion_map.fps
    some = [Segment(clip, round(10 * scale), round(40 * scale)), Segment(clip, round(30 * scale), round(60 * scale))]
    wanted = np.zeros(motion_map.grid)
    for x, y in motion_map.nodes_of(clip)[10:60]:
        wanted[x, y] += 1 / motion_map.fps
    np.testing.assert_allclose(layers.seconds_on_nodes(motion_map, [some, [Segment("nobody", 0, 5)]])[0], wanted)
    lead = layers.leading(per_clip)
    assert ((lead < 0) == (motion_map.density == 0)).all()
    x, y = np.argwhere(motion_map.density > 0)[0]
    assert per_clip[lead[x, y], x, y] == per_clip[:, x, y].max()
    speeds = layers.mean_speed(motion_map)
    assert (np.isnan(speeds) == (motion_map.density == 0)).all() and np.nanmax(speeds) < 8


def test_what_passes_a_region(demo, motion_map):
    segments = {3: [Segment(clip.name, 20, 90) for clip in demo.clips], 5: [Segment("nobody", 0, 9)]}
    nodes = motion_map.regions == motion_map.regions[tuple(motion_map.nodes_of(motion_map.clips[0])[15])]
    wanted = [
        k for k, s in enumerate(segments[3]) if layers.seconds_on_nodes(motion_map, [[s]])[0][nodes].sum() > 0
    ]  # fmt: skip
    assert layers.passing(motion_map, nodes, segments) == ({3: wanted} if wanted else {})
