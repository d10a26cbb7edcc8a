"""Arguments of the commands ``report`` and ``import-bundle``."""

from __future__ import annotations

import argparse
from pathlib import Path


def report(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``report``."""
    parser.add_argument("source", metavar="WORKSPACE/NAME", help="a dataset of a workspace")
    parser.add_argument("--board", metavar="NAME", help="the board to write (default: an overview of the dataset)")
    words = "file to write: .html, .pdf, or .zip for a bundle that another workspace takes over"
    parser.add_argument("--out", type=Path, required=True, metavar="report.html", help=words)
    parser.add_argument("--features-only", action="store_true", help="a bundle without the recordings themselves")
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary")


def import_bundle(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``import-bundle``."""
    parser.add_argument("workspace", type=Path, metavar="WORKSPACE", help="the workspace that takes it over")
    parser.add_argument("bundle", type=Path, metavar="bundle.zip", help="what “report --out bundle.zip” wrote")
    parser.add_argument("--name", metavar="NAME", help="another name for the dataset")
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary")
