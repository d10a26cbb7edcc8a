"""Runs analyses: turns a request into its result, which is computed once and stored.

The command line, the app and its workers all come through here, so that the same request is computed once (across
threads and processes), its progress is seen by all, and anyone may cancel it.
"""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from core.caching import RecentCache
from core.errors import AnalysisError, ParameterError
from core.estimates import advice_for, counted, estimate
from core.grammar.table import TableParameters, part_report
from core.job_errors import failure, failure_elsewhere
from core.methods import METHODS, Method
from core.motifs.axes import SweepParameters
from core.parameters import Parameter as Parameter
from core.parameters import build, parameters_of
from core.progress import Cancelled, Report, silent
from core.requests import Request as Request
from core.requests import query_request
from core.workspace import (
    Job,
    ResultDamaged,
    Workspace,
    WorkspaceError,
    query_files,
    tasks,
    was_interrupted,
)
from core.workspace.people import Person, acting_as
from core.workspace.query_files import QueryFileParameters

if TYPE_CHECKING:
    from core.mocap.dataset import Dataset

DEMO = "demo"  # name of the embedded data set
EVERYTHING = ("motifs", "map", "search", "grammar")  # what pages show of a dataset, first what most of them need
_POLL = 0.1  # seconds between two looks at a job that another process works on


@dataclass(frozen=True)
class Task:
    """Something done to a workspace as a job that leaves a data set, or results of other requests.

    analyses: whether it works on a data set that is there already.
    """

    title: str
    parameters: type
    perform: Callable[[Workspace, str, Any, Report], None]
    analyses: bool = False


def parameters(method: str) -> tuple[Parameter, ...]:
    """The parameters of a method, for forms and command lines; raises ParameterError for an unknown method."""
    return parameters_of(_kind(method))


def normalise(request: Request) -> Request:
    """The request with all parameters, checked: equal requests become equal. Raises ParameterError."""
    filled = build(_kind(request.method), request.parameters)
    return Request(str(request.dataset), request.method, asdict(filled))


def compute(dataset: Dataset, method: str, values: Mapping[str, Any], report: Report = silent) -> Any:
    """The result of ``method`` on a data set in memory; nothing is kept. Raises ParameterError, AnalysisError."""
    built, extends = build(_kind(method), values), METHODS[method].extends
    if extends and extends(built):
        raise ParameterError("An earlier result can only be gone on from in the workspace that keeps it.")
    given = [compute(dataset, *need, report) for need in METHODS[method].needs(built)]
    return METHODS[method].compute(_comparable(dataset, method), built, report, *given)


def _comparable(dataset: Dataset, method: str) -> Dataset:
    """The clips that a method can compare: all of them, or the largest kind (core.mocap.rigs.left_out says which)."""
    from core.mocap.rigs import comparable

    return dataset if METHODS[method].all_kinds else comparable(dataset)


def key(workspace: Workspace, request: Request) -> str:
    """Hash of content, method with version, and parameters; raises ParameterError, WorkspaceError (no data set)."""
    request = normalise(request)
    if request.method in TASKS and not TASKS[request.method].analyses:
        return _digest(request.method, request.dataset, request.parameters)
    return result_key(workspace.info(request.dataset).fingerprint, request)


def result_key(fingerprint: str, request: Request) -> str:
    """The key of a normalised request about the data set with this content; :func:`key` for many without looking up."""
    version = METHODS[request.method].version if request.method in METHODS else 0
    return _digest(request.method, version, fingerprint, request.parameters)


def stored(workspace: Workspace, request: Request) -> Any | None:
    """The result if it has been computed, else None (also when its file was damaged: it has been set aside then).

    Raises ParameterError, WorkspaceError (no such data set).
    """
    if request.method in TASKS:
        return None
    return _load(workspace, request.method, key(workspace, request))


def kept(workspace: Workspace, method: str, result_key: str) -> Any | None:
    """The result of ``method`` under this key (:func:`key`), or None. Raises NameRefused for what is no key."""
    known = (workspace.path, method, result_key) in _results
    return _load(workspace, method, result_key) if known or _is_of(workspace, method, result_key) else None


def _is_of(workspace: Workspace, method: str, result_key: str) -> bool:
    """Whether what is stored under a key from outside can be a result of this method."""
    try:
        document_and_arrays = workspace.results.get(result_key)
    except ResultDamaged:
        return False
    kind = str(document_and_arrays[0].get("format", "")).split("/") if document_and_arrays else []
    return document_and_arrays is not None and (len(kind) < 2 or kind[1] not in METHODS or kind[1] == method)


def submit(workspace: Workspace, request: Request, *, ask: bool = False) -> Job:
    """Enters the request into the job table, or returns the active job for it; a worker computes it.

    ask: hold a job that would take very long or more memory than there is, until someone says that it shall start.

    Raises ParameterError, or WorkspaceError (no such data set, or for an import a name that is taken).
    """
    request = normalise(request)
    entry = asdict(request)
    kind = METHODS.get(request.method) or TASKS[request.method]
    if isinstance(kind, Method) or kind.analyses:
        entry["fingerprint"] = workspace.info(request.dataset).fingerprint
    elif request.method == "import":
        workspace.check_free(request.dataset)
    elif request.method in ("add", "remove", "edit", "reread", "repair"):
        workspace.info(request.dataset)  # raises where it is not there
    expected = estimate(workspace, request)
    held = expected.objection(advice_for(request)) if expected and ask else ""
    words = expected.words if expected else ""
    title = f"{kind.title}: {request.dataset}"
    return workspace.jobs.submit(key(workspace, request), entry, title, expected=words, held=held)


def expected_words(workspace: Workspace, request: Request) -> str:
    """What a request will take, in words; empty where nobody knows, or it cannot be used."""
    with suppress(ParameterError, WorkspaceError):
        expected = estimate(workspace, normalise(request))
        return expected.words if expected else ""
    return ""


def missing(workspace: Workspace, dataset: str) -> list[Request]:
    """What pages show of a dataset under the usual settings and has not been computed yet.

    Raises WorkspaceError where there is no such dataset.
    """
    requests = (Request(dataset, method) for method in EVERYTHING)
    return [request for request in requests if not workspace.results.has(key(workspace, request))]


def run(workspace: Workspace, request: Request, report: Report = silent) -> Any:
    """The result of the request: opened where it is stored, else computed here or awaited from another process.

    A worker that dies meanwhile is replaced. Raises ParameterError, WorkspaceError, AnalysisError; Cancelled when
    ``report`` raises it or someone cancels the job.
    """
    request = normalise(request)
    for _ in range(3):
        result = stored(workspace, request)
        if result is not None:
            return result
        job = submit(workspace, request)
        claimed = workspace.jobs.claim(job.id)
        if claimed:
            return execute(workspace, claimed, report)
        job = _await(workspace, job, report)
        if job.state == "cancelled":
            raise Cancelled
        if job.state == "failed" and not job.died:
            raise failure_elsewhere(workspace, job)
        if job.state == "done" and request.method in TASKS:
            return None
    raise AnalysisError("The worker of this analysis stopped again and again; see the logs of the workspace.")


def result_now(workspace: Workspace, request: Request, report: Report = silent) -> Any:
    """The result of a request that takes about a second: opened, or computed here and kept, without a job.

    Raises MotionscapeError where it cannot be.
    """
    request = normalise(request)
    return _made(workspace, workspace.open(request.dataset), request.method, request.parameters, report)


def execute(workspace: Workspace, job: Job, report: Report = silent) -> Any:
    """Does a claimed job in this process and writes its end into the table; the result (None for a task).

    Raises AnalysisError in plain words (LoggedBug where it is our fault; then the traceback is in the workspace's
    logs), or Cancelled.
    """
    with workspace.jobs.working(job.id) as note:

        def both(stage: str, fraction: float) -> None:
            note(stage, fraction)
            report(stage, fraction)

        try:
            with acting_as(Person(workspace.audit.who_started(job.id))):
                result = _perform(workspace, job, both)
        except (Cancelled, KeyboardInterrupt):
            workspace.jobs.stopped(job.id)
            raise
        except Exception as error:
            if was_interrupted(error):
                workspace.jobs.stopped(job.id)
                raise KeyboardInterrupt from error
            told = failure(workspace, job, error)
            workspace.jobs.fail(job.id, str(told))
            raise told from error
    workspace.jobs.finish(job.id)
    return result


def _perform(workspace: Workspace, job: Job, report: Report) -> Any:
    entry = job.request
    if entry["method"] in TASKS:
        task = TASKS[entry["method"]]
        name = workspace.open_fingerprint(entry["fingerprint"]).name if task.analyses else entry["dataset"]
        request = Request(name, entry["method"], entry["parameters"])
        with counted(workspace, request):
            task.perform(workspace, name, build(task.parameters, entry["parameters"]), report)
        return None
    result = _load(workspace, entry["method"], job.key)
    if result is None:  # otherwise someone finished it between the request and now
        method = METHODS[entry["method"]]
        report("opening", 0.0)
        dataset = workspace.open_fingerprint(entry["fingerprint"])
        with counted(workspace, Request(dataset.name, entry["method"], entry["parameters"])):
            result = _computed(workspace, dataset, entry["method"], entry["parameters"], report)
        workspace.results.put(job.key, *method.pack(result, dataset))
        _results.put((workspace.path, entry["method"], job.key), result)
    return result


def _computed(workspace: Workspace, dataset: Dataset, name: str, values: Mapping[str, Any], report: Report) -> Any:
    method = METHODS[name]
    built = build(method.parameters(), values)
    given = [_made(workspace, dataset, *need, report) for need in method.needs(built)]
    if method.extends and method.extends(built):
        given.append(_earlier(workspace, name, method.extends(built)))
    return method.compute(_comparable(dataset, name), built, report, *given)


def _earlier(workspace: Workspace, method: str, result_key: str) -> Any:
    """The result that another builds on. Raises AnalysisError where it no longer exists, or is of another method."""
    result = kept(workspace, method, result_key)
    if result is None:
        raise AnalysisError(f"{METHODS[method].title}: the earlier result is no longer there; compute it anew.")
    return result


def _made(workspace: Workspace, dataset: Dataset, method: str, values: Mapping[str, Any], report: Report) -> Any:
    """A result: opened, or computed in this thread and kept."""
    request = normalise(Request(dataset.name, method, values))
    made_key = result_key(dataset.fingerprint, request)
    result = _load(workspace, method, made_key)
    if result is None:
        result = _computed(workspace, dataset, method, request.parameters, report)
        workspace.results.put(made_key, *METHODS[method].pack(result, dataset))
        _results.put((workspace.path, method, made_key), result)
    return result


def _await(workspace: Workspace, job: Job, report: Report) -> Job:
    """Follows a job that another process works on until it has ended."""
    while job.alive:
        report(job.stage, job.fraction)
        time.sleep(_POLL)
        job = workspace.jobs.get(job.id) or job
    return job


def _load(workspace: Workspace, method: str, result_key: str) -> Any | None:
    place = workspace.path, method, result_key
    if (result := _results.get(place)) is not None:
        return result
    try:
        document_and_arrays = workspace.results.get(result_key)
        result = METHODS[method].unpack(*document_and_arrays) if document_and_arrays else None
    except ResultDamaged:
        return None
    except (ValueError, KeyError, TypeError, IndexError):  # whole, but not what this version writes
        workspace.results.remove(result_key)
        return None
    if result is not None:
        _results.put(place, result)
    return result


def _digest(*parts: object) -> str:
    return hashlib.blake2b(json.dumps(parts, sort_keys=True).encode(), digest_size=16).hexdigest()


def _kind(method: str) -> type:
    if method in METHODS:
        return METHODS[method].parameters()
    if method in TASKS:
        return TASKS[method].parameters
    raise ParameterError(f"There is no method {str(method)[:40]!r}; there are {', '.join(METHODS)}.")


_results: RecentCache[tuple[Path, str, str], Any] = RecentCache(16)  # by workspace, method and key


def _make_demo(workspace: Workspace, name: str, values: tasks.DemoParameters, report: Report) -> None:
    """Makes the demo data set where it is missing, and asks for what pages show of it."""
    from core.demo import make_demo

    if name not in {info.name for info in workspace.datasets()}:
        workspace.add_dataset(name, make_demo(values.minutes, values.seed, report), report)
    for request in missing(workspace, name):
        submit(workspace, request)


def _sweep(workspace: Workspace, name: str, values: SweepParameters, report: Report) -> None:
    """Computes the motif graphs of all points that are not there yet, each kept under the key of its own request."""
    from core.figures import keep_figures, read_figures
    from core.motifs.sweep import graphs_of

    dataset = workspace.open(name)
    points_by_key = {point_key(dataset.fingerprint, point): point for point in values.points()}
    there = read_figures(workspace, dataset, list(points_by_key))
    missing = [key for key, figures in zip(points_by_key, there, strict=True) if figures is None]
    points = [points_by_key[key] for key in missing]
    alike = _comparable(dataset, "motifs")
    for k, graph in graphs_of(alike, points, report, ready=len(points_by_key) - len(missing)):
        workspace.results.put(missing[k], *METHODS["motifs"].pack(graph, dataset))
        keep_figures(workspace, missing[k], graph, dataset)


def _grammar_table(workspace: Workspace, name: str, values: TableParameters, report: Report) -> None:
    """Computes the grammars for all numbers of terminals that are not there yet, each kept as its own result."""
    dataset, points = workspace.open(name), values.points()
    for number, point in enumerate(points):
        _made(workspace, dataset, "grammar", point, part_report(report, number, len(points)))


def point_key(fingerprint: str, point: Any) -> str:
    """The key of the motif graph with the MotifParameters ``point``, of the data set with this content."""
    return result_key(fingerprint, Request("", "motifs", asdict(point)))


def _report(workspace: Workspace, name: str, values: tasks.ReportParameters, report: Report) -> None:
    """Reports are written by the server, which enters them as jobs that it works on itself."""
    raise WorkspaceError("Only the app writes reports: ask for it again in the menu of the dataset or the board.")


def _read_query(workspace: Workspace, name: str, values: QueryFileParameters, report: Report) -> None:
    """Reads an uploaded recording and keeps it under the key of the request (core/workspace/query_files.py)."""
    query_files.read_query_file(workspace, key(workspace, query_request(name, values.upload)), values, report)


TASKS: dict[str, Task] = {
    "import": Task("Import", tasks.ImportParameters, tasks.import_upload),
    "add": Task("Add to", tasks.AddParameters, tasks.add_upload),
    "remove": Task("Remove clips from", tasks.RemoveParameters, tasks.remove_clips),
    "reread": Task("Change how clips are read in", tasks.RereadParameters, tasks.reread_clips),
    "repair": Task("Repair clips of", tasks.RepairParameters, tasks.repair_clips),
    "edit": Task("Edit a clip of", tasks.EditParameters, tasks.edit_clip),
    "report": Task("Report", tasks.ReportParameters, _report),
    "query": Task("Read", query_files.QueryFileParameters, _read_query),
    "demo": Task("Demo", tasks.DemoParameters, _make_demo),
    "sweep": Task("Sweep", SweepParameters, _sweep, analyses=True),
    "grammar-table": Task("Compare numbers of actions", TableParameters, _grammar_table, analyses=True),
}
