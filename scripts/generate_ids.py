"""Writes the ids and shapes that Python declares for the modules of the browser: ``assets/*/ids.mjs``.

``python -m scripts.generate_ids`` writes the files; with ``--check`` it fails where one is not up to date.
"""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType, NoneType, UnionType
from typing import Any, Literal, Union, get_args, get_origin, is_typeddict

from webapp.shell.identifiers import Pattern, Store, constant, declared
from webapp.shell.shapes import keys

REPOSITORY = Path(__file__).resolve().parents[1]
FEATURES = ("library", "clip", "motifs", "sweeps", "motion_map", "search", "grammar", "groups", "boards")
# folder of assets -> the module whose names it gets; every room may import "shared"
ROOMS = {"shared": "webapp.shell.names", "jobs": "webapp.jobs.names", "stage": "webapp.stage.names"} | {
    name: f"webapp.features.{name}.names" for name in FEATURES
}
STORE_ID = "/** The id of a store that holds a T. @template T @typedef {string & { content?: T }} StoreId */"
_PLAIN = {NoneType: "null", bool: "boolean", int: "number", float: "number", str: "string", Any: "any"}


def ids_of(room: str) -> str:
    """The text of ``assets/<room>/ids.mjs``."""
    module = import_module(ROOMS[room])
    lines = [
        "// Ids of components, and the shapes of stores and of answers. Written by scripts/generate_ids.py from",
        f"// {ROOMS[room]}: change that module and run `make bundle`.",
        *(["", STORE_ID] if room == "shared" else ['/** @import { StoreId } from "../shared/ids.mjs" */']),
    ]
    for name, shape in _shapes(module):
        lines += ["", *_typedef(name, shape, room)]
    if room == "shared":
        lines += ["", *_views()]
    lines.append("")
    for _, identifier in declared(module):
        if isinstance(identifier, Pattern):  # only Dash looks for them
            continue
        text = f'"{identifier}"'
        if isinstance(identifier, Store):
            text = f"/** @type {{StoreId<{typescript(identifier.content, room)}>}} */ ({text})"
        lines.append(f"export const {constant(identifier)} = {text};")
    return "\n".join(lines) + "\n"


def typescript(shape: Any, room: str) -> str:
    """A shape as a type of TypeScript, as a module of ``room`` writes it."""
    if shape is None or shape in _PLAIN:
        return _PLAIN[NoneType if shape is None else shape]
    origin, parts = get_origin(shape), get_args(shape)
    if origin is Literal:
        return " | ".join(f'"{part}"' if isinstance(part, str) else str(part).lower() for part in parts)
    if origin in (Union, UnionType):
        return " | ".join(dict.fromkeys(typescript(part, room) for part in parts))
    if origin is list:
        return f"Array<{typescript(parts[0], room)}>"
    if origin is tuple:
        return f"[{', '.join(typescript(part, room) for part in parts)}]"
    if origin is dict:
        return f"Record<string, {typescript(parts[1], room)}>"
    if is_typeddict(shape):
        home = next(name for name, module in ROOMS.items() if module == shape.__module__)
        return shape.__name__ if home == room else f'import("../{home}/ids.mjs").{shape.__name__}'
    return typescript(parts[0], room)  # Annotated, Required, NotRequired


def _shapes(module: ModuleType) -> list[tuple[str, Any]]:
    """The shapes that a module defines itself, by name."""
    return [item for item in vars(module).items() if is_typeddict(item[1]) and item[1].__module__ == module.__name__]


def _views() -> list[str]:
    """The keys of the links of all pages, as one type: the store "view" holds them together."""
    views = {name: import_module(ROOMS[name]).View for name in FEATURES}
    keys_of_pages = [(name, key) for name, view in views.items() for key in keys(view)[0]]
    return [
        "/**",
        " * What the pages show beside the selection, by key of the link.",
        " * @typedef {object} PageView",
        *(f" * @property {{string}} [{key}] of the page {name.replace('_', ' ')}" for name, key in keys_of_pages),
        " */",
    ]


def _typedef(name: str, shape: Any, room: str) -> list[str]:
    words = (shape.__doc__ or "").strip().split("\n")[0]
    known, required = keys(shape)
    properties = [
        f" * @property {{{typescript(part, room)}}} {key if key in required else f'[{key}]'}"
        for key, part in known.items()
    ]
    return ["/**", *([f" * {words}"] if words else []), f" * @typedef {{object}} {name}", *properties, " */"]


def main(arguments: list[str]) -> int:
    """The exit code: 1 where ``--check`` is among the arguments and a file is not up to date."""
    stale = []
    for room in ROOMS:
        path, text = REPOSITORY / "assets" / room / "ids.mjs", ids_of(room)
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            stale.append(path)
            if "--check" not in arguments:
                path.write_text(text, encoding="utf-8")
    if "--check" not in arguments:
        return 0
    for path in stale:
        print(f'{path.relative_to(REPOSITORY)} is not up to date: run "make bundle".', file=sys.stderr)
    return int(bool(stale))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
