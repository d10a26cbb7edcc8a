"""Copies, rare postures and the keep-list, against what a person would say by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.mocap import quaternions as quat
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import Motif, MotifGraph
from core.motifs.redundancy import (
    Copies,
    RedundancyParameters,
    from_json,
    keep_list,
    kept_segments,
    rare_postures,
    redundancy,
)
from core.poses.features import pose_features
from tests.webapp.generated import walk


def renamed(clip: Clip, name: str) -> Clip:
    return replace(clip, name=name)


@pytest.fixture(scope="module")
def dataset() -> Dataset:
    """A walk, two copies of it, a faster one, and one with an arm thrown up once."""
    odd = walk("odd", seconds=8.0, pace=1.3)
    arm = odd.skeleton.index("LeftArm")
    rotations = odd.rotations.copy()
    rotations[240:270, arm] = quat.from_rotvec(np.tile([0.0, 0.0, 2.6], (30, 1)))
    base = walk("a", seconds=8.0)
    clips = (base, renamed(base, "b"), renamed(base, "c"), walk("fast", seconds=8.0, pace=1.4))
    return Dataset("walks", (*clips, replace(odd, rotations=rotations)))


@pytest.fixture(scope="module")
def report(dataset):
    return redundancy(dataset, RedundancyParameters(kappa=60, min_letters=4))


def test_copies_are_found_and_one_of_each_stays(report, dataset):
    groups = [len(c.motions) for c in report.copies]
    assert groups and max(groups) >= 3
    assert 0.1 < report.metrics["copies"] < 1 and 0 < report.metrics["coverage"] <= 1


def test_the_copied_clips_are_not_worth_keeping(report):
    kept = {clip.clip for clip in report.clips if clip.keep}
    assert "odd" in kept and len(kept & {"a", "b", "c"}) <= 1
    assert sum(clip.gain < 0.5 for clip in report.clips if clip.clip in "abc") >= 2
    assert report.clips[-1].total == pytest.approx(1.0)
    totals = [clip.total for clip in report.clips]
    assert totals == sorted(totals)
    gains = [clip.gain for clip in report.clips]
    assert gains == sorted(gains, reverse=True)


def test_the_thrown_arm_is_the_rarest_posture(report):
    assert report.rare[0].clip == "odd" and 230 <= report.rare[0].frame <= 280
    assert report.rare[0].distance > 3


def test_the_report_reads_back(report):
    assert from_json(report.to_json()).to_json() == report.to_json()
    with pytest.raises(ValueError, match="format"):
        from_json({"format": "other"})


def test_rare_postures_agree_with_all_pairs(dataset):
    poses = pose_features(dataset, analysis_fps=10)
    clip = np.searchsorted(poses.clip_starts, np.arange(len(poses.values)), side="right") - 1
    lonely = []
    for i, value in enumerate(poses.values):
        others = [
            np.linalg.norm(value - poses.values[j])
            for j in range(len(poses.values))
            if clip[j] != clip[i] or abs(i - j) > 2.0 * poses.fps
        ]
        lonely.append(min(others))
    best = int(np.argmax(lonely))
    (found,) = rare_postures(poses, 1)
    assert found.clip == poses.clips[clip[best]]
    assert found.frame == poses.frame_of(clip[best], best - poses.clip_starts[clip[best]])
    assert found.distance == pytest.approx(lonely[best] / max(np.median(lonely), 1e-9), rel=1e-3)


def graph_of(*motifs: tuple[Segment, ...]) -> MotifGraph:
    made = tuple(Motif(i, segments, 0, tuple(np.zeros(3) for _ in segments)) for i, segments in enumerate(motifs))
    return MotifGraph(made, (), {"coverage": 0.5}, {})


def test_the_keep_list_by_hand():
    clips = tuple(walk(name, seconds=1.0, fps=60.0) for name in "xyz")
    graph = graph_of((Segment("x", 0, 60), Segment("y", 0, 60)), (Segment("z", 0, 30), Segment("y", 0, 0)))
    found = keep_list(Dataset("d", clips), graph, [Copies(0, (0, 1))])
    # x and y hold the same second; z has half a second of its own and half a second of a motif: all of it is new
    assert [(clip.clip, round(clip.gain, 6)) for clip in found] == [("x", 1.0), ("z", 1.0), ("y", 0.0)]
    assert [clip.keep for clip in found] == [True, True, False]
    assert [keep for _, _, keep in kept_segments(graph, (Copies(0, (0, 1)),))] == [True, False, True, True]
