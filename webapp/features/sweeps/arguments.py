"""Arguments of the commands: each function gives those of one command to its parser."""

from __future__ import annotations

import argparse
from pathlib import Path

from webapp.cli.arguments import SOURCE_HELP, common, of_method, whole


def sweep(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``sweep``."""
    parser.description = (
        "Motif graphs over ranges of parameters: every option of motifs takes several values, separated by commas. "
        "Without any, kappa 50 to 2000 and rho .2 to 5 as in the 2008 paper."
    )
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    of_method(parser, "motifs", many=True)
    parser.add_argument("--seeds", type=whole, default=1, metavar="N", help="seeds at every point (default 1)")
    parser.add_argument(
        "--out", type=Path, required=True, metavar="sweep.csv", help="file to write (a row for each point)"
    )
    parser.add_argument("--plot", type=Path, metavar="DIR", help="write charts (SVG) into this folder as well")
    common(parser)
