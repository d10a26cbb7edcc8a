"""Arguments of the commands ``report`` and ``import-bundle``."""

from __future__ import annotations

import argparse
from pathlib import Path


def report(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``report``."""
    parser.add_argument("source", metavar="WORKSPACE/NAME", help="a dataset of a workspace")
    parser.add_argument("--board", metavar="NAME", help="the board to write (default: an overview of the dataset)")
    parser.add_argument("--out", type=Path, required=True, metavar="report.html", help="file to write: .html or .pdf")
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary")
