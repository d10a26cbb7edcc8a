"""Walks: where frames come from, no jump at seams, feet that stay, and what a BVH of it looks like to others."""

from __future__ import annotations

import warnings
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from core.editing.contacts import foot_skate
from core.mocap.bvh import read_bvh, write_bvh
from core.mocap.dataset import Dataset, open_dataset
from core.mocap.kinematics import joint_positions
from core.motifs.build import MotifParameters, find_motifs
from core.synthesis import TRANSITION, NoWay, Random, find_route, make_walk
from core.synthesis.kept_walks import pack_walk, unpack_walk
from core.synthesis.stitching import seam_speed
from tests.core.synthesis.recordings import demo, other_joints, string_graph
from tests.core.synthesis.test_stitching import same_up_to_place


def test_a_recorded_succession_is_walked_as_it_was_recorded() -> None:
    dataset, graph = string_graph("abcd", "dcba", gap=6)
    walk = make_walk(dataset, graph, "0-1-2-3", keep_feet=False)
    assert same_up_to_place(joint_positions(walk.clip), joint_positions(dataset.clip("take_0"))[: 46 * 3 + 40])
    assert [(p.start, p.end, p.motif) for p in walk.parts] == [
        *(
            (46 * k, 46 * k + 40, k) if not gap else (46 * k + 40, 46 * k + 46, TRANSITION)
            for k in range(3)
            for gap in (0, 1)
        ),
        (138, 178, 3),
    ]


@pytest.mark.parametrize("further", [False, True])
def test_every_frame_says_where_it_comes_from(further: bool) -> None:
    dataset, graph = demo()
    walk = make_walk(dataset, graph, Random(25, 1), keep_feet=False, further=further)
    assert walk.parts[0].start == 0 and walk.parts[-1].end == walk.clip.n_frames
    assert all(a.end == b.start for a, b in pairwise(walk.parts))
    visited = [p.motif for p in walk.parts if p.motif != TRANSITION]
    assert all(p.motif == (walk.path[p.visit] if p.visit >= 0 else TRANSITION) for p in walk.parts)
    visits = [p.visit for p in walk.parts if p.visit >= 0]
    assert visits == sorted(visits) and set(visits) == set(range(len(walk.path)))
    runs = [m for k, m in enumerate(visited) if k == 0 or visited[k - 1] != m]
    assert runs == [m for k, m in enumerate(walk.path) if k == 0 or walk.path[k - 1] != m]
    motions = {motif.id: motif.segments for motif in graph.motifs}
    copies = 0
    for part in walk.parts:
        if part.motif != TRANSITION:  # what it shows lies in a motion of that motif
            inside = (s.clip == part.source.clip and s.start <= part.source.start + 1 for s in motions[part.motif])
            assert any(inside)
        if part.fading is None and part.source.n_frames == part.end - part.start:
            shown = walk.clip.rotations[part.start : part.end, 1:]
            own = dataset.clip(part.source.clip).rotations[part.source.start : part.source.end, 1:]
            assert np.abs((shown * own).sum(-1)).min() > 1 - 1e-5  # to the frame
            copies += part.end - part.start
    assert copies > 0.3 * walk.clip.n_frames


def test_random_walks_do_not_jump_and_keep_their_feet() -> None:
    dataset, graph = demo()
    anew = []
    for seed in range(5):
        walk, plain = (make_walk(dataset, graph, Random(12, seed), keep_feet=feet) for feet in (True, False))
        assert not walk.speeds.jump
        assert walk.skate.kept <= 0.5 * walk.skate.plain
        anew.append(foot_skate(walk.clip, floor=0.0) / foot_skate(plain.clip, floor=0.0))  # contacts of each result
        assert 9 <= walk.clip.seconds < 15  # as long as whole motifs can be
    assert np.mean(anew) <= 0.45 and max(anew) <= 0.55


def test_the_same_path_gives_the_same_walk() -> None:
    dataset, graph = demo()
    first, second = (make_walk(dataset, graph, "random:8:4") for _ in range(2))
    assert first.path == second.path and np.array_equal(first.clip.rotations, second.clip.rotations)


def test_real_recordings_walk_without_jumps_and_skate_half_as_much(shared_data) -> None:
    dataset = open_dataset(shared_data / "cmu" / "asfamc" / "86", clips=["86_09"])
    graph = find_motifs(dataset, MotifParameters(init="random"))
    for seed in range(2):
        walk = make_walk(dataset, graph, Random(15, seed))
        assert not walk.speeds.jump
        assert walk.skate.kept <= 0.5 * walk.skate.plain
        assert walk.skate.plain < 1.4 * walk.skate.source  # blending alone adds little


def test_the_bvh_of_a_walk_shows_the_same_motion_and_no_jump(tmp_path) -> None:
    dataset, graph = demo()
    walk = make_walk(dataset, graph, Random(10, 2))
    write_bvh(tmp_path / "walk.bvh", walk.clip)
    back = read_bvh(tmp_path / "walk.bvh")
    assert np.allclose(joint_positions(back), joint_positions(walk.clip), atol=1e-4)
    assert seam_speed(back, walk.seams) <= 1.001 * walk.speeds.sources
    pybvh = pytest.importorskip("pybvh")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its doubts about which way is up
        places = np.asarray(pybvh.read_bvh_file(str(tmp_path / "walk.bvh")).joint_positions())
    places = places * walk.clip.skeleton.unit
    speed = np.linalg.norm(np.diff(places.reshape(len(places), -1, 3), axis=0), axis=-1).max(1) * walk.clip.fps
    assert max(speed[max(0, a - 1) : b].max() for a, b in walk.seams) <= 1.001 * walk.speeds.sources


def test_missing_edges_are_refused_bridged_or_gone_round() -> None:
    dataset, graph = string_graph("abcd", "cb")
    with pytest.raises(
        NoWay, match=r"No edge leads from motif 0 to motif 2\. The shortest way goes by way of 1"
    ) as refusal:
        find_route(dataset, graph, "0-2-3")
    assert (refusal.value.source, refusal.value.target, refusal.value.detour) == (0, 2, (0, 1, 2))
    assert find_route(dataset, graph, "0-2-3", gaps="detour").path == (0, 1, 2, 3)
    bridged = find_route(dataset, graph, "0-2-3", gaps="bridge")
    assert [link.kind for link in bridged.links] == ["bridge", "seen"]
    assert "bridged by a blend: 0 to 2" in bridged.warnings[0]
    assert make_walk(dataset, graph, "3-0", gaps="bridge").path == (3, 0)
    with pytest.raises(NoWay, match="Nor is there any way round"):
        find_route(dataset, graph, "fewest:3:0")
    assert find_route(dataset, graph, "fewest:0:3").path == (0, 1, 2, 3)
    assert "Motif 3 is a dead end" in find_route(dataset, graph, "fewest:0:3").warnings[0]


@pytest.mark.parametrize("seed", range(4))
def test_any_path_can_be_bridged_without_spinning_or_sliding(seed: int) -> None:
    dataset, graph = demo()
    path = [int(motif) for motif in np.random.default_rng(seed).choice([m.id for m in graph.motifs], 6)]
    walk = make_walk(dataset, graph, path, gaps="bridge")
    assert walk.path == tuple(path)
    assert walk.speeds.seams <= 1.3 * walk.speeds.sources  # from any posture to any other within a second or two
    assert walk.skate.kept <= 0.5 * walk.skate.plain


def test_unknown_motifs_and_options_are_refused() -> None:
    dataset, graph = string_graph("ab")
    for path, words in (("0-7", "There is no motif 7"), ((), "at least one motif"), ("0-", "is no path")):
        with pytest.raises(ValueError, match=words):
            find_route(dataset, graph, path)
    with pytest.raises(ValueError, match="expected one of"):
        find_route(dataset, graph, "0-1", gaps="jump")
    with pytest.raises(ValueError, match="no motifs"):
        find_route(dataset, replace(graph, motifs=(), edges=()), "0")


def test_a_single_motif_is_its_most_typical_motion() -> None:
    dataset, graph = demo()
    motif = graph.motifs[2]
    walk = make_walk(dataset, graph, str(motif.id), keep_feet=False)
    assert walk.parts == ((0, walk.clip.n_frames, motif.id, 0, motif.segments[motif.medoid], None),)


def test_a_walk_keeps_to_skeletons_with_the_same_joints() -> None:
    dataset, graph = string_graph("abc", "acb", "cab")
    mixed = Dataset("mixed", tuple(other_joints(c) if c.name == "take_1" else c for c in dataset.clips))
    route = find_route(mixed, graph, "0-2-1")  # seen only in the clip with other joints
    assert {link.exit.clip for link in route.links} == {"take_1"}
    walk = make_walk(mixed, graph, "2-0-1")
    assert all(p.source.clip != "take_1" for p in walk.parts)
    with pytest.raises(NoWay):
        find_route(mixed, graph, "0-2-0")


def test_a_walk_is_kept_whole() -> None:
    dataset, graph = demo()
    walk = make_walk(dataset, graph, Random(6, 0))
    document, arrays = pack_walk(walk)
    back = unpack_walk(document, arrays)
    assert (back.path, back.links, back.parts, back.seams) == (walk.path, walk.links, walk.parts, walk.seams)
    assert (back.skate, back.speeds, back.warnings) == (walk.skate, walk.speeds, walk.warnings)
    assert back.clip.skeleton == walk.clip.skeleton and np.array_equal(back.clip.rotations, walk.clip.rotations)
    with pytest.raises(ValueError, match="not a walk"):
        unpack_walk({"format": "something else"}, {})
