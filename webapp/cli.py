"""The command ``motionscape``: reads the arguments, runs one command, turns errors into one clear line.

Exit codes: 0 success, 2 wrong usage or unreadable input, 130 interrupted, 1 a fault of ours. Only light modules are
imported here: each command imports what it needs when it runs, so that ``--help`` answers at once.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Callable, Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import NamedTuple, NoReturn

DEBUG = "MOTIONSCAPE_DEBUG"  # set it to see tracebacks
SOURCE_HELP = "a folder of recordings (searched recursively), one file, or WORKSPACE/NAME"


class Command(NamedTuple):
    """A command: what --help says of it, which arguments it takes, and what it does (the exit code)."""

    help: str
    arguments: Callable[[argparse.ArgumentParser], None]
    run: Callable[[argparse.Namespace], int]


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        """Ends with exit code 2 after one line on stderr."""
        self.exit(2, f"{self.prog}: {message} (see {self.prog} --help)\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command that ``arguments`` (default: those of the process) ask for; the exit code."""
    arguments = list(sys.argv[1:] if arguments is None else arguments)
    asked = _parser(arguments).parse_args(arguments)
    try:
        return COMMANDS[asked.command].run(asked)
    except BrokenPipeError:  # the reader of our output (head, less) has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except (KeyboardInterrupt, Exception) as error:
        if os.environ.get(DEBUG):
            raise
        words, code = _in_words(error)
        print(f"motionscape {asked.command}: {words}", file=sys.stderr)
        return code


def _in_words(error: BaseException) -> tuple[str, int]:
    from core.progress import Cancelled
    from core.workspace import explain, was_interrupted
    from webapp.advice import on_the_command_line

    if was_interrupted(error):
        return "stopped", 130
    if isinstance(error, Cancelled):
        return "cancelled", 130
    if isinstance(error, FileNotFoundError) and error.filename:
        return f"{error.filename}: no such file or folder", 2
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {explain(error)}", 2
    if isinstance(error, OSError | MemoryError):
        return explain(error), 2
    if isinstance(error, ValueError):  # RecordingError, WorkspaceError, ParameterError: written for people
        return " ".join(on_the_command_line(str(error)).split()), 2
    return f"a fault in Motionscape ({type(error).__name__}: {error}); {DEBUG}=1 shows where", 1


def _parser(arguments: Sequence[str]) -> Parser:
    parser = Parser(prog="motionscape", description="See what is inside a collection of motion capture.")
    parser.add_argument("--version", action="version", version=f"motionscape {_version()}")
    parts = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    chosen = next((word for word in arguments if not word.startswith("-")), None)
    for name, command in COMMANDS.items():
        part = parts.add_parser(name, help=command.help, description=command.help, allow_abbrev=False)
        if name == chosen:  # the parameters of a method are only read when they are asked for
            command.arguments(part)
    return parser


def _version() -> str:
    try:
        return version("motionscape")
    except PackageNotFoundError:
        return "(not installed)"


def _common(parser: argparse.ArgumentParser) -> None:
    """What every command that reads recordings accepts."""
    parser.add_argument("--skeleton", type=Path, metavar="FILE.asf", help="the skeleton of AMC files")
    parser.add_argument("--fps", type=_fps, metavar="N", help="frames per second of AMC files (default 120)")
    parser.add_argument("--clips", type=_names, metavar="A,B,C", help="only the clips of these names")
    parser.add_argument("--labels", type=Path, metavar="FILE|DIR", help="labels: a CSV file or a folder of them")
    parser.add_argument("--seed", type=_whole, default=0, metavar="N", help="start of random choices (default 0)")
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


def _whole(text: str) -> int:
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


def _serve_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("workspace", nargs="?", default="workspace", type=Path, metavar="WORKSPACE")
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on (default 127.0.0.1: this machine)")
    parser.add_argument("--port", default=8050, type=_port, help="default 8050; 0 takes a free one")
    parser.add_argument("--demo", action="store_true", help="have the demo dataset and its motif graph there")
    parser.add_argument("--no-browser", action="store_true", help="do not open a browser")


def _import_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("workspace", type=Path, metavar="WORKSPACE", help="folder of the workspace, made where missing")
    parser.add_argument("paths", nargs="+", type=Path, metavar="PATH", help="recordings, or folders of them")
    parser.add_argument("--name", help="name of the dataset (default: that of the first PATH)")
    parser.add_argument("--add", action="store_true", help="add to the dataset of that name, which is there already")
    _common(parser)


def _labels_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", metavar="WORKSPACE/NAME", help="the dataset")
    parser.add_argument("paths", nargs="+", type=Path, metavar="FILE|DIR", help="labels: CSV files or folders of them")
    parser.add_argument("--replace", action="store_true", help="the labels that are there go")
    parser.add_argument("--quiet", action="store_true", help="no summary")


def _inspect_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("paths", nargs="+", type=Path, metavar="PATH", help="recordings, or folders of them")
    parser.add_argument("--json", action="store_true", help="print JSON instead of lines")
    _common(parser)


def _demo_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("folder", type=Path, metavar="DIR", help="where to write, made where missing")
    parser.add_argument("--minutes", type=_minutes, default=6.0, help="length (default 6)")
    parser.add_argument("--seed", type=_whole, default=0, metavar="N", help="the same seed gives the same bytes")
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary")


def _motifs_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    _method_arguments(parser, "motifs")
    parser.add_argument("--out", type=Path, required=True, metavar="motifs.json", help="file to write")
    _common(parser)


def _sweep_arguments(parser: argparse.ArgumentParser) -> None:
    parser.description = (
        "Motif graphs over ranges of parameters: every option of motifs takes several values, separated by commas. "
        "Without any, kappa 50 to 2000 and rho .2 to 5 as in the 2008 paper."
    )
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    _method_arguments(parser, "motifs", many=True)
    parser.add_argument("--seeds", type=_whole, default=1, metavar="N", help="seeds at every point (default 1)")
    parser.add_argument("--out", type=Path, required=True, metavar="sweep.csv", help="file to write, a row a point")
    parser.add_argument("--plot", type=Path, metavar="DIR", help="write charts (SVG) into this folder as well")
    _common(parser)


def _compare_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("first", type=Path, metavar="A.json", help="a result that motifs wrote")
    parser.add_argument("second", type=Path, metavar="B.json", help="another of the same recordings")
    parser.add_argument("--out", type=Path, metavar="comparison.json", help="file to write")
    parser.add_argument("--quiet", action="store_true", help="print nothing")


def _stability_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    _method_arguments(parser, "stability")
    parser.add_argument("--out", type=Path, required=True, metavar="stability.json", help="file to write")
    _common(parser)


def _walk_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    parser.add_argument(
        "--from", dest="graph", type=Path, required=True, metavar="motifs.json", help="the graph: a file of motifs"
    )
    parser.add_argument("--motifs", type=_ids, metavar="3,7,9", help="the way, motif by motif")
    parser.add_argument("--start", type=_whole, metavar="N", help="motif to begin with")
    parser.add_argument("--target", type=_whole, metavar="N", help="motif to come to from --start")
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
    _common(parser)


def _ids(text: str) -> list[int]:
    if not re.fullmatch(r"\d{1,6}([,-]\d{1,6})*", text):
        raise argparse.ArgumentTypeError(f"{text[:60]!r}: expected numbers of motifs, such as 3,7,9")
    return [int(number) for number in re.split("[,-]", text)]


def _map_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    _method_arguments(parser, "map")
    parser.add_argument("--out", type=Path, required=True, metavar="map.json", help="file to write")
    _common(parser)


def _export_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    parser.add_argument(
        "--out", type=Path, required=True, metavar="FILE", help="features.npz, features.parquet, clip.bvh, or a folder"
    )
    parser.add_argument("--frames", type=_interval, metavar="START-END", help="only these frames of the clip (BVH)")
    _method_arguments(parser, "features")
    _common(parser)


def _interval(text: str) -> tuple[int, int]:
    start, dash, end = text.partition("-")
    if not (dash and start.isdecimal() and end.isdecimal() and int(start) < int(end) < 10**9):
        raise argparse.ArgumentTypeError(f"{text!r}: expected START-END, frames of the clip, the end excluded")
    return int(start), int(end)


def _method_arguments(parser: argparse.ArgumentParser, method: str, many: bool = False) -> None:
    """The parameters of a method as options, ``many``: with several values; the seed is among the common ones."""
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
        parser.add_argument(
            f"--{parameter.name.replace('_', '-')}",
            type=reader(parameter),
            default=(parameter.default,) if many else parameter.default,
            metavar="|".join(filter(None, [words, ("N,N" if many else "N") if parameter.kinds else ""])),
            help=f"{parameter.help} (default {parameter.default})".replace("%", "%%"),
        )


def _later(module: str, function: str) -> Callable[[argparse.Namespace], int]:
    def run(asked: argparse.Namespace) -> int:
        from importlib import import_module

        return getattr(import_module(module), function)(asked)

    return run


COMMANDS = {
    "serve": Command("Show a workspace in the browser.", _serve_arguments, _later("webapp.serving", "serve")),
    "import": Command("Read recordings into a workspace.", _import_arguments, _later("webapp.commands", "import_")),
    "labels": Command(
        "Bring labels (CSV) to a dataset of a workspace.", _labels_arguments, _later("webapp.label_commands", "labels")
    ),
    "inspect": Command(
        "Say of every file whether it can be read, and what is odd about it.",
        _inspect_arguments,
        _later("webapp.commands", "inspect"),
    ),
    "demo": Command(
        "Write the demo dataset: labelled motion as BVH files.", _demo_arguments, _later("webapp.commands", "demo")
    ),
    "map": Command(
        "Lay the postures of all recordings out on a map.", _map_arguments, _later("webapp.map_commands", "map_")
    ),
    "export": Command(
        "Write features (npz, Parquet) or clips (BVH) for other tools.",
        _export_arguments,
        _later("webapp.export_commands", "export"),
    ),
    "motifs": Command(
        "Find the motions that recur and how they follow one another.",
        _motifs_arguments,
        _later("webapp.commands", "motifs"),
    ),
    "sweep": Command(
        "Find motifs over ranges of parameters, at about the price of a few.",
        _sweep_arguments,
        _later("webapp.sweep_commands", "sweep"),
    ),
    "compare": Command(
        "Hold two results of the same recordings against each other.",
        _compare_arguments,
        _later("webapp.compare_commands", "compare_files"),
    ),
    "stability": Command(
        "Measure how surely each motif is found again: with noise, other seeds, settings a step away.",
        _stability_arguments,
        _later("webapp.compare_commands", "measure_stability"),
    ),
    "walk": Command(
        "Make new motion along a path through a motif graph.", _walk_arguments, _later("webapp.walk_commands", "walk")
    ),
}

if __name__ == "__main__":
    sys.exit(main())
