"""A sweep gives what separate analyses give, shares their work, and can be stopped."""

from __future__ import annotations

import threading
from dataclasses import fields, replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.mocap.dataset import Dataset
from core.motifs import stages
from core.motifs.build import find_motifs
from core.motifs.graph import MotifGraph
from core.motifs.parameters import MotifParameters
from core.motifs.sweep import graphs_of, sweep
from core.progress import Cancelled
from tests.core.motifs.recordings import recurring

DATASET = recurring(1, n_clips=2, length=4)
BASE = MotifParameters(kappa=40)


def content(graph: MotifGraph) -> dict:
    """All of a graph but the time it took."""
    return graph.to_json() | {"seconds": None}


def calls(monkeypatch, name: str) -> list:
    """Notes every call of a function that the stages use."""
    seen, real = [], getattr(stages, name)

    def noted(*args, **more):
        seen.append(args)
        return real(*args, **more)

    monkeypatch.setattr(stages, name, noted)
    return seen


parameters = st.builds(
    MotifParameters,
    kappa=st.sampled_from(["auto", 30, 40]),
    rho=st.sampled_from([0.2, 1.0, 5.0]),
    gamma=st.sampled_from([1.2, 1.5]),
    adjacency=st.sampled_from(["radius", "spheres"]),
    pose=st.sampled_from(["angles", "positions"]),
    analysis_fps=st.sampled_from([15.0, 30.0]),
    seed=st.integers(0, 1),
    join=st.sampled_from([0.0, 0.8]),
    hold=st.sampled_from([0.0, 0.25]),
    tightness=st.sampled_from([0.0, 0.6]),
    seeding=st.sampled_from(["largest", "random"]),
    min_letters=st.sampled_from([3, 5]),
    strictness=st.sampled_from([0.5, 0.6]),
)


@settings(max_examples=12, deadline=None)
@given(st.lists(parameters, min_size=1, max_size=6), st.integers(1, 3))
def test_every_point_is_what_a_separate_analysis_finds(points, workers):
    found = dict(graphs_of(DATASET, points, workers=workers))
    assert sorted(found) == list(range(len(points)))
    for k, point in enumerate(points):
        assert content(found[k]) == content(find_motifs(DATASET, point))


def test_every_parameter_is_read_by_one_stage():
    """One that none reads would be shared by points that differ in it."""
    read = [name for stage in stages.STAGES for name in stage.reads]
    assert sorted(read) == sorted(f.name for f in fields(MotifParameters))


def test_work_in_common_is_done_once(monkeypatch):
    poses, letters = calls(monkeypatch, "pose_features"), calls(monkeypatch, "k_means")
    matchers, discoveries = calls(monkeypatch, "Matcher"), calls(monkeypatch, "largest_first")
    axes = {"adjacency": ("radius", "spheres"), "kappa": (20, 30, 40), "rho": (0.2, 0.5, 1.0, 5.0)}
    points = sweep(DATASET, BASE, axes, seeds=2)
    assert len(points) == len(discoveries) == 2 * 3 * 4 * 2
    assert (len(poses), len(letters), len(matchers)) == (1, 3 * 2, 2 * 3 * 2)
    assert sorted({(args[1], args[2]) for args in letters}) == [(k, s) for k in (20, 30, 40) for s in (0, 1)]


def test_points_come_one_after_another_and_in_the_end_in_order(monkeypatch):
    letters, seen = calls(monkeypatch, "k_means"), []
    for k, graph in graphs_of(DATASET, [replace(BASE, kappa=20 + k) for k in range(5)], workers=1):
        seen.append(k)
        assert graph.parameters["kappa"] == 20 + k
        assert len(letters) <= len(seen) + 1, "letters of points that nobody has asked for yet"
    assert seen == list(range(5))
    told = []
    points = sweep(DATASET, BASE, {"rho": (1.0, 0.2)}, seeds=2, on_point=told.append)
    assert [(p.parameters.rho, p.parameters.seed) for p in points] == [(1.0, 0), (1.0, 1), (0.2, 0), (0.2, 1)]
    assert sorted(map(id, told)) == sorted(map(id, points))


def test_progress_counts_points_and_never_falls():
    said = []
    sweep(DATASET, BASE, {"kappa": (20, 30)}, seeds=2, report=lambda stage, fraction: said.append((stage, fraction)))
    fractions = [fraction for _, fraction in said]
    assert fractions == sorted(fractions) and fractions[0] >= 0 and said[-1] == ("4 of 4 points", 1.0)
    assert ("0 of 4 points", 0.0) in said


def test_it_can_be_stopped_and_keeps_what_it_told():
    told = []

    def report(stage, fraction):
        if told:
            raise Cancelled

    before = threading.active_count()
    with pytest.raises(Cancelled):
        sweep(DATASET, BASE, {"kappa": tuple(range(10, 40))}, on_point=told.append, report=report)
    assert 1 <= len(told) < 30
    assert threading.active_count() == before


def test_a_consumer_that_leaves_stops_the_work():
    before = threading.active_count()
    graphs = graphs_of(DATASET, [replace(BASE, kappa=k) for k in range(10, 40)])
    next(graphs)
    graphs.close()
    assert threading.active_count() == before


def test_what_fails_in_a_thread_is_raised_here():
    before = threading.active_count()
    with pytest.raises(ValueError, match="no clips"):
        sweep(Dataset("empty", ()), BASE, {"rho": (0.2, 1.0)})
    assert threading.active_count() == before


def test_no_points_is_nothing():
    assert list(graphs_of(DATASET, [])) == []
