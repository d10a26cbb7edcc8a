"""The whole pipeline: what must hold for every result, odd inputs, wrong parameters, stopping, quality."""

from __future__ import annotations

import json
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.mocap.dataset import Dataset, open_dataset
from core.motifs.build import MotifParameters, find_motifs, motifs_of_poses
from core.motifs.graph import MotifGraph, from_json
from core.poses.features import pose_features
from core.progress import Cancelled
from tests.core.motifs.recordings import clip_of, recurring, still

QUICK = MotifParameters(kappa=60)


def content(graph: MotifGraph) -> set:
    """The motifs without their numbers."""
    return {frozenset(motif.segments) for motif in graph.motifs}


def check(graph: MotifGraph, dataset: Dataset) -> None:
    frames = {clip.name: np.zeros(clip.n_frames, int) for clip in dataset.clips}
    for motif in graph.motifs:
        assert motif.n_motions >= 2 and 0 <= motif.medoid < motif.n_motions
        for segment, warp in zip(motif.segments, motif.warps, strict=True):
            assert 0 <= segment.start < segment.end <= dataset.clip(segment.clip).n_frames
            frames[segment.clip][segment.start : segment.end] += 1
            assert len(warp) == motif.segments[motif.medoid].n_frames
            assert (np.diff(warp) >= 0).all() and warp[0] >= 0 and warp[-1] <= segment.n_frames - 1
    assert max((f.max() for f in frames.values()), default=0) <= 1
    covered = sum((f > 0).sum() for f in frames.values()) / dataset.n_frames
    assert graph.metrics["coverage"] == pytest.approx(covered)
    for edge in graph.edges:
        assert edge.count == len(edge.transitions) > 0
        ends = {(s.clip, s.end) for s in graph.motifs[edge.source].segments}
        starts = {(s.clip, s.start) for s in graph.motifs[edge.target].segments}
        for t in edge.transitions:
            assert (t.clip, t.start) in ends and (t.clip, t.end) in starts
            assert frames[t.clip][t.start : t.end].sum() == 0
    in_clip = [sum(s.clip == clip.name for m in graph.motifs for s in m.segments) for clip in dataset.clips]
    assert sum(edge.count for edge in graph.edges) == sum(max(n - 1, 0) for n in in_clip)


@settings(max_examples=12, deadline=None)
@given(
    seed=st.integers(0, 10**4),
    adjacency=st.sampled_from(["radius", "spheres"]),
    seeding=st.sampled_from(["largest", "random"]),
    rates=st.sampled_from([(30, 30), (120, 30), (60, 25), (30, 60)]),
)
def test_motions_and_edges_are_real(seed, adjacency, seeding, rates):
    dataset = recurring(seed, n_clips=2, length=4, fps=rates[0])
    check(find_motifs(dataset, replace(QUICK, adjacency=adjacency, seeding=seeding, analysis_fps=rates[1])), dataset)


def test_recurring_actions_are_found_and_kept_apart():
    dataset = Dataset(
        "two", tuple(clip_of(n, a, np.random.default_rng(ord(n))) for n, a in [("a", [0, 1, 0]), ("b", [1, 0, 1])])
    )
    graph = find_motifs(dataset, replace(QUICK, kappa=40))
    assert graph.metrics["coverage"] > 0.6
    assert max(motif.n_motions for motif in graph.motifs) >= 3
    assert graph.metrics["average_frame_error"] < 0.35 * graph.metrics["mean_pose_distance"]


@pytest.mark.parametrize("seeding", ["largest", "random"])
def test_order_of_the_clips_and_a_second_run_change_nothing(seeding):
    dataset, parameters = recurring(1), replace(QUICK, seeding=seeding)
    turned = Dataset("turned", dataset.clips[::-1])
    graphs = [find_motifs(d, parameters) for d in (dataset, dataset, turned)]
    assert content(graphs[0]) and content(graphs[0]) == content(graphs[1]) == content(graphs[2])


def test_graph_survives_json():
    dataset = recurring(2)
    graph = find_motifs(dataset, QUICK)
    document = json.loads(json.dumps(graph.to_json(dataset)))
    back = from_json(document)
    assert back.to_json() == graph.to_json()
    assert content(back) == content(graph) and back.components("weak") == graph.components("weak")
    assert document["clips"][0] == {"name": "clip0", "frames": dataset.clips[0].n_frames, "fps": 30.0}


@pytest.mark.parametrize("document", [None, {}, {"format": "motionscape/map/1"}, {"format": "motionscape/motifs/1"}])
def test_other_documents_are_refused(document):
    with pytest.raises(ValueError, match="motif graph"):
        from_json(document)


def test_components_of_a_known_graph():
    graph = find_motifs(recurring(3), QUICK)
    ids = sorted(m.id for m in graph.motifs)
    for connection in ("strong", "weak"):
        assert sorted(i for group in graph.components(connection) for i in group) == ids
    assert len(graph.components("weak")) <= len(graph.components("strong"))
    with pytest.raises(ValueError, match="connection"):
        graph.components("loose")


@pytest.mark.parametrize(
    "clips",
    [
        [still(3)],
        [still(1)],
        [still(200)],
        [still(40, "a"), still(40, "b")],
        [clip_of(n, [0, 1, 2], np.random.default_rng(0)) for n in "abc"],
        [clip_of("a", [0], np.random.default_rng(0)), still(1, "b")],
    ],
    ids=["three frames", "one frame", "no movement", "two still", "all clips equal", "a clip of one frame"],
)
@pytest.mark.parametrize("adjacency", ["radius", "spheres"])
def test_odd_collections(clips, adjacency):
    dataset = Dataset("odd", tuple(clips))
    graph = find_motifs(dataset, MotifParameters(adjacency=adjacency))
    check(graph, dataset)
    assert np.isfinite(list(graph.metrics.values())).all()
    from_json(json.loads(json.dumps(graph.to_json(), allow_nan=False)))


def test_equal_clips_share_their_motions():
    dataset = Dataset("equal", tuple(clip_of(n, [0, 1, 2], np.random.default_rng(0)) for n in "abc"))
    graph = find_motifs(dataset)
    assert graph.metrics["coverage"] > 0.9 and graph.metrics["average_frame_error"] == pytest.approx(0, abs=1e-4)


def test_no_clips_is_said():
    with pytest.raises(ValueError, match="no clips"):
        find_motifs(Dataset("empty", ()))


@pytest.mark.parametrize(
    "wrong",
    [
        {"kappa": 1}, {"kappa": "many"}, {"kappa": 2.5}, {"rho": 0}, {"rho": float("nan")}, {"gamma": 0.5},
        {"min_letters": 1},
        {"min_letters": 9, "max_letters": 8}, {"adjacency": "cubes"}, {"pose": "mood"}, {"analysis_fps": 0},
        {"seed": -1}, {"strictness": "high"}, {"min_letters": True},
    ],
    ids=str,
)  # fmt: skip
def test_wrong_parameters_name_themselves(wrong):
    with pytest.raises(ValueError, match=next(iter(wrong))):
        MotifParameters(**wrong)


def test_every_parameter_explains_itself():
    for f in fields(MotifParameters):
        assert len(f.metadata["help"]) > 20
        assert f.metadata["choices"] or f.metadata["min"] is not None


@pytest.mark.parametrize("stage", ["poses", "quantisation", "matching", "discovery", "alignment"])
def test_it_can_be_stopped_at_every_stage(stage):
    def stop(now, fraction):
        assert 0 <= fraction <= 1
        if now == stage:
            raise Cancelled

    with pytest.raises(Cancelled):
        find_motifs(recurring(0), QUICK, stop)


@pytest.mark.slow
def test_trends_of_the_paper(shared_data):
    """Figures 5 and 6: error and coverage fall as kappa rises; motions a motif fall as rho rises."""
    poses = pose_features(_exercises(shared_data))
    few, many = (motifs_of_poses(poses, MotifParameters(kappa=k, adjacency="spheres")).metrics for k in (150, 800))
    assert many["average_frame_error"] < few["average_frame_error"] and many["coverage"] < few["coverage"]
    short, long = (motifs_of_poses(poses, MotifParameters(rho=rho)).metrics for rho in (0.2, 5.0))
    assert long["mean_motions"] < short["mean_motions"] and long["mean_frames"] > short["mean_frames"]


@pytest.mark.slow
def test_quality_floor(shared_data):
    """Default setting, median of eight seeds, against the labels; the error ratio is the benchmark's business."""
    from core.evaluation.coverage import score_motifs
    from core.mocap.labels import read_labels

    dataset, labels = _exercises(shared_data), read_labels(shared_data / "labels" / "mocap6")
    poses = pose_features(dataset)
    graphs = [motifs_of_poses(poses, MotifParameters(seed=s)) for s in range(8)]
    scores = np.median([score_motifs([m.segments for m in g.motifs], labels) for g in graphs], axis=0)
    assert scores[0] >= 0.79 and scores[1] >= 0.975 and scores[3] >= 0.83
    ratios = [g.metrics["average_frame_error"] / g.metrics["mean_pose_distance"] for g in graphs]
    assert np.median(ratios) <= 0.24


def _exercises(shared_data) -> Dataset:
    folder = shared_data / "cmu" / "asfamc"
    clips = "13_29,13_30,13_31,14_14,14_20"
    return open_dataset([folder / "13", folder / "14"], skeleton=folder / "86" / "86.asf", clips=clips)
