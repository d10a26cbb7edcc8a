"""Arguments of the commands: each function gives those of one command to its parser."""

from __future__ import annotations

import argparse
from pathlib import Path

from webapp.cli.arguments import SOURCE_HELP, common, names, number, of_method, reading_options, whole


def import_(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``import``."""
    parser.add_argument("workspace", type=Path, metavar="WORKSPACE", help="folder of the workspace, made where missing")
    parser.add_argument("paths", nargs="+", type=Path, metavar="PATH", help="recordings, or folders of them")
    parser.add_argument("--name", help="name of the dataset (default: that of the first PATH)")
    parser.add_argument("--add", action="store_true", help="add to the dataset of that name, which is there already")
    common(parser)


def labels(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``labels``."""
    parser.add_argument("source", metavar="WORKSPACE/NAME", help="the dataset")
    parser.add_argument("paths", nargs="+", type=Path, metavar="FILE|DIR", help="labels: CSV files or folders of them")
    parser.add_argument("--replace", action="store_true", help="the labels that are there go")
    parser.add_argument("--quiet", action="store_true", help="no summary")


def properties(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``properties``."""
    parser.add_argument("source", metavar="WORKSPACE/NAME", help="the dataset")
    parser.add_argument("--table", type=Path, metavar="FILE.csv", help="read them from a CSV file: clip, column, ...")
    parser.add_argument("--names", metavar="PATTERN", help="read them from names of clips, as {subject}_{condition}_*")
    parser.add_argument("--preview", action="store_true", help="say what would be read and keep nothing")
    parser.add_argument("--out", type=Path, metavar="FILE.csv", help="write all properties to a CSV file")
    parser.add_argument("--quiet", action="store_true", help="no summary")


def inspect(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``inspect``."""
    parser.add_argument("paths", nargs="+", type=Path, metavar="PATH", help="recordings, or folders of them")
    parser.add_argument("--json", action="store_true", help="print JSON instead of lines")
    common(parser)


def reread(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``reread``."""
    parser.add_argument("source", metavar="WORKSPACE/NAME", help="the dataset")
    parser.add_argument("--clips", type=names, metavar="A,B,C", help="only the clips of these names")
    reading_options(parser)
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary")


def body(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``body``."""
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.json", help="file to write")
    common(parser)


def demo(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``demo``."""
    parser.add_argument("folder", type=Path, metavar="DIR", help="where to write, made where missing")
    parser.add_argument("--minutes", type=_minutes, default=6.0, help="length (default 6)")
    parser.add_argument("--seed", type=whole, default=0, metavar="N", help="the same seed gives the same bytes")
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary")


def evaluate(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``evaluate``."""
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    words = "what is scored: a file that motifs or grammar wrote"
    parser.add_argument("--from", dest="result", type=Path, required=True, metavar="RESULT.json", help=words)
    parser.add_argument("--track", default="actions", metavar="NAME", help="track of labels (default: actions)")
    parser.add_argument("--out", type=Path, required=True, metavar="scores.json", help="file to write")
    common(parser)


def export(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``export``."""
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    parser.add_argument(
        "--out",
        type=Path,
        required=True,
        metavar="FILE",
        help="features.npz, features.parquet, clip.bvh, clip.glb, or a folder",
    )
    parser.add_argument("--frames", type=_interval, metavar="START-END", help="only these frames of the clip (BVH)")
    of_method(parser, "features")
    common(parser)


def _minutes(text: str) -> float:
    value = number(text)
    if not 0.5 <= value <= 6000:
        raise argparse.ArgumentTypeError(f"{text!r}: expected minutes from 0.5 to 6000")
    return value


def _interval(text: str) -> tuple[int, int]:
    start, dash, end = text.partition("-")
    if not (dash and start.isdecimal() and end.isdecimal() and int(start) < int(end) < 10**9):
        raise argparse.ArgumentTypeError(f"{text!r}: expected START-END, frames of the clip, the end excluded")
    return int(start), int(end)
