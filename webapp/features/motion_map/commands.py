"""``motionscape map``: the postures of all recordings on a self-organising map."""

from __future__ import annotations

from argparse import Namespace

from webapp.cli.arguments import on_source
from webapp.cli.one_result import result_of
from webapp.cli.result_files import write_json

arguments = on_source("map", "map.json")


def map_(arguments: Namespace) -> int:
    """Makes the map and writes map.json; prints the time of each stage and both errors.

    Raises ParameterError, WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    motion_map = result_of(arguments, "map")
    write_json(arguments.out, motion_map.to_json())
    if not arguments.quiet:
        for stage, taken in motion_map.seconds.items():
            print(f"  {stage:<14}{taken:8.2f} s")
        figures = (f"{name.replace('_', ' ')} {value:.3g}" for name, value in motion_map.metrics.items())
        print(f"{motion_map.grid[0]} x {motion_map.grid[1]} nodes: {', '.join(figures)}")
        print(f"written to {arguments.out}")
    return 0
