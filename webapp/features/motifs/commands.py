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


def motifs(asked: Namespace) -> int:
    """Finds motifs and writes motifs.json; prints the time of each stage, kappa, the memory taken and the metrics."""
    from core import analyses
    from webapp.cli.sources import named_dataset, open_source, refuse_reading_options

    values = {p.name: getattr(asked, p.name) for p in analyses.parameters("motifs")}
    analyses.normalise(analyses.Request("", "motifs", values))  # refuses before anything is read
    if asked.out.is_dir():
        raise WorkspaceError(f"{asked.out} is a folder; --out names the file to write.")
    named = named_dataset(asked.source)
    started, notes = time.perf_counter(), {}
    with progress_bar(asked.quiet) as report:
        if named and not asked.clips:
            refuse_reading_options(asked)
            workspace, name = named
            dataset = workspace.open(name)
            read = time.perf_counter() - started
            request = analyses.Request(name, "motifs", values)
            graph = analyses.run(workspace, request, report)
            found = {motif.id: motif.segments for motif in graph.motifs}
            notes = workspace.notes.of(workspace.info(name).id, analyses.key(workspace, request), found)
        else:
            dataset = open_source(asked, report)
            read = time.perf_counter() - started
            graph = analyses.compute(dataset, "motifs", values, report)
    write_json(asked.out, graph.to_json(dataset, notes))
    if not asked.quiet:
        print("\n".join(_motif_summary(dataset, graph, {"reading": read} | dict(graph.seconds), asked)))
    return 0


def _motif_summary(dataset: Any, graph: Any, seconds: dict[str, float], asked: Namespace) -> Iterator[str]:
    frames = sum(clip.n_frames for clip in dataset.clips)
    yield f"{len(dataset.clips)} clips, {frames} frames, {sum(clip.seconds for clip in dataset.clips):.1f} s of motion"
    for stage, taken in seconds.items():
        yield f"  {stage:<14}{taken:8.2f} s"
    yield f"  {'peak memory':<14}{_peak_memory() / MB:8.0f} MB"
    yield f"kappa {graph.parameters['kappa']}" + (" (auto)" if asked.kappa == "auto" else "")
    yield ", ".join(f"{name.replace('_', ' ')} {_short(value)}" for name, value in graph.metrics.items())
    yield f"written to {asked.out}"


def _peak_memory() -> float:
    """Bytes that this process has held at most."""
    try:
        import resource
    except ImportError:  # Windows
        import psutil

        return psutil.Process().memory_info().peak_wset
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else peak * 1024


def _short(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
