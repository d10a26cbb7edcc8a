"""Links: the seen ones are contiguous, the further ones are the best that brute force finds."""

from __future__ import annotations

import numpy as np

from core.synthesis.links import BRIDGE, FURTHER, SEEN, bridge_links, further_links, seen_links, typical_distance
from core.synthesis.postures import Moment, moments_apart
from tests.core.synthesis.recordings import demo, string_graph


def test_seen_links_are_the_successions_of_the_edges() -> None:
    _, graph = demo()
    links = seen_links(graph)
    motifs = {motif.id: motif for motif in graph.motifs}
    assert {ends: len(found) for ends, found in links.items()} == {(e.source, e.target): e.count for e in graph.edges}
    for (source, target), found in links.items():
        for link in found:
            before, after = motifs[source].segments[link.leave], motifs[target].segments[link.enter]
            assert link.kind == SEEN and before.clip == after.clip and before.end <= after.start
            assert link.exit == Moment(before.clip, before.end) and link.entry == Moment(after.clip, after.start)


def test_links_keep_to_the_clips_they_are_given() -> None:
    _, graph = string_graph("abc", "acb")
    assert set(seen_links(graph)) == {(0, 1), (1, 2), (0, 2), (2, 1)}
    assert set(seen_links(graph, {"take_1"})) == {(0, 2), (2, 1)}


def test_alike_moments_are_near_wherever_they_happen() -> None:
    dataset, _ = demo()
    clip = dataset.clips[0]
    moments = [Moment(clip.name, f) for f in (100, 102, 400)]
    features = moments_apart(dataset, moments)
    near, far = (np.linalg.norm(features[0] - features[k]) for k in (1, 2))
    assert near < 0.1 < far
    turned = moments_apart(dataset, [moments[0], *moments])
    assert np.allclose(turned[0], turned[1]) and np.allclose(turned[1:], features)


def test_bridges_are_the_most_alike_ends_and_beginnings() -> None:
    dataset, graph = demo()
    a, b = graph.motifs[0], graph.motifs[-1]
    links = bridge_links(dataset, a, b, most=3)
    ends = moments_apart(dataset, [Moment(s.clip, s.end - 1) for s in a.segments])
    starts = moments_apart(dataset, [Moment(s.clip, s.start) for s in b.segments])
    every = sorted(float(np.linalg.norm(e - s)) for e in ends for s in starts)
    assert np.allclose([link.cost for link in links], every[:3], atol=1e-5)
    assert all(link.kind == BRIDGE and link.seconds > 0 for link in links)


def test_further_links_against_all_pairs() -> None:
    dataset, graph = demo()
    limit = typical_distance(dataset, graph)
    found = further_links(dataset, graph, per_motif=1000)
    assert found and all(links[0].kind == FURTHER and links[0].cost <= limit for links in found.values())
    joined = {(edge.source, edge.target) for edge in graph.edges}
    motifs = {motif.id: motif for motif in graph.motifs}
    for (source, target), (link,) in found.items():
        assert source != target and (source, target) not in joined
        assert motifs[source].segments[link.leave].start <= link.exit.frame < motifs[source].segments[link.leave].end
        assert motifs[target].segments[link.enter].start <= link.entry.frame < motifs[target].segments[link.enter].end
        pair = moments_apart(dataset, [link.exit, link.entry])
        assert np.isclose(np.linalg.norm(pair[0] - pair[1]), link.cost, atol=1e-5)
    # brute force over every candidate: nothing nearer is missed
    from core.synthesis.links import _candidates

    exits, entries = _candidates(dataset, graph, None)
    a, b = (moments_apart(dataset, [row[2] for row in rows]) for rows in (exits, entries))
    apart = np.linalg.norm(a[:, None] - b[None], axis=2)
    best: dict[tuple[int, int], float] = {}
    for i, exit_ in enumerate(exits):
        for k, entry in enumerate(entries):
            ends = exit_[0], entry[0]
            if ends[0] != ends[1] and ends not in joined and apart[i, k] <= limit:
                best[ends] = min(best.get(ends, np.inf), float(apart[i, k]))
    assert set(found) == set(best)
    assert all(np.isclose(found[ends][0].cost, cost, atol=1e-5) for ends, cost in best.items())


def test_only_the_best_few_further_links_of_a_motif_stay() -> None:
    dataset, graph = demo()
    every, few = further_links(dataset, graph, per_motif=1000), further_links(dataset, graph, per_motif=1)
    sources = [source for source, _ in few]
    assert len(sources) == len(set(sources)) == len({source for source, _ in every})
    for source, target in few:
        assert few[source, target][0].cost == min(links[0].cost for ends, links in every.items() if ends[0] == source)
