"""Pieces grouped into actions: Ward's method against scipy's, features of mirror images, the number of groups."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.optimize import linear_sum_assignment

from core.demo import make_demo
from core.evaluation.segmentation import frame_accuracy
from core.grammar.grouping import choose_groups, describe, nearest_groups, pieces_of, ward
from core.grammar.identification import find_terminals
from core.grammar.objective import Clustering
from core.grammar.parameters import TerminalParameters
from core.grammar.pose_space import PoseSpace
from core.grammar.terminals import from_json


def same(a, b):
    """Whether two labellings are the same but for the numbers of the groups."""
    table = np.zeros((a.max() + 1, b.max() + 1), int)
    np.add.at(table, (a, b), 1)
    rows, columns = linear_sum_assignment(-table)
    return table[rows, columns].sum() == len(a) and a.max() == b.max()


def space_with(values, mirrored=None, starts=None):
    n = len(values)
    starts = np.array([0, n]) if starts is None else np.array(starts)
    clips = tuple(f"c{i}" for i in range(len(starts) - 1))
    rates = (15.0,) * len(clips)
    return PoseSpace(values, mirrored, starts, clips, rates, tuple(np.diff(starts).tolist()), 15.0, 1.0)


def clustering(spans, labels):
    spans, labels = np.array(spans), np.array(labels)
    medoids = np.array([int(np.flatnonzero(labels == k)[0]) for k in range(labels.max() + 1)])
    return Clustering(spans, medoids, labels, np.zeros(len(spans)))


@pytest.mark.parametrize("seed", range(4))
def test_ward_is_that_of_scipy_where_all_weigh_the_same(seed):
    x = np.random.default_rng(seed).normal(size=(40, 3))
    tree, levels = linkage(x, "ward"), ward(x, np.ones(40), 40)
    assert len(levels) == 40
    for k, level in enumerate(levels, 1):
        assert same(level, fcluster(tree, k, "maxclust") - 1)


def test_a_weight_counts_like_so_many_copies():
    rng = np.random.default_rng(0)
    x, copies = rng.normal(size=(15, 2)), rng.integers(1, 4, 15)
    many = ward(np.repeat(x, copies, axis=0), np.ones(copies.sum()), 10)
    few = ward(x, copies.astype(float), 10)
    firsts = np.append(0, np.cumsum(copies)[:-1])
    assert all(same(a, b[firsts]) for a, b in zip(few, many, strict=True))


def test_a_span_and_its_mirror_image_have_the_same_features():
    rng = np.random.default_rng(1)
    x, y = rng.normal(size=(2, 30, 4)).astype(np.float32)
    spans = np.array([[0, 12], [12, 30]])
    here, there = space_with(x, y), space_with(y, x)
    np.testing.assert_allclose(describe(here, spans), describe(there, spans), atol=1e-6)
    assert np.abs(describe(space_with(x), spans) - describe(space_with(y), spans)).max() > 0.1


def test_pieces_join_neighbours_of_one_terminal_within_a_clip():
    space = space_with(np.random.default_rng(0).normal(size=(40, 2)).astype(np.float32), starts=[0, 20, 40])
    pieces = pieces_of(space, clustering([[0, 5], [5, 10], [10, 20], [20, 30], [30, 40]], [0, 0, 1, 1, 0]))
    assert pieces.spans.tolist() == [[0, 10], [10, 20], [20, 30], [30, 40]]
    assert pieces.of_span.tolist() == [0, 0, 1, 2, 3]


def made_up(actions, seed=0):
    """A space in which each stretch of 30 poses swings about the posture of its action, and two searches of it."""
    rng = np.random.default_rng(seed)
    centres = rng.normal(size=(actions, 6)) * 2
    order = np.concatenate([rng.permutation(actions) for _ in range(6)])
    swing = np.sin(np.arange(30) / 2)[:, None] * 0.3
    values = np.concatenate([centres[a] + swing + rng.normal(size=(30, 6)) * 0.1 for a in order])
    spans = [[30 * i, 30 * i + 30] for i in range(len(order))]
    space = space_with(values.astype(np.float32))
    # every action has two terminals, as two people might give it
    return space, order, clustering(spans, order * 2 + np.arange(len(order)) // actions % 2)


@pytest.mark.parametrize("actions", [3, 5, 8])
def test_the_number_of_groups_is_found(actions):
    space, order, found = made_up(actions)
    choice = choose_groups(space, [found, found])
    assert min(choice.description, key=choice.description.get) == actions
    assert same(choice.labels, order)
    with pytest.raises(ValueError, match="searches"):
        choose_groups(space, [])


def test_spans_of_a_longer_recording_join_the_nearest_group():
    space, order, found = made_up(5)
    choice = choose_groups(space, [found])
    assert same(nearest_groups(space, found, space, found, choice.labels), order)


def test_actions_of_the_demo_without_a_number():
    demo = make_demo(3, seed=7)
    found = find_terminals(demo, TerminalParameters())
    actions = len({label.action for label in demo.labels})
    assert actions / 2 <= found.n_terminals <= 2 * actions
    assert frame_accuracy(found.segments, demo.labels).one_to_one > 0.6
    assert min(found.description, key=found.description.get) == found.n_terminals
    assert from_json(found.to_json()).description.keys() == found.description.keys()
    again = find_terminals(replace(demo, clips=demo.clips[::-1]), TerminalParameters())
    assert again.segments == found.segments
