"""Plans: the smoothest choice of links against all choices, and pieces that pass into one another."""

from __future__ import annotations

from itertools import pairwise, product

import numpy as np
import pytest

from core.synthesis.links import SEEN, bridge_links, motion_features, seen_links
from core.synthesis.paths import Random, open_ways, random_path
from core.synthesis.planning import lay_out, smoothest
from tests.core.synthesis.recordings import demo, string_graph


def test_the_smoothest_links_against_every_combination() -> None:
    dataset, graph = demo()
    motifs = {motif.id: motif for motif in graph.motifs}
    links = seen_links(graph)
    ways = open_ways(dataset, graph)
    apart = {m.id: motion_features(dataset, m) for m in graph.motifs}
    tried = 0
    for seed in range(30):
        path = random_path(dataset, ways, Random(3, seed))[0][:5]
        if any(pair not in links for pair in pairwise(path)):
            continue
        choices = [links[pair] for pair in pairwise(path)]
        if not 1 < np.prod([len(c) for c in choices]) < 3000:
            continue

        def cost(chosen) -> float:
            between = [apart[a.target][a.enter] - apart[a.target][b.leave] for a, b in pairwise(chosen)]
            return sum(float(np.linalg.norm(d.astype(float), axis=1).mean()) for d in between)

        best = min(cost(chosen) for chosen in product(*choices))
        assert cost(smoothest(dataset, motifs, choices)) == pytest.approx(best, abs=1e-5)
        tried += 1
    assert tried >= 3


def test_a_path_that_was_recorded_is_one_piece() -> None:
    dataset, graph = string_graph("abcabc", "acb")
    motifs = {motif.id: motif for motif in graph.motifs}
    links = smoothest(dataset, motifs, [seen_links(graph)[pair] for pair in ((0, 1), (1, 2), (2, 0))])
    plan = lay_out(dataset, motifs, (0, 1, 2, 0), links)
    assert plan.pieces == (("take_0", 0, 160),) and not plan.overlaps
    assert plan.visits == tuple(((0, 40 * k), (0, 40 * k + 40)) for k in range(4))


def test_inside_a_motif_the_walk_passes_from_the_motion_it_enters_to_the_one_it_leaves() -> None:
    dataset, graph = string_graph("ab", ".bc")
    motifs = {motif.id: motif for motif in graph.motifs}
    links = smoothest(dataset, motifs, [seen_links(graph)[pair] for pair in ((0, 1), (1, 2))])
    plan = lay_out(dataset, motifs, (0, 1, 2), links)
    assert [piece.clip for piece in plan.pieces] == ["take_0", "take_1"]
    rows = plan.overlaps[0].rows
    assert np.allclose(rows[0], [40, 40]) and np.allclose(rows[-1], [79, 79])  # the whole motif, frame by frame
    assert plan.visits == (((0, 0), (0, 40)), ((0, 40), (1, 80)), ((1, 80), (1, 120)))


def test_bridges_leave_the_middle_of_every_motion_alone() -> None:
    dataset, graph = demo()
    motifs = {motif.id: motif for motif in graph.motifs}
    path = [graph.motifs[k].id for k in (0, 3, 1, 4, 2)]
    choices = [bridge_links(dataset, motifs[a], motifs[b]) for a, b in pairwise(path)]
    links = smoothest(dataset, motifs, choices)
    plan = lay_out(dataset, motifs, path, links)
    assert all(link.kind != SEEN for link in links)
    for before, after, piece in zip(plan.overlaps, plan.overlaps[1:], plan.pieces[1:], strict=False):
        assert before.rows[-1, 1] <= after.rows[0, 0]
        assert piece.start <= before.rows[0, 1] and after.rows[-1, 0] < piece.end
