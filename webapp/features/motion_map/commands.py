"""``motionscape map``: the postures of all recordings on a self-organising map."""

from __future__ import annotations

from argparse import Namespace

from webapp.cli.arguments import on_source
from webapp.cli.one_result import result_of
from webapp.cli.result_files import write_json

arguments = on_source("map", "map.json")


def map_(asked: Namespace) -> int:
    """Makes the map and writes map.json; prints the time of each stage and both errors.

    Raises ParameterError, WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    found = result_of(asked, "map")
    write_json(asked.out, found.to_json())
    if not asked.quiet:
        for stage, taken in found.seconds.items():
            print(f"  {stage:<14}{taken:8.2f} s")
        figures = (f"{name.replace('_', ' ')} {value:.3g}" for name, value in found.metrics.items())
        print(f"{found.grid[0]} x {found.grid[1]} nodes: {', '.join(figures)}")
        print(f"written to {asked.out}")
    return 0
