"""Requests: equal ones have equal keys, are computed once, followed, cancelled and taken over."""

import multiprocessing
import os
import signal

import pytest

from core import analyses, requests
from core.analyses import Request
from core.errors import AnalysisError, ParameterError
from core.parameters import fill, parameters_of
from core.progress import Cancelled
from core.workspace import Workspace, WorkspaceError
from tests import toy_method
from tests.toy_method import ToyParameters, make_dataset

spawn = multiprocessing.get_context("spawn")  # a fork of a process that has used OpenMP cannot compute


@pytest.fixture
def workspace(tmp_path):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("toy", make_dataset())
    return workspace


@pytest.fixture(autouse=True)
def fresh_memory():
    analyses._results.clear()


def toy(**parameters):
    return Request("toy", "toy", {"seconds": 0} | parameters)


def test_equal_requests_have_equal_keys(workspace):
    def key(**parameters):
        return analyses.key(workspace, Request("toy", "motifs", parameters))

    assert key() == key(rho=1) == key(rho="1.0", kappa="AUTO", seed=0)
    assert len({key(), key(rho=2), key(kappa=100), key(seed=1)}) == 4
    assert key(kappa=100) == key(kappa="100") == key(kappa=100.0)


def test_the_key_covers_content_method_and_version(workspace, monkeypatch):
    first = analyses.key(workspace, toy())
    workspace.rename("toy", "renamed")
    assert analyses.key(workspace, Request("renamed", "toy", {"seconds": 0})) == first
    workspace.add_dataset("toy", make_dataset(seed=1))
    assert analyses.key(workspace, toy()) != first
    method = analyses.METHODS["toy"]
    monkeypatch.setitem(analyses.METHODS, "toy", analyses.Method("Toy", 2, *list(vars(method).values())[2:]))
    assert analyses.key(workspace, Request("renamed", "toy", {"seconds": 0})) != first


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({"kappa": "many"}, "auto or a whole number"),
        ({"kappa": 1}, "from 2"),
        ({"rho": float("nan")}, "a number from"),
        ({"rho": "1e999"}, "a number from"),
        ({"adjacency": "../x"}, "radius or spheres"),
        ({"seed": -1}, "at least 0"),
        ({"min_letters": 2.5}, "whole number"),
        ({"min_letters": 20, "max_letters": 10}, "must not exceed"),
        ({"colour": "red"}, "no such parameter"),
        ({"seed": True}, "whole number"),
        ({"kappa": None}, "expected"),
        ({"kappa": [1]}, "expected"),
    ],
)
def test_bad_parameters_are_refused_in_words(workspace, parameters, words):
    with pytest.raises(ParameterError, match=words):
        analyses.submit(workspace, Request("toy", "motifs", parameters))
    assert workspace.jobs.list() == []


def test_unknown_methods_and_data_sets_are_refused(workspace):
    with pytest.raises(ParameterError, match="no method"):
        analyses.submit(workspace, Request("toy", "magic"))
    with pytest.raises(WorkspaceError, match="no dataset"):
        analyses.run(workspace, Request("../toy", "toy"))


def test_every_parameter_of_every_method_says_what_it_is_for():
    for name in analyses.METHODS:
        if name != "toy":
            assert all(len(parameter.help) > 10 for parameter in analyses.parameters(name))
    assert parameters_of(ToyParameters)[0].expected == "a number from 0 to 600"
    assert fill(ToyParameters, {"seconds": "2"}) == {"seconds": 2.0, "mode": "count", "log": "", "gate": ""}


def test_a_result_is_computed_once_and_then_opened(workspace, tmp_path):
    request = toy(log=str(tmp_path / "log"))
    assert analyses.stored(workspace, request) is None
    result = analyses.run(workspace, request)
    assert result == {"frames": 81, "names": ["walk_0", "walk_1"]}
    assert analyses.stored(Workspace(workspace.path), request) == result
    assert analyses.run(workspace, request) == result
    assert (tmp_path / "log").read_text().count("\n") == 1
    (job,) = workspace.jobs.list()
    assert (job.state, job.title) == ("done", "Toy: toy")


def test_a_damaged_result_is_computed_again(workspace):
    result = analyses.run(workspace, toy())
    for damage in ("{", "[]"):
        analyses._results.clear()
        next(workspace.results.folder.rglob("*.json")).write_text(damage)
        assert analyses.stored(workspace, toy()) is None
        assert analyses.run(workspace, toy()) == result


def test_progress_reaches_the_caller_and_the_table(workspace):
    seen = []

    def report(stage, fraction):
        seen.append((stage, fraction, workspace.jobs.list()[0].stage))

    analyses.run(workspace, toy(seconds=1.0), report)
    assert {stage for stage, _, _ in seen} == {"opening", "counting"}
    assert "counting" in {noted for _, _, noted in seen}


def test_what_is_wrong_is_said_in_plain_words_and_details_go_to_the_log(workspace):
    with pytest.raises(AnalysisError, match=r"^These clips are too short\.$"):
        analyses.run(workspace, toy(mode="refuse"))
    with pytest.raises(AnalysisError) as fault:
        analyses.run(workspace, toy(mode="break"))
    assert "secret" not in str(fault.value) and "logs" in str(fault.value)
    first, second = workspace.jobs.list()
    assert (first.state, first.error) == ("failed", str(fault.value)) and second.state == "failed"
    log = (workspace.logs / f"job-{first.id}.log").read_text()
    assert "secret detail" in log and "Traceback" in log


def test_a_report_that_cancels_stops_the_work(workspace):
    def report(_stage, fraction):
        if fraction > 0.005:
            raise Cancelled

    with pytest.raises(Cancelled):
        analyses.run(workspace, toy(seconds=60), report)
    assert workspace.jobs.list()[0].state == "cancelled"
    assert analyses.stored(workspace, toy(seconds=60)) is None


def _run(path, request, outcome, under_way=None):
    def report(_stage, _fraction):
        if under_way:
            under_way.set()

    try:
        outcome.put(analyses.run(Workspace(path), request, report))
    except BaseException as error:
        outcome.put(repr(error))


def test_two_processes_that_ask_for_the_same_compute_it_once(workspace, tmp_path):
    gate = tmp_path / "gate"
    request, outcome = toy(gate=str(gate), log=str(tmp_path / "log")), spawn.Queue()
    waiting = [spawn.Event() for _ in range(3)]
    askers = [spawn.Process(target=_run, args=(workspace.path, request, outcome, event)) for event in waiting]
    for asker in askers:
        asker.start()
    assert all(event.wait(120) for event in waiting)
    gate.touch()
    results = [outcome.get(timeout=120) for _ in askers]
    for asker in askers:
        asker.join(120)
    assert results[0] == results[1] == results[2] == {"frames": 81, "names": ["walk_0", "walk_1"]}
    assert (tmp_path / "log").read_text().count("\n") == 1


def test_a_killed_worker_is_replaced_by_who_waits(workspace, tmp_path):
    gate = tmp_path / "gate"
    request, nothing, outcome = toy(gate=str(gate), log=str(tmp_path / "log")), spawn.Queue(), spawn.Queue()
    under_way, waiting = spawn.Event(), spawn.Event()
    first = spawn.Process(target=_run, args=(workspace.path, request, nothing, under_way))
    first.start()
    assert under_way.wait(120)
    second = spawn.Process(target=_run, args=(workspace.path, request, outcome, waiting))
    second.start()
    assert waiting.wait(120)
    os.kill(first.pid, signal.SIGKILL)
    gate.touch()
    assert outcome.get(timeout=120)["frames"] == 81
    first.join()
    second.join(120)
    assert (tmp_path / "log").read_text().count("\n") == 2
    assert [job.state for job in workspace.jobs.list()] == ["done", "failed"]


def test_anyone_can_cancel_and_everyone_who_waits_hears_of_it(workspace):
    request, outcome = toy(seconds=600), spawn.Queue()
    waiting = [spawn.Event(), spawn.Event()]
    askers = [spawn.Process(target=_run, args=(workspace.path, request, outcome, event)) for event in waiting]
    for asker in askers:
        asker.start()
    assert all(event.wait(120) for event in waiting)
    (job,) = workspace.jobs.list()
    workspace.jobs.cancel(job.id)
    assert [outcome.get(timeout=120) for _ in askers] == ["Cancelled()"] * 2
    for asker in askers:
        asker.join(120)
    assert workspace.jobs.get(job.id).state == "cancelled"


def test_renaming_and_deleting_do_not_disturb_a_running_analysis(workspace):
    def report(stage, _fraction):
        if stage == "counting" and workspace.datasets():
            workspace.rename("toy", "other")
            workspace.trash("other")

    assert analyses.run(workspace, toy(seconds=0.3), report)["frames"] == 81


def test_a_job_whose_data_set_changed_says_so(workspace):
    first, second = analyses.submit(workspace, toy()), analyses.submit(workspace, toy(seconds=0.1))
    workspace.remove_clips("toy", ["walk_0"])
    assert analyses.execute(workspace, workspace.jobs.claim(first.id))["frames"] == 81  # what was asked for
    workspace.empty_trash()
    with pytest.raises(AnalysisError, match="changed or removed"):
        analyses.execute(workspace, workspace.jobs.claim(second.id))


def test_an_upload_is_imported_as_a_job(workspace, tmp_path):
    from core.mocap.bvh import write_bvh

    clip = make_dataset().clips[0]
    write_bvh(tmp_path / "a.bvh", clip)
    token = workspace.uploads.create()
    workspace.uploads.add(token, "a.bvh", [(tmp_path / "a.bvh").read_bytes()])
    analyses.run(workspace, requests.import_request("uploaded", token))
    assert workspace.info("uploaded").clips == 1 and workspace.jobs.list()[0].state == "done"
    with pytest.raises(WorkspaceError, match="already"):
        analyses.submit(workspace, requests.import_request("uploaded", token))
    with pytest.raises(AnalysisError, match="no longer here"):
        analyses.run(workspace, requests.import_request("again", token))
    bad = workspace.uploads.create()
    workspace.uploads.add(bad, "a.bvh", [b"nothing of use"])
    with pytest.raises(AnalysisError, match=r"cannot be read: a\.bvh"):
        analyses.run(workspace, requests.import_request("bad", bad))
    with pytest.raises(AnalysisError, match="not a valid upload"):
        analyses.run(workspace, requests.import_request("bad", "../datasets"))


def test_what_comes_to_a_data_set_or_leaves_it_is_a_job(workspace):
    token = workspace.uploads.create()
    workspace.uploads.add(token, "a.csv", [b"clip,action\nwalk_1,sit\nwalk_0,stand\n"])
    analyses.run(workspace, requests.add_request("toy", token, labels="replace"))
    assert [label.action for label in workspace.open("toy").labels] == ["sit", "stand"]
    analyses.run(workspace, requests.remove_request("toy", ["walk_1"]))
    assert workspace.open("toy").names == ("walk_0",)
    for wrong in (requests.remove_request("toy", ["x"]), Request("toy", "remove", {"clips": "{"})):
        with pytest.raises(AnalysisError, match=r"no clip|not clear"):
            analyses.run(workspace, wrong)
    for wrong in (requests.remove_request("none", ["x"]), requests.add_request("none", token)):
        with pytest.raises(WorkspaceError, match="no dataset"):
            analyses.submit(workspace, wrong)
    titles = {job.title for job in workspace.jobs.list()}
    assert titles == {"Add to: toy", "Remove clips from: toy"}


def test_the_demo_comes_with_all_that_pages_show_asked_for(workspace):
    analyses.run(workspace, Request(analyses.DEMO, "demo", {"minutes": 0.5}))
    assert workspace.info("demo").labels > 0
    asked = [job for job in sorted(workspace.jobs.list(), key=lambda job: job.id) if job.request["method"] != "demo"]
    assert [job.request["method"] for job in asked] == ["motifs", "map", "search", "grammar"]
    assert {job.state for job in asked} == {"queued"}
    analyses.run(workspace, Request(analyses.DEMO, "map"))
    assert [request.method for request in analyses.missing(workspace, "demo")] == ["motifs", "search", "grammar"]


def test_motifs_are_the_same_from_memory_and_from_the_workspace(workspace):
    from core.demo import make_demo

    dataset = make_demo(0.5)
    workspace.add_dataset("short", dataset)
    request = Request("short", "motifs", {"kappa": 60})
    graph = analyses.run(workspace, request)
    assert graph.motifs
    analyses._results.clear()
    again = analyses.stored(workspace, request)
    assert again.to_json(dataset) | {"seconds": 0} == graph.to_json(dataset) | {"seconds": 0}
    memory = analyses.compute(workspace.open("short"), "motifs", {"kappa": 60})
    assert memory.to_json(dataset)["motifs"] == graph.to_json(dataset)["motifs"]


def test_a_task_is_not_a_result(workspace):
    assert analyses.stored(workspace, Request("demo", "demo")) is None
    assert toy_method.METHODS is analyses.METHODS
