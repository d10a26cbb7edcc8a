"""Samples, regions, key poses and bones against what is slow but obvious."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.ndimage import label

from core.motion_map.bones import bone_lengths, bone_vectors, rebuild, refine, with_real_bones
from core.motion_map.build import MapParameters
from core.motion_map.key_poses import key_nodes, runs_of, search_keys
from core.motion_map.regions import borders, find_regions, region_icons
from core.motion_map.samples import reduce_samples, threshold_for
from core.motion_map.som import batch_som, u_matrix


def brute_reduction(postures, threshold):
    kept = []
    for i, posture in enumerate(postures):
        if all(np.sqrt(((posture - postures[k]) ** 2).sum()) > threshold for k in kept):
            kept.append(i)
    return kept


@settings(max_examples=30)
@given(st.integers(0, 10**6), st.integers(1, 120), st.integers(1, 7), st.floats(0.05, 3.0))
def test_reduction_is_the_papers_rule(seed, n, d, threshold):
    postures = np.random.default_rng(seed).normal(size=(n, d)).astype(np.float32).cumsum(axis=0) / 3
    assert list(reduce_samples(postures, threshold)) == brute_reduction(postures, threshold)


def test_a_threshold_for_about_so_many():
    postures = np.random.default_rng(0).normal(size=(3000, 5)).astype(np.float32)
    kept = len(reduce_samples(postures, threshold_for(postures, 300)))
    assert 200 <= kept <= 300
    assert threshold_for(postures[:100], 300) == 0 and len(reduce_samples(postures[:100], 0)) == 100
    with pytest.raises(ValueError, match="negative"):
        reduce_samples(postures, -1)


def flood(weights):
    """Regions by hand: flood fill over nodes that are no ridge, then the nearest border node joins, again and again."""
    heights = u_matrix(weights)
    nx, ny = heights.shape
    border = np.zeros((nx, ny), bool)
    for i in range(nx):
        for j in range(ny):
            for a, b in ((1, 0), (0, 1), (1, 1), (1, -1)):
                ends = [(i - a, j - b), (i + a, j + b)]
                if all(0 <= u < nx and 0 <= v < ny for u, v in ends):
                    border[i, j] |= all(heights[i, j] > heights[end] for end in ends)
    regions, n = np.full((nx, ny), -1), 0
    for i in range(nx):
        for j in range(ny):
            if border[i, j] or regions[i, j] >= 0:
                continue
            stack = [(i, j)]
            while stack:
                u, v = stack.pop()
                if 0 <= u < nx and 0 <= v < ny and not border[u, v] and regions[u, v] < 0:
                    regions[u, v] = n
                    stack += [(u + 1, v), (u - 1, v), (u, v + 1), (u, v - 1)]
            n += 1
    while (regions < 0).any() and n:
        pairs = [
            (np.linalg.norm(weights[i, j] - weights[u, v]), i, j, u, v)
            for i, j in np.argwhere(regions < 0)
            for u, v in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1))
            if 0 <= u < nx and 0 <= v < ny and regions[u, v] >= 0
        ]
        _, i, j, u, v = min(pairs)
        regions[i, j] = regions[u, v]
    return border, regions


@settings(max_examples=25)
@given(st.integers(0, 10**6), st.integers(2, 9), st.integers(2, 9))
def test_regions_are_those_of_a_flood(seed, nx, ny):
    weights = np.random.default_rng(seed).normal(size=(nx, ny, 3)).astype(np.float32)
    border, wanted = flood(weights)
    np.testing.assert_array_equal(borders(u_matrix(weights)), border)
    found = find_regions(weights)
    groups = {frozenset(map(tuple, np.argwhere(found == k))) for k in range(found.max() + 1)}
    assert groups == {frozenset(map(tuple, np.argwhere(wanted == k))) for k in range(wanted.max() + 1)}
    icons = region_icons(found)
    assert [found[tuple(icon)] for icon in icons] == list(range(found.max() + 1))


def brute_search(nodes, clip_starts, keys):
    """All chains of runs that pass the keys as the paper's steps say, then the shortest of those with the same end."""
    runs = []
    for c, (low, high) in enumerate(itertools.pairwise(clip_starts)):
        start = low
        for k in range(low, high):
            if k + 1 == high or nodes[k + 1] != nodes[k]:
                runs.append((c, start - low, k + 1 - low, nodes[k]))
                start = k + 1
    found = {}
    for c, start, end, node in runs:
        if node not in keys[0]:
            continue
        reached, total = end, keys[0][node]
        for key in keys[1:]:
            later = [r for r in runs if r[0] == c and r[1] >= reached and r[3] in key]
            if not later:
                break
            best = min(later, key=lambda r: r[2])
            reached, total = best[2], total + key[best[3]]
        else:
            if (c, reached) not in found or start > found[c, reached][0]:
                found[c, reached] = (start, total)
    return sorted((round(total, 6), c, start, end) for (c, end), (start, total) in found.items())


@settings(max_examples=60)
@given(st.data())
def test_key_poses_are_found_as_by_hand(data):
    clips = data.draw(st.lists(st.lists(st.integers(0, 5), min_size=1, max_size=25), min_size=1, max_size=4))
    keys = data.draw(
        st.lists(
            st.dictionaries(st.integers(0, 5), st.sampled_from([0.0, 0.5, 1.25]), min_size=1, max_size=3),
            min_size=1, max_size=3,
        )
    )  # fmt: skip
    nodes = np.array([node for clip in clips for node in clip])
    starts = np.concatenate([[0], np.cumsum([len(clip) for clip in clips])])
    runs = runs_of(nodes, np.zeros(len(nodes)), starts)
    asked = [(np.array(sorted(key)), np.array([key[node] for node in sorted(key)])) for key in keys]
    found = search_keys(runs, asked)
    assert sorted((round(h.distance, 6), h.clip, h.start, h.end) for h in found) == brute_search(nodes, starts, keys)
    ranked = [(round(h.distance, 9), h.end - h.start) for h in found]
    assert ranked == sorted(ranked)


def test_no_keys_no_hits_and_a_key_grows_with_the_threshold():
    assert search_keys(runs_of(np.array([0, 1]), np.zeros(2), np.array([0, 2])), []) == []
    weights = np.arange(6, dtype=np.float32).reshape(2, 3, 1)
    assert list(key_nodes(weights, (0, 1), 0.0)[0]) == [1]
    nodes, apart = key_nodes(weights, (0, 1), 1.5)
    assert list(nodes) == [0, 1, 2] and list(apart) == [1, 0, 1]


PARENTS = (-1, 0, 1, 0)


def test_bones_keep_their_lengths():
    rng = np.random.default_rng(0)
    postures = rng.normal(size=(50, 4, 3))
    lengths = np.array([0.3, 0.5, 0.2, 0.4])
    real = with_real_bones(postures, PARENTS, lengths)
    np.testing.assert_allclose(np.linalg.norm(bone_vectors(real, PARENTS), axis=-1), np.tile(lengths, (50, 1)))
    np.testing.assert_allclose(bone_lengths(real, PARENTS), lengths)
    np.testing.assert_allclose(rebuild(bone_vectors(real, PARENTS), PARENTS, lengths), real)


def test_virtual_nodes_lie_on_the_great_circle():
    weights = np.zeros((2, 2, 1, 3))
    weights[0, :, 0], weights[1, :, 0] = [1, 0, 0], [0, 1, 0]
    fine = refine(weights, (-1,), np.array([2.0]), 2)
    assert fine.shape == (3, 3, 1, 3)
    np.testing.assert_allclose(fine[1, 1, 0], [2**0.5, 2**0.5, 0], atol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(fine, axis=-1), 2, atol=1e-6)


def held_postures(n, seed=0):
    """Model vectors of a map of ``n`` postures, each held with a little tremor."""
    rng = np.random.default_rng(seed)
    centres = rng.normal(size=(n, 12))
    samples = centres[rng.integers(n, size=600)] + rng.normal(size=(600, 12)) * 0.02
    return batch_som(samples.astype(np.float32), (21, 21), epochs=24, sigma=(10.5, 0.7), seed=seed)


@pytest.mark.parametrize("seed", range(3))
def test_two_held_postures_are_two_regions(seed):
    weights = held_postures(2, seed)
    assert find_regions(weights, MapParameters().ridge).max() + 1 == 2
    assert find_regions(weights).max() + 1 > 10  # what the paper's rule makes of the tremor


def test_a_pass_must_be_so_much_higher_than_the_shallower_bottom():
    line = np.array([0, 1, 2, 5, 6, 7, 8.5, 9.5, 10.5, 20, 21, 22.0])[:, None, None]  # gaps of 3, 1.5 and 9.5
    counts = [int(find_regions(line, ridge).max()) + 1 for ridge in (0.01, 0.3, 1.0, 5.0)]
    assert counts == sorted(counts, reverse=True) and counts[0] == 4 and counts[-1] == 1
    with pytest.raises(ValueError, match="ridge"):
        find_regions(line, -1)


@settings(max_examples=30)
@given(st.integers(0, 10**6), st.integers(2, 9), st.integers(2, 9), st.floats(0.01, 2))
@example(3348, 5, 7, 0.25)  # a shallow basin touched the deepest only through a node of a third
def test_basins_are_in_one_piece_and_cover_the_map(seed, nx, ny, ridge):
    weights = np.random.default_rng(seed).normal(size=(nx, ny, 3))
    regions = find_regions(weights, ridge)
    assert regions.shape == (nx, ny) and set(np.unique(regions)) == set(range(regions.max() + 1))
    for region in range(regions.max() + 1):
        assert label(regions == region)[1] == 1
