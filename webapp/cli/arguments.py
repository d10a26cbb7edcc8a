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
    reading_options(parser)
    points_options(parser)
    parser.add_argument("--clips", type=names, metavar="A,B,C", help="only the clips of these names")
    parser.add_argument("--labels", type=Path, metavar="FILE|DIR", help="labels: a CSV file or a folder of them")
    parser.add_argument("--seed", type=whole, default=0, metavar="N", help="start of random choices (default 0)")
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary")


def reading_options(parser: argparse.ArgumentParser) -> None:
    """What can be said about recordings beside what their files say, or of a dataset that is there already."""
    unit = "unit of length in the files: m, dm, cm, mm, in, ft, cmu, metres as a number, or auto (found from the body)"
    parser.add_argument("--unit", type=_unit, metavar="UNIT", help=unit)
    up = "axis that points up in the files: y, z, x, -y, -z, -x, or auto (found from the body)"
    parser.add_argument("--up", type=_up, metavar="AXIS", help=up)
    fps = "frames per second, in place of what the files say (AMC files say nothing: default 120)"
    parser.add_argument("--fps", type=_fps, metavar="N", help=fps)
    body = "which joints are which part of the body, as 'motionscape body' writes it"
    parser.add_argument("--body", type=Path, metavar="FILE.json", help=body)


def points_options(parser: argparse.ArgumentParser) -> None:
    """What can be said about files of points while they are read."""
    points = "joints of files of points: kinect1, kinect2, mediapipe, body25, coco, h36m, smpl22, smpl24, or auto"
    parser.add_argument("--points", type=_points, metavar="LIST", help=points)
    smooth = "smooth points: take out what is faster than HZ, such as the jitter of depth cameras (6)"
    parser.add_argument("--smooth", type=_fps, metavar="HZ", help=smooth)


def _points(text: str) -> str:
    from core.errors import ParameterError
    from core.mocap.points.naming import preset_called

    try:
        if text != "auto":
            preset_called(text)
    except ParameterError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return text


def _unit(text: str) -> str:
    from core.errors import ParameterError
    from core.mocap.units import metres_of

    try:
        metres_of(text)
    except ParameterError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return text


def _up(text: str) -> str:
    from core.errors import ParameterError
    from core.mocap.upright import axis_of

    try:
        axis_of(text)
    except ParameterError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return text


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


def names(text: str) -> list[str]:
    """Names separated by commas, for argparse; raises its error where there is none."""
    found = [name.strip() for name in text.split(",") if name.strip()]
    if not found:
        raise argparse.ArgumentTypeError("expected names of clips, separated by commas")
    return found


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
