"""The command ``motionscape``: reads the arguments, runs one command, turns errors into one clear line.

Exit codes: 0 success, 2 wrong usage or unreadable input, 130 interrupted, 1 a bug. Only light modules are
imported here: each command imports what it needs when it runs, so that ``--help`` is fast.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import NoReturn

import webapp.features  # noqa: F401  registers the features
from webapp.shell.feature import Command, features, later

_USERS = "webapp.cli.user_commands"
DEBUG = "MOTIONSCAPE_DEBUG"  # set it to see tracebacks


class Parser(argparse.ArgumentParser):
    """A parser whose errors are one line."""

    def error(self, message: str) -> NoReturn:
        """Ends with exit code 2 after one line on stderr."""
        self.exit(2, f"{self.prog}: {message} (see {self.prog} --help)\n")


def main(line: Sequence[str] | None = None) -> int:
    """Runs the command that the words of ``line`` (default: those of the process) ask for; the exit code."""
    line = list(sys.argv[1:] if line is None else line)
    name = "motionscape"
    try:
        arguments = _parser(line).parse_args(line)
        name += f" {arguments.command}"
        return commands()[arguments.command].run(arguments)
    except BrokenPipeError:  # the program that reads the output (head, less) has ended
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except (KeyboardInterrupt, Exception) as error:
        if os.environ.get(DEBUG):
            raise
        words, code = _in_words(error)
        print(f"{name}: {words}", file=sys.stderr)
        return code


def _in_words(error: BaseException) -> tuple[str, int]:
    from core.errors import LoggedBug, MotionscapeError
    from core.progress import Cancelled
    from core.workspace import explain, was_interrupted
    from webapp.shell.advice import on_the_command_line

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
    if isinstance(error, MotionscapeError):
        return " ".join(on_the_command_line(str(error)).split()), 1 if isinstance(error, LoggedBug) else 2
    return _log_bug(error), 1


def _log_bug(error: BaseException) -> str:
    """Writes the traceback of an error that is not meant for people into a file; what to print, on one line."""
    import tempfile
    import traceback

    from core.errors import new_bug_id

    bug_id = new_bug_id()
    log = Path(tempfile.gettempdir(), f"motionscape-error-{bug_id}.log")
    where = f"{DEBUG}=1 shows where"
    with suppress(OSError):
        log.write_text("".join(traceback.format_exception(error)), encoding="utf-8")
        where = f"the details are in {log}"
    what = " ".join(f"{type(error).__name__}: {error}".split())
    return f"a fault in Motionscape, error {bug_id} ({what}); {where}"


def _parser(line: Sequence[str]) -> Parser:
    parser = Parser(prog="motionscape", description="See what is inside a collection of motion capture.")
    parser.add_argument("--version", action="version", version=f"motionscape {_version()}")
    parts = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    chosen = next((word for word in line if not word.startswith("-")), None)
    for name, command in commands().items():
        part = parts.add_parser(name, help=command.help, description=command.help, allow_abbrev=False)
        if name == chosen:  # the parameters of a method are read only for the command that was typed
            command.arguments(part)
    return parser


def _version() -> str:
    try:
        return version("motionscape")
    except PackageNotFoundError:
        return "(not installed)"


def commands() -> dict[str, Command]:
    """All commands by name: ``serve``, those about accounts, and those of the features."""
    commands_by_name = {
        "serve": Command("Show a workspace in the browser.", _serve_arguments, later("webapp.serving:serve")),
        "user": Command(
            "Add, list, remove or change the accounts of a workspace.",
            later(f"{_USERS}:user_arguments"),
            later(f"{_USERS}:user"),
        ),
        "audit": Command(
            "Say who changed what in a workspace, and when.",
            later(f"{_USERS}:audit_arguments"),
            later(f"{_USERS}:audit"),
        ),
        "doctor": Command(
            "Check everything in a workspace, and repair what can be repaired.",
            later("webapp.cli.doctor_command:doctor_arguments"),
            later("webapp.cli.doctor_command:doctor"),
        ),
    }
    for feature in features():
        commands_by_name.update(feature.commands)
    return commands_by_name


def _serve_arguments(parser: argparse.ArgumentParser) -> None:
    words = "folder of the workspace, made where missing (default: workspace)"
    parser.add_argument("workspace", nargs="?", default="workspace", type=Path, metavar="WORKSPACE", help=words)
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on (default 127.0.0.1: this machine)")
    parser.add_argument("--port", default=8050, type=_port, help="default 8050; 0 takes a free one")
    parser.add_argument("--demo", action="store_true", help="have the demo dataset and its motif graph there")
    parser.add_argument("--no-browser", action="store_true", help="do not open a browser")


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > 65535:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a port from 0 to 65535")
    return int(text)
