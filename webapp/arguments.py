"""The arguments of the commands: a function a command, which gives them to its parser.

Only light modules are imported here (see cli.py); a function named as a command takes that command's parser.
"""

from __future__ import annotations

import argparse
import re
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
    value = _number(text)
    if not 1 <= value <= 1000:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a frame rate from 1 to 1000")
    return value


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None


def whole(text: str) -> int:
    """A whole number, for argparse; raises its error for anything else."""
    if not text.isdecimal() or len(text) > 9:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a whole number, at least 0")
    return int(text)


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > 65535:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a port from 0 to 65535")
    return int(text)


def _names(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",") if name.strip()]
    if not names:
        raise argparse.ArgumentTypeError("expected names of clips, separated by commas")
    return names


def _minutes(text: str) -> float:
    value = _number(text)
    if not 0.5 <= value <= 6000:
        raise argparse.ArgumentTypeError(f"{text!r}: expected minutes from 0.5 to 6000")
    return value


def serve(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``serve``."""
    parser.add_argument("workspace", nargs="?", default="workspace", type=Path, metavar="WORKSPACE")
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on (default 127.0.0.1: this machine)")
    parser.add_argument("--port", default=8050, type=_port, help="default 8050; 0 takes a free one")
    parser.add_argument("--demo", action="store_true", help="have the demo dataset and its motif graph there")
    parser.add_argument("--no-browser", action="store_true", help="do not open a browser")


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


def inspect(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``inspect``."""
    parser.add_argument("paths", nargs="+", type=Path, metavar="PATH", help="recordings, or folders of them")
    parser.add_argument("--json", action="store_true", help="print JSON instead of lines")
    common(parser)


def demo(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``demo``."""
    parser.add_argument("folder", type=Path, metavar="DIR", help="where to write, made where missing")
    parser.add_argument("--minutes", type=_minutes, default=6.0, help="length (default 6)")
    parser.add_argument("--seed", type=whole, default=0, metavar="N", help="the same seed gives the same bytes")
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary")


def on_source(method: str, out: str) -> Callable[[argparse.ArgumentParser], None]:
    """Arguments of a command that computes ``method`` on SOURCE and writes a file such as ``out``."""

    def arguments(parser: argparse.ArgumentParser) -> None:
        parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
        of_method(parser, method)
        parser.add_argument("--out", type=Path, required=True, metavar=out, help="file to write")
        common(parser)

    return arguments


def sweep(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``sweep``."""
    parser.description = (
        "Motif graphs over ranges of parameters: every option of motifs takes several values, separated by commas. "
        "Without any, kappa 50 to 2000 and rho .2 to 5 as in the 2008 paper."
    )
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    of_method(parser, "motifs", many=True)
    parser.add_argument("--seeds", type=whole, default=1, metavar="N", help="seeds at every point (default 1)")
    parser.add_argument("--out", type=Path, required=True, metavar="sweep.csv", help="file to write, a row a point")
    parser.add_argument("--plot", type=Path, metavar="DIR", help="write charts (SVG) into this folder as well")
    common(parser)


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
        "--seconds", type=_number, default=30.0, metavar="N", help="length of a random walk (default 30)"
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


def export(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``export``."""
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    parser.add_argument(
        "--out", type=Path, required=True, metavar="FILE", help="features.npz, features.parquet, clip.bvh, or a folder"
    )
    parser.add_argument("--frames", type=_interval, metavar="START-END", help="only these frames of the clip (BVH)")
    of_method(parser, "features")
    common(parser)


def _interval(text: str) -> tuple[int, int]:
    start, dash, end = text.partition("-")
    if not (dash and start.isdecimal() and end.isdecimal() and int(start) < int(end) < 10**9):
        raise argparse.ArgumentTypeError(f"{text!r}: expected START-END, frames of the clip, the end excluded")
    return int(start), int(end)


def of_method(
    parser: argparse.ArgumentParser, method: str, many: bool = False, also: Mapping[str, str] | None = None
) -> None:
    """The parameters of a method as options, ``many``: with several values; the seed is among the common ones.

    also: parameter -> another name of its option."""
    from core.analyses import parameters
    from core.motifs.axes import read_values
    from core.parameters import Parameter, ParameterError

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
