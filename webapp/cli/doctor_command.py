"""The command ``doctor``: checks a workspace, repairs it, and says what it did."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from webapp.cli.progress_bar import progress_bar


def doctor_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``motionscape doctor``."""
    parser.add_argument("workspace", type=Path, metavar="WORKSPACE", help="folder of the workspace")
    parser.add_argument("--repair", action="store_true", help="repair what can be repaired; stop the server before")
    parser.add_argument("--quiet", action="store_true", help="no progress")


def doctor(arguments: argparse.Namespace) -> int:
    """Prints a line for each problem; 2 where one is left. Raises WorkspaceError."""
    from core.workspace.doctor import examine

    with progress_bar(arguments.quiet) as report:
        problems = examine(arguments.workspace, arguments.repair, report)
    for problem in problems:
        print(problem.words)
    left = sum(not problem.done for problem in problems)
    if not problems:
        print(f"{arguments.workspace}: everything is whole.")
    elif left:
        print(f"{left} of {len(problems)} problems are left.", file=sys.stderr)
    return 2 if left else 0
