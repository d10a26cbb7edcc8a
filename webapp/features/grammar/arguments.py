"""Arguments of ``grammar`` and ``derive``."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from webapp.cli.arguments import SOURCE_HELP, common, of_method, whole


def grammar(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``grammar``."""
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    of_method(parser, "grammar", also={"n_terminals": "--terminals"})
    parser.add_argument("--out", type=Path, required=True, metavar="grammar.json", help="file to write")
    common(parser)


def derive(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``derive``."""
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    parser.add_argument(
        "--from", dest="grammar", type=Path, required=True, metavar="grammar.json", help="a file of grammar"
    )
    parser.add_argument(
        "--max-terminals", type=whole, default=40, metavar="N", help="actions of the sentence at most (default 40)"
    )
    parser.add_argument(
        "--sentence", type=_sentence, metavar="0.3.1", help="this one, by its rule indices, instead of one by chance"
    )
    parser.add_argument("--plain", action="store_true", help="blending alone: leave feet as they slide")
    parser.add_argument("--parts", type=Path, metavar="sentence.json", help="write where every frame comes from")
    parser.add_argument("--out", type=Path, required=True, metavar="sentence.bvh", help="file to write")
    common(parser)


def _sentence(text: str) -> str:
    if not re.fullmatch(r"\d{1,5}([.-]\d{1,5})*", text):
        raise argparse.ArgumentTypeError(f"{text[:60]!r}: expected rule indices, such as 0.3.1")
    return text
