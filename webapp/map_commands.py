"""``motionscape map``: the postures of all recordings on a self-organising map."""

from __future__ import annotations

from argparse import Namespace

from core import analyses
from core.workspace import WorkspaceError
from webapp.commands import write_json
from webapp.progress_bar import progress_bar
from webapp.sources import named_dataset, open_source, refuse_reading_options


def map_(asked: Namespace) -> int:
    """Makes the map and writes map.json; prints the time of each stage and both errors.

    Raises ParameterError, WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    values = {p.name: getattr(asked, p.name) for p in analyses.parameters("map")}
    analyses.normalise(analyses.Request("", "map", values))  # refuses before anything is read
    if asked.out.is_dir():
        raise WorkspaceError(f"{asked.out} is a folder; --out names the file to write.")
    named = named_dataset(asked.source)
    with progress_bar(asked.quiet) as report:
        if named and not asked.clips:
            refuse_reading_options(asked)
            workspace, name = named
            found = analyses.run(workspace, analyses.Request(name, "map", values), report)
        else:
            found = analyses.compute(open_source(asked, report), "map", values, report)
    write_json(asked.out, found.to_json())
    if not asked.quiet:
        for stage, taken in found.seconds.items():
            print(f"  {stage:<14}{taken:8.2f} s")
        figures = (f"{name.replace('_', ' ')} {value:.3g}" for name, value in found.metrics.items())
        print(f"{found.grid[0]} x {found.grid[1]} nodes: {', '.join(figures)}")
        print(f"written to {asked.out}")
    return 0
