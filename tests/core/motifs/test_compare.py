"""Comparing two motif graphs: against a reading of the definition frame by frame, and its symmetries."""

from __future__ import annotations

import json
from collections import Counter

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sklearn.metrics import adjusted_rand_score

from core.mocap.clip import Segment
from core.motifs.build import MotifParameters, find_motifs
from core.motifs.compare import compare, frame_motifs
from core.motifs.graph import Motif, MotifGraph
from tests.core.motifs.recordings import recurring

MIRROR = {"kept": "kept", "lost": "gained", "gained": "lost", "split": "merged", "merged": "split"}


def graph_of(*clips: str, fps: tuple[float, ...] | float = 30, first_id: int = 0) -> MotifGraph:
    """A graph from strings, one a clip, a letter a frame: letters are motifs, ``.`` is none."""
    rates = fps if isinstance(fps, tuple) else (fps,) * len(clips)
    segments: dict[str, list[Segment]] = {}
    for number, text in enumerate(clips):
        start = 0
        for k in range(1, len(text) + 1):
            if k == len(text) or text[k] != text[start]:
                if text[start] != ".":
                    segments.setdefault(text[start], []).append(Segment(f"clip{number}", start, k))
                start = k
    motifs = tuple(Motif(first_id + i, tuple(segments[x]), 0, ()) for i, x in enumerate(sorted(segments)))
    heads = tuple((f"clip{i}", len(text), rate) for i, (text, rate) in enumerate(zip(clips, rates, strict=True)))
    return MotifGraph(motifs, (), {}, {}, clips=heads)


def naive(a: list[str], b: list[str]) -> tuple[dict[str, str], dict[str, str], set, float]:
    """The module's first paragraph, word by word: changes of either side's letters, kept pairs, agreement."""
    frames = list(zip("".join(a), "".join(b), strict=True))
    in_a = {x: {k for k, (p, _) in enumerate(frames) if p == x} for x, _ in frames if x != "."}
    in_b = {y: {k for k, (_, q) in enumerate(frames) if q == y} for _, y in frames if y != "."}
    links, kept = [], set()
    for x, xs in in_a.items():
        for y, ys in in_b.items():
            both = len(xs & ys)
            if 2 * both > len(xs) or 2 * both > len(ys):
                links.append((x, y))
            if 2 * both > len(xs) and 2 * both > len(ys):
                kept.add((x, y))
    for x, y in links:
        if [link for link in links if x == link[0] or y == link[1]] == [(x, y)]:
            kept.add((x, y))

    def change(own, number, side, alone, several, one):
        if any(pair[side] == own for pair in kept):
            return "kept"
        return alone if number == 0 else several if number > 1 else one

    degree = [Counter(link[side] for link in links) for side in (0, 1)]
    changes_a = {x: change(x, degree[0][x], 0, "lost", "split", "merged") for x in in_a}
    changes_b = {y: change(y, degree[1][y], 1, "gained", "merged", "split") for y in in_b}
    agreed = sum((p, q) in kept or (p, q) == (".", ".") for p, q in frames)
    return changes_a, changes_b, kept, agreed / len(frames)


texts = st.lists(st.tuples(st.sampled_from("ABCD."), st.sampled_from("ABCD."), st.integers(1, 5)), min_size=1)


@given(texts, st.data())
def test_agrees_with_the_definition_read_frame_by_frame(runs, data):
    a = "".join(x * n for x, _, n in runs)
    b = "".join(y * n for _, y, n in runs)
    cut = data.draw(st.integers(0, len(a)))
    parts_a, parts_b = ([text for text in (s[:cut], s[cut:]) if text] for s in (a, b))
    found = compare(graph_of(*parts_a), graph_of(*parts_b))
    changes_a, changes_b, kept, agreement = naive(parts_a, parts_b)
    names_a, names_b = (sorted(set(text) - {"."}) for text in (a, b))
    assert {names_a[f.motif]: f.change for f in found.a} == changes_a
    assert {names_b[f.motif]: f.change for f in found.b} == changes_b
    assert {(names_a[k.a], names_b[k.b]) for k in found.links if k.kept} == kept
    assert found.agreement == pytest.approx(agreement)
    assert found.adjusted_rand == pytest.approx(adjusted_rand_score(list(a), list(b)))
    for fate in found.a:
        own = {k for k, x in enumerate(a) if x == names_a[fate.motif]}
        others = [{k for k, y in enumerate(b) if y == name} for name in names_b]
        assert fate.best == pytest.approx(max((len(own & o) / len(own | o) for o in others), default=0))
        assert fate.seconds == pytest.approx(len(own) / 30)


@given(texts)
def test_exchanging_the_graphs_exchanges_the_roles(runs):
    a = graph_of("".join(x * n for x, _, n in runs), first_id=10)
    b = graph_of("".join(y * n for _, y, n in runs), first_id=50)
    there, back = compare(a, b), compare(b, a)
    for one, other in ((there.a, back.b), (there.b, back.a)):
        assert [(f.motif, f.change, set(f.partners), f.best, f.seconds) for f in one] == [
            (f.motif, MIRROR[f.change], set(f.partners), f.best, f.seconds) for f in other
        ]
    assert {(k.a, k.b, k.overlap, k.kept) for k in there.links} == {(k.b, k.a, k.overlap, k.kept) for k in back.links}
    assert there.agreement == back.agreement and there.adjusted_rand == pytest.approx(back.adjusted_rand)


@given(texts)
def test_a_graph_is_kept_by_itself(runs):
    graph = graph_of("".join(x * n for x, _, n in runs))
    found = compare(graph, graph)
    assert {f.change for f in (*found.a, *found.b)} <= {"kept"}
    assert all(f.best == 1 and f.partners == (f.motif,) for f in found.a)
    assert found.agreement == 1 and found.adjusted_rand == 1


def test_each_change_in_a_small_example():
    found = compare(
        graph_of("AAAAAAAABBBBCCCCDDDDEEEE....", first_id=0),
        graph_of("AAAABBBBCCCCCCCCDDD.....FFFF", first_id=5),
    )
    assert [(f.motif, f.change, f.partners) for f in found.a] == [
        (0, "split", (5, 6)),
        (1, "merged", (7,)),
        (2, "merged", (7,)),
        (3, "kept", (8,)),
        (4, "lost", ()),
    ]
    assert [(f.motif, f.change) for f in found.b] == [
        (5, "split"),
        (6, "split"),
        (7, "merged"),
        (8, "kept"),
        (9, "gained"),
    ]
    assert found.counts("a") == {"kept": 1, "split": 1, "merged": 2, "lost": 1, "gained": 0}
    kept = next(link for link in found.links if link.kept)
    assert (kept.a, kept.b, kept.overlap) == (3, 8, 0.75)
    assert found.agreement == pytest.approx(3 / 28)


def test_clips_of_a_higher_rate_weigh_no_more():
    slow = compare(graph_of("AAAB", "AABB"), graph_of("AABB", "AABB"))
    fast = compare(
        graph_of("AAAB", "AAAAAAAABBBBBBBB", fps=(30, 120)), graph_of("AABB", "AAAAAAAABBBBBBBB", fps=(30, 120))
    )
    assert fast.a == slow.a and fast.b == slow.b and fast.agreement == slow.agreement
    assert fast.shared.toarray() == pytest.approx(slow.shared.toarray())
    assert fast.adjusted_rand == pytest.approx(slow.adjusted_rand, abs=0.15)


def test_no_motifs_at_all_on_one_side_or_both():
    none, some = graph_of("...."), graph_of("AAB.")
    assert [f.change for f in compare(some, none).a] == ["lost", "lost"]
    assert [f.change for f in compare(none, some).b] == ["gained", "gained"]
    assert compare(none, none).agreement == 1 and compare(none, none).adjusted_rand == 1


def test_other_recordings_are_refused():
    with pytest.raises(ValueError, match="different recordings"):
        compare(graph_of("AB"), graph_of("ABB"))


def test_real_graphs_whatever_the_order_of_the_clips():
    dataset = recurring(n_clips=4)
    a = find_motifs(dataset, MotifParameters(kappa=60))
    b = find_motifs(dataset.select(dataset.names[::-1]), MotifParameters(kappa=40, seed=3))
    found = compare(a, b)
    assert found.shared.sum() == pytest.approx(dataset.seconds)
    assert sum(f.seconds for f in found.a) == pytest.approx(a.metrics["coverage"] * dataset.seconds, rel=0.01)
    assert found.counts("a")["kept"] >= 1 and found.adjusted_rand > 0.5
    assert (frame_motifs(a)[0] >= 0).sum() == sum(s.n_frames for m in a.motifs for s in m.segments)
    assert json.loads(json.dumps(found.to_json()))["agreement"] == found.agreement


def test_cost_is_linear_in_frames():
    rng = np.random.default_rng(0)
    letters = "".join(chr(200 + x) * 20 for x in rng.integers(0, 400, 20_000))
    a, b = graph_of(letters), graph_of(letters[10:] + letters[:10])
    found = compare(a, b)  # 400 000 frames, 20 000 motions: all pairs of motions would take minutes
    assert found.counts("a")["kept"] + found.counts("a")["lost"] > 0
