"""The command ``motifs``."""

from __future__ import annotations

import sys
import time
from argparse import Namespace
from collections.abc import Iterator
from typing import Any

from core.workspace import WorkspaceError
from webapp.cli.progress_bar import progress_bar
from webapp.cli.result_files import write_json

MB = 1024 * 1024


def motifs(arguments: Namespace) -> int:
    """Finds motifs and writes motifs.json; prints the time of each stage, kappa, the memory taken and the metrics."""
    from core import analyses
    from core.mocap.rigs import comparable
    from webapp.cli.expected import say_expected
    from webapp.cli.sources import open_source, say_left_out, stored_dataset

    values = {p.name: getattr(arguments, p.name) for p in analyses.parameters("motifs")}
    analyses.normalise(analyses.Request("", "motifs", values))  # refuses before anything is read
    if arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out} is a folder; --out names the file to write.")
    named = stored_dataset(arguments)
    started, notes = time.perf_counter(), {}
    with progress_bar(arguments.quiet) as report:
        if named:
            workspace, name = named
            dataset = workspace.open(name)
            read = time.perf_counter() - started
            request = analyses.Request(name, "motifs", values)
            say_expected(request, workspace, arguments.quiet)
            graph = analyses.run(workspace, request, report)
            by_id = {motif.id: motif.segments for motif in graph.motifs}
            notes = workspace.notes.of(workspace.info(name).id, analyses.key(workspace, request), by_id)
        else:
            dataset = open_source(arguments, report)
            read = time.perf_counter() - started
            say_expected(analyses.Request(dataset.name, "motifs", values), dataset, arguments.quiet)
            graph = analyses.compute(dataset, "motifs", values, report)
    say_left_out(dataset, arguments.quiet)
    dataset = comparable(dataset)
    write_json(arguments.out, graph.to_json(dataset, notes))
    if not arguments.quiet:
        print("\n".join(_motif_summary(dataset, graph, {"reading": read} | dict(graph.seconds), arguments)))
    return 0


def _motif_summary(dataset: Any, graph: Any, seconds: dict[str, float], arguments: Namespace) -> Iterator[str]:
    frames = sum(clip.n_frames for clip in dataset.clips)
    yield f"{len(dataset.clips)} clips, {frames} frames, {sum(clip.seconds for clip in dataset.clips):.1f} s of motion"
    for stage, duration in seconds.items():
        yield f"  {stage:<14}{duration:8.2f} s"
    yield f"  {'peak memory':<14}{_peak_memory() / MB:8.0f} MB"
    yield f"kappa {graph.parameters['kappa']}" + (" (auto)" if arguments.kappa == "auto" else "")
    yield ", ".join(f"{name.replace('_', ' ')} {_short(value)}" for name, value in graph.metrics.items())
    yield f"written to {arguments.out}"


def _peak_memory() -> float:
    """The largest memory of this process so far, in bytes."""
    if sys.platform == "win32":
        import psutil

        return float(psutil.Process().memory_info().peak_wset)
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else peak * 1024


def _short(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
