"""Arguments that several commands share; those of one command stand in the folder of its feature.

Only light modules are imported here, so that ``--help`` is fast.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping
from pathlib import Path

SOURCE_HELP = "a folder of recordings (searched recursively), one file, or WORKSPACE/NAME"


def common(parser: argparse.ArgumentParser) -> None:
    """What every command that reads recordings accepts."""
    parser.add_argument("--skeleton", type=Path, metavar="FILE.asf", help="the skeleton of AMC files")
    parser.add_argument("--fps", type=_fps, metavar="N", help="frames per second of AMC files (default 120)")
    parser.add_argument("--clips", type=_names, metavar="A,B,C", help="only the clips of these names")
    parser.add_argument("--labels", type=Path, metavar="FILE|DIR", help="labels: a CSV file or a folder of them")
    parser.add_argument("--seed", type=whole, default=0, metavar="N", help="start of random choices (default 0)")
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary")


def _fps(text: str) -> float:
    value = number(text)
    if not 1 <= value <= 1000:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a frame rate from 1 to 1000")
    return value


def number(text: str) -> float:
    """A number, for argparse; raises its error for anything else."""
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None


def whole(text: str) -> int:
    """A whole number, for argparse; raises its error for anything else."""
    if not text.isdecimal() or len(text) > 9:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a whole number, at least 0")
    return int(text)


def _names(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",") if name.strip()]
    if not names:
        raise argparse.ArgumentTypeError("expected names of clips, separated by commas")
    return names


def on_source(method: str, out: str) -> Callable[[argparse.ArgumentParser], None]:
    """Arguments of a command that computes ``method`` on SOURCE and writes a file such as ``out``."""

    def arguments(parser: argparse.ArgumentParser) -> None:
        parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
        of_method(parser, method)
        parser.add_argument("--out", type=Path, required=True, metavar=out, help="file to write")
        common(parser)

    return arguments


def of_method(
    parser: argparse.ArgumentParser, method: str, many: bool = False, also: Mapping[str, str] | None = None
) -> None:
    """The parameters of a method as options, ``many``: with several values; the seed is among the common ones.

    also: parameter -> another name of its option."""
    from core.analyses import parameters
    from core.errors import ParameterError
    from core.motifs.axes import read_values
    from core.parameters import Parameter

    def reader(parameter: Parameter) -> Callable[[str], object]:
        def read(text: str) -> object:
            try:
                return read_values(parameter.name, text) if many else parameter.parse(text)
            except ParameterError as error:
                if many:
                    raise argparse.ArgumentTypeError(str(error)) from None
                raise argparse.ArgumentTypeError(f"{text[:60]!r}: expected {parameter.expected}") from None

        return read

    for parameter in parameters(method):
        if parameter.name == "seed":
            continue
        words = "|".join(map(str, parameter.words))
        names = [f"--{parameter.name.replace('_', '-')}", (also or {}).get(parameter.name)]
        parser.add_argument(
            *filter(None, names),
            dest=parameter.name,
            type=reader(parameter),
            default=(parameter.default,) if many else parameter.default,
            metavar="|".join(filter(None, [words, ("N,N" if many else "N") if parameter.kinds else ""])),
            help=f"{parameter.help} (default {parameter.default})".replace("%", "%%"),
        )
