"""Engines ``parts`` and ``printed``: what is put in is found, weights, hybrids, added clips, tables."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest

from core.demo import make_demo
from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.mocap.skeleton import Skeleton
from core.poses.body_parts import LEAVES, LEVEL, NODES, leaves_of, part_joints
from core.retrieval.node_index import centred
from core.retrieval.queries import hybrid_query, whole_query
from core.retrieval.search import SearchParameters, build_search_index, unpack

PARTS, PRINTED = SearchParameters(method="parts"), SearchParameters(method="printed")


@pytest.fixture(scope="module")
def demo():
    whole = make_demo(minutes=1.5)
    cuts = [
        clip.cut(start, start + 240, f"{clip.name}-{start}")
        for clip in whole.clips
        for start in range(0, clip.n_frames - 240, 240)
    ]
    return Dataset("demo", tuple(cuts[:12]))


@pytest.fixture(scope="module")
def index(demo):
    return build_search_index(demo, PARTS)


@pytest.fixture(scope="module")
def printed(demo):
    return build_search_index(demo, PRINTED)


def shaken(clip: Clip, leaf: str, name: str, seed: int = 0) -> Clip:
    """The clip with the joints of one leaf turned about at random."""
    rng, rotations = np.random.default_rng(seed), np.array(clip.rotations)
    for joint in part_joints(find_anatomy(clip.skeleton))[leaf]:
        turns = quat.from_rotvec(np.cumsum(rng.normal(size=(clip.n_frames, 3)), axis=0) * 0.1)
        rotations[:, joint] = quat.multiply(rotations[:, joint], turns)
    return replace(clip, name=name, rotations=rotations)


def test_a_clip_is_most_like_itself_and_all_are_ranked(demo, index):
    for clip in demo.clips[::4]:
        hits = index.search(whole_query(clip))
        assert hits[0].segment == Segment(clip.name, 0, clip.n_frames) and hits[0].score == pytest.approx(1)
        assert len({hit.segment.clip for hit in hits}) == len(demo.clips)
        assert all(a.score >= b.score for a, b in itertools.pairwise(hits))


def test_the_same_clips_make_the_same_index(demo, index):
    document, arrays = index.pack()
    again, others = build_search_index(demo, PARTS).pack()
    assert document["engine"] == again["engine"] and all(np.array_equal(arrays[k], others[k]) for k in arrays)


def test_a_stretch_is_found_where_it_is(demo, index):
    clip = demo.clips[3]
    hits = index.search(whole_query(clip, 70, 190), level="interval", top=5)
    assert hits[0].segment.clip == clip.name
    assert abs(hits[0].segment.start - 70) <= 20 and abs(hits[0].segment.end - 190) <= 20
    by_clip = {}
    for hit in hits:
        by_clip.setdefault(hit.segment.clip, []).append(hit.segment)
    for segments in by_clip.values():
        for a, b in itertools.combinations(segments, 2):
            shared = min(a.end, b.end) - max(a.start, b.start)
            assert shared <= 0.55 * min(a.n_frames, b.n_frames)


@pytest.mark.parametrize("frames", [1, 3])
def test_a_query_may_be_as_short_as_a_frame(demo, index, frames):
    query = whole_query(demo.clips[0], 100, 100 + frames)
    hits = index.search(query, level="interval", top=3)
    assert hits and index.explain(query, hits[0]).warp.shape == (frames,)
    assert len(index.search(query)) == len(demo.clips)


@pytest.mark.parametrize("leaf", ["left_arm", "torso", "right_foot"])
@pytest.mark.parametrize("level", ["clip", "interval"])
def test_a_leaf_of_weight_zero_has_no_influence_at_all(demo, index, leaf, level):
    clip = demo.clips[2]
    found = index.add(Dataset("more", (replace(clip, name="a"), shaken(clip, leaf, "b"))))
    query = whole_query(demo.clips[5], 60, 180)
    weights = {other: 1.0 for other in LEAVES if other != leaf}
    scores = [
        [(h.score, *h.segment[1:]) for h in found.search(query, weights=weights, level=level, only={name})]
        for name in ("a", "b")
    ]
    assert scores[0] == scores[1]
    full = [found.search(query, only={name})[0].score for name in ("a", "b")]
    assert full[0] != full[1]
    changed = shaken(demo.clips[5], leaf, "query")  # nor has it in the query
    asked = [found.search(q, weights=weights, level=level) for q in (query, whole_query(changed, 60, 180))]
    assert asked[0] == asked[1]


def test_weight_on_the_left_arm_orders_by_the_left_arm(demo):
    base = demo.clips[1]
    joint = find_anatomy(base.skeleton).joints["left_shoulder"]

    def swung(degrees: float, name: str) -> Clip:
        rotations = np.array(base.rotations)
        angles = np.radians(degrees) * np.sin(np.linspace(0, 6 * np.pi, base.n_frames))
        rotations[:, joint] = quat.multiply(rotations[:, joint], quat.from_rotvec(angles[:, None] * [[0.0, 0.0, 1.0]]))
        return replace(base, name=name, rotations=rotations)

    arms = [swung(degrees, f"swing{degrees:02d}") for degrees in (0, 30, 90)]
    found = build_search_index(Dataset("arms", (*arms, *demo.clips[4:8])), PARTS)
    hits = found.search(whole_query(base), weights={"left_arm": 1}, only={clip.name for clip in arms})
    assert [hit.segment.clip for hit in hits] == [clip.name for clip in arms]
    legs = found.search(whole_query(base), weights={"lower_body": 1}, only={clip.name for clip in arms})
    assert len({hit.score for hit in legs}) == 1


def test_a_hybrid_finds_the_motion_that_is_put_together_so(demo, index):
    upper, lower = demo.clips[0], demo.clips[6]
    joints = part_joints(find_anatomy(upper.skeleton))
    rotations = np.array(lower.rotations)
    for leaf in leaves_of("upper_body"):
        rotations[:, list(joints[leaf])] = upper.rotations[:, list(joints[leaf])]
    found = index.add(Dataset("more", (replace(lower, name="both", rotations=rotations),)))
    hits = found.search(hybrid_query({"upper_body": (upper, None, None), "lower_body": (lower, None, None)}))
    assert hits[0].segment.clip == "both" and hits[0].score > hits[1].score + 0.03
    short = hybrid_query({"upper_body": (upper, 0, 60), "lower_body": (lower, 20, 200)})
    assert found.search(short, level="interval", top=2)[0].segment.clip in {"both", upper.name, lower.name}


def test_added_clips_get_the_nearest_patterns_and_nothing_else_changes(demo):
    first = build_search_index(Dataset("first", demo.clips[:-2]), PARTS)
    grown = first.add(Dataset("second", demo.clips[-2:]))
    for node, index in first.engine.nodes.items():
        more = grown.engine.nodes[node]
        assert more.library is index.library
        assert np.array_equal(more.symbols[: len(index.symbols)], index.symbols)
        assert len(more.starts) == len(demo.clips) + 1 and more.ends[-1] == grown.engine.store.starts[-1]
    clip = demo.clips[-1]
    assert grown.search(whole_query(clip))[0].segment.clip == clip.name
    assert grown.search(whole_query(clip))[0].score == pytest.approx(1)


def test_a_kept_index_answers_alike(demo, index, printed):
    for found in (index, printed):
        again = unpack(*found.pack())
        query = whole_query(demo.clips[1], 10, 200)
        for level in ("clip", "interval"):
            assert again.search(query, level=level) == found.search(query, level=level)


def test_an_explanation_says_which_part_is_alike_when(demo, index):
    clip = demo.clips[4]
    other = shaken(clip, "left_arm", "other")
    found = index.add(Dataset("more", (other,)))
    why = found.explain(whole_query(clip), Segment("other", 0, clip.n_frames))
    means = dict(zip(why.parts, why.similarity.mean(axis=1), strict=True))
    assert means["left_arm"] < 0.8 and all(means[leaf] == pytest.approx(1) for leaf in LEAVES if leaf != "left_arm")
    assert why.similarity.shape == (10, len(why.times)) and (np.diff(why.warp) >= 0).all()
    part = found.explain(hybrid_query({"left_arm": (clip, None, None)}), Segment("other", 0, 100))
    assert np.isnan(part.similarity[LEAVES.index("head")]).all()
    with pytest.raises(KeyError):
        found.explain(whole_query(clip), Segment("nobody", 0, 5))


def test_the_path_counts_where_it_is_asked_for(demo, index):
    query = whole_query(demo.clips[2])
    for level in ("clip", "interval"):
        assert index.search(query, root_path=1.0, level=level)[0].segment.clip == demo.clips[2].name
        plain, mixed = (index.search(query, root_path=share, level=level, top=4) for share in (0.0, 0.5))
        assert [hit.score for hit in plain] != [hit.score for hit in mixed]


def test_tables_1_and_2_can_be_read_off_the_index(demo, index, printed):
    for found in (index, printed):
        rows = {row.node: row for row in found.engine.diagnostics()}
        assert tuple(rows) == NODES
        frames = sum(stop - start for start, stop in itertools.pairwise(found.engine.store.starts))
        for node, row in rows.items():
            assert row.level == LEVEL[node] and row.mean_frames * row.segments == pytest.approx(frames)
            assert 1 <= row.patterns <= row.segments
    coarse = build_search_index(demo, replace(PARTS, pattern_error=2.0)).engine.diagnostics()
    assert sum(row.patterns for row in coarse) < sum(row.patterns for row in index.engine.diagnostics())


def seconds_of(demo, **settings) -> dict[str, float]:
    """Node -> mean seconds of a segment, of all nodes but the hands, which hardly move in the demo."""
    engine = build_search_index(demo, replace(PARTS, **settings)).engine
    rows = engine.diagnostics()
    return {row.node: row.mean_frames / engine.store.fps for row in rows if row.node not in ("left_hand", "right_hand")}


def test_segments_follow_the_motion(demo, index):
    """R has an effect, segments last equally long at all rates, and those of some parts longer than those of others."""
    few = Dataset("few", demo.clips[:6])
    usual = seconds_of(few)
    longer, shorter = seconds_of(few, r=4.0), seconds_of(few, r=0.25)
    assert all(shorter[node] <= usual[node] < longer[node] for node in usual)
    assert np.mean([*shorter.values()]) * 1.05 < np.mean([*usual.values()]) < np.mean([*longer.values()]) / 1.2
    for fps in (60.0, 120.0):
        again = seconds_of(few, analysis_fps=fps)
        assert np.mean([*again.values()]) == pytest.approx(np.mean([*usual.values()]), rel=0.05)
    frames = [row.mean_frames for row in index.engine.diagnostics() if row.node in LEAVES]
    assert max(frames) > 1.25 * min(frames)


def test_the_settings_of_the_paper_reach_the_engines(demo, printed):
    few = Dataset("few", demo.clips[:6])
    query = whole_query(few.clips[0])

    def scores(method: str, **settings):
        return [hit.score for hit in build_search_index(few, SearchParameters(method=method, **settings)).search(query)]

    usual = scores("printed")
    for settings in ({"min_con_num": 2}, {"max_tolerance": 0.3}, {"alpha": 0.9}):
        assert scores("printed", **settings) != usual
    assert scores("parts", alpha=0.9) != scores("parts")
    patterns = [
        sum(
            row.patterns for row in build_search_index(few, replace(PARTS, k0=k0, pattern_error=5)).engine.diagnostics()
        )
        for k0 in (2, 20)
    ]
    assert patterns[0] < patterns[1]
    with pytest.raises(ValueError, match="alpha must be 0 to 1"):
        SearchParameters(alpha=1.5)


def test_added_clips_and_queries_are_cut_as_the_first_clips_were(demo, index):
    grown = index.add(Dataset("more", (replace(demo.clips[0], name="copy"),)))
    for node, own in grown.engine.nodes.items():
        first, copy = (
            slice(*own.starts[k : k + 2]) for k in (grown.engine.store.index(n) for n in (demo.clips[0].name, "copy"))
        )
        assert own.threshold == index.engine.nodes[node].threshold
        assert np.array_equal(own.symbols[first], own.symbols[copy])
        assert np.array_equal(np.diff(own.begins[first]), np.diff(own.begins[copy]))


def test_printed_takes_the_papers_numbers_and_still_ranks(demo, printed):
    hits = printed.search(whole_query(demo.clips[0]))
    assert len(hits) == len(demo.clips) and hits[0].segment.clip == demo.clips[0].name
    whole = {clip.name: clip.n_frames for clip in demo.clips}
    found = printed.search(whole_query(demo.clips[0], 30, 120), level="interval", top=3)
    assert all((hit.segment.start, hit.segment.end) == (0, whole[hit.segment.clip]) for hit in found)


def test_printed_still_penalises_a_part_of_no_weight(demo, printed):
    """One of the faults of Algorithm 2 that ``parts`` mends: see the test of weight zero above."""
    clip = demo.clips[2]
    found = printed.add(Dataset("more", (replace(clip, name="a"), shaken(clip, "left_arm", "b"))))
    weights = {leaf: 1.0 for leaf in LEAVES if leaf != "left_arm"}
    hits = found.search(whole_query(demo.clips[5]), weights=weights, only={"a", "b"})
    assert len({hit.score for hit in hits}) == 2


def test_centring_takes_off_a_share_of_the_posture_around():
    x = np.random.default_rng(0).normal(size=(20, 2))
    found = centred(x, 0.7, 4)
    for k in (0, 3, 11, 19):
        np.testing.assert_allclose(found[k], x[k] - 0.7 * x[max(0, k - 4) : k + 5].mean(0), atol=1e-6)


def chain(name: str) -> Clip:
    """A recording in which no body is recognised."""
    offsets = np.array([[0, 0, 0], [0, 1, 0], [0, 1, 0]], np.float32)
    skeleton = Skeleton(("a", "b", "c"), (-1, 0, 1), offsets, (False,) * 3)
    rotations = np.zeros((90, 3, 4), np.float32)
    rotations[..., 0] = 1
    return Clip(name, skeleton, 30.0, np.zeros((90, 3), np.float32), rotations)


def test_what_is_no_body_is_compared_with_its_own_rig_only(demo, index):
    found = index.add(Dataset("more", (chain("chain"),)))
    hits = found.search(whole_query(demo.clips[0]))
    assert "chain" not in {hit.segment.clip for hit in hits} and len(hits) == len(demo.clips)
    assert "chain" not in {hit.segment.clip for hit in found.search(whole_query(demo.clips[0]), level="interval")}
    assert [hit.segment.clip for hit in found.search(whole_query(chain("query")))] == ["chain"]
    with pytest.raises(ValueError, match="no clip here has a body that can be compared"):
        index.search(whole_query(chain("query")))
    assert [clip.name for clip in build_search_index(Dataset("chains", (chain("one"),)), PARTS).clips] == ["one"]
    whole = build_search_index(Dataset("both", (chain("chain"), *demo.clips[:3])), PARTS)
    assert whole.search(whole_query(demo.clips[1]))[0].segment.clip == demo.clips[1].name
