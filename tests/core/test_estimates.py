"""Time and memory of a job, said before it starts."""

from __future__ import annotations

import json

import pytest

from core import analyses, estimates
from core.machine import MEMORY
from core.requests import Request
from core.workspace import Workspace
from core.workspace.costs import Cost
from tests import toy_method
from tests.toy_method import make_dataset


@pytest.fixture
def workspace(tmp_path):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("toy", make_dataset(n_frames=1800))  # two minutes, 30 frames a second
    return workspace


def prior(monkeypatch, **methods):
    monkeypatch.setattr(estimates, "_prior", lambda: methods)


def asked(**parameters):
    return analyses.normalise(Request("toy", "motifs", parameters))


def test_between_and_beyond_measured_points_growth_is_a_power(workspace, monkeypatch):
    prior(monkeypatch, motifs=[(1000, 10, 1e8), (100_000, 1000, 1e9)])
    amount = estimates.amount_of(workspace, asked())
    assert amount == pytest.approx(3601, abs=2)
    seconds, size = estimates.estimate(workspace, asked()).middle
    assert seconds == pytest.approx(37, rel=0.02) and 1.5e8 < size < 4e8
    twice = estimates.estimate(workspace, asked(analysis_fps=60)).middle
    assert twice[0] == pytest.approx(2 * seconds, rel=0.03)


def test_what_was_never_measured_has_no_estimate_until_it_ran_once(workspace, monkeypatch):
    prior(monkeypatch)
    assert estimates.estimate(workspace, asked()) is None
    amount = estimates.amount_of(workspace, asked())
    workspace.costs.add(Cost("motifs", "", amount, 40.0, 3e8))
    found = estimates.estimate(workspace, asked())
    assert found.measured == 1 and found.seconds[0] < 40 < found.seconds[1]


def test_jobs_on_this_machine_narrow_the_range_and_those_on_the_same_dataset_count_alone(workspace, monkeypatch):
    prior(monkeypatch, motifs=[(1000, 10, 1e8), (100_000, 1000, 1e9)])
    amount, own = estimates.amount_of(workspace, asked()), workspace.info("toy").fingerprint
    first = estimates.estimate(workspace, asked())
    for seconds in (70, 80, 76):
        workspace.costs.add(Cost("motifs", "another", amount, seconds, 2e8))
    learnt = estimates.estimate(workspace, asked())
    assert learnt.seconds[0] < 70 < 80 < learnt.seconds[1]
    assert learnt.seconds[1] / learnt.seconds[0] < first.seconds[1] / first.seconds[0]
    for _ in range(2):
        workspace.costs.add(Cost("motifs", own, amount, 8, 2e8))
    same = estimates.estimate(workspace, asked())
    assert same.seconds[0] < 8 < same.seconds[1] < 20 and same.measured == 2


def test_matching_everything_is_a_kind_of_its_own(workspace):
    assert estimates.kind_of(asked()) == "motifs"
    assert estimates.kind_of(asked(sample=0)) == estimates.kind_of(asked(seeding="random")) == "exact"
    assert "sample" in estimates.advice_for(asked(sample=0))


def test_a_sweep_is_as_many_analyses_as_it_has_points(workspace):
    sweep = analyses.normalise(Request("toy", "sweep", {"axes": "rho:0.5,1,2", "seeds": 2}))
    one = estimates.amount_of(workspace, asked())
    assert estimates.amount_of(workspace, sweep) == pytest.approx(6 * one)


def test_a_job_that_is_too_large_or_long_waits_until_someone_says_so(workspace, monkeypatch):
    prior(monkeypatch, motifs=[(3600, 5000, 1e8)])
    job = analyses.submit(workspace, asked(), ask=True)
    assert "This would take" in job.held and "fewer clips" in job.held
    assert workspace.jobs.claim_next(4) is None and workspace.jobs.newest_queued() is None
    workspace.jobs.release(job.id)
    assert workspace.jobs.claim_next(4).id == job.id
    prior(monkeypatch, motifs=[(3600, 5, 9e8)])
    monkeypatch.setenv(MEMORY, "0.5")
    assert "of memory" in analyses.submit(workspace, asked(rho=2.0), ask=True).held
    assert not analyses.submit(workspace, asked(rho=3.0)).held


def test_what_a_job_took_is_kept(tmp_path):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("toy", make_dataset())
    request = analyses.normalise(toy_method.request(seconds=0.3))
    analyses.run(workspace, request)
    (cost,) = workspace.costs.of("toy")
    assert cost.seconds >= 0.3 and cost.bytes > 1e6 and cost.amount == workspace.info("toy").frames


def test_shipped_points_grow():
    document = json.loads(estimates.PRIOR.read_text(encoding="utf-8"))
    for points in document["methods"].values():
        amounts, seconds, _ = zip(*points, strict=True)
        assert list(amounts) == sorted(amounts) and list(seconds) == sorted(seconds)


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        ((0.5, 3), "a few seconds"),
        ((20, 61), "20 to 61 s"),
        ((110, 300), "2 to 5 min"),
        ((4000, 9000), "67 min to 2 h"),
        ((40, 100), "40 s to 2 min"),
    ],
)
def test_spans_are_said_in_words(seconds, words):
    assert estimates.Estimate(seconds, (1e8, 1.3e9), 0).words == f"{words}, up to 1.3 GB"
