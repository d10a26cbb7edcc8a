"""Arguments of ``motionscape search`` beside the parameters of the index."""

from __future__ import annotations

import argparse
from pathlib import Path

from core.errors import ParameterError
from core.poses.body_parts import normalise_weights
from webapp.cli.arguments import number, on_source


def search(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``search``."""
    query_arguments(parser)
    on_source("search", "hits.json")(parser)


def query_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the query, the parts of the body and the number of hits."""
    stretch = "CLIP[:START-END]"
    parser.add_argument("--query", metavar=stretch, help="what to search for: a clip, a stretch of one, or a file")
    parser.add_argument("--lower", metavar=stretch, help="take the legs from here and the rest from --query")
    parser.add_argument("--queries", type=Path, metavar="queries.json", help="many queries: a JSON list of them")
    parser.add_argument(
        "--words",
        action="append",
        metavar="TEXT",
        help="what to search for in words, such as 'walk then turn left'; may be given several times",
    )
    parser.add_argument(
        "--weights", type=_weights, metavar="PART=N,...", help="how much parts count: left_arm=.35,right_arm=.45,..."
    )
    parser.add_argument("--top", type=_top, metavar="N", help="hits (default: every clip, or 20 stretches)")
    parser.add_argument(
        "--level", choices=("clip", "interval"), help="whole clips (default for whole clips) or stretches of them"
    )
    parser.add_argument(
        "--root-path", type=_share, default=0.0, metavar="N", help="how much the path on the ground counts, 0 to 1"
    )


def _weights(text: str) -> dict[str, float]:
    weights: dict[str, float] = {}
    for entry in filter(None, (part.strip() for part in text.split(","))):
        name, _, value = entry.partition("=")
        weights[name.strip()] = weights.get(name.strip(), 0.0) + number(value)
    try:
        normalise_weights(weights)
    except ParameterError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return weights


def _top(text: str) -> int:
    if not text.isdecimal() or not 0 < int(text) < 10**9:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a whole number, at least 1")
    return int(text)


def _share(text: str) -> float:
    value = number(text)
    if not 0 <= value <= 1:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a number from 0 to 1")
    return value
