"""Checks the arguments of a command that writes one result, then opens or computes it."""

from __future__ import annotations

from argparse import Namespace
from typing import Any

from core import analyses
from core.workspace import WorkspaceError
from webapp.cli.expected import say_expected
from webapp.cli.progress_bar import progress_bar
from webapp.cli.sources import open_source, say_left_out, stored_dataset


def result_of(arguments: Namespace, method: str) -> Any:
    """The result of ``method`` with the settings of the command: kept in the workspace where SOURCE is one of its
    datasets.

    Raises ParameterError, WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    values = {p.name: getattr(arguments, p.name) for p in analyses.parameters(method)}
    analyses.normalise(analyses.Request("", method, values))  # refuses before anything is read
    if arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out} is a folder; --out names the file to write.")
    named = stored_dataset(arguments)
    with progress_bar(arguments.quiet) as report:
        if named:
            workspace, name = named
            say_left_out(workspace.open(name), arguments.quiet)
            say_expected(request := analyses.Request(name, method, values), workspace, arguments.quiet)
            return analyses.run(workspace, request, report)
        dataset = open_source(arguments, report)
        say_left_out(dataset, arguments.quiet)
        say_expected(analyses.Request(dataset.name, method, values), dataset, arguments.quiet)
        return analyses.compute(dataset, method, values, report)
