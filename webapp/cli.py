"""The command ``motionscape``: reads the arguments, runs one command, turns errors into one clear line.

Exit codes: 0 success, 2 wrong usage or unreadable input, 130 interrupted, 1 a fault of ours. Only light modules are
imported here: each command imports what it needs when it runs, so that ``--help`` answers at once.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from importlib.metadata import PackageNotFoundError, version
from typing import NamedTuple, NoReturn

from webapp import arguments

DEBUG = "MOTIONSCAPE_DEBUG"  # set it to see tracebacks


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


def main(line: Sequence[str] | None = None) -> int:
    """Runs the command that the words of ``line`` (default: those of the process) ask for; the exit code."""
    line = list(sys.argv[1:] if line is None else line)
    name = "motionscape"
    try:
        asked = _parser(line).parse_args(line)
        name += f" {asked.command}"
        return COMMANDS[asked.command].run(asked)
    except BrokenPipeError:  # the reader of our output (head, less) has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except (KeyboardInterrupt, Exception) as error:
        if os.environ.get(DEBUG):
            raise
        words, code = _in_words(error)
        print(f"{name}: {words}", file=sys.stderr)
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


def _parser(line: Sequence[str]) -> Parser:
    parser = Parser(prog="motionscape", description="See what is inside a collection of motion capture.")
    parser.add_argument("--version", action="version", version=f"motionscape {_version()}")
    parts = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    chosen = next((word for word in line if not word.startswith("-")), None)
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


def _query_arguments(parser: argparse.ArgumentParser) -> None:
    from webapp.search_arguments import query_arguments

    query_arguments(parser)
    arguments.on_source("search", "hits.json")(parser)


def _grammar_arguments(parser: argparse.ArgumentParser) -> None:
    from webapp.grammar_arguments import grammar

    grammar(parser)


def _derive_arguments(parser: argparse.ArgumentParser) -> None:
    from webapp.grammar_arguments import derive

    derive(parser)


def _later(module: str, function: str) -> Callable[[argparse.Namespace], int]:
    def run(asked: argparse.Namespace) -> int:
        from importlib import import_module

        return getattr(import_module(module), function)(asked)

    return run


COMMANDS = {
    "serve": Command("Show a workspace in the browser.", arguments.serve, _later("webapp.serving", "serve")),
    "import": Command("Read recordings into a workspace.", arguments.import_, _later("webapp.commands", "import_")),
    "labels": Command(
        "Bring labels (CSV) to a dataset of a workspace.", arguments.labels, _later("webapp.label_commands", "labels")
    ),
    "inspect": Command(
        "Say of every file whether it can be read, and what is odd about it.",
        arguments.inspect,
        _later("webapp.commands", "inspect"),
    ),
    "demo": Command(
        "Write the demo dataset: labelled motion as BVH files.", arguments.demo, _later("webapp.commands", "demo")
    ),
    "map": Command(
        "Lay the postures of all recordings out on a map.",
        arguments.on_source("map", "map.json"),
        _later("webapp.map_commands", "map_"),
    ),
    "search": Command(
        "Find motions like one of a clip, by the whole body or the parts that matter.",
        _query_arguments,
        _later("webapp.search_commands", "search"),
    ),
    "export": Command(
        "Write features (npz, Parquet) or clips (BVH) for other tools.",
        arguments.export,
        _later("webapp.export_commands", "export"),
    ),
    "motifs": Command(
        "Find the motions that recur and how they follow one another.",
        arguments.on_source("motifs", "motifs.json"),
        _later("webapp.commands", "motifs"),
    ),
    "sweep": Command(
        "Find motifs over ranges of parameters, at about the price of a few.",
        arguments.sweep,
        _later("webapp.sweep_commands", "sweep"),
    ),
    "compare": Command(
        "Hold two results of the same recordings against each other.",
        arguments.compare,
        _later("webapp.compare_commands", "compare_files"),
    ),
    "stability": Command(
        "Measure how surely each motif is found again: with noise, other seeds, settings a step away.",
        arguments.on_source("stability", "stability.json"),
        _later("webapp.compare_commands", "measure_stability"),
    ),
    "walk": Command(
        "Make new motion along a path through a motif graph.", arguments.walk, _later("webapp.walk_commands", "walk")
    ),
    "grammar": Command(
        "Learn elementary actions and the rules of what follows what.",
        _grammar_arguments,
        _later("webapp.grammar_commands", "grammar"),
    ),
    "derive": Command(
        "Make new motion that obeys a grammar.", _derive_arguments, _later("webapp.grammar_commands", "derive_")
    ),
}

if __name__ == "__main__":
    sys.exit(main())
