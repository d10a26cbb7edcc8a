"""Tables of the documentation site that are read from the code, so that they are never out of date.

mkdocs calls :func:`on_page_markdown` for every page. ``<!-- settings: motifs -->`` becomes the settings of that method,
``<!-- all settings -->`` those of every method, and ``<!-- commands -->`` the arguments of every command.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator, Mapping
from typing import Any

SETTINGS = re.compile(r"<!-- settings: ([a-z-]+) -->")
ALL_SETTINGS = "<!-- all settings -->"
COMMANDS = "<!-- commands -->"


def on_page_markdown(markdown: str, **_: Any) -> str:
    """The text of a page with its tables in place; raises ParameterError for a method that does not exist."""
    markdown = SETTINGS.sub(lambda match: settings_table(match[1]), markdown)
    for marker, sections in ((ALL_SETTINGS, settings_sections), (COMMANDS, command_sections)):
        if marker in markdown:
            markdown = markdown.replace(marker, "\n".join(sections()))
    return markdown


def settings_sections() -> Iterator[str]:
    """Lines of one section for each method."""
    from core.analyses import METHODS

    for name, method in METHODS.items():
        yield f"## {name}\n\n{method.title}.\n\n{settings_table(name)}\n"


def settings_table(method: str) -> str:
    """A Markdown table of the settings of a method."""
    from core.analyses import parameters

    rows = ["| setting | default | values | meaning |", "|---|---|---|---|"]
    for parameter in parameters(method):
        if not parameter.help:  # part of a request that the program writes, not a person
            continue
        cells = (f"`{parameter.name}`", f"`{parameter.default}`", parameter.expected, parameter.help)
        rows.append(row(cells))
    return "\n".join(rows)


def command_sections() -> Iterator[str]:
    """Lines of one section for each command: what it does, how it is called, and its arguments."""
    for name, parser in parsers().items():
        usage = parser.format_usage().removeprefix("usage: ").rstrip()
        yield f"## {name}\n\n{parser.description}\n\n```text\n{usage}\n```\n"
        yield "| argument | meaning |\n|---|---|"
        for action in parser._actions:
            if not isinstance(action, argparse._HelpAction):
                yield row((f"`{spelled(action)}`", (action.help or "") % help_values(action)))
        yield ""


def parsers() -> dict[str, argparse.ArgumentParser]:
    """The parser of each command, by its name."""
    from webapp.cli.main import commands

    found = {}
    for name, command in commands().items():
        found[name] = argparse.ArgumentParser(
            prog=f"motionscape {name}", description=command.help, formatter_class=narrow
        )
        command.arguments(found[name])
    return found


def narrow(prog: str) -> argparse.HelpFormatter:
    """Lines that fit a page, however wide the terminal is."""
    return argparse.HelpFormatter(prog, width=80)


def spelled(action: argparse.Action) -> str:
    """An argument as one types it."""
    metavar = action.metavar if isinstance(action.metavar, str) else "|".join(map(str, action.choices or ()))
    value = metavar or ("" if action.nargs == 0 else action.dest.upper())
    return f"{', '.join(action.option_strings)} {value}".strip()


def help_values(action: argparse.Action) -> Mapping[str, Any]:
    """What a help text may refer to, such as ``%(default)s``."""
    return {"default": action.default, "choices": action.choices}


def row(cells: tuple[str, ...]) -> str:
    """One row of a Markdown table."""
    return "| " + " | ".join(" ".join(cell.split()).replace("|", "\\|") for cell in cells) + " |"
