"""Arguments of the commands: each function gives those of one command to its parser."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from webapp.cli.arguments import SOURCE_HELP, common, number, on_source, whole

motifs = on_source("motifs", "motifs.json")
stability = on_source("stability", "stability.json")


def compare(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``compare``."""
    parser.add_argument("first", type=Path, metavar="A.json", help="a result that motifs wrote")
    parser.add_argument("second", type=Path, metavar="B.json", help="another of the same recordings")
    parser.add_argument("--out", type=Path, metavar="comparison.json", help="file to write")
    parser.add_argument("--quiet", action="store_true", help="print nothing")


def walk(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``walk``."""
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    parser.add_argument(
        "--from", dest="graph", type=Path, required=True, metavar="motifs.json", help="the graph: a file of motifs"
    )
    parser.add_argument("--motifs", type=_ids, metavar="3,7,9", help="the way, motif by motif")
    parser.add_argument("--start", type=whole, metavar="N", help="motif to begin with")
    parser.add_argument("--target", type=whole, metavar="N", help="motif to come to from --start")
    parser.add_argument(
        "--by",
        choices=("fewest", "used"),
        default="fewest",
        help="in the fewest steps (default) or by the most-used edges",
    )
    parser.add_argument("--random", action="store_true", help="anywhere, for --seconds, with --seed")
    parser.add_argument(
        "--seconds", type=number, default=30.0, metavar="N", help="length of a random walk (default 30)"
    )
    parser.add_argument("--further", action="store_true", help="pass at good transition points inside motifs as well")
    parser.add_argument(
        "--gaps",
        choices=("refuse", "detour", "bridge"),
        default="refuse",
        help="where no edge leads on: refuse (default), go round by others, or bridge the gap by a blend",
    )
    parser.add_argument(
        "--dead-end", choices=("jump", "stop"), default="jump", help="what a random walk does there (default jump)"
    )
    parser.add_argument("--plain", action="store_true", help="blending alone: leave feet as they slide")
    parser.add_argument("--parts", type=Path, metavar="walk.json", help="write where every frame comes from")
    parser.add_argument("--out", type=Path, required=True, metavar="walk.bvh", help="file to write")
    common(parser)


def _ids(text: str) -> list[int]:
    if not re.fullmatch(r"\d{1,6}([,-]\d{1,6})*", text):
        raise argparse.ArgumentTypeError(f"{text[:60]!r}: expected numbers of motifs, such as 3,7,9")
    return [int(number) for number in re.split("[,-]", text)]
