"""Arguments of the command ``compare-groups``."""

from __future__ import annotations

import argparse
from pathlib import Path

from webapp.cli.arguments import SOURCE_HELP, common, names, number, whole


def compare_groups(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``compare-groups``."""
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    parser.add_argument("--by", required=True, metavar="COLUMN", help="property of clips that makes the groups")
    parser.add_argument(
        "--properties",
        type=Path,
        metavar="clips.csv",
        help="properties: clip, column, ... (default: the dataset's own)",
    )
    parser.add_argument(
        "--from",
        dest="result",
        type=Path,
        metavar="motifs.json|grammar.json",
        help="what is counted (default: labels of the dataset)",
    )
    parser.add_argument("--groups", type=names, metavar="A,B,C", help="values of COLUMN to compare (default: all)")
    parser.add_argument(
        "--subject", metavar="COLUMN", help="property that names who moves (default: one called subject, person ...)"
    )
    parser.add_argument("--map", action="store_true", help="compare where on a motion map the groups are as well")
    parser.add_argument(
        "--paired",
        choices=("auto", "yes", "no"),
        default="auto",
        help="compare subjects with themselves: auto where one is in several groups (default)",
    )
    parser.add_argument("--permutations", type=whole, default=1000, metavar="N", help="of each test (default 1000)")
    parser.add_argument("--resamples", type=whole, default=1000, metavar="N", help="for each interval (default 1000)")
    parser.add_argument("--alpha", type=number, default=0.05, metavar="P", help="level of a difference (default 0.05)")
    parser.add_argument(
        "--out", type=Path, required=True, metavar="groups.json|groups.csv", help="file to write, JSON or a table"
    )
    common(parser)
