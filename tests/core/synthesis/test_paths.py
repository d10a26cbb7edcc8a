"""Paths: text, shortest ways against breadth-first search, random ones with a seed, dead ends, components."""

from __future__ import annotations

from collections import deque
from itertools import pairwise

import numpy as np
import pytest

from core.synthesis.paths import Between, NoWay, Random, fill_gaps, open_ways, parse_path, random_path
from tests.core.synthesis.recordings import demo, string_graph


def test_paths_in_text() -> None:
    assert parse_path("3-7-9") == (3, 7, 9) and parse_path("12") == (12,)
    assert parse_path("fewest:3:9") == Between(3, 9) and parse_path("used:3:9") == Between(3, 9, "used")
    assert parse_path("random:30:7") == Random(30, 7) and parse_path("random:2.5:0:4") == Random(2.5, 0, 4)
    for bad in ("", "3-", "3,7", "random:30", "random:x:1", "fewest:3", "3-7-9; rm", "-3"):
        with pytest.raises(ValueError, match="is no path"):
            parse_path(bad)
    with pytest.raises(ValueError, match="at most 600 seconds"):
        parse_path("random:99999:1")
    with pytest.raises(ValueError, match="at most 1000 motifs"):
        parse_path("-".join(["1"] * 1001))


def _steps(following: dict, start: int, target: int) -> int | None:
    queue, seen = deque([(start, 0)]), {start}
    while queue:
        at, steps = queue.popleft()
        if at == target:
            return steps
        queue.extend((b, steps + 1) for b in following[at] if b not in seen and not seen.add(b))
    return None


def test_the_shortest_way_has_the_fewest_steps() -> None:
    dataset, graph = demo()
    ways = open_ways(dataset, graph)
    ids = list(ways.following)
    for start in ids[::3]:
        for target in ids:
            way, steps = ways.shortest(Between(start, target)), _steps(ways.following, start, target)
            assert (way is None) == (steps is None)
            if way:
                assert len(way) - 1 == steps and way[0] == start and way[-1] == target
                assert all(pair in ways.links for pair in pairwise(way))


def test_the_most_used_way_prefers_edges_seen_often() -> None:
    dataset, graph = string_graph("acb" * 4, "abcb")  # a to b once, a to c and c to b often
    ways = open_ways(dataset, graph)
    counts = {ends: len(links) for ends, links in ways.links.items()}
    assert counts[0, 1] == 1 and counts[0, 2] == 4 and counts[2, 1] == 5
    assert ways.shortest(Between(0, 1)) == (0, 1)
    assert ways.shortest(Between(0, 1, "used")) == (0, 2, 1)


def test_dead_ends_and_components() -> None:
    dataset, graph = string_graph("ababc", "acc")
    ways = open_ways(dataset, graph)
    assert ways.dead_ends == (2,)  # c is followed by nothing but itself
    assert ways.components == ((0, 1), (2,))
    assert ways.shortest(Between(2, 0)) is None and ways.shortest(Between(2, 2)) == (2,)


def test_random_paths_follow_edges_and_their_seed() -> None:
    dataset, graph = demo()
    ways = open_ways(dataset, graph)
    found = [random_path(dataset, ways, Random(20, seed))[0] for seed in range(6)]
    assert random_path(dataset, ways, Random(20, 3))[0] == found[3] and len(set(found)) > 3
    for path in found:
        for source, target in pairwise(path):
            assert (source, target) in ways.links or source in ways.dead_ends


def test_random_steps_are_as_likely_as_they_were_seen() -> None:
    dataset, graph = string_graph("abababacab", "bacaba")
    ways = open_ways(dataset, graph)
    path = random_path(dataset, ways, Random(590, 5, start=0))[0]
    after = [b for a, b in pairwise(path) if a == 0]
    share = ways.following[0][1] / sum(ways.following[0].values())
    assert abs(np.mean([b == 1 for b in after]) - share) < 0.08 and path[0] == 0


def test_at_a_dead_end_a_random_walk_stops_or_jumps() -> None:
    dataset, graph = string_graph("abc", "abc")
    ways = open_ways(dataset, graph)
    path, ended = random_path(dataset, ways, Random(30, 0), "stop")
    assert path[-1] == 2 and "ends early, in motif 2" in ended
    path, ended = random_path(dataset, ways, Random(10, 0), "jump")
    jumps = [b for a, b in pairwise(path) if a == 2]
    assert jumps and set(jumps) <= {0, 1} and not ended


def test_gaps_are_filled_by_the_shortest_way_or_named() -> None:
    dataset, graph = string_graph("abcd", "cb")
    ways = open_ways(dataset, graph)
    assert fill_gaps(ways, (0, 2, 3)) == (0, 1, 2, 3)
    with pytest.raises(NoWay, match=r"No edge leads from motif 3 to motif 0\. Nor is there any way round"):
        fill_gaps(ways, (3, 0))
    with pytest.raises(ValueError, match="There is no motif 9; they go from 0 to 3"):
        ways.shortest(Between(0, 9))
