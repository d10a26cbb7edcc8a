"""Recipes that repeat a search: a command and a Python script (see webapp/shell/recipes.py)."""

from __future__ import annotations

import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path

from core import analyses
from core.analyses import Request
from core.poses.body_parts import LEAVES, leaves_of
from webapp.features.search.queries import Piece, nodes_of
from webapp.features.search.searching import Search
from webapp.features.search.uploaded import UPLOAD
from webapp.shell.virtual import MARK


def texts(workspace: Path, request: Request, search: Search, level: str) -> dict[str, str]:
    """What the menu of a search offers to copy: label -> text; the command only where there is one.

    request: that of the index; level: of the hits, "clip" or "interval".
    """
    recipes: dict[str, str] = {}
    query = _options(search.pieces)
    if query is not None:
        recipes["Copy as command"] = command(workspace, request, search, level, query)
    if all(_python(piece) for piece in search.pieces):
        recipes["Copy as Python"] = script(workspace, request, search, level)
    return recipes


def command(workspace: Path, request: Request, search: Search, level: str, query: Sequence[str]) -> str:
    """``motionscape search SOURCE --query ... --out hits.json``; filters of the page have no options there."""
    words = ["motionscape", "search", f"{workspace}/{request.dataset}", *query]
    for name, value in _not_default(request).items():
        words += [f"--{name.replace('_', '-')}", str(value)]
    if search.weights:
        words += ["--weights", ",".join(f"{part}={weight:g}" for part, weight in search.weights.items())]
    words += ["--root-path", f"{search.route:g}"] if search.route else []
    return shlex.join([*words, "--level", level, "--top", str(search.top), "--out", "hits.json"])


def script(workspace: Path, request: Request, search: Search, level: str) -> str:
    """A Python script that opens the index, computed where it is not kept, and prints the hits."""
    pieces = [f"{_python(piece)}, {piece.start}, {piece.end}" for piece in search.pieces]
    if len(pieces) == 1 and len(search.pieces[0].leaves) == len(LEAVES):
        maker, query = "whole_query", f"whole_query({pieces[0]})"
    else:
        named = zip(search.pieces, pieces, strict=True)
        entries = [f"    {node!r}: ({text})," for piece, text in named for node in nodes_of(piece.leaves)]
        maker, query = "hybrid_query", "\n".join(["hybrid_query({", *entries, "})"])
    imports = ["from core.workspace.query_files import kept_query"] if "kept_query(" in query else []
    arguments = {"level": level, "top": search.top}
    arguments |= {"weights": dict(search.weights)} if search.weights else {}
    arguments |= {"root_path": search.route} if search.route else {}
    options = ", ".join(f"{name}={value!r}" for name, value in arguments.items())
    lines = [
        "from core import Workspace",
        "from core.analyses import Request, run",
        f"from core.retrieval.queries import {maker}",
        *imports,
        "",
        f"workspace = Workspace({str(workspace)!r})",
        f"dataset = workspace.open({request.dataset!r})",
        f"index = run(workspace, Request({request.dataset!r}, {request.method!r}, {_not_default(request)!r}))",
        f"query = {query}",
        f"for hit in index.search(query, {options}):",
        "    print(round(hit.score, 4), *hit.segment)",
    ]
    return "\n".join(lines) + "\n"


def _options(pieces: Sequence[Piece]) -> list[str] | None:
    """The command's options for a query; None where it has none."""
    if any(piece.dataset for piece in pieces):
        return None
    texts = [f"{piece.clip}:{piece.start}-{piece.end}" for piece in pieces]
    if len(pieces) == 1 and len(pieces[0].leaves) == len(LEAVES):
        return ["--query", texts[0]]
    halves = {leaves_of("upper_body"): "--query", leaves_of("lower_body"): "--lower"}
    if len(pieces) == 2 and {piece.leaves for piece in pieces} == set(halves):
        arguments = {halves[piece.leaves]: text for piece, text in zip(pieces, texts, strict=True)}
        return ["--query", arguments["--query"], "--lower", arguments["--lower"]]
    return None


def _python(piece: Piece) -> str:
    """An expression for a piece's clip; "" for motion that only the app makes."""
    if not piece.dataset:
        return f"dataset.clip({piece.clip!r})"
    if piece.dataset.startswith(f"{MARK}{UPLOAD}{MARK}"):
        return f"kept_query(workspace, {piece.dataset.rpartition(MARK)[2]!r})"
    return "" if piece.dataset.startswith(MARK) else f"workspace.open({piece.dataset!r}).clip({piece.clip!r})"


def _not_default(request: Request) -> Mapping[str, object]:
    filled = analyses.normalise(request).parameters
    return {p.name: filled[p.name] for p in analyses.parameters(request.method) if filled[p.name] != p.default}
