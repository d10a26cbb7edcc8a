"""Searching: what is put in is found, weights do what they say, and an index can be kept and grown."""

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
from core.poses.body_parts import LEAVES, part_joints
from core.retrieval import bounded_edit
from core.retrieval.queries import hybrid_query, parse_query, whole_query
from core.retrieval.search import SearchParameters, build_search_index, unpack


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=2)


@pytest.fixture(scope="module")
def index(demo):
    return build_search_index(demo)


def turned(clip: Clip, joint: str, degrees: float, name: str) -> Clip:
    """The clip with one joint turned by ``degrees`` more, at all times."""
    j = find_anatomy(clip.skeleton).joints[joint]
    rotations = np.array(clip.rotations)
    turn = quat.from_rotvec(np.radians([0.0, 0.0, degrees]))
    rotations[:, j] = quat.multiply(rotations[:, j], turn)
    return replace(clip, name=name, rotations=rotations)


def swung(clip: Clip, joint: str, degrees: float, name: str) -> Clip:
    """The clip with one joint swinging by up to ``degrees``, twice."""
    j = find_anatomy(clip.skeleton).joints[joint]
    rotations = np.array(clip.rotations)
    angles = np.radians(degrees) * np.sin(np.linspace(0, 4 * np.pi, clip.n_frames))
    rotations[:, j] = quat.multiply(rotations[:, j], quat.from_rotvec(angles[:, None] * [[0.0, 0.0, 1.0]]))
    return replace(clip, name=name, rotations=rotations)


def test_a_clip_is_most_like_itself_and_all_are_ranked(demo, index):
    hits = index.search(whole_query(demo.clips[1]))
    assert len(hits) == len(demo.clips) == len({hit.segment.clip for hit in hits})
    assert hits[0].segment == Segment(demo.clips[1].name, 0, demo.clips[1].n_frames)
    assert hits[0].score == pytest.approx(1) and all(a.score >= b.score for a, b in itertools.pairwise(hits))


def test_of_very_many_clips_the_nearest_are_measured_exactly(demo, monkeypatch):
    pieces = [
        replace(c.cut(k, k + 90), name=f"{c.name}_{k}") for c in demo.clips for k in range(0, c.n_frames - 90, 90)
    ]
    found = build_search_index(Dataset("pieces", tuple(pieces)))
    query = whole_query(pieces[5])
    exact = found.search(query)
    monkeypatch.setattr(bounded_edit, "EXACT", 10)
    monkeypatch.setattr(bounded_edit, "RERANKED", 40)
    quick = found.search(query)
    assert quick[0] == exact[0] and len(set(quick[:10]) & set(exact[:10])) >= 7
    assert {h.segment for h in quick} == {h.segment for h in exact}
    assert all(a.score >= b.score for a, b in itertools.pairwise(quick)) and quick[-1].score >= 0


def test_a_stretch_is_found_where_it_is(demo, index):
    clip = demo.clips[0]
    hits = index.search(whole_query(clip, 120, 240), level="interval", top=5)
    assert hits[0].segment.clip == clip.name
    assert abs(hits[0].segment.start - 120) <= 8 and abs(hits[0].segment.end - 240) <= 8
    assert len(hits) == 5


@pytest.mark.parametrize("frames", [1, 2, 5])
def test_a_query_may_be_as_short_as_a_frame(demo, index, frames):
    clip = demo.clips[0]
    query = whole_query(clip, 100, 100 + frames)
    hits = index.search(query, level="interval", top=3)
    assert hits[0].segment.clip == clip.name and abs(hits[0].segment.start - 100) <= 6
    assert len(index.search(query)) == len(demo.clips)
    assert index.explain(query, hits[0]).warp.shape == (frames,)


def test_weight_on_the_left_arm_orders_by_the_left_arm():
    walk = make_demo(minutes=0.5).clips[0].cut(0, 240, "walk")
    clips = [swung(walk, "left_shoulder", degrees, f"swing{degrees:02d}") for degrees in (0, 10, 25, 45, 80)]
    others = [
        swung(clips[k], "right_hip", 90 - 20 * k, clip.name) for k, clip in enumerate(clips)
    ]  # legs say the reverse
    found = build_search_index(Dataset("arms", tuple(others)))
    query = whole_query(walk)
    ranked = [hit.segment.clip for hit in found.search(query, weights={"left_arm": 1})]
    assert ranked == sorted(ranked)
    ranked = [hit.segment.clip for hit in found.search(query, weights={"lower_body": 1})]
    assert ranked == sorted(ranked, reverse=True)


@pytest.mark.parametrize("leaf", LEAVES)
@pytest.mark.parametrize("level", ["clip", "interval"])
def test_a_leaf_of_weight_zero_has_no_influence_at_all(leaf, level):
    """Clips that differ in one leaf alone get equal scores, to the last bit, where it weighs nothing."""
    clip = make_demo(minutes=0.5).clips[0].cut(0, 200, "a")
    rotations = np.array(clip.rotations)
    rng = np.random.default_rng(0)
    for joint in part_joints(find_anatomy(clip.skeleton))[leaf]:
        turns = quat.from_rotvec(np.cumsum(rng.normal(size=(200, 3)), axis=0) * 0.1)
        rotations[:, joint] = quat.multiply(rotations[:, joint], turns)
    dataset = Dataset("pair", (clip, replace(clip, name="b", rotations=rotations)))
    found = build_search_index(dataset)
    query = whole_query(make_demo(minutes=0.5, seed=3).clips[0], 100, 220)
    weights = {other: 1.0 for other in LEAVES if other != leaf}
    scores = {hit.segment.clip: hit.score for hit in found.search(query, weights=weights, level=level, top=2)}
    if level == "clip":
        assert scores["a"] == scores["b"]
    found_a = [h.score for h in found.search(query, weights=weights, level=level, only={"a"})]
    found_b = [h.score for h in found.search(query, weights=weights, level=level, only={"b"})]
    assert found_a == found_b
    assert found.search(query, only={"a"})[0].score != found.search(query, only={"b"})[0].score


def test_a_hybrid_finds_the_motion_that_is_put_together_so(demo, index):
    upper, lower = demo.clips[0].cut(60, 180, "upper"), demo.clips[0].cut(600, 720, "lower")
    joints = part_joints(find_anatomy(upper.skeleton))
    rotations = np.array(lower.rotations)
    for leaf in ("head", "torso", "left_arm", "left_hand", "right_arm", "right_hand"):
        rotations[:, list(joints[leaf])] = upper.rotations[:, list(joints[leaf])]
    both = replace(lower, name="both", rotations=rotations)
    found = index.add(Dataset("more", (both, replace(upper, name="upper"), replace(lower, name="lower"))))
    query = hybrid_query({"upper_body": (upper, None, None), "lower_body": (lower, None, None)})
    hits = found.search(query)
    odds = [hit.score / (1 - hit.score) for hit in hits[:2]]
    assert hits[0].segment.clip == "both" and odds[0] > 10 * odds[1]
    with_short = hybrid_query({"upper_body": (upper, 0, 60), "lower_body": (lower, None, None)})
    assert found.search(with_short)[0].score < hits[0].score


def test_added_clips_are_found_with_the_scores_of_an_index_built_anew(demo):
    first = build_search_index(Dataset("first", demo.clips[:-1]))
    grown, anew = first.add(Dataset("second", demo.clips[-1:])), build_search_index(demo)
    query = whole_query(demo.clips[-1], 30, 160)
    ours, theirs = grown.search(query), anew.search(query)  # alike but for the axes, which the first clips gave
    assert [hit.segment for hit in ours] == [hit.segment for hit in theirs]
    np.testing.assert_allclose([hit.score for hit in ours], [hit.score for hit in theirs], atol=0.02)
    ours, theirs = grown.search(query, level="interval")[0], anew.search(query, level="interval")[0]
    assert ours.segment == theirs.segment and ours.score == pytest.approx(theirs.score, abs=0.02)
    assert grown.search(query, level="interval")[0].segment.clip == demo.clips[-1].name
    assert len(first.clips) == len(demo.clips) - 1
    with pytest.raises(ValueError, match="already"):
        grown.add(Dataset("again", demo.clips[-1:]))


def test_a_kept_index_answers_alike(demo, index):
    document, arrays = index.pack()
    again = unpack(document, arrays)
    query = whole_query(demo.clips[1], 10, 200)
    assert again.search(query, level="interval") == index.search(query, level="interval")
    with pytest.raises(ValueError, match="not a search index"):
        unpack(document | {"format": "other"}, arrays)


def test_only_and_exclude_choose_the_clips(demo, index):
    names = [clip.name for clip in demo.clips]
    query = whole_query(demo.clips[0])
    assert {h.segment.clip for h in index.search(query, only=names[1:3])} == set(names[1:3])
    assert names[0] not in {h.segment.clip for h in index.search(query, exclude=names[:1], level="interval")}
    assert index.search(query, only=()) == []


def test_the_path_counts_where_it_is_asked_for(demo, index):
    query = whole_query(demo.clips[0])
    assert index.search(query, root_path=1.0)[0].segment.clip == demo.clips[0].name
    plain = {h.segment.clip: h.score for h in index.search(query)}
    mixed = {h.segment.clip: h.score for h in index.search(query, root_path=0.5)}
    assert plain != mixed


def test_an_explanation_says_which_part_is_alike(demo, index):
    clip = demo.clips[0].cut(100, 220, "base")
    other = turned(clip, "left_shoulder", 70, "other")
    found = index.add(Dataset("more", (other,)))
    why = found.explain(whole_query(clip), Segment("other", 0, 120))
    means = dict(zip(why.parts, why.similarity.mean(axis=1), strict=True))
    assert means["left_arm"] < 0.7 and all(means[leaf] > 0.95 for leaf in LEAVES if leaf != "left_arm")
    assert why.similarity.shape == (10, len(why.times)) and (np.diff(why.warp) >= 0).all()
    assert why.warp.shape == (120,) and np.abs(why.warp - np.arange(120)).mean() < 3
    with pytest.raises(KeyError):
        found.explain(whole_query(clip), Segment("nobody", 0, 5))


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"level": "song"}, "level"),
        ({"top": 0}, "top"),
        ({"root_path": 2}, "root_path"),
        ({"weights": {"left_arm": 0}}, "zero"),
        ({"weights": {"wing": 1}}, "no part"),
    ],
)
def test_what_cannot_be_asked_is_refused_in_plain_words(demo, index, options, words):
    with pytest.raises(ValueError, match=words):
        index.search(whole_query(demo.clips[0]), **options)


def test_queries_are_read_from_text(demo):
    name = demo.clips[0].name
    assert parse_query(f"{name}:10-90", demo).parts[0].end == 90
    assert parse_query(name, demo).parts[0].end == demo.clips[0].n_frames
    for text in ("nobody", f"{name}:90-10", f"{name}:0-99999999"):
        with pytest.raises(ValueError, match=r"clip|frames"):
            parse_query(text, demo)


def test_parameters_are_checked():
    with pytest.raises(ValueError, match="method"):
        SearchParameters(method="guess")
    with pytest.raises(ValueError, match="no clips"):
        build_search_index(Dataset("none", ()))
