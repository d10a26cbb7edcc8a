"""Which bodies can be compared, and that methods compare no others."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core import analyses
from core.errors import AnalysisError
from core.mocap.dataset import Dataset, open_dataset
from core.mocap.rigs import comparable, comparable_groups, kinds_of, left_out, rig_of, rigs_of
from core.poses.features import pose_features
from core.retrieval.queries import hybrid_query, whole_query
from core.retrieval.search import SearchParameters, build_search_index, unpack
from tests.core.mocap import samples
from tests.core.mocap.odd_clips import dog, in_other_axes, spider, walking, without, written
from tests.core.mocap.test_reading import FROM_Y

NO_LEGS = ("LeftUpLeg", "RightUpLeg")


def mixed() -> Dataset:
    """People (one of them small, one without legs), dogs and spiders."""
    people = [walking("a", seconds=6), walking("b", seconds=5, seed=2, scale=0.7)]
    animals = [*(dog(f"dog{k}", 4, k) for k in range(3)), *(spider(f"spider{k}", seconds=3, seed=k) for k in range(2))]
    return Dataset("mixed", (*people, without(walking("part"), *NO_LEGS), *animals))


NAMES = mixed().names


def test_a_rig_is_one_in_any_size_and_another_where_its_bones_point_elsewhere():
    plain, turned = walking().skeleton, in_other_axes(walking(), FROM_Y["z"]).skeleton
    small = samples.body(0.6)
    assert plain.names == turned.names
    assert rig_of(plain).fits(small) and not rig_of(plain).fits(turned)
    rigs, number = rigs_of([plain, turned, small])
    assert len(rigs) == 2 and number[plain] == number[small] != number[turned]


def test_groups_of_what_can_be_compared():
    groups = comparable_groups(mixed())
    assert [group.clips for group in groups] == [
        ("a", "b"),
        ("dog0", "dog1", "dog2"),
        ("part",),
        ("spider0", "spider1"),
    ]
    assert groups[0].words == "people" and groups[2].words == "people without legs"
    assert len(set(kinds_of([dog().skeleton, replace(dog().skeleton, offsets=-dog().skeleton.offsets)]).values())) == 2
    words = left_out(mixed())
    assert words.startswith("6 clips left out") and "dog0" in words and "--clips" in words
    assert comparable(mixed()).names == ("a", "b")
    alone = Dataset("people", (walking("a"),))
    assert comparable(alone) is alone and left_out(alone) == left_out(Dataset("none", ())) == ""


@pytest.mark.parametrize(
    ("method", "clips"),
    [("motifs", None), ("terminals", None), *((m, ("dog0", "dog1", "dog2")) for m in ("motifs", "map", "terminals"))],
)
def test_methods_work_on_one_kind_at_a_time(method, clips):
    dataset = mixed() if clips is None else mixed().select(clips)
    few = {"motifs": {"kappa": 20}, "map": {"grid": "6x6"}, "terminals": {"n_terminals": 3}}[method]
    result = analyses.compute(dataset, method, few)
    document = result.to_json() if hasattr(result, "to_json") else result.pack()[0]
    names = set(clips or ("a", "b"))
    assert names & _clips_in(document) and _clips_in(document) <= names


def _clips_in(document) -> set[str]:
    if isinstance(document, dict):
        document = [*document.values()]
    if isinstance(document, list | tuple):
        return set().union(*(_clips_in(part) for part in document)) if document else set()
    return {document} if isinstance(document, str) and document in NAMES else set()


def test_poses_of_what_cannot_be_compared_are_refused():
    with pytest.raises(AnalysisError, match="cannot be compared: people, the rig of Hips"):
        pose_features(mixed().select(["a", "dog0"]))
    assert pose_features(mixed().select(["dog0", "dog1"])).values.shape[0] > 100


@pytest.mark.parametrize("method", ["bounded-edit", "parts"])
def test_a_search_finds_the_querys_own_kind_only(method):
    dataset = mixed()
    built = build_search_index(dataset, SearchParameters(method=method))
    for index in (built, unpack(*built.pack()), _grown(dataset, method)):
        assert {clip.name for clip in index.clips} == set(dataset.names)
        for kind in (("a", "b", "part"), ("dog0", "dog1", "dog2"), ("spider0", "spider1")):
            query = whole_query(dataset.clip(kind[0]))
            hits = index.search(query)
            assert {hit.segment.clip for hit in hits} == set(kind) and index.not_compared(query) == 8 - len(kind)
            assert hits[0].segment.clip == kind[0] and hits[0].score == pytest.approx(1)
            assert {hit.segment.clip for hit in index.search(query, level="interval")} <= set(kind)
    stranger = spider("stranger", legs=10)
    with pytest.raises(AnalysisError, match="no clip here has a body"):
        built.search(whole_query(stranger))
    halves = {"upper_body": (dataset.clip("a"), None, None), "lower_body": (dataset.clip("dog0"), None, None)}
    with pytest.raises(AnalysisError, match="bodies that cannot be compared"):
        built.search(hybrid_query(halves))


def _grown(dataset: Dataset, method: str):
    index = build_search_index(dataset.select(["a", "dog0"]), SearchParameters(method=method))
    return index.add(dataset.select(name for name in dataset.names if name not in ("a", "dog0")))


def test_the_turned_copy_of_a_walk_is_found_at_1_and_changes_nothing_of_the_others(tmp_path):
    others = [walking("other", seed=3, speed=0.4), samples.idling("idle", fps=30.0)]
    handless = without(walking("handless"), "LeftHand", "RightHand")
    plain = open_dataset(written(tmp_path / "plain", walking(), *others, handless))
    turned = replace(in_other_axes(walking(), FROM_Y["z"]), name="a turned copy")
    both = open_dataset(written(tmp_path / "both", walking(), *others, handless, turned))
    assert both.clip("walk").skeleton == both.clip("a turned copy").skeleton
    before, after = build_search_index(plain), build_search_index(both)
    hits = after.search(whole_query(both.clip("walk")))
    scores = {hit.segment.clip: hit.score for hit in hits}
    assert scores["a turned copy"] == pytest.approx(1, abs=1e-3)
    order = [hit.segment.clip for hit in hits if hit.segment.clip != "a turned copy"]
    assert order == [hit.segment.clip for hit in before.search(whole_query(plain.clip("walk")))]
    _same_postures(before, after, plain.names, within=1)


def test_a_raw_copy_with_other_axes_changes_nothing_of_the_others():
    """Not even where nothing turned it: what is learnt from the one rig is not used for the other."""
    clips = (walking(), walking("other", seed=3, speed=0.4))
    plain = Dataset("plain", clips)
    odd = Dataset("odd", (*clips, replace(in_other_axes(walking(), FROM_Y["z"]), name="odd")))
    _same_postures(build_search_index(plain), build_search_index(odd), plain.names)
    poses = [pose_features(dataset, pose="angles").values for dataset in (plain, odd)]
    assert np.isfinite(poses[1]).all() and len(poses[1]) > len(poses[0])


def _same_postures(before, after, names, within: int = 0) -> None:
    """What the engines compare, and so every distance, is the same for these clips, up to rounding (one of 127)."""
    one, two = before.engine.store, after.engine.store
    for name in names:
        codes = one.of(one.index(name)).astype(int) - two.of(two.index(name))
        assert np.abs(codes).max() <= within, name
