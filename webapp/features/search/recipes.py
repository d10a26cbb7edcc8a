"""A search again, elsewhere: as a command and as a Python script that give its hits (see webapp/shell/recipes.py)."""

from __future__ import annotations

import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path

from core import analyses
from core.analyses import Request
from core.poses.body_parts import LEAVES, leaves_of
from webapp.features.search.queries import Piece, nodes_of
from webapp.features.search.searching import Asked
from webapp.features.search.uploaded import UPLOAD
from webapp.shell.virtual import MARK


def both(workspace: Path, request: Request, asked: Asked, level: str) -> dict[str, str]:
    """What the menu of a search offers to copy: label -> text; the command only where there is one.

    request: that of the index; level: of the hits, "clip" or "interval".
    """
    made: dict[str, str] = {}
    query = _options(asked.pieces)
    if query is not None:
        made["Copy as command"] = command(workspace, request, asked, level, query)
    if all(_python(piece) for piece in asked.pieces):
        made["Copy as Python"] = script(workspace, request, asked, level)
    return made


def command(workspace: Path, request: Request, asked: Asked, level: str, query: Sequence[str]) -> str:
    """``motionscape search SOURCE --query ... --out hits.json``; filters of the page have no options there."""
    words = ["motionscape", "search", f"{workspace}/{request.dataset}", *query]
    for name, value in _not_default(request).items():
        words += [f"--{name.replace('_', '-')}", str(value)]
    if asked.weights:
        words += ["--weights", ",".join(f"{part}={weight:g}" for part, weight in asked.weights.items())]
    words += ["--root-path", f"{asked.route:g}"] if asked.route else []
    return shlex.join([*words, "--level", level, "--top", str(asked.top), "--out", "hits.json"])


def script(workspace: Path, request: Request, asked: Asked, level: str) -> str:
    """A Python script that opens the index, computed where it is not kept, and prints the hits."""
    pieces = [f"{_python(piece)}, {piece.start}, {piece.end}" for piece in asked.pieces]
    if len(pieces) == 1 and len(asked.pieces[0].leaves) == len(LEAVES):
        maker, query = "whole_query", f"whole_query({pieces[0]})"
    else:
        named = zip(asked.pieces, pieces, strict=True)
        entries = [f"    {node!r}: ({text})," for piece, text in named for node in nodes_of(piece.leaves)]
        maker, query = "hybrid_query", "\n".join(["hybrid_query({", *entries, "})"])
    kept = ["from core.workspace.query_files import kept_query"] if "kept_query(" in query else []
    given = {"level": level, "top": asked.top}
    given |= {"weights": dict(asked.weights)} if asked.weights else {}
    given |= {"root_path": asked.route} if asked.route else {}
    options = ", ".join(f"{name}={value!r}" for name, value in given.items())
    lines = [
        "from core import Workspace",
        "from core.analyses import Request, run",
        f"from core.retrieval.queries import {maker}",
        *kept,
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
    """The options that stand for a query; None where the command has none for it."""
    if any(piece.dataset for piece in pieces):
        return None
    texts = [f"{piece.clip}:{piece.start}-{piece.end}" for piece in pieces]
    if len(pieces) == 1 and len(pieces[0].leaves) == len(LEAVES):
        return ["--query", texts[0]]
    halves = {leaves_of("upper_body"): "--query", leaves_of("lower_body"): "--lower"}
    if len(pieces) == 2 and {piece.leaves for piece in pieces} == set(halves):
        given = {halves[piece.leaves]: text for piece, text in zip(pieces, texts, strict=True)}
        return ["--query", given["--query"], "--lower", given["--lower"]]
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
