"""A sweep as a job: it leaves the results of its points, keeps what is done, does what is missing; figures beside."""

from __future__ import annotations

from dataclasses import replace

import pytest

from core import analyses, figures
from core.analyses import Request
from core.errors import ParameterError
from core.evaluation.coverage import score_motifs
from core.figures import METRICS, SCORES, figures_of, read_figures
from core.mocap.clip import Label
from core.motifs import stages
from core.motifs.axes import SweepParameters
from core.motifs.build import find_motifs
from core.motifs.parameters import MotifParameters
from core.progress import Cancelled
from core.workspace import Workspace, WorkspaceError
from tests.core.motifs.recordings import recurring

SWEEP = {"axes": "kappa:20,30;rho:0.2,1", "seeds": 2, "base": '{"hold": 0.1}'}
LABELS = (Label("clip0", 0, 60, "wave"), Label("clip1", 0, 60, "kick"))


@pytest.fixture
def workspace(tmp_path):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("moves", replace(recurring(1, n_clips=2, length=4), labels=LABELS))
    return workspace


@pytest.fixture(autouse=True)
def fresh_memory():
    analyses._results.clear()
    figures._known.clear()


def sweep(**parameters) -> Request:
    return Request("moves", "sweep", SWEEP | parameters)


def keys(workspace, request=None) -> list[str]:
    fingerprint = workspace.info("moves").fingerprint
    asked = analyses.normalise(request or sweep()).parameters
    return [analyses.point_key(fingerprint, point) for point in SweepParameters(**asked).points()]


def letters(monkeypatch) -> list:
    """Notes every clustering."""
    seen, real = [], stages.k_means

    def noted(*args, **more):
        seen.append(args)
        return real(*args, **more)

    monkeypatch.setattr(stages, "k_means", noted)
    return seen


def test_every_point_is_the_result_of_its_own_request(workspace):
    said = []
    analyses.run(workspace, sweep(), lambda stage, _: said.append(stage))
    assert "0 of 8 points" in said
    dataset = workspace.open("moves")
    for kappa in (20, 30):
        for rho in (0.2, 1.0):
            for seed in (0, 1):
                values = {"kappa": kappa, "rho": rho, "seed": seed, "hold": 0.1, "init": "random"}
                request = Request("moves", "motifs", values)
                graph = analyses.stored(workspace, request)
                assert analyses.key(workspace, request) in keys(workspace)
                separate = find_motifs(dataset, MotifParameters(**values))
                assert graph.to_json() | {"seconds": 0} == separate.to_json(dataset) | {"seconds": 0}
    job = workspace.jobs.list()[0]
    assert (job.state, job.title) == ("done", "Sweep: moves")


def test_a_second_sweep_does_what_is_missing(workspace, monkeypatch):
    analyses.run(workspace, sweep(axes="kappa:20;rho:0.2,1"))
    clustered, said = letters(monkeypatch), []
    analyses.run(workspace, sweep(), lambda stage, _: said.append(stage))
    assert sorted({args[1] for args in clustered}) == [30] and "4 of 8 points" in said
    clustered.clear()
    analyses.run(workspace, sweep())
    assert clustered == []


def test_a_cancelled_sweep_keeps_its_points(workspace):
    def report(_stage, fraction):
        if fraction > 0.4:
            raise Cancelled

    with pytest.raises(Cancelled):
        analyses.run(workspace, sweep(), report)
    assert workspace.jobs.list()[0].state == "cancelled"
    found = read_figures(workspace, workspace.open("moves"), keys(workspace))
    assert 0 < sum(f is not None for f in found) < 8
    analyses.run(workspace, sweep())
    assert None not in read_figures(workspace, workspace.open("moves"), keys(workspace))


def test_figures_are_read_without_opening_graphs(workspace, monkeypatch):
    analyses.run(workspace, sweep())
    figures._known.clear()
    monkeypatch.setattr(figures, "from_json", None)
    found = read_figures(workspace, workspace.open("moves"), [*keys(workspace), "0" * 32])
    assert found.pop() is None
    for key, entry in zip(keys(workspace), found, strict=True):
        graph = workspace.results.get(key).document
        assert {name: entry[name] for name in METRICS} == graph["metrics"]
        assert entry["kappa"] == graph["parameters"]["kappa"]
        assert entry["seconds"] == pytest.approx(sum(graph["seconds"].values()), abs=1e-3)
    assert read_figures(workspace, workspace.open("moves"), keys(workspace)) == found  # now from memory


def test_figures_of_graphs_that_no_sweep_made_and_of_changed_labels(workspace):
    graph = analyses.run(workspace, Request("moves", "motifs", {"kappa": 20}))
    key = analyses.key(workspace, Request("moves", "motifs", {"kappa": 20}))
    dataset = workspace.open("moves")
    (found,) = read_figures(workspace, dataset, [key])
    scores = score_motifs([motif.segments for motif in graph.motifs], LABELS)
    assert (found["purity"], found["f1_majority"]) == (scores.purity, scores.f1_majority)
    (one,) = read_figures(workspace, replace(dataset, labels=(Label("clip0", 0, 999, "all"),)), [key])
    assert one["purity"] == 1.0
    (none,) = read_figures(workspace, replace(dataset, labels=()), [key])
    assert not set(none) & set(SCORES) and none["coverage"] == graph.metrics["coverage"]
    assert figures_of(graph, LABELS) == pytest.approx(found, abs=1e-3)


def test_a_damaged_graph_has_no_figures_and_is_made_again(workspace):
    analyses.run(workspace, sweep())
    figures._known.clear()
    for path in (workspace.path / "results").rglob("*.json"):
        path.write_text("{")
    dataset = workspace.open("moves")
    assert read_figures(workspace, dataset, keys(workspace)) == [None] * 8
    analyses.run(workspace, sweep())
    assert None not in read_figures(workspace, dataset, keys(workspace))


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"axes": "kappa:1"}, "from 2"),
        ({"axes": "kappa"}, "name:value"),
        ({"axes": "kappa:20;kappa:30"}, "must be different"),
        ({"axes": "kappa:20", "base": "[1]"}, "JSON object"),
        ({"axes": "kappa:20", "base": "{"}, "JSON object"),
        ({"axes": "kappa:20", "base": '{"colour": 1}'}, "no such parameter"),
        ({"axes": "kappa:20", "seeds": 0}, "seeds"),
        ({"axes": "min_letters:5,60"}, "must not exceed"),
    ],
)
def test_sweeps_that_cannot_be_are_refused_before_a_job_is_entered(workspace, wrong, said):
    with pytest.raises(ParameterError, match=said):
        analyses.submit(workspace, Request("moves", "sweep", wrong))
    with pytest.raises(WorkspaceError):
        analyses.submit(workspace, Request("nothing", "sweep", SWEEP))
    assert workspace.jobs.list() == []


def test_equal_sweeps_are_one_job_and_renaming_does_not_disturb(workspace):
    first = analyses.submit(workspace, sweep())
    again = analyses.submit(workspace, sweep(axes=" kappa: 30 20,20; rho:1 .2", base='{"hold":0.10,"rho":2}'))
    assert first.id == again.id
    workspace.rename("moves", "renamed")
    analyses.execute(workspace, workspace.jobs.claim(first.id))
    assert workspace.jobs.get(first.id).state == "done"
