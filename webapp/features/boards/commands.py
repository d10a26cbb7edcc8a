"""The command ``report``: a data set or a board as one file that others open without Motionscape."""

from __future__ import annotations

import sys
from argparse import Namespace
from pathlib import Path

from core import analyses
from core.workspace import Workspace, WorkspaceError, atomic_file
from webapp.cli.progress_bar import progress_bar
from webapp.cli.sources import named_dataset

ALWAYS = ("motifs", "map")  # computed for a report where they are missing


def report(arguments: Namespace) -> int:
    """Writes the report. Raises WorkspaceError, AnalysisError or OSError in plain words."""
    from webapp.features.boards.printing import find_browser, write_pdf
    from webapp.features.boards.report import make_report

    suffix = arguments.out.suffix.lower()
    if suffix not in (".html", ".htm", ".pdf") or arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out}: --out names a file .html or .pdf.")
    workspace, name = _dataset(arguments.source)
    if suffix == ".pdf":
        find_browser()  # before anything is computed
    with progress_bar(arguments.quiet) as progress:
        for method in ALWAYS:
            analyses.run(workspace, analyses.Request(name, method), progress)
        made = make_report(workspace, name, report=progress)
    if not arguments.quiet:
        for sentence in made.left_out:
            print(f"left out: {sentence}", file=sys.stderr)
        print(f"{made.size / 1e6:.1f} MB. {made.motion}", flush=True)
    if suffix == ".pdf":
        write_pdf(made.html, arguments.out)
    else:
        _write(arguments.out, made.html)
    if not arguments.quiet:
        print(f"written to {arguments.out}")
    return 0


def _dataset(source: str) -> tuple[Workspace, str]:
    named = named_dataset(source)
    if named is None:
        raise WorkspaceError(
            f"{source}: a report is made of a dataset of a workspace, WORKSPACE/NAME; import it first."
        )
    return named


def _write(path: Path, text: str) -> None:
    with atomic_file(path) as file:
        file.write(text.encode())
